"""Rows of the tables of ``tmodes describe``: joints, links and gears of an arm."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmodes.analysis.describe.bare import bare_beam
from tmodes.chain.chain import Beam, Body, Chain, Node, Segment
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
    bodies = sum(body.mass for node in nodes for body in _bodies(node))
    beam = next((node.link for node in nodes if isinstance(node.link, Beam)), None)
    segments = [node.link for node in nodes if isinstance(node.link, Segment)]
    row = {"name": name, "model": "rigid", "mass_kg": float(bodies), "length_m": None}
    if beam:
        return row | _beam_numbers(beam, bodies)
    if segments:
        return row | _segment_numbers(segments) | _segment_masses(arm.link(name), float(bodies))
    return row


def _bodies(node: Node) -> list[Body]:
    return list(node.link.all_bodies)


def _beam_numbers(beam: Beam, bodies: float) -> dict[str, Any]:
    first, last = beam.pieces[0], beam.pieces[-1]
    bare = bare_beam(beam)
    return {
        "model": "strain",
        "functions": {"twist": beam.twist, "bend_y": beam.bend_y, "bend_z": beam.bend_z, "stretch": beam.stretch},
        "basis": beam.basis,
        "length_m": beam.length,
        "mass_kg": float(bodies) + bare.mass,
        "beam_mass_kg": bare.mass,
        "bending_stiffness_y_Nm2": _ends(first.bend_y[0], last.bend_y[1]),
        "bending_stiffness_z_Nm2": _ends(first.bend_z[0], last.bend_z[1]),
        "torsional_stiffness_Nm2": _ends(first.torsion[0], last.torsion[1]),
        "axial_stiffness_N": _ends(first.axial[0], last.axial[1]),
        "tip_stiffness_y_N_per_m": _over(bare.compliance[0]),
        "tip_stiffness_z_N_per_m": _over(bare.compliance[1]),
        "bare_bend_y_Hz": bare.bend_y_Hz,
        "bare_bend_z_Hz": bare.bend_z_Hz,
        "bare_twist_Hz": bare.twist_Hz,
        "damping_time_s": beam.damping_time,
    }


def _ends(first: float, last: float) -> list[float | None]:
    """Values at root and tip; None: rigid."""
    return [x if np.isfinite(x) else None for x in (first, last)]


def _over(compliance: float) -> float | None:
    return 1 / compliance if compliance > 0 else None


def _segment_numbers(segments: list[Segment]) -> dict[str, Any]:
    """Segments in a row; EI from their tip stiffness 3 EI/l^3."""
    first, last = segments[0], segments[-1]
    stiffness = [
        [getattr(one, f"stiffness_{axis}") * one.length**3 / 3 for one in (first, last)] for axis in ("y", "z")
    ]
    return {
        "model": f"segments ({len(segments)})",
        "length_m": sum(one.length for one in segments),
        "bending_stiffness_y_Nm2": _ends(*stiffness[0]),
        "bending_stiffness_z_Nm2": _ends(*stiffness[1]),
    }


def _segment_masses(link: LinkSheet, equivalent: float) -> dict[str, float]:
    """The link's own mass; and that of its model, in which 33/140 of each segment's mass stands at its tip."""
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
