"""What an arm is, in numbers: masses, lengths, stiffnesses, frequencies, sag, and what gives way at the tip."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import numpy as np

from tmodes.analysis.arm_compliance import DIRECTIONS, point_compliance
from tmodes.analysis.describe_doubts import doubts, rest_doubts
from tmodes.analysis.describe_links import gear_rows, joint_rows, link_rows
from tmodes.analysis.equilibrium import Equilibrium
from tmodes.analysis.equilibrium_arm import arm_rest
from tmodes.analysis.equilibrium_path import Progress
from tmodes.analysis.range import link_ranges
from tmodes.arm import Arm
from tmodes.arm_model import ArmModel
from tmodes.errors import SimulationError

__all__ = ["compliance_table", "describe", "sag", "statics_told"]


def describe(
    arm: Arm, held: Mapping[str, float] | None = None, progress: Progress = lambda stage, share: None
) -> dict[str, Any]:
    """All that ``tmodes describe`` tells of an arm, as plain data with units in the names.

    The sag and the stiffness are those under the arm's weight alone, the driven coordinates at ``held``, else at their
    first command. An arm that finds no rest is described too: then ``sag`` and ``stiffness`` are None and ``warnings``
    say why. Raises :class:`tmodes.errors.InputError` for an unknown name in ``held``.
    """
    chain = arm.chain()
    model = ArmModel(chain)
    links = link_rows(arm, chain)
    progress("statics", 0.0)
    rest, trouble = _rest(arm, model, held, progress)
    told = {
        "name": arm.name,
        "title": arm.title,
        "assumed": arm.assumed,
        "gravity_m_per_s2": list(arm.gravity),
        "coordinates": list(model.coordinates),
        "total_mass_kg": float(sum(link["mass_kg"] for link in links)),
        "joints": joint_rows(arm),
        "links": links,
        "gears": gear_rows(arm, chain),
        "sag": sag(rest) if rest else None,
        "stiffness": compliance_table(rest) if rest else None,
    }
    return told | {"warnings": [*trouble, *doubts(arm, chain, told, rest)]}


def _rest(
    arm: Arm, model: ArmModel, held: Mapping[str, float] | None, progress: Progress
) -> tuple[Equilibrium | None, list[str]]:
    try:
        return arm_rest(arm, model=model, held=held, sheet=False, contact=False, progress=progress), []
    except SimulationError as error:
        return None, [f"no rest under its own weight: {error}"]


def statics_told(arm: Arm, rest: Equilibrium, point: int = 0) -> dict[str, Any]:
    """All that ``tmodes static`` tells of an arm at rest, as plain data; ``point``: whose stiffness."""
    free = rest.lowest_frequency_Hz
    return {
        "coordinates": rest.named,
        "held": [name for k, name in enumerate(rest.model.coordinates) if k not in rest.free],
        "residual": rest.residual,
        "stable": rest.stable,
        "lowest_frequency_Hz": free if np.isfinite(free) else None,
        "unstable_modes": [asdict(mode) for mode in rest.unstable_modes],
        "lost_stability_at": rest.lost_stability_at,
        "load_steps": len(rest.load_path) - 1,
        "points": [sag(rest, k) for k in range(len(rest.model.parts.points))],
        "links": [asdict(link) for link in link_ranges(rest.model, rest.q)],
        "stiffness": compliance_table(rest, point),
        "warnings": rest_doubts(arm, rest),
    }


def sag(rest: Equilibrium, point: int = 0) -> dict[str, Any]:
    """How far a point is moved and turned by weight and loads, from the unloaded arm."""
    travel, turn = rest.displacement(point)
    position = rest.model.pose(rest.q)[0][point]
    return {
        "point": rest.model.parts.points[point].name,
        "position_m": position.tolist(),
        "displacement_m": travel.tolist(),
        "displacement_size_m": float(np.linalg.norm(travel)),
        "rotation_vector_rad": turn.tolist(),
        "rotation_rad": float(np.linalg.norm(turn)),
    }


def compliance_table(rest: Equilibrium, point: int = 0) -> dict[str, Any] | None:
    """Stiffness of a point by direction and the share of each element in its compliance; None where it has none."""
    try:
        found = point_compliance(rest, point)
    except SimulationError:
        return None
    stiffness = found.stiffness
    matrix = found.stiffness_matrix
    return {
        "point": found.point,
        "directions": [
            {
                "direction": name,
                "stiffness": float(stiffness[k]) if np.isfinite(stiffness[k]) else None,
                "unit": "N/m" if k < 3 else "N*m/rad",
                "compliance": float(found.compliance[k, k]),
                "shares": found.shares(k),
            }
            for k, name in enumerate(DIRECTIONS)
        ],
        "compliance_matrix_SI": found.compliance.tolist(),
        "stiffness_matrix_SI": None if matrix is None else matrix.tolist(),
    }
