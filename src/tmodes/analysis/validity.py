"""Where a run leaves what its model is good for: told in the result, never hidden."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.analysis.energy import largest_flow
from tmodes.robot import Robot

__all__ = ["BENDING_LIMIT", "ENERGY_LIMIT", "deflection_warnings", "energy_warnings", "start_warnings"]

BENDING_LIMIT = 0.1
"""Bending angle [rad] up to which tan th = th, on which (9)-(12) rest, is true to 0.3 %."""

ENERGY_LIMIT = 1e-6
"""Residual of the energy balance over the energy moved above which a run is called inaccurate."""


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


def energy_warnings(data: Any) -> list[str]:
    """An energy balance that does not close."""
    moved = largest_flow(data["energy"].values, data["work"].values)
    worst = float(np.abs(data["energy_balance"].values).max(initial=0.0))
    if worst <= ENERGY_LIMIT * moved or worst < 1e-12:
        return []
    return [
        f"the energy balance is off by {worst:.2g} J, {worst / moved:.1e} of the energy moved ({moved:.3g} J): the "
        "integration is too coarse; lower integration.relative_tolerance (dormand_prince) or integration.step (rk4)"
    ]


def start_warnings(data: Any, robot: Robot) -> list[str]:
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
