"""What a robot is, in numbers: masses, lengths, stiffnesses, frequencies, sag, and what gives way at the tip."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from tmodes.analysis.describe.links import gear_rows, joint_rows, link_rows, notices, parallel_rows, rest_notices
from tmodes.analysis.line.line import LinkLines, elastic_line
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.compliance import DIRECTIONS, PointCompliance, missing_functions, point_compliance
from tmodes.analysis.statics.equilibrium import Equilibrium, base_spin, steady_rates
from tmodes.analysis.statics.path import Progress
from tmodes.analysis.statics.reactions import reactions
from tmodes.analysis.validity import link_ranges, missing_share, rest_warnings
from tmodes.errors import SimulationError
from tmodes.kinds.joints.joint import JointState
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["NOTHING_MOVES", "compliance_table", "describe", "link_states", "sag", "statics_info"]

NOTHING_MOVES = "nothing in it moves or bends: its joints are locked or fixed, and no link has a function"

BAD_SHARE = 0.05
"""Share of a link's energy in shapes that its functions do not have, from which its model does not hold."""


def describe(
    robot: Robot, held: Mapping[str, float | str] | None = None, progress: Progress = lambda stage, share: None
) -> dict[str, Any]:
    """All that ``tmodes describe`` prints of a robot, as plain data with units in the names.

    The sag and the stiffness are those under the robot's weight alone, the driven coordinates at ``held``, else at
    their first command; with free joints also in its contact, and without numbers for the sag. A robot that finds no
    rest is described too: then ``sag`` and ``stiffness`` are None and ``warnings`` say why. Raises
    :class:`tmodes.errors.InputError` for an unknown name in ``held``.
    """
    chain = robot.chain()
    model = Model(chain)
    links = link_rows(robot, chain)
    progress("statics", 0.0)
    rest, trouble = _rest(robot, model, held, progress)
    info = {
        "name": robot.name,
        "title": robot.title,
        "assumed": robot.assumed,
        "notes": [
            *robot.held_notices,
            *_standing(robot, model),
            *([_IN_CONTACT] if _leans(robot) else ()),
            *_rigid(links),
        ],
        "gravity_m_per_s2": list(robot.gravity),
        "coordinates": list(model.coordinates),
        "total_mass_kg": float(sum(link["mass_kg"] for link in links)),
        "joints": joint_rows(robot),
        "links": links,
        "gears": gear_rows(robot, links),
        "springs": parallel_rows(robot),
        "sag": _sag(robot, rest) if rest else None,
        "stiffness": compliance_table(rest) if rest else None,
    }
    found = [*(one for one in robot.notices if one not in robot.assumed), *trouble, *notices(robot, chain, info, rest)]
    return info | {"warnings": [*found, *(rest_warnings(robot, model, _lines(rest)) if rest else ()), *_still(model)]}


def _standing(robot: Robot, model: Model) -> list[str]:
    moves = steady_rates(robot, model) or base_spin(robot) is not None
    return (
        ["sag and stiffness are of the robot standing still; `static` and `modes` are about its motion"]
        if moves
        else []
    )


_IN_CONTACT = "sag and stiffness are of the robot in contact, which may be all that holds its free joints"


def _leans(robot: Robot) -> bool:
    """Whether a contact may be what holds a robot: it has one, and joints that nothing else holds."""
    return robot.contact is not None and any(joint.state is JointState.FREE for joint in robot.joints)


def _rigid(links: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    """Links without functions for a kind of bending or for twist, which the model leaves rigid there."""
    for link in links:
        functions = link.get("functions", {})
        left = [name for name in ("bend_y", "bend_z", "twist") if not functions.get(name, 1)]
        if left:
            yield f"link {link['name']} has no functions for {' and '.join(left)}: it is rigid there"


def _sag(robot: Robot, rest: Equilibrium) -> dict[str, Any]:
    """The place of the tip, and how far it sags; that is None where a free joint lets it swing to there."""
    found = sag(rest)
    if any(joint.state is JointState.FREE and joint.spring is None for joint in robot.joints):
        return found | dict.fromkeys(name for name in found if "displacement" in name or "rotation" in name)
    return found


def _still(model: Model) -> list[str]:
    return [] if model.nq else [NOTHING_MOVES]


def _lines(rest: Equilibrium) -> LinkLines:
    wrenches = None if rest.wrenches is None else rest.wrenches[None]
    rates = 0.0 if rest.rates is None else rest.rates
    return elastic_line(rest.model, rest.q, rates, wrenches=wrenches, base=rest.base)


def link_states(rest: Equilibrium, lines: LinkLines | None = None) -> list[dict[str, Any]]:
    """The flexible links at rest, and whether the model of each holds: ``verdict`` good, fair, bad, beyond the model.

    ``missing_share``: of its energy in shapes that its functions do not have, None of segments. A link that carries
    more than a twentieth of it so is bad, however little it bends.
    """
    lines, info = lines or _lines(rest), []
    names = [node.name for node in rest.model.chain.nodes]
    for link in link_ranges(rest.model, rest.q):
        index = names.index(link.link)
        shape, own = rest.model.chain.nodes[index].link, [line for line in lines.links.values() if line.node == index]
        shares = [value for line in own for value in missing_share(line, shape).values()]
        share = max(shares, default=0.0) if shape.projected else None
        row = asdict(link) | {"missing_share": share}
        info.append(row | {"verdict": "bad"} if (share or 0.0) > BAD_SHARE else row)
    return info


def _rest(
    robot: Robot, model: Model, held: Mapping[str, float | str] | None, progress: Progress
) -> tuple[Equilibrium | None, list[str]]:
    try:
        return robot_rest(robot, model=model, held=held, sheet=False, contact=_leans(robot), progress=progress), []
    except SimulationError as error:
        return None, [f"no rest under its own weight: {error}"]


def statics_info(robot: Robot, rest: Equilibrium, point: int = 0) -> dict[str, Any]:
    """All that ``tmodes static`` prints of a robot at rest, as plain data; ``point``: whose stiffness."""
    free, lines = rest.lowest_frequency_Hz, _lines(rest)
    return {
        "coordinates": rest.named,
        "held": [name for k, name in enumerate(rest.model.coordinates) if k not in rest.free],
        "moving": rest.moving,
        "efforts": dict(rest.efforts),
        "residual": rest.residual,
        "stable": rest.stable,
        "neutral": [*rest.neutral],
        "lowest_frequency_Hz": free if np.isfinite(free) else None,
        "unstable_modes": [asdict(mode) for mode in rest.unstable_modes],
        "lost_stability_at": rest.lost_stability_at,
        "load_steps": len(rest.load_path) - 1,
        "points": [sag(rest, k) for k in range(len(rest.model.parts.points))],
        "links": link_states(rest, lines),
        "stiffness": compliance_table(rest, point),
        "reactions": reactions(robot, rest),
        "warnings": [*rest_notices(robot, rest), *rest_warnings(robot, rest.model, lines), *_still(rest.model)],
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
    """Stiffness of a point by direction and the share of each element in its compliance; None where it has none.

    A direction in which the sheet leaves out how the robot gives has no numbers, and ``why`` says so; one without a
    stiffness and a reason is rigid.
    """
    try:
        found = point_compliance(rest, point)
    except SimulationError:
        return None
    matrix, missing = found.stiffness_matrix, missing_functions(rest, found, point)
    return {
        "point": found.point,
        "directions": [_direction(found, k, missing[k]) for k in range(6)],
        "compliance_matrix_SI": found.compliance.tolist(),
        "stiffness_matrix_SI": None if matrix is None else matrix.tolist(),
    }


def _direction(found: PointCompliance, k: int, missing: str) -> dict[str, Any]:
    stiffness = float(found.stiffness[k])
    return {
        "direction": DIRECTIONS[k],
        "stiffness": stiffness if np.isfinite(stiffness) and not missing else None,
        "unit": "N/m" if k < 3 else "N*m/rad",
        "compliance": None if missing else float(found.compliance[k, k]),
        "why": f"not modelled (no {missing} functions)" if missing else None,
        "shares": {} if missing else found.shares(k),
    }
