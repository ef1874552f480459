"""Scalars of a file or the command line: bare words of YAML 1.2, numbers, and numbers with their unit (``"600 mm"``).

Text is held against a closed grammar before the unit library sees it: a number and a few unit words, with ``*``, ``/``,
one-digit powers and one level of parentheses; :mod:`tmodes.io.unit_words` says what people write for these. Inside
tmodes every number is a plain float in SI units.
"""

from __future__ import annotations

import math
import re
from contextlib import suppress
from dataclasses import dataclass
from functools import cache, lru_cache
from numbers import Real
from typing import Any

from tmodes.errors import InputError
from tmodes.io.unit_words import UNIT, angles, cyclic, grains, guesses, readings, spelt
from tmodes.io.words import shown

__all__ = [
    "EVERYDAY",
    "FLOAT",
    "NotANumber",
    "finite_float",
    "finite_number",
    "library_factor",
    "number",
    "scalar",
    "udunits",
]

NUMBER = r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?"
FLOAT = re.compile(NUMBER)
COMMA = re.compile(r"([-+]?[0-9]+),([0-9]+)([^,]*)")
INFINITE = re.compile(r"[-+]?\.?(inf|Inf|INF|infinity|Infinity)")
LONGEST = 80

EVERYDAY = {
    "m": {"mm": 1e-3, "cm": 0.01, "um": 1e-6},
    "rad": {"mrad": 1e-3, "deg": math.pi / 180},
    "kg": {"g": 1e-3},
    "s": {"ms": 1e-3},
    "m/s": {"mm/s": 1e-3},
    "rad/s": {"deg/s": math.pi / 180},
    "N": {"kN": 1e3},
    "N*m": {"N*mm": 1e-3},
    "N*m/rad": {"N*m": 1.0},
    "N*m*s/rad": {"N*m*s": 1.0},
    "Pa": {"kPa": 1e3, "MPa": 1e6, "GPa": 1e9},
    "-": {"percent": 0.01},
}
"""Factors as the unit library gives them, by unit of the place and text: it takes half a second to load."""


def udunits(unit: str) -> str:
    """A unit as files for other programs write it (UDUNITS): ``N*m/s^2`` is ``N m s-2``, no unit is 1."""
    above, *below = unit.replace("^", "").replace("*", " ").split("/")
    words = [
        *above.replace("-", "1").split(),
        *(f"{one.rstrip('23')}-{one[-1] if one[-1] in '23' else 1}" for one in below),
    ]
    return " ".join(word for word in words if word != "1") or "1"


@dataclass
class NotANumber(ValueError):
    """What is wrong with a value where a number belongs, and how to fix it."""

    got: str
    hint: str


def number(value: Any, unit: str) -> float:
    """The number in SI units that a value from a file stands for; ``unit`` is the place's own, ``-`` for none.

    Infinite values pass (whether they may, the place decides); raises :class:`NotANumber`.
    """
    if isinstance(value, str):
        return _from_text(" ".join(value.split()), unit)
    if isinstance(value, bool) or not isinstance(value, Real):
        hint = f"write the number{_in(unit)} after the colon" if value is None else f"write one number{_in(unit)}"
        boolean = "write a number; true and false are not numbers"
        raise NotANumber(shown(value), boolean if isinstance(value, bool) else hint)
    try:
        result = float(value)
    except OverflowError:
        raise NotANumber(shown(value), "write a smaller number") from None
    if math.isnan(result):
        raise NotANumber(".nan (not a number)", "write a finite number")
    return result


def finite_number(
    which: str, value: Any, unit: str, expected: str = "a finite number", *, most: float = math.inf
) -> float:
    """As :func:`number`, of finite size at most ``most``; raises :class:`tmodes.errors.InputError` that names it."""
    wanted = expected if unit == "-" else f"{expected} [{unit}]"
    try:
        found = number(value.item() if getattr(value, "shape", None) == () else value, unit)
    except NotANumber as error:
        raise InputError(which, error.got, wanted, error.hint) from None
    if not (math.isfinite(found) and abs(found) <= most):
        size = "" if math.isinf(most) else f", at most {most:g} in size"
        raise InputError(which, shown(value), f"{wanted}{size}", "correct the exponent or the unit")
    return found


def _from_text(text: str, unit: str) -> float:
    if INFINITE.fullmatch(text):
        return float(text.replace(".", ""))
    plain = spelt(text) if len(text) <= LONGEST else ""
    figures = FLOAT.match(plain)
    unit_text = plain[figures.end() :].removeprefix(" ") if figures else ""
    if figures is None or not (unit_text == "" or UNIT.fullmatch(unit_text)):
        raise NotANumber(f"the text {shown(text)}", _hint_text(text, unit))
    value = finite_float(figures[0])
    if value is None:
        raise NotANumber(f"{shown(figures[0])}, which no double can hold", "write a number of sensible size")
    if not unit_text:
        return value
    try:
        return _converted(value, _factor(unit_text, unit), text)
    except _WrongUnit as error:
        own = text[len(text) - len(unit_text) :] if text.endswith(unit_text) else unit_text
        got = f"the unit {shown(own)} of {shown(text)}, which is {error.reason}"
        raise NotANumber(got, error.hint or _hint_unit(figures[0], unit_text, unit)) from None


def _hint_text(text: str, unit: str) -> str:
    if comma := COMMA.fullmatch(text):
        return f"write a decimal point instead of the comma: {comma[1]}.{comma[2]}{comma[3]}"
    example = "" if unit == "-" else f', or a number with its unit, such as "1.5 {unit}"'
    return f"write a number{_in(unit)}{example}"


def _hint_unit(figures: str, unit_text: str, unit: str) -> str:
    """What a wrong unit was probably meant to be, else what would be right."""
    for guess in guesses(unit_text):
        with suppress(_WrongUnit):
            _checked_factor(guess, unit)
            return f'did you mean "{figures} {guess}"?'
    if unit == "-":
        return "write a number without a unit"
    return f'write the number in {unit}, or with a unit that converts to it, such as "{figures} {unit}"'


def _converted(value: float, factor: float, text: str) -> float:
    """The value in our unit. Divides where the factor is one over a whole number: 700 mm is 0.7 m to the last digit."""
    whole = round(1 / factor) if 1e-15 < factor < 1 else 0
    result = value / whole if whole and whole * factor == 1.0 else value * factor
    if not math.isfinite(result):
        raise NotANumber(f"{shown(text)}, which no double can hold", "write a number of sensible size")
    return result


@dataclass
class _WrongUnit(ValueError):
    """Why a unit does not belong in a place, and how to fix it where that is known."""

    reason: str
    hint: str = ""


@lru_cache(1000)
def _factor(unit_text: str, unit: str) -> float:
    """Our units in one of a text: of its first reading that has our dimension."""
    refused: list[_WrongUnit] = []
    factors: dict[str, float] = {}
    for count, reading in enumerate(readings(unit_text)):
        try:
            factors[reading] = _checked_factor(reading, unit)
        except _WrongUnit as error:
            refused.append(error)
        else:
            if count == 0:
                break
    if len({*factors.values()}) > 1:
        raise _WrongUnit(f"either {' or '.join(factors)}", "write the one that is meant")
    if not factors:
        general = {_OTHER: 1, _UNKNOWN: 2}
        raise min(refused, key=lambda error: general.get(error.reason, 0))
    return next(iter(factors.values()))


_UNKNOWN, _OTHER = "unknown", "of another dimension"


def _checked_factor(unit_text: str, unit: str) -> float:
    """Our units in one of a text in the library's spelling; raises :class:`_WrongUnit`.

    An angle is no dimension of the library: it belongs only where our unit has one, and may be left out there.
    """
    turns = angles(unit)
    if grains(unit_text):
        raise _WrongUnit(_UNKNOWN, "write g for grams")
    if turns and cyclic(unit_text):
        raise _WrongUnit("of turns or of radians", "write rpm or rev/s for turns, else rad/s")
    factor = 1.0 if unit_text == unit else EVERYDAY.get(unit, {}).get(unit_text)
    factor = library_factor(unit_text, unit) if factor is None else factor
    if turns and angles(unit_text) > turns:
        raise _WrongUnit("of the same angle more than once")
    if (angles(unit_text) and not turns) or ("percent" in unit_text and unit != "-"):
        raise _WrongUnit(_OTHER)
    return factor


def library_factor(unit_text: str, unit: str) -> float:
    """Our units in one of a text, by the unit library; raises a ValueError for what is no unit of this kind."""
    ours = "dimensionless" if unit == "-" else unit
    try:
        one, two = (float(_registry().Quantity(count, unit_text).to(ours).magnitude) for count in (1.0, 2.0))
    except Exception as error:  # the library raises errors of many families; each means: not this unit
        raise _WrongUnit(_OTHER if type(error).__name__ == "DimensionalityError" else _UNKNOWN) from None
    if not math.isclose(two, 2 * one):  # decibels and the like are no factors
        raise _WrongUnit("not a plain factor")
    return one


@cache
def _registry() -> Any:
    """The unit registry: built once, when the first unit is met that is not an everyday one."""
    import pint

    return pint.UnitRegistry()


def _in(unit: str) -> str:
    return "" if unit == "-" else f" in {unit}"


INTEGER = re.compile(r"[-+]?[0-9]+")
YAML_INFINITE = re.compile(r"([-+]?)\.(inf|Inf|INF)")
BARE_WORDS = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **dict.fromkeys((".nan", ".NaN", ".NAN"), float("nan")),
}
MOST_DIGITS = 4000


def scalar(text: str) -> bool | int | float | str | None:
    """The value of a bare word after the core schema of YAML 1.2 (without octal and hexadecimal integers).

    A number that no double can hold (``1e400``) stays text, so that nothing is rounded to infinity or to zero.
    """
    if text in BARE_WORDS:
        return BARE_WORDS[text]
    if INTEGER.fullmatch(text) and len(text) <= MOST_DIGITS:
        return int(text)
    if FLOAT.fullmatch(text):
        value = finite_float(text)
        return text if value is None else value
    if infinite := YAML_INFINITE.fullmatch(text):
        return float(f"{infinite[1]}inf")
    return text


def finite_float(text: str) -> float | None:
    """The double nearest to a decimal number; None when there is none (overflow, or underflow to zero)."""
    if len(text) > MOST_DIGITS or not FLOAT.fullmatch(text):
        return None
    value = float(text)
    mantissa = re.split("[eE]", text)[0]
    lost = value == 0.0 and any(digit in mantissa for digit in "123456789")
    return None if lost or value in (float("inf"), float("-inf")) else value
