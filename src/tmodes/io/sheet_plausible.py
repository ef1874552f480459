"""Numbers of a robot that are allowed and yet look like a wrong unit: warnings with the likely factor, never errors."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import named, quantities
from tmodes.kinds.links.sheet import BendingSheet
from tmodes.kinds.schema.frames import TURN, Convention, Origin
from tmodes.sheet import Robot
from tmodes.sheet.checks import coordinate_count
from tmodes.sheet.topology import loose_links, parents, rooted_order

__all__ = ["implausible_beams", "implausible_numbers", "notices_about", "reading_notices", "turned"]

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


GRAVITY = 30.0
"""Largest usual gravity [m/s^2]: that of Jupiter is 24.8."""

TURNS = 4 * math.pi
"""Largest usual angle of a joint in a motion [rad]: two turns; beyond, degrees are likely."""

TRAVEL = 50.0
"""Largest usual position of a prismatic joint [m]."""

MANY = 60
"""Number of coordinates beyond which every answer takes its time."""

LEVELS = ("value", "start", "end", "amplitude", "offset", "values")
"""Keys of a signal that are values of it, of whatever type it is."""

CONSTANTS = (0.5, 2.0)
"""Usual ratio of a DC motor's torque constant to its back electromotive force constant, both in SI [-]."""

SLIPS = {
    "m": {1e-3: "mm", 1e-2: "cm"},
    "kg": {1e-3: "g", 1e3: "t"},
    "kg/m": {1e-3: "g/m", 1e3: "kg/mm"},
    "kg*m^2": {1e-7: "g*cm^2", 1e-6: "kg*mm^2", 1e-4: "kg*cm^2"},
    "N*m^2": {1e-6: "N*mm^2", 1e9: "GPa for Pa in E", 1e6: "MPa for Pa in E"},
    "N*m/rad": {180 / math.pi: "N*m/deg", 1e-3: "N*mm/rad"},
    "rad": {math.pi / 180: "deg"},
    "s": {1e-3: "ms"},
    "m/s": {1e-3: "mm/s"},
    "m/s^2": {1e-2: "cm/s^2"},
    "Pa": {1e9: "GPa", 1e6: "MPa"},
    "kg/m^3": {1e3: "g/cm^3"},
    "ohm": {1e-3: "mohm"},
}
"""Factor from a unit that people write by mistake to the unit of the sheet."""


def notices_about(sheet: Robot) -> list[str]:
    """Sentences on numbers that look like a wrong unit, and on what was corrected when the sheet was read."""
    return [*implausible_numbers(sheet), *reading_notices(sheet)]


def implausible_numbers(robot: Robot) -> list[str]:
    """Sentences on numbers that look like a wrong unit, each with the likely factor; empty when all look right."""
    checks = (_ranges, implausible_beams, _motors, _inertia, _motion)
    return [sentence for check in checks for sentence in check(robot)]


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
    return [
        *(one for one in robot.notices if one not in robot.assumed),
        *(f"{path}: {notice}" for path, notice in info.items() if notice),
    ]


def _ranges(robot: Robot) -> Iterator[str]:
    data = sheet_data(robot)
    for container, key, steps, place in quantities(data):
        value = float(container[key])
        odd = _oddity(value, place.unit or "-", place.extra.get("plausible"))
        if odd and value != 0.0:
            yield f"{named(steps, data)} {odd}"


def _motors(robot: Robot) -> Iterator[str]:
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


def _inertia(robot: Robot) -> Iterator[str]:
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


def _motion(robot: Robot) -> Iterator[str]:
    """Sentences on gravity, motions and limits that look like a wrong unit, and on a robot of very many coordinates."""
    if (pull := math.hypot(*robot.gravity)) > GRAVITY:
        yield f"gravity {_oddity(pull, 'm/s^2', (0.0, GRAVITY))}"
    yield from _limits(robot)
    yield from _initial(robot)
    yield from _signals(robot)
    if (count := coordinate_count(robot)) > MANY:
        info = "each answer takes long; fewer functions or segments will do for most links"
        yield f"the arm has {count} coordinates, more than {MANY}: {info}"


def turned(angle: float) -> str:
    """An angle [rad] of many turns, with the question whether degrees were meant."""
    turns = f"{angle:g} rad, {abs(angle) / (2 * math.pi):.3g} turns"
    return f'{turns}; was it meant in deg (factor {math.pi / 180:.4g})? Then write "{angle:g} deg"'


def _limits(robot: Robot) -> Iterator[str]:
    for joint in robot.joints:
        for name in ("lower", "upper") if joint.limits else ():
            value = getattr(joint.limits, name) or 0.0
            path = f"joints.{joint.name}.limits.{name}"
            if joint.unit == "m" and abs(value) > TRAVEL:
                yield _far(path, value)
            elif joint.unit == "rad" and abs(value) > TURNS and _as_degrees(value):
                yield f"{path} is {turned(value)}"


def _as_degrees(angle: float) -> bool:
    """Whether a number looks like degrees: a whole one of at most two turns."""
    return angle.is_integer() and abs(angle) <= math.degrees(TURNS)


def _initial(robot: Robot) -> Iterator[str]:
    turning = {name for joint in robot.joints if joint.unit == "rad" for name in joint.coordinates}
    for name, value in robot.initial.coordinates.items():
        if name.removesuffix(".motor") in turning and abs(value) > TURN:
            yield f"initial.coordinates.{name} is {turned(value)}"


def _signals(robot: Robot) -> Iterator[str]:
    units = {name: joint.unit for joint in robot.joints for name in joint.coordinates}
    for index, drive in enumerate(robot.drives):
        if not drive.command.is_motion:
            continue
        path, slides = f"drives.{index} (`{drive.joint}`)", units[drive.joint] == "m"
        value = _largest(drive.signal)
        if slides and abs(value) > TRAVEL:
            yield _far(f"{path}.signal", value)
        elif not slides and abs(value) > TURNS:
            yield f"{path}.signal goes to {turned(value)}"


def _far(path: str, value: float) -> str:
    slip = "was it meant in mm (factor 0.001)?" if abs(value) * 1e-3 <= TRAVEL else "is the unit right?"
    return f"{path} = {value:g} m is more than the usual {TRAVEL:g} m; {slip}"


def _largest(signal: Any) -> float:
    """The value of a signal with the largest magnitude, by its numbers; 0 where it has none (an expression)."""
    found = [getattr(signal, name, None) for name in LEVELS]
    values = [0.0, *(value for value in found if isinstance(value, float))]
    values += [value for table in found if isinstance(table, tuple) for value in table]
    return max(values, key=abs)


def _oddity(value: float, unit: str, plausible: Sequence[float] | None) -> str | None:
    """What is odd about a number outside the plausible range of its field, with the likely factor; None inside.

    A negative damping is given in words of its own: it is allowed, as in a model of chatter or flutter.
    """
    low, high = plausible or (-math.inf, math.inf)
    if low <= value <= high or math.isinf(value):
        return None
    if value < 0.0 == low:
        return f"= {value:g} {unit} is negative: it feeds energy into the motion; was a damping meant?"
    slips = SLIPS.get(unit, {})
    likely = next((f"{name} (factor {k:.4g})" for k, name in slips.items() if low <= k * value <= high), None)
    guess = f"; was it meant in {likely}?" if likely else "; is the unit right?"
    return f"= {value:g} {unit} is outside the usual {low:g} to {high:g}{guess}"
