"""Motors, bodies and sags that look like a wrong unit: warnings with the likely factor, never errors."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmodes.kinds.links.sheet import BendingSheet
from tmodes.sheet.topology import parents, rooted_order

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = ["implausible_inertia", "implausible_motors", "implausible_sag", "masses_beyond"]

SAG = 3.0
"""Largest usual angle by which a link would sag, linearly, if the weight of what it carries pulled across it [rad]."""

CONSTANTS = (0.5, 2.0)
"""Usual ratio of a DC motor's torque constant to its back electromotive force constant, both in SI [-]."""

WEIGHT = 3 / 8
"""Share of a uniform beam's mass that bends its tip as a mass there does, at rest."""


def implausible_motors(robot: Robot) -> Iterator[str]:
    """In SI units both constants of a DC motor are the same number but for losses."""
    low, high = CONSTANTS
    rpm = 60 / (2 * math.pi)
    for joint in robot.joints:
        emf, torque = (getattr(joint.motor, name, None) for name in ("back_emf_constant", "torque_constant"))
        if not emf or not torque or low <= torque / emf <= high:
            continue
        likely = f"V/rpm (factor {rpm:.4g})" if low <= torque / (emf * rpm) <= high else "V per degree, or N*mm/A"
        name = f"joints.{joint.name}.motor"
        yield (
            f"{name}.back_emf_constant = {emf:g} and torque_constant = {torque:g} (SI) are nearly equal in real "
            f"motors; was one of them meant in {likely}?"
        )


def implausible_inertia(robot: Robot) -> Iterator[str]:
    """Bodies whose inertia is more than their mass can have within the length of the whole robot."""
    placed = [joint.origin.position for joint in robot.joints if joint.origin]
    placed += [body.center for link in robot.links for body in link.bodies]
    reach = sum(math.hypot(*place) for place in placed) + sum(
        link.beam.line_length for link in robot.links if link.beam
    )
    for link in robot.links:
        for body in link.bodies:
            largest = float(np.trace(body.inertia_matrix())) / 2
            if body.mass and reach and largest > 1.5 * body.mass * reach**2:
                path = f"links.{link.name}.bodies" + (f".{body.name}" if body.name else "")
                yield (
                    f"{path}: an inertia of {largest / 1.5:.4g} kg*m^2 is more than {body.mass:g} kg can have within "
                    "the length of the robot; was it meant in g*cm^2 (factor 1e-07) or kg*mm^2 (factor 1e-06)?"
                )


def masses_beyond(robot: Robot) -> dict[str, float]:
    """Mass [kg] of all that the tip of each link carries: its own bodies by their station, and the links behind it."""
    own = {link.name: sum(body.mass for body in link.bodies) for link in robot.links}
    beams = {link.name: _mass(link.beam) for link in robot.links if link.beam}
    at_tip = {
        link.name: sum(body.mass * (body.station**2 if link.beam else 1.0) for body in link.bodies)
        for link in robot.links
    }
    whole: dict[str, float] = {}
    beyond: dict[str, float] = {}
    names = parents(robot.joints)
    for index in reversed(rooted_order(robot.joints)):
        link, parent = robot.joints[index].child, names[index]
        beyond[link] = beyond.get(link, 0.0) + at_tip.get(link, 0.0)
        whole[link] = whole.get(link, 0.0) + own.get(link, 0.0) + beams.get(link, 0.0)
        whole[parent] = whole.get(parent, 0.0) + whole[link]
        beyond[parent] = beyond.get(parent, 0.0) + whole[link]
    return beyond


def _mass(beam: BendingSheet) -> float:
    """Mass of a beam [kg]."""
    total, start = 0.0, 0.0
    for piece in beam.section_pieces():
        total += (piece.end - start) * beam.line_length * (piece.start.mass + piece.stop.mass) / 2
        start = piece.end
    return total


def implausible_sag(robot: Robot, name: str, beam: BendingSheet, beyond: float) -> Iterator[str]:
    """A link that sags beyond reason even in its stiffer direction, with the mass ``beyond`` [kg] at its tip."""
    mass = beyond + WEIGHT * _mass(beam)
    sag = mass * math.hypot(*robot.gravity) * _compliance(beam) / beam.line_length
    if beam.coordinate_count and sag > SAG:
        likely = "masses in g (factor 0.001), lengths in mm (factor 0.001), or E in MPa or GPa (factor 1e+06 or 1e+09)"
        yield f"links.{name}.beam sags by {sag:.3g} rad under the weight of {mass:.3g} kg; were {likely} meant?"


def _compliance(beam: BendingSheet) -> float:
    """Deflection of the tip per force across it [m/N], clamped at the root, in the stiffer direction of each piece."""
    total, start = 0.0, 0.0
    for piece in beam.section_pieces():
        stiffness = max(piece.start.bend_y, piece.start.bend_z, piece.stop.bend_y, piece.stop.bend_z)
        total += ((1 - start) ** 3 - (1 - piece.end) ** 3) / (3 * stiffness)
        start = piece.end
    return total * beam.line_length**3
