"""Numbers that are allowed and yet look like a wrong unit: warnings with the likely factor, never errors."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmodes.io.fields import places
from tmodes.paper.mode import FlexibleMode
from tmodes.paper.sheet import PaperRobot

__all__ = ["implausible", "oddity"]

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

SAG = 1.0
"""Largest static bending angle under the weight of what a mode carries [rad]."""


def implausible(robot: PaperRobot) -> list[str]:
    """Sentences on numbers that look like a wrong unit, each with the likely factor; empty when all look right."""
    sentences = [*_ranges(robot), *_motor(robot), *_inertia(robot)]
    for index, (mode, mass) in enumerate(_carried(robot)):
        name = f"link.modes.{index}"
        if not any(sentence.startswith(name) for sentence in sentences):
            found = (*_section(name, mode), *_sag(name, mode, mass, robot.gravity), *_frequency(name, mode, mass))
            sentences.extend(found[:1])
    return sentences


def oddity(value: float, unit: str, plausible: Sequence[float] | None) -> str | None:
    """What is odd about a number outside the plausible range of its field, with the likely factor; None inside.

    A negative damping is told in words of its own: it is allowed, as in a model of chatter or flutter.
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


def _ranges(robot: PaperRobot) -> Iterator[str]:
    values = dict(robot.numbers())
    values |= {"reference.start": robot.reference.start, "reference.end": robot.reference.end}
    for path, value in values.items():
        place = places()[path]
        if odd := oddity(value, place.unit or "-", place.extra["plausible"]):
            yield f"{path} {odd}"


def _motor(robot: PaperRobot) -> Iterator[str]:
    """In SI units both constants of a DC motor are the same number but for losses."""
    emf, torque = robot.motor.back_emf_constant, robot.motor.torque_constant
    if not 0.5 <= torque / emf <= 2.0:
        rpm = 60 / (2 * math.pi)
        likely = f"V/rpm (factor {rpm:.4g})" if 0.5 <= torque / (emf * rpm) <= 2.0 else "V per degree, or N*mm/A"
        yield (
            f"motor.back_emf_constant = {emf:g} V*s/rad and motor.torque_constant = {torque:g} N*m/A are nearly equal "
            f"in real motors; was one of them meant in {likely}?"
        )


def _carried(robot: PaperRobot) -> Iterator[tuple[FlexibleMode, float]]:
    """Each mode that bends, and the mass at its tip and beyond [kg]."""
    first, second = robot.link.modes
    beyond = second.tip_mass + robot.payload.mass
    yield first, first.tip_mass + beyond
    yield second, beyond


def _section(name: str, mode: FlexibleMode) -> Iterator[str]:
    """A round rod has w^2/(4 pi EI) = rho^2/E whatever its thickness; tubes and strips are not far from it."""
    if math.isinf(mode.bending_stiffness):
        return
    low, high = DENSITY_OVER_MODULUS
    ratio = mode.mass_per_length**2 / (4 * math.pi * mode.bending_stiffness)
    heavy = "mass_per_length in g/m (factor 0.001), or E in MPa or GPa (factor 1e+06 or 1e+09)"
    stiff = "bending_stiffness in N*mm^2 (factor 1e-06), or mass_per_length in kg/mm (factor 1000)"
    if not low <= ratio <= high:
        yield (
            f"{name}: a rod with bending_stiffness = {mode.bending_stiffness:g} N*m^2 and mass_per_length "
            f"= {mode.mass_per_length:g} kg/m is of no known material; was {heavy if ratio > high else stiff} meant?"
        )


def _sag(name: str, mode: FlexibleMode, mass: float, gravity: float) -> Iterator[str]:
    sag = mass * gravity / (mode.tip_stiffness * mode.length)
    if sag > SAG:
        likely = "masses in g (factor 0.001), lengths in mm (factor 0.001), or E in MPa or GPa (factor 1e+06 or 1e+09)"
        yield f"{name} sags by {sag:.3g} rad under the weight of {mass:.3g} kg; were {likely} meant?"


def _frequency(name: str, mode: FlexibleMode, mass: float) -> Iterator[str]:
    low, high = FIRST_FREQUENCY
    frequency = math.sqrt(mode.tip_stiffness / mass) / (2 * math.pi)
    if not low <= frequency <= high and not math.isinf(frequency):
        usual = f"outside the usual {low:g} to {high:g} Hz"
        yield f"{name} bends at {frequency:.3g} Hz, {usual}; are its length, EI and masses in SI units?"


def _inertia(robot: PaperRobot) -> Iterator[str]:
    payload = robot.payload
    length = sum(mode.length for mode in robot.link.modes)
    if payload.inertia > payload.mass * length**2:
        likely = "g*cm^2 (factor 1e-07) or kg*mm^2 (factor 1e-06)"
        yield (
            f"payload.inertia = {payload.inertia:g} kg*m^2 is more than {payload.mass:g} kg can have within the length "
            f"of the arm; was it meant in {likely}?"
        )
