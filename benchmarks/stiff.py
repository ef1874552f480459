"""A stiff arm, 54 coordinates: what a second of its motion costs, side by side, with the error along the whole path.

    python -m benchmarks.stiff [--rounds 3] [--starts rest,drop] [--stretch 0.05] [--exudyn] [--json FILE]

The arm and its manoeuvre are in `stiff_arm.py`; the error is the largest of all coordinates at samples every 1 ms,
against our own Dormand-Prince at 1e-10. That one is held back by stability at any tolerance: beside it, its time at
1e-6 over a stretch of the motion is scaled up to the whole. Contenders take turns; medians are printed. ``--exudyn``:
see `stiff_exudyn.py`.
"""

from __future__ import annotations

import argparse
import json
import platform
import statistics
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tmodes.motion.regime import ArmRegime, arm_regime, run_arm_regime
from tmodes.trajectory import Trajectory

from .stiff_arm import stiff_arm

METHODS = {
    "extrapolation 1e-6": {"method": "extrapolation", "relative_tolerance": 1e-6, "absolute_tolerance": 1e-8},
    "extrapolation 1e-7": {"method": "extrapolation", "relative_tolerance": 1e-7, "absolute_tolerance": 1e-9},
    "midpoint, 0.25 ms": {"method": "midpoint", "step": 2.5e-4},
}
REFERENCE = {"method": "dormand_prince", "relative_tolerance": 1e-10, "absolute_tolerance": 1e-12}
EXPLICIT = {"method": "dormand_prince", "relative_tolerance": 1e-6, "absolute_tolerance": 1e-8}


class Figures(NamedTuple):
    """Median seconds for a second of motion, largest error of any coordinate [rad], and passes of the recursion."""

    seconds: float
    error: float
    evaluations: float


def _regime(start: str, **integration: Any) -> ArmRegime:
    return arm_regime(stiff_arm(start=start, output_step=1e-3, **integration))


def _timed(regime: ArmRegime) -> tuple[float, Trajectory]:
    began = time.process_time()
    run = run_arm_regime(regime)
    return time.process_time() - began, run


def measured(start: str, rounds: int, stretch: float) -> dict[str, Figures]:
    """Figures of all contenders from one start."""
    whole, exact = _timed(_regime(start, **REFERENCE))
    regimes = {name: _regime(start, **told) for name, told in METHODS.items()}
    short = _regime(start, duration=stretch, **EXPLICIT)
    times: dict[str, list[float]] = {name: [] for name in regimes}
    explicit: list[float] = []
    runs: dict[str, Trajectory] = {}
    for regime in regimes.values():
        run_arm_regime(regime, until=1e-3)  # compiled before it is timed
    for _ in range(rounds):
        for name, regime in regimes.items():
            seconds, runs[name] = _timed(regime)
            times[name].append(seconds)
        explicit.append(_timed(short)[0] / stretch)
    count = len(regimes["extrapolation 1e-7"].model.coordinates)
    figures = {
        name: Figures(
            statistics.median(times[name]),
            float(np.abs(run.states - exact.states)[:, :count].max()),
            run.statistics["evaluations"],
        )
        for name, run in runs.items()
    }
    evaluations = exact.statistics["evaluations"]
    figures["dormand_prince 1e-10 (the reference)"] = Figures(whole, 0.0, evaluations)
    figures[f"dormand_prince 1e-6 ({stretch:g} s, scaled)"] = Figures(statistics.median(explicit), float("nan"), 0.0)
    return figures


def _told(start: str, figures: dict[str, Figures]) -> None:
    explicit = min(found.seconds for name, found in figures.items() if name.startswith("dormand_prince"))
    print(f"start: {start}")
    for name, found in figures.items():
        print(
            f"  {name:<40}{found.seconds:9.3f} s{1 / found.seconds:8.1f} x real time{explicit / found.seconds:8.1f} x "
            f"dormand_prince   error {found.error:8.1e} rad   {found.evaluations:9.0f} passes"
        )


def main() -> None:
    """Measure and print."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--starts", default="rest,drop")
    options.add_argument("--stretch", type=float, default=0.05, help="seconds of motion of the explicit method")
    options.add_argument("--exudyn", action="store_true", help="also beside Exudyn's geometrically exact beams")
    options.add_argument("--json", help="also write the figures to this file")
    chosen = options.parse_args()
    machine = platform.processor() or platform.machine()
    print(f"1 s of motion, processor time, medians of {chosen.rounds} rounds; {machine}")
    told: dict[str, Any] = {}
    for start in chosen.starts.split(","):
        figures = measured(start, chosen.rounds, chosen.stretch)
        _told(start, figures)
        told[start] = {name: found._asdict() for name, found in figures.items()}
    if chosen.exudyn:
        from .stiff_exudyn import compared

        told["exudyn"] = compared(chosen.rounds)
    if chosen.json:
        Path(chosen.json).write_text(json.dumps(told, indent=1))


if __name__ == "__main__":
    main()
