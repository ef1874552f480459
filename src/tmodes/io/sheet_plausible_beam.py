"""Beams of a robot whose numbers look like a wrong unit: warnings with the likely factor, never errors."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmodes.kinds.links.sheet import BendingSheet
from tmodes.kinds.schema.frames import Convention
from tmodes.sheet import Robot
from tmodes.sheet.topology import loose_links, parents, rooted_order

__all__ = ["implausible_beams"]

SLENDERNESS = (5.0, 1000.0)
"""Range of the length of a beam over the height of its section [-]: thicker ones shear, thinner ones are threads."""

CLAMPED_FREE = 1.8751040687119611
"""First root of cos x cosh x = -1: a clamped bare beam has 2 pi f = (x/L)^2 sqrt(EI/w)."""

FREE_FREE = 4.730040744862704
"""First root of cos x cosh x = 1, of one with both ends free."""

FIRST_FREQUENCY = (0.05, 5e3)
"""Range of the bending frequency of a mode that carries everything beyond it [Hz]."""

DENSITY_OVER_MODULUS = (3e-8, 3.0)
"""Range of rho^2/E of a round rod [kg^2/(N*m^4)]: steel 3e-4, nylon 5e-4, rubber 0.3; as if round: carbon tube 1e-6."""

SAG = 3.0
"""Largest usual angle by which a link would sag, linearly, if the weight of what it carries pulled across it [rad]."""

WEIGHT = 3 / 8
"""Share of a uniform beam's mass that bends its tip as a mass there does, at rest."""


def implausible_beams(robot: Robot) -> Iterator[str]:
    """Sentences on each beam, and what its own sheet has to say."""
    beyond, loose = _masses_beyond(robot), loose_links(robot.joints)
    for link in robot.links:
        if link.beam:
            yield from _beam(robot, link.name, link.beam, None if link.name in loose else beyond[link.name])
            yield from _swapped(robot, link.name, link.beam)
            yield from (f"links.{link.name}.beam{notice}" for notice in link.beam.notices())


def _beam(robot: Robot, name: str, beam: BendingSheet, beyond: float | None) -> Iterator[str]:
    """The first of what is strange about a beam: the others follow from it.

    ``beyond``: mass [kg] at its tip; None where nothing holds its root, so that no weight bends it as if clamped.
    """
    if not beam.section_pieces():
        return
    found = [*_slenderness(name, beam), *_material(name, beam), *_frequency(name, beam, clamped=beyond is not None)]
    yield from [*found, *(() if beyond is None else _sag(robot, name, beam, beyond))][:1]


def _swapped(robot: Robot, name: str, beam: BendingSheet) -> Iterator[str]:
    """A flat section that its joint turns in its stiff direction: its sides, or stiffnesses, may be exchanged."""
    joint = next(one for one in robot.joints if one.child == name)
    axis = joint.axis or ((0.0, 0.0, 1.0) if joint.dh and joint.dh.convention is not Convention.STANDARD else None)
    if axis is None or not beam.section_pieces() or "root_mount" in beam.mounts:
        return
    root = beam.section_pieces()[0].start
    about = {"y": root.bend_y, "z": root.bend_z}
    main = next(
        (letter for letter, part in zip("yz", axis[1:], strict=True) if abs(part) > 0.9 * math.hypot(*axis)), ""
    )
    ratio = about[main] / min(about.values()) if main else 1.0
    if FLAT < ratio < math.inf:
        other = "z" if main == "y" else "y"
        yield (
            f"links.{name}.beam is {ratio:.3g} times as stiff in bending about {main}, about which `{joint.name}` "
            f"turns it, as about {other}; a width is along y, a height along z: are they, or EI_y and EI_z, exchanged?"
        )


FLAT = 100.0
"""Ratio of the stiffnesses of both bending directions from which they may be exchanged [-]."""


def _slenderness(name: str, beam: BendingSheet) -> Iterator[str]:
    root = beam.section_pieces()[0].start
    height = 2 * max(root.outer_y, root.outer_z)
    low, high = SLENDERNESS
    if not height or not beam.coordinate_count or low <= beam.line_length / height <= high:
        return
    ratio = beam.line_length / height
    slip = "length in mm (factor 0.001)" if ratio > high else "section in mm (factor 0.001)"
    scaled = ratio * (1e-3 if ratio > high else 1e3)
    guess = f"was its {slip} meant?" if low <= scaled <= high else "are its length and its section both in m?"
    yield f"links.{name}.beam is {ratio:.3g} times as long as high, outside the usual {low:g} to {high:g}; {guess}"


def _material(name: str, beam: BendingSheet) -> Iterator[str]:
    """Of a round rod w^2/(4 pi EI) is rho^2/E; by the mean of both directions, other shapes come near it."""
    root: Any = beam.section_pieces()[0].start
    low, high = DENSITY_OVER_MODULUS
    stiffness = math.sqrt(root.bend_y) * math.sqrt(root.bend_z)
    ratio = root.mass**2 / (4 * math.pi * stiffness)
    if math.isinf(stiffness) or low <= ratio <= high:
        return
    heavy = "mass or density in g (factor 0.001), or E in MPa or GPa (factor 1e+06 or 1e+09)"
    light = "stiffness in N*mm^2 (factor 1e-06), or density in g/cm^3 (factor 1000)"
    info = f"EI = {stiffness:g} N*m^2 and {root.mass:g} kg/m"
    yield f"links.{name}.beam with {info} is of no known material; was its {heavy if ratio > high else light} meant?"


def _frequency(name: str, beam: BendingSheet, *, clamped: bool) -> Iterator[str]:
    low, high = FIRST_FREQUENCY
    root: Any = beam.section_pieces()[0].start
    stiffness = min(root.bend_y, root.bend_z)
    if math.isinf(stiffness) or not beam.coordinate_count:
        return
    root_of_ends, ends = (CLAMPED_FREE, "clamped") if clamped else (FREE_FREE, "with free ends")
    frequency = (root_of_ends / beam.line_length) ** 2 * math.sqrt(stiffness / root.mass) / (2 * math.pi)
    if not low <= frequency <= high:
        factors = {1e6: "length in mm (factor 0.001)", math.sqrt(1e9): "E in GPa (factor 1e+09)"}
        factors |= {1e3: "E in MPa (factor 1e+06)", 1e-3: "stiffness in N*mm^2 (factor 1e-06)"}
        likely = next((info for factor, info in factors.items() if low <= factor * frequency <= high), None)
        guess = f"was its {likely} meant?" if likely else "are its length, stiffness and mass in SI units?"
        usual = f"outside the usual {low:g} to {high:g} Hz"
        yield f"links.{name}.beam, {ends}, swings at {frequency:.3g} Hz, {usual}; {guess}"


def _masses_beyond(robot: Robot) -> dict[str, float]:
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


def _sag(robot: Robot, name: str, beam: BendingSheet, beyond: float) -> Iterator[str]:
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
