"""What a robot does and how large it is, where that looks like a slip: warnings, never errors."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from tmodes.sheet.checks import coordinate_count

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = ["DENSITY_OVER_MODULUS", "FIRST_FREQUENCY", "implausible_motion", "oddity"]

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


def implausible_motion(robot: Robot) -> Iterator[str]:
    """Sentences on gravity, motions and limits that look like a wrong unit, and on a robot of very many coordinates."""
    pull = math.hypot(*robot.gravity)
    if pull > GRAVITY:
        yield f"gravity {oddity(pull, 'm/s^2', (0.0, GRAVITY))}"
    yield from _limits(robot)
    yield from _signals(robot)
    if (count := coordinate_count(robot)) > MANY:
        info = "each answer takes long; fewer functions or segments will do for most links"
        yield f"the arm has {count} coordinates, more than {MANY}: {info}"


def _limits(robot: Robot) -> Iterator[str]:
    for joint in robot.joints:
        if joint.unit == "m" and joint.limits:
            for name in ("lower", "upper"):
                value = getattr(joint.limits, name)
                if value is not None and abs(value) > TRAVEL:
                    yield _far(f"joints.{joint.name}.limits.{name}", value)


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
            turned = f"{value:g} rad, {abs(value) / (2 * math.pi):.3g} turns"
            yield f"{path}.signal goes to {turned}; was it meant in deg (factor {math.pi / 180:.4g})?"


def _far(path: str, value: float) -> str:
    slip = "was it meant in mm (factor 0.001)?" if abs(value) * 1e-3 <= TRAVEL else "is the unit right?"
    return f"{path} = {value:g} m is more than the usual {TRAVEL:g} m; {slip}"


def _largest(signal: Any) -> float:
    """The value of a signal with the largest magnitude, by its numbers; 0 where it has none (an expression)."""
    found = [getattr(signal, name, None) for name in LEVELS]
    values = [0.0, *(value for value in found if isinstance(value, float))]
    values += [value for table in found if isinstance(table, tuple) for value in table]
    return max(values, key=abs)


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

FIRST_FREQUENCY = (0.05, 5e3)
"""Range of the bending frequency of a mode that carries everything beyond it [Hz]."""

DENSITY_OVER_MODULUS = (3e-8, 3.0)
"""Range of rho^2/E of a round rod [kg^2/(N*m^4)]: steel 3e-4, nylon 5e-4, rubber 0.3; as if round: carbon tube 1e-6."""


def oddity(value: float, unit: str, plausible: Sequence[float] | None) -> str | None:
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
