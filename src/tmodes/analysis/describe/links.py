"""Rows of the tables of ``tmodes describe``: joints, links and gears of an arm."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmodes.analysis.statics.equilibrium import Equilibrium, base_spin
from tmodes.analysis.statics.loads import first_value
from tmodes.analysis.validity import link_ranges
from tmodes.chain.chain import Chain, Node
from tmodes.io.sheet_plausible import turned
from tmodes.kinds.joints.joint import JointSheet, JointState
from tmodes.kinds.noted.functions import number
from tmodes.kinds.schema.frames import TURN
from tmodes.sheet import Robot
from tmodes.sheet.parts import LinkSheet
from tmodes.sheet.topology import loose_links

__all__ = [
    "gear_rows",
    "joint_rows",
    "link_masses",
    "link_rows",
    "notices",
    "parallel_rows",
    "pose_notices",
    "rest_notices",
]


def joint_rows(robot: Robot) -> list[dict[str, Any]]:
    """Each joint: its type in the group's letters (active or locked, elastic or rigid gear), drive and limits."""
    commands = {drive.joint: str(drive.command) for drive in robot.drives}
    return [
        {
            "name": joint.name,
            "type": str(joint.type),
            "kind": _letters(joint),
            "carries": joint.child,
            "motor": joint.motor is not None,
            "command": commands.get(joint.name),
            "state": str(joint.state),
            "lower": joint.limits.lower if joint.limits else None,
            "upper": joint.limits.upper if joint.limits else None,
            "unit": joint.unit,
        }
        for joint in robot.joints
    ]


def _letters(joint: JointSheet) -> str:
    """AE, LE, AR, LR or F; a fixed joint is LR: locked and rigid."""
    if joint.state is JointState.FREE:
        return "F"
    active = joint.is_active and joint.kind.moves
    return f"{'A' if active else 'L'}{'E' if joint.is_elastic else 'R'}"


def link_nodes(chain: Chain, name: str) -> Iterator[Node]:
    """The nodes of a chain that one link of a data sheet became: its root, itself, or its segments."""
    for node in chain.nodes:
        own, _, part = node.name.rpartition(".")
        if node.name == name or (own == name and (part == "root" or part.isdigit())):
            yield node


def link_rows(robot: Robot, chain: Chain) -> list[dict[str, Any]]:
    """Each link: model, length, masses, stiffness at its root and tip, and first frequencies by itself, clamped."""
    return [_link_row(robot, chain, joint.child) for joint in robot.joints]


def _link_row(robot: Robot, chain: Chain, name: str) -> dict[str, Any]:
    nodes = [*link_nodes(chain, name)]
    bodies, bending = _bodies(nodes), [node.link for node in nodes if node.link.bends]
    row = {"name": name, "model": "rigid", "mass_kg": bodies, "length_m": None}
    if not bending:
        return row
    info = bending[0].described(bending)
    if "mass_kg" not in info:
        return row | info | _lumped_masses(robot.link(name), bodies)
    return row | info | {"mass_kg": bodies + info["beam_mass_kg"]}


def _bodies(nodes: Sequence[Node]) -> float:
    return number(sum(body.mass for node in nodes for body in node.link.all_bodies))


def link_masses(robot: Robot, chain: Chain) -> dict[str, tuple[float, float]]:
    """Mass of each link and of its beam [kg], by its name, as :func:`link_rows` has them."""
    found = {}
    for joint in robot.joints:
        nodes = [*link_nodes(chain, joint.child)]
        bodies, bending = _bodies(nodes), [node.link for node in nodes if node.link.bends]
        beam = bending[0].beam_mass if bending else 0.0
        if beam is None:
            lumped = _lumped_masses(robot.link(joint.child), bodies)
            found[joint.child] = lumped["mass_kg"], lumped["beam_mass_kg"]
        else:
            found[joint.child] = bodies + beam, beam
    return found


def _lumped_masses(link: LinkSheet, equivalent: float) -> dict[str, float]:
    """The link's own mass; and that of its model, in which 33/140 of each mode's mass is at its end."""
    own, start = sum(body.mass for body in link.bodies), 0.0
    beam_mass = 0.0
    for piece in link.beam.section_pieces() if link.beam else ():
        beam_mass += (piece.end - start) * (piece.start.mass + piece.stop.mass) / 2
        start = piece.end
    beam_mass *= link.beam.line_length if link.beam else 0.0
    return {"mass_kg": own + beam_mass, "beam_mass_kg": beam_mass, "equivalent_mass_kg": equivalent}


def gear_rows(robot: Robot, links: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Each elastic gear: stiffness, and that over EI/L of the softer bending of the link it carries.

    ``links``: the rows of :func:`link_rows`, one for each joint.
    """
    rows = []
    for joint, link in zip(robot.joints, links, strict=True):
        if joint.gear is None or not joint.is_elastic:
            continue
        stiffness = list(joint.gear.stiffness)
        bending = [link.get(f"bending_stiffness_{axis}_Nm2") for axis in ("y", "z")]
        soft = min((ends[0] for ends in bending if ends and ends[0]), default=None)
        rows.append(
            {
                "joint": joint.name,
                "stiffness": stiffness,
                "unit": joint.kind.coordinates[0].stiffness_unit,
                "torque_limits": list(joint.gear.torque_limits),
                "backlash": joint.gear.backlash,
                "damping": joint.gear.damping,
                "link": joint.child,
                "stiffness_over_EI_per_L": stiffness[0] * link["length_m"] / soft if soft else None,
            }
        )
    return rows


def parallel_rows(robot: Robot) -> list[dict[str, Any]]:
    """Each spring next to a motor or on a free joint, with the unit of its stiffness."""
    joints = [(joint, joint.spring) for joint in robot.joints if joint.spring]
    return [
        {"joint": joint.name, **spring.model_dump(), "unit": joint.kind.coordinates[0].stiffness_unit}
        for joint, spring in joints
    ]


FIRST_FREQUENCY = (0.05, 5e3)
"""Usual range of the first frequency of a bare link [Hz]."""

GEAR_OVER_LINK = (1e-2, 1e4)
"""Usual range of a gear's stiffness over EI/L of its link."""

THICK = 10.0
"""Length over the distance of the outer fibre below which shear, which is left out, would count."""


def notices(robot: Robot, chain: Chain, info: dict[str, Any], rest: Equilibrium | None) -> list[str]:
    """Sentences on what is reported of a robot, and on its rest where it has one."""
    loose = loose_links(robot.joints)
    found = [
        *_frequencies([link for link in info["links"] if link["name"] not in loose]),
        *_gears(info["gears"]),
        *_thick(chain),
    ]
    return [*found, *(rest_notices(robot, rest) if rest else ())]


def _frequencies(links: list[dict[str, Any]]) -> Iterator[str]:
    low, high = FIRST_FREQUENCY
    for link in links:
        for axis in ("y", "z"):
            value = link.get(f"bare_bend_{axis}_Hz")
            if value is not None and not low <= value <= high:
                yield (
                    f"link {link['name']}: its first frequency by itself is {value:.3g} Hz, usual are {low:g} to "
                    f"{high:g} Hz; is a unit of its stiffness, mass or length wrong (GPa, mm, g)?"
                )


def _gears(gears: list[dict[str, Any]]) -> Iterator[str]:
    low, high = GEAR_OVER_LINK
    for gear in gears:
        ratio = gear["stiffness_over_EI_per_L"]
        if ratio is not None and not low <= ratio <= high:
            yield (
                f"joint {gear['joint']}: its gear has {ratio:.3g} times the stiffness EI/L of link {gear['link']}, "
                f"usual are {low:g} to {high:g}; is it in {gear['unit']}, at the joint?"
            )


def _thick(chain: Chain) -> Iterator[str]:
    for node in chain.nodes:
        outer = node.link.outer_distance
        if outer and node.link.length / outer < THICK:
            yield (
                f"link {node.name}: {node.link.length:.3g} m long and {2 * outer:.3g} m thick: shear, which is left "
                "out, makes so short a beam softer"
            )


def rest_notices(robot: Robot, rest: Equilibrium) -> list[str]:
    """What is uncertain about a robot at rest: unstable, bent beyond its models, past a joint's limits."""
    return [*_stability(rest), *_ranges(rest), *_limits(robot, rest), *pose_notices(robot, rest)]


def pose_notices(robot: Robot, rest: Equilibrium) -> Iterator[str]:
    """What is odd about the pose: angles of more than a turn, a motion that is not steady, a base that is tilted."""
    names, units = rest.model.coordinates, rest.model.chain.units(rest.model.coordinates)
    for k in sorted({*range(len(names))} - {*rest.free.tolist()}):
        if units[names[k]] == "rad" and abs(rest.q[k]) > TURN:
            yield f"{names[k]} is held at {turned(float(rest.q[k]))}"
    if rest.unsteady:
        yield (
            "the motion at constant speed is not steady: weight, loads or other joints turn as seen by what moves; "
            "what is reported is of the pose that is held, with its joints and base moving"
        )
    turns = robot.base_motion.turns if robot.base_motion else ()
    spin = np.zeros(3) if (found := base_spin(robot)) is None else found
    if any(turn and not rate and first_value(robot, turn) for turn, rate in zip(turns, spin, strict=False)):
        yield "`base_motion` begins with a tilted base; what is reported is of the base without that tilt"


def _stability(rest: Equilibrium) -> Iterator[str]:
    if rest.lost_stability_at is not None:
        yield f"the arm buckles: it lost its stability at {rest.lost_stability_at:.4g} of its weight and loads"
    if rest.neutral:
        yield f"this equilibrium is neutral: nothing holds {' and '.join(rest.neutral)}, the arm stays where it is put"
    elif not rest.stable:
        where = f", first in {rest.unstable_modes[0].coordinate}" if rest.unstable_modes else ""
        yield f"this equilibrium is not stable: the arm does not stay there{where}"


def _ranges(rest: Equilibrium) -> Iterator[str]:
    for link in link_ranges(rest.model, rest.q):
        if link.verdict != "good":
            yield (
                f"link {link.link} bends by {link.deflection_over_length:.1%} of its length: {link.verdict} for its "
                f"model ({link.model}, angle {link.angle_rad:.3g} rad); {link.cure}"
            )


def _limits(robot: Robot, rest: Equilibrium) -> Iterator[str]:
    pose = rest.named
    for joint, name in ((each, own) for each in robot.joints for own in each.coordinates):
        if joint.limits is None or name not in pose:
            continue
        value = pose[name]
        low = -np.inf if joint.limits.lower is None else joint.limits.lower
        high = np.inf if joint.limits.upper is None else joint.limits.upper
        if not low <= value <= high:
            yield f"joint {name} stands at {value:.4g}, beyond its limits {low:g} to {high:g}"
