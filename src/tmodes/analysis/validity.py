"""Where a run leaves what its model is good for: given in the result, never hidden."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["energy_lost", "energy_sentence", "jam_warnings"]

_ROUNDING = 1e-12
"""A residual [J] that is rounding, however little energy was moved."""


def energy_lost(residual: NDArray[np.float64], moved: float, tolerance: float) -> int | None:
    """First sample whose residual [J] is more than ``tolerance`` of the energy moved [J]; None where none is."""
    return _first_beyond(np.abs(residual), moved, tolerance)


def _first_beyond(off: NDArray[np.float64], moved: float, tolerance: float) -> int | None:
    beyond = np.flatnonzero(off > max(tolerance * moved, _ROUNDING))
    return int(beyond[0]) if len(beyond) else None


def energy_sentence(
    times: NDArray[np.float64], residual: NDArray[np.float64], moved: float, tolerance: float, hint: str
) -> str:
    """A residual [J] beyond ``tolerance`` of the energy moved [J], in words, with its fix; empty within it."""
    off = np.abs(residual)
    first = _first_beyond(off, moved, tolerance)
    if first is None:
        return ""
    worst = float(off.max())
    return (
        f"the energy balance is off first at t = {float(times[first]):.4g} s, by {worst:.2g} J at worst, "
        f"{worst / moved if moved else np.inf:.1e} of the energy moved ({moved:.3g} J): the integration is too "
        f"coarse; {hint}"
    )


def jam_warnings(time: NDArray[np.float64], fold: NDArray[np.float64]) -> list[str]:
    """Contact whose friction and mass are so large that the forces have no, or two, answers (``contact_fold``)."""
    jammed = np.flatnonzero(fold <= 0)
    if not len(jammed):
        return []
    return [
        f"the contact jams first at t = {time[jammed[0]]:.4g} s, and at {len(jammed)} samples in all: friction and the "
        "environment's mass are so large that the force has no single answer; do not trust the motion from there on; "
        "lower the contact's friction or mass"
    ]
