"""The falling arm of the stiff benchmark next to Exudyn's geometrically exact beams, at equal error of the tip.

Exudyn has no elastic joint with a motor behind it that a few lines could make: both let the arm of the benchmark fall
into its gears, with motors that stand. Each engine's error is that of its time integration alone, against its own
solution with half the step (Exudyn's, extrapolated with its order 2) or at 1e-10 (ours). What its mesh of two-node
beams leaves out is not counted: 8e-5 m of the tip with 2 elements in a tube, 1.3e-5 m with 4, seen by doubling them.
With 16, near 1e-6 m, a step takes seven times the time that it takes with 2, and the iterations stay noisy.

Exudyn's settings were searched by hand: generalized alpha with spectral radius 0.9 (0.6 and 1.0: errors within 30 % of
it), modified Newton (full: twice the time), the sparse solver (dense: twice the time with 2 elements); its Newton
iterations fail at the default tolerance 1e-8 with 4 elements and more from 2,000 steps on, so they get 1e-6 there.
"""

from __future__ import annotations

import statistics
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.simulation.initial_state import RunSetup, run_setup, run_trajectory
from tmodes.simulation.motion_run import gathered

from .peers.exudyn_beams import fall
from .stiff_arm import falling_arm

__all__ = ["compared"]

ERROR = 1e-6
"""Error of the tip at which both are compared [m]."""


def _regime(tolerance: float) -> RunSetup:
    info = {"relative_tolerance": tolerance, "absolute_tolerance": tolerance / 100}
    return run_setup(falling_arm(method="extrapolation", **info))


def _tip(setup: RunSetup) -> NDArray[np.float64]:
    return gathered(setup, run_trajectory(setup)).points.position[:, -1]


def _ours(rounds: int) -> tuple[float, float]:
    """Seconds at the largest tolerance whose error of the tip is below the one asked for, and that error."""
    exact = _tip(_regime(1e-10))
    for tolerance in (1e-5, 5e-6, 3e-6, 2e-6, 1e-6, 5e-7):
        setup = _regime(tolerance)
        error = float(np.abs(_tip(setup) - exact).max())
        if error <= ERROR:
            break
    times = []
    for _ in range(rounds):
        began = time.process_time()
        run_trajectory(setup)
        times.append(time.process_time() - began)
    return statistics.median(times), error


def _theirs(elements: int, steps: int, tolerance: float) -> tuple[float, float, float]:
    """Seconds and error with so many steps, and the seconds that the error asked for would take, by order 2."""
    chain = falling_arm().chain()
    coarse = fall(chain, elements=elements, steps=steps, newton_tolerance=tolerance)
    fine = fall(chain, elements=elements, steps=2 * steps, newton_tolerance=tolerance)
    error = float(np.abs(fine.tip - coarse.tip).max()) / 3  # of the finer one
    return fine.seconds, error, fine.seconds * np.sqrt(error / ERROR)


def compared(rounds: int) -> dict[str, Any]:
    """Measure, print, and return the figures."""
    seconds, error = _ours(rounds)
    print(f"falling arm, 1 s, processor time at {ERROR:g} m of the tip")
    print(f"  extrapolation {seconds:.3f} s, error {error:.1e} m")
    info: dict[str, Any] = {"ours": {"seconds": seconds, "error": error}}
    for elements, steps, tolerance in ((2, 4000, 1e-8), (4, 2000, 1e-6)):
        spent, found, scaled = _theirs(elements, steps, tolerance)
        print(
            f"  Exudyn, {elements} elements in a tube, {2 * steps} steps: {spent:.2f} s, error {found:.1e} m; "
            f"{scaled:.2f} s at {ERROR:g} m, {scaled / seconds:.0f} times ours"
        )
        info[f"exudyn {elements}"] = {"seconds": spent, "error": found, "at_equal_error": float(scaled)}
    return info
