"""Where a run leaves what its model is good for: given in the result, never hidden."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import largest_flow
from tmodes.paper.sheet import PaperRobot

__all__ = [
    "BENDING_LIMIT",
    "deflection_warnings",
    "energy_lost",
    "energy_sentence",
    "energy_warnings",
    "first_energy_error",
    "held_warnings",
    "jam_warnings",
    "start_warnings",
]

BENDING_LIMIT = 0.1
"""Bending angle [rad] up to which tan th = th, on which (9)-(12) rest, is true to 0.3 %."""

_ROUNDING = 1e-12
"""A residual [J] that is rounding, however little energy was moved."""


def deflection_warnings(data: Any) -> list[str]:
    """Bending angles beyond the small angles of the model, with the first time and the largest value."""
    warnings = []
    for name in ("th11q", "th12d", "th11m", "th12e"):
        angle = np.abs(data["deformation"].sel(deformation_kind=name).values)
        beyond = np.flatnonzero(angle > BENDING_LIMIT)
        if len(beyond):
            first = float(data["time"].values[beyond[0]])
            warnings.append(
                f"bending angle {name} leaves the small-angle range of the model (|th| <= {BENDING_LIMIT:g} rad) first "
                f"at t = {first:.4g} s and reaches {angle.max():.3g} rad: take the deflections as a hint only"
            )
    return warnings


def first_energy_error(data: Any, tolerance: float) -> int | None:
    """Index of the first sample at which the balance is off by more than ``tolerance`` of the energy moved, or None."""
    moved = largest_flow(data["energy"].values, data["work"].values)
    return energy_lost(data["energy_balance"].values, moved, tolerance)


def energy_lost(residual: NDArray[np.float64], moved: float, tolerance: float) -> int | None:
    """First sample whose residual [J] is more than ``tolerance`` of the energy moved [J]; None where none is."""
    return _first_beyond(np.abs(residual), moved, tolerance)


def _first_beyond(off: NDArray[np.float64], moved: float, tolerance: float) -> int | None:
    beyond = np.flatnonzero(off > max(tolerance * moved, _ROUNDING))
    return int(beyond[0]) if len(beyond) else None


def energy_warnings(data: Any, tolerance: float) -> list[str]:
    """An energy balance that does not close, with the first time and the worst value."""
    moved = largest_flow(data["energy"].values, data["work"].values)
    hint = "lower integration.relative_tolerance (adaptive methods) or integration.step (rk4, midpoint)"
    info = energy_sentence(data["time"].values, data["energy_balance"].values, moved, tolerance, hint)
    return [info] if info else []


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


def start_warnings(data: Any, robot: PaperRobot) -> list[str]:
    """A start away from the environment's sphere, which launches the tip."""
    if "contact_force_radial" not in data:
        return []
    reach = sum(mode.length for mode in robot.link.modes)
    deviation = float(np.linalg.norm(data["tip"].values[0]) - reach)
    if abs(deviation) <= 1e-3 * reach:
        return []
    return [
        f"the tip starts {deviation * 1e3:.3g} mm off the environment's sphere (radius {reach:.4g} m): the environment "
        f"pulls with {robot.environment.stiffness * abs(deviation):.3g} N from the first instant"
    ]


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


def held_warnings(time: NDArray[np.float64], found: NDArray[np.bool_]) -> list[str]:
    """Instants at which the arm could not hold its loads statically, so that T_st is an estimate."""
    lost = np.flatnonzero(~found)
    if not len(lost):
        return []
    return [
        f"at {len(lost)} samples, first at t = {time[lost[0]]:.4g} s, the arm could not hold its present loads "
        "statically: there the stationary part T_st is that of the arm as it is linear about its present shape"
    ]
