"""Is a fixed step small enough? The highest frequency at the start answers before the run does."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.settings import Integration, Method

__all__ = ["StepVerdict", "step_size_verdict"]


@dataclass(frozen=True)
class StepVerdict:
    """``highest`` |eigenvalue| [1/s] at the start; ``dt_omega`` = step times it; ``stable``; ``sentence`` to tell."""

    highest: float
    dt_omega: float | None
    stable: bool
    sentence: str = ""


def step_size_verdict(settings: Integration, eigenvalues: NDArray[np.complex128]) -> StepVerdict:
    """Judge the fixed step by the amplification of the classical Runge-Kutta method, |R(dt lambda)| <= 1.

    An adaptive method chooses its own step, so it is always stable here.
    """
    highest = float(np.abs(eigenvalues).max(initial=0.0))
    if settings.method is not Method.RK4:
        return StepVerdict(highest, None, True)
    z = settings.step * eigenvalues[eigenvalues.real <= 0]
    growth = float(np.abs(1 + z + z**2 / 2 + z**3 / 6 + z**4 / 24).max(initial=0.0))
    dt_omega = settings.step * highest
    told = f"dt*omega = {dt_omega:.3g} (step {settings.step:.3g} s, highest frequency {highest:.4g} rad/s)"
    if growth > 1 + 1e-9:
        mend = f"set integration.step below {2.5 / highest:.2g}, or integration.method: dormand_prince"
        return StepVerdict(highest, dt_omega, False, f"rk4 is unstable at this step: {told}; {mend}")
    if dt_omega > 1.0:
        mend = f"set integration.step near {0.3 / highest:.2g}, or integration.method: dormand_prince"
        return StepVerdict(highest, dt_omega, True, f"rk4 is stable but inaccurate at this step: {told}; {mend}")
    return StepVerdict(highest, dt_omega, True)
