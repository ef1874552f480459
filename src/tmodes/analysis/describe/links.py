"""Rows of the tables of ``tmodes describe``: joints, links and gears of an arm."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tmodes.chain.chain import Chain, Node
from tmodes.kinds.joints.joint import JointSheet
from tmodes.sheet import Robot
from tmodes.sheet.parts import LinkSheet

__all__ = ["gear_rows", "joint_rows", "link_nodes", "link_rows"]


def joint_rows(arm: Robot) -> list[dict[str, Any]]:
    """Each joint: its type in the group's letters (active or locked, elastic or rigid gear), drive and limits."""
    commands = {drive.joint: str(drive.command) for drive in arm.drives}
    return [
        {
            "name": joint.name,
            "type": str(joint.type),
            "kind": _letters(joint),
            "carries": joint.child,
            "motor": joint.motor is not None,
            "command": commands.get(joint.name),
            "lower": joint.limits.lower if joint.limits else None,
            "upper": joint.limits.upper if joint.limits else None,
            "unit": joint.unit,
        }
        for joint in arm.joints
    ]


def _letters(joint: JointSheet) -> str:
    """AE, LE, AR or LR; a fixed joint is LR: locked and rigid."""
    active = joint.is_active and joint.kind.moves
    return f"{'A' if active else 'L'}{'E' if joint.is_elastic else 'R'}"


def link_nodes(chain: Chain, name: str) -> Iterator[Node]:
    """The nodes of a chain that one link of a data sheet became: its root, itself, or its segments."""
    for node in chain.nodes:
        own, _, part = node.name.rpartition(".")
        if node.name == name or (own == name and (part == "root" or part.isdigit())):
            yield node


def link_rows(arm: Robot, chain: Chain) -> list[dict[str, Any]]:
    """Each link: model, length, masses, stiffness at its root and tip, and first frequencies by itself, clamped."""
    return [_link_row(arm, chain, joint.child) for joint in arm.joints]


def _link_row(arm: Robot, chain: Chain, name: str) -> dict[str, Any]:
    nodes = [*link_nodes(chain, name)]
    bodies = float(sum(body.mass for node in nodes for body in node.link.all_bodies))
    bending = [node.link for node in nodes if node.link.bends]
    row = {"name": name, "model": "rigid", "mass_kg": bodies, "length_m": None}
    if not bending:
        return row
    info = bending[0].described(bending)
    if "mass_kg" not in info:
        return row | info | _lumped_masses(arm.link(name), bodies)
    return row | info | {"mass_kg": bodies + info["beam_mass_kg"]}


def _lumped_masses(link: LinkSheet, equivalent: float) -> dict[str, float]:
    """The link's own mass; and that of its model, in which 33/140 of each mode's mass is at its end."""
    own, start = sum(body.mass for body in link.bodies), 0.0
    beam_mass = 0.0
    for piece in link.beam.section_pieces() if link.beam else ():
        beam_mass += (piece.end - start) * (piece.start.mass + piece.stop.mass) / 2
        start = piece.end
    beam_mass *= link.beam.line_length if link.beam else 0.0
    return {"mass_kg": own + beam_mass, "beam_mass_kg": beam_mass, "equivalent_mass_kg": equivalent}


def gear_rows(arm: Robot, links: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Each elastic gear: stiffness, and that over EI/L of the softer bending of the link it carries.

    ``links``: the rows of :func:`link_rows`, one for each joint.
    """
    rows = []
    for joint, link in zip(arm.joints, links, strict=True):
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
