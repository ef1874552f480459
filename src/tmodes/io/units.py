"""Scalars of a file or the command line: bare words of YAML 1.2, numbers, and numbers with their unit (``"600 mm"``).

Text is held against a closed grammar before the unit library sees it: a number and a few unit words, with ``*``, ``/``,
one-digit powers and one level of parentheses. Inside tmodes every number is a plain float in SI units.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import cache
from numbers import Real
from typing import Any

from tmodes.errors import InputError
from tmodes.io.words import shown

__all__ = ["EVERYDAY", "FLOAT", "NotANumber", "finite_float", "library_factor", "number", "parse_assignment", "scalar"]

NUMBER = r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?"
FLOAT = re.compile(NUMBER)
WORD = r"[A-Za-zµμΩ°]{1,20}(?:(?:\^|\*\*)-?[1-9])?[²³]?"
TIMES = r"(?: ?[*·/] ?| )"
WORDS = rf"{WORD}(?:{TIMES}{WORD}){{0,5}}"
UNIT = rf"(?:1 ?/ ?)?(?:{WORDS}|\({WORDS}\))(?:{TIMES}(?:{WORD}|\({WORDS}\))){{0,2}}"
QUANTITY = re.compile(rf"({NUMBER}) ?({UNIT})?")
COMMA = re.compile(r"([-+]?[0-9]+),([0-9]+)([^,]*)")
INFINITE = re.compile(r"[-+]?\.?(inf|Inf|INF|infinity|Infinity)")
LONGEST = 80

EVERYDAY = {
    "m": {"m": 1.0, "mm": 1e-3, "cm": 0.01, "um": 1e-6, "µm": 1e-6},
    "rad": {"rad": 1.0, "mrad": 1e-3, "deg": math.pi / 180, "°": math.pi / 180},
    "kg": {"kg": 1.0, "g": 1e-3},
    "s": {"s": 1.0, "ms": 1e-3},
    "m/s": {"m/s": 1.0, "mm/s": 1e-3},
    "rad/s": {"rad/s": 1.0, "deg/s": math.pi / 180},
    "N": {"N": 1.0, "kN": 1e3},
    "N*m": {"N*m": 1.0, "N m": 1.0, "N mm": 1e-3},
    "Pa": {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9},
    "-": {"percent": 0.01},
}
"""Factors as the unit library gives them, by unit of the place and text: it takes half a second to load."""


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


def _from_text(text: str, unit: str) -> float:
    if INFINITE.fullmatch(text):
        return float(text.replace(".", ""))
    match = QUANTITY.fullmatch(text) if len(text) <= LONGEST else None
    if match is None:
        raise NotANumber(f"the text {shown(text)}", _hint_text(text, unit))
    value = finite_float(match[1])
    if value is None:
        raise NotANumber(f"{shown(match[1])}, which no double can hold", "write a number of sensible size")
    return value if match[2] is None else _converted(value, match[2], unit)


def _hint_text(text: str, unit: str) -> str:
    if comma := COMMA.fullmatch(text):
        return f"write a decimal point instead of the comma: {comma[1]}.{comma[2]}{comma[3]}"
    example = "" if unit == "-" else f', or a number with its unit, such as "1.5 {unit}"'
    return f"write a number{_in(unit)}{example}"


def _converted(value: float, unit_text: str, unit: str) -> float:
    """The value in our unit. Divides where the factor is one over a whole number: 700 mm is 0.7 m to the last digit."""
    factor = _factor(unit_text, unit)
    whole = round(1 / factor) if 1e-15 < factor < 1 else 0
    result = value / whole if whole and whole * factor == 1.0 else value * factor
    if not math.isfinite(result):
        raise NotANumber(f"{value!r} {unit_text}, which no double can hold", "write a number of sensible size")
    return result


def _factor(unit_text: str, unit: str) -> float:
    factor = EVERYDAY.get(unit, {}).get(unit_text)
    return library_factor(unit_text, unit) if factor is None else factor


def library_factor(unit_text: str, unit: str) -> float:
    """Our units in one of a text, by the unit library; raises :class:`NotANumber` for what is no unit of this kind."""
    ours = "dimensionless" if unit == "-" else unit
    try:
        one, two = (float(_registry().Quantity(count, unit_text).to(ours).magnitude) for count in (1.0, 2.0))
    except Exception as error:  # the library raises errors of many families; each means: not this unit
        reason = "of another dimension" if type(error).__name__ == "DimensionalityError" else "unknown"
        raise _wrong_unit(unit_text, reason, unit) from None
    if not math.isclose(two, 2 * one):  # decibels and the like are no factors
        raise _wrong_unit(unit_text, "not a plain factor", unit)
    return one


def _wrong_unit(unit_text: str, reason: str, unit: str) -> NotANumber:
    hint = f"write the number{_in(unit)}, or with a unit that converts to it"
    return NotANumber(f"the unit {shown(unit_text)}, which is {reason}", hint if unit != "-" else "leave the unit out")


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


LONGEST_VALUE = 2_000

NUMBERS = re.compile(r"\[ *[-+.0-9][^][{},'\"&*!]*(,[ ]*[-+.0-9][^][{},'\"&*!]*)*\]")
"""A flow list of numbers, each perhaps with its unit."""


def parse_assignment(text: str) -> tuple[str, Any]:
    """Path and value of ``path=value``: a bare word, quoted text or list of numbers of YAML; else an InputError."""
    path, equals, value = (part.strip() for part in text.partition("="))
    if not (path and equals and value) or len(value) > LONGEST_VALUE:
        hint = "write it without spaces around =, as in gear.stiffness=900"
        raise InputError("--set", shown(text), "PATH=VALUE", hint)
    if len(value) > 1 and value[0] == value[-1] and value[0] in "'\"":
        return path, value[1:-1]
    if NUMBERS.fullmatch(value):
        return path, [scalar(word.strip()) for word in value[1:-1].split(",")]
    return path, scalar(value)
