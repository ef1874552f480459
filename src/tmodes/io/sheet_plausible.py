"""Numbers of a robot that are allowed and yet look like a wrong unit: warnings with the likely factor, never errors."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import named, quantities
from tmodes.io.sheet_plausible_beam import implausible_beams
from tmodes.kinds.schema.frames import TURN, Origin
from tmodes.sheet import Robot
from tmodes.sheet.checks import coordinate_count

__all__ = ["implausible_numbers", "notices_about", "reading_notices", "turned"]

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
