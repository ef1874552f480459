"""Numbers of a robot that are allowed and yet look like a wrong unit: warnings with the likely factor, never errors."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import named, quantities
from tmodes.io.sheet_plausible_motion import DENSITY_OVER_MODULUS, FIRST_FREQUENCY, implausible_motion, oddity
from tmodes.io.sheet_plausible_parts import implausible_inertia, implausible_motors, implausible_sag, masses_beyond
from tmodes.kinds.links.sheet import BendingSheet
from tmodes.kinds.schema.frames import Origin

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = ["implausible_numbers", "notices_about", "reading_notices"]

SLENDERNESS = (5.0, 1000.0)
"""Range of the length of a beam over the height of its section [-]: thicker ones shear, thinner ones are threads."""

CLAMPED_FREE = 1.8751040687119611
"""First root of cos x cosh x = -1: a clamped bare beam has 2 pi f = (x/L)^2 sqrt(EI/w)."""


def implausible_numbers(robot: Robot) -> list[str]:
    """Sentences on numbers that look like a wrong unit, each with the likely factor; empty when all look right."""
    beams, beyond = [(link.name, link.beam) for link in robot.links if link.beam], masses_beyond(robot)
    found = (
        sentence
        for name, beam in beams
        for sentence in (
            *_beam(robot, name, beam, beyond[name]),
            *(f"links.{name}.beam{notice}" for notice in beam.notices()),
        )
    )
    return [
        *_ranges(robot),
        *found,
        *implausible_motors(robot),
        *implausible_inertia(robot),
        *implausible_motion(robot),
    ]


def reading_notices(robot: Robot) -> list[str]:
    """Sentences on what was put right in reading the robot: directions and quaternions not of length 1."""
    places: dict[str, Origin | None] = {"base": robot.base, "tip": robot.tip}
    places |= {f"points.{point.name}": point for point in robot.points}
    places |= {f"joints.{joint.name}.origin": joint.origin for joint in robot.joints}
    for link in robot.links:
        if link.beam:
            places |= {f"links.{link.name}.beam.{name}": origin for name, origin in link.beam.mounts.items()}
    info = {path: origin.notice() for path, origin in places.items() if origin}
    info |= {f"joints.{joint.name}.axis": joint.notice() for joint in robot.joints}
    return [f"{path}: {notice}" for path, notice in info.items() if notice]


def _ranges(robot: Robot) -> Iterator[str]:
    data = sheet_data(robot)
    for container, key, steps, place in quantities(data):
        value = float(container[key])
        odd = oddity(value, place.unit or "-", place.extra.get("plausible"))
        if odd and value != 0.0:
            yield f"{named(steps, data)} {odd}"


def _beam(robot: Robot, name: str, beam: BendingSheet, beyond: float) -> Iterator[str]:
    """The first of what is strange about a beam: the others follow from it."""
    if not beam.section_pieces():
        return
    found = [*_slenderness(name, beam), *_material(name, beam), *_frequency(name, beam)]
    yield from [*found, *implausible_sag(robot, name, beam, beyond)][:1]


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


def _frequency(name: str, beam: BendingSheet) -> Iterator[str]:
    low, high = FIRST_FREQUENCY
    root: Any = beam.section_pieces()[0].start
    stiffness = min(root.bend_y, root.bend_z)
    if math.isinf(stiffness) or not beam.coordinate_count:
        return
    frequency = (CLAMPED_FREE / beam.line_length) ** 2 * math.sqrt(stiffness / root.mass) / (2 * math.pi)
    if not low <= frequency <= high:
        factors = {1e6: "length in mm (factor 0.001)", math.sqrt(1e9): "E in GPa (factor 1e+09)"}
        factors |= {1e3: "E in MPa (factor 1e+06)", 1e-3: "stiffness in N*mm^2 (factor 1e-06)"}
        likely = next((info for factor, info in factors.items() if low <= factor * frequency <= high), None)
        guess = f"was its {likely} meant?" if likely else "are its length, stiffness and mass in SI units?"
        usual = f"outside the usual {low:g} to {high:g} Hz"
        yield f"links.{name}.beam, clamped, swings at {frequency:.3g} Hz, {usual}; {guess}"


def notices_about(sheet: Robot) -> list[str]:
    """Sentences on numbers that look like a wrong unit, and on what was corrected when the sheet was read."""
    return [*implausible_numbers(sheet), *reading_notices(sheet)]
