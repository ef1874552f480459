"""The energy monitor: what came in, less what went out, must be what is there."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["energy_lost", "energy_sentence", "largest_flow", "stands"]

_ROUNDING = 1e-12
"""A residual [J] that is rounding, however little energy was moved."""


STILL = 1e-9
"""Energy moved over that which is there up to which a robot stands still: what moves is rounding."""


def largest_flow(energy: ArrayLike, work: ArrayLike) -> float:
    """The energy moved [J]: the largest change of any kind of energy, work of any kind, or kinetic energy, in the run.

    ``energy`` (n, kinds), the kinetic one first: a robot that moves on at a constant speed changes none and does no
    work, and its balance has the errors of what it carries along.
    """
    energy = np.asarray(energy)
    return float(max(np.abs(energy - energy[0]).max(), np.abs(work).max(), np.abs(energy[:, 0]).max()))


def stands(moved: float, there: float) -> bool:
    """Whether what moves is rounding: the energy ``moved`` next to the largest of any kind that is ``there`` [J]."""
    return moved <= STILL * there


def energy_lost(residual: NDArray[np.float64], moved: float, there: float, tolerance: float) -> int | None:
    """First sample whose residual [J] is more than ``tolerance`` of the energy moved [J]; None where none is.

    ``there``: the largest energy [J] of any kind, next to which a robot that :func:`stands` loses none.
    """
    if stands(moved, there):
        return None
    beyond = np.flatnonzero(np.abs(residual) > max(tolerance * moved, _ROUNDING))
    return int(beyond[0]) if len(beyond) else None


def energy_sentence(
    times: NDArray[np.float64], residual: NDArray[np.float64], moved: float, there: float, tolerance: float, cause: str
) -> str:
    """A residual [J] beyond ``tolerance`` of the energy moved [J], in words, with its cause; empty within it."""
    first = energy_lost(residual, moved, there, tolerance)
    if first is None:
        return ""
    worst = float(np.abs(residual).max())
    return (
        f"the energy balance is off first at t = {float(times[first]):.4g} s, by {worst:.2g} J at worst, "
        f"{worst / moved if moved else np.inf:.1e} of the energy moved ({moved:.3g} J): {cause}"
    )
