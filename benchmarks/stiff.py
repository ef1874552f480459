"""A stiff arm, 54 coordinates: what a second of its motion costs, side by side, with the error along the whole path.

    python -m benchmarks.stiff [--rounds 3] [--damping 0,1e-7,3e-5,2e-4] [--starts rest,drop] [--stretch 0.02]
                               [--exudyn] [--json FILE]

The arm and its manoeuvre are in `stiff_arm.py`; ``--damping``: damping times of the links [s]. The error is the largest
of all coordinates at samples every 1 ms, against our own Dormand-Prince at 1e-10. That one is held back by stability at
any tolerance: next to it, its time at 1e-6 over a stretch of the motion is scaled up to the whole. For damping times
beyond 1e-4 s it would take minutes: there the reference is extrapolation at 1e-10, and Dormand-Prince at 1e-10 checks
it over the stretch. Contenders take turns; medians of processor time are printed. ``--exudyn``: see `stiff_exudyn.py`.
"""

from __future__ import annotations

import argparse
import json
import platform
import statistics
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tmodes.simulation.initial_state import RunSetup, run_setup, run_trajectory
from tmodes.simulation.parts import Trajectory

from .stiff_arm import stiff_arm


def _at(method: str, tolerance: float) -> dict[str, Any]:
    return {"method": method, "relative_tolerance": tolerance, "absolute_tolerance": tolerance / 100}


METHODS = {
    "extrapolation 1e-6": _at("extrapolation", 1e-6),
    "extrapolation 2e-7": _at("extrapolation", 2e-7),
    "extrapolation 1e-7": _at("extrapolation", 1e-7),
    "midpoint, 0.25 ms": {"method": "midpoint", "step": 2.5e-4},
}
EXPLICIT_AT_MOST = 1e-4
"""Damping time [s] beyond which the reference is not explicit."""


class Figures(NamedTuple):
    """Median seconds for a second of motion, largest error of any coordinate [rad], and passes of the recursion."""

    seconds: float
    error: float
    passes: float


class Case(NamedTuple):
    """Damping time of the links [s], and start."""

    damping_time: float
    start: str

    def setup(self, **integration: Any) -> RunSetup:
        """The arm, ready to run."""
        arm = stiff_arm(start=self.start, damping_time=self.damping_time, output_step=1e-3, **integration)
        return run_setup(arm)


def _timed(setup: RunSetup) -> tuple[float, Trajectory]:
    began = time.process_time()
    run = run_trajectory(setup)
    return time.process_time() - began, run


def _passes(run: Trajectory) -> float:
    return run.statistics.get("passes", run.statistics["evaluations"])


def _apart(run: Trajectory, exact: Trajectory, count: int) -> float:
    length = min(len(run.states), len(exact.states))
    return float(np.abs(run.states[:length] - exact.states[:length])[:, :count].max())


def measured(case: Case, rounds: int, stretch: float) -> dict[str, Figures]:
    """Figures of all contenders."""
    explicit = case.damping_time <= EXPLICIT_AT_MOST
    name = "dormand_prince" if explicit else "extrapolation"
    regimes = {label: case.setup(**info) for label, info in METHODS.items()}
    times: dict[str, list[float]] = {label: [] for label in (*regimes, "short")}
    runs: dict[str, Trajectory] = {}
    for setup in regimes.values():
        run_trajectory(setup, until=1e-3)  # compiled before it is timed
    whole, exact = _timed(case.setup(**_at(name, 1e-10)))
    regimes["short"] = case.setup(duration=stretch, **_at("dormand_prince", 1e-6))
    for _ in range(rounds):
        for label, setup in regimes.items():
            seconds, runs[label] = _timed(setup)
            times[label].append(seconds)
    count = len(regimes["short"].model.coordinates)
    figures = {
        label: Figures(statistics.median(times[label]), _apart(runs[label], exact, count), _passes(runs[label]))
        for label in METHODS
    }
    figures[f"{name} 1e-10, the reference"] = Figures(whole, float("nan"), _passes(exact))
    scaled = statistics.median(times["short"]) / stretch
    figures[f"dormand_prince 1e-6, {stretch:g} s scaled"] = Figures(
        scaled, float("nan"), _passes(runs["short"]) / stretch
    )
    if not explicit:
        seconds, checked = _timed(case.setup(duration=stretch, **_at("dormand_prince", 1e-10)))
        apart, passes = _apart(checked, exact, count), _passes(checked) / stretch
        figures[f"dormand_prince 1e-10, {stretch:g} s scaled"] = Figures(seconds / stretch, apart, passes)
    return figures


def _lines(case: Case, figures: dict[str, Figures]) -> Iterator[str]:
    explicit = next(found.seconds for name, found in figures.items() if name.startswith("dormand_prince 1e-6"))
    for name, found in figures.items():
        yield (
            f"{case.damping_time:7.0e} {case.start:5}{name:40}{found.seconds:9.3f}{1 / found.seconds:10.1f}"
            f"{explicit / found.seconds:12.1f}{found.error:11.1e}{found.passes:11.0f}"
        )


def main() -> None:
    """Measure and print."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--damping", default="0,1e-7,3e-5,2e-4", help="damping times of the links [s]")
    options.add_argument("--starts", default="rest,drop")
    options.add_argument("--stretch", type=float, default=0.02, help="seconds of motion of the explicit method")
    options.add_argument("--exudyn", action="store_true", help="also next to Exudyn's geometrically exact beams")
    options.add_argument("--json", help="also write the figures to this file")
    chosen = options.parse_args()
    machine = platform.processor() or platform.machine()
    print(f"1 s of motion, processor time, medians of {chosen.rounds} rounds; {machine}")
    head = ("s", "x real time", "x explicit", "error/rad", "passes")
    print(f"{'damping':>7} {'start':5}{'':40}{head[0]:>9}{head[1]:>10}{head[2]:>12}{head[3]:>11}{head[4]:>11}")
    info: dict[str, Any] = {}
    for damping_time in map(float, chosen.damping.split(",")):
        for start in chosen.starts.split(","):
            figures = measured(case := Case(damping_time, start), chosen.rounds, chosen.stretch)
            print("\n".join(_lines(case, figures)), flush=True)
            info[f"{damping_time:g} {start}"] = {name: found._asdict() for name, found in figures.items()}
    if chosen.exudyn:
        from .stiff_exudyn import compared

        info["exudyn"] = compared(chosen.rounds)
    if chosen.json:
        Path(chosen.json).write_text(json.dumps(info, indent=1))


if __name__ == "__main__":
    main()
