"""Scalars of a file or the command line: bare words of YAML 1.2, numbers, and numbers with their unit (``"600 mm"``).

Text is held against a closed grammar before the unit library sees it: a number and a few unit words, with ``*``, ``/``,
one-digit powers and one level of parentheses; :mod:`tmodes.io.units` says what people write for these. Inside
tmodes every number is a plain float in SI units.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import islice, product
from numbers import Real
from typing import Any

from tmodes.errors import InputError
from tmodes.io.words import shown

__all__ = [
    "EVERYDAY",
    "FLOAT",
    "UNIT",
    "NotANumber",
    "angles",
    "cyclic",
    "finite_float",
    "finite_number",
    "grains",
    "guesses",
    "library_factor",
    "number",
    "readings",
    "scalar",
    "spelt",
    "udunits",
]

_LETTERS = {
    **dict.fromkeys("·⋅∙•×\u2217", "*"), **dict.fromkeys("−–\u2010\u2011", "-"), **dict.fromkeys("µμ", "u"),
    **dict.fromkeys("Ω\u2126", "ohm"), **dict.fromkeys("°º˚", "deg"), **dict.fromkeys("\u2044\u2215", "/"),
    "%": "percent",
}  # fmt: skip
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_TABLE = str.maketrans(_LETTERS)

_TERM = r"[A-Za-z]{1,20}(?:\^?-?[1-9](?![0-9]))?"
_TIMES = r"(?: ?[*/-] ?| )"
_TERMS = rf"{_TERM}(?:{_TIMES}{_TERM}){{0,5}}"
UNIT = re.compile(rf"(?:1 ?/ ?)?(?:{_TERMS}|\({_TERMS}\))(?:{_TIMES}(?:{_TERM}|\({_TERMS}\))){{0,2}}")
"""The closed grammar of a unit, after :func:`spelt`."""

_TOKEN = re.compile(r"(?P<mark>\A1 ?/ ?|[()]| ?[*/] ?| ?- ?(?=[A-Za-z(])| )|(?P<word>[A-Za-z]+)|\^?(?P<power>-?[1-9])")

_OTHER_NAMES = {
    **dict.fromkeys(("rev", "revs", "Rev"), "revolution"), "RPM": "rpm", "Ohm": "ohm", "Ohms": "ohm", "sek": "s",
}  # fmt: skip

_PREFIXES = {
    "N": " u m k M", "m": " u m c k", "g": " m k", "s": " u m", "rad": " m", "deg": " ", "V": " m k", "A": " m",
    "W": " k", "J": " m k", "Pa": " k M G", "ohm": " m k", "H": " u m", "min": " ", "in": " ", "ft": " ",
    "lbf": " ", "ozf": " ", "kgf": " ", "rpm": " k",
}  # fmt: skip
_PARTS = {prefix + base: base for base, prefixes in _PREFIXES.items() for prefix in prefixes.split(" ")}
"""Units that are written without a space between them, each with the unit that it is a multiple of."""

_SINGLE = {part: part for part in _PARTS}

_LONGEST_SYMBOL = 3
_MOST_PARTS, _MOST_READINGS = 4, 24

_ANGLES = {"rad", "mrad", "deg", "grad", "gon", "arcmin", "arcsec", "rpm", "krpm", "revolution", "turn", "cycle"}
_ANGLES |= {"radian", "degree"}
_CYCLES = {"Hz", "kHz", "MHz", "mHz", "hertz", "cps"}
_LOOK_ALIKES = {"lb": "lbf", "lbs": "lbf", "oz": "ozf", "kg": "kgf", "g": "gf"}
"""Units of mass that people write for the weight of it."""


def spelt(text: str) -> str:
    """A number with its unit in plain letters: no raised digits, middle dots, Greek letters, or long dashes."""
    text = re.sub(r"[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda raised: f"^{raised[0].translate(_RAISED)}", text)
    text = text.translate(_TABLE).replace("**", "^")
    text = re.sub(r"(?<=[A-Za-z0-9)])\.(?=[A-Za-z])(?<![0-9]\.)", "*", text)
    text = re.sub(r"\^\((-?[1-9])\)", r"^\1", text)
    return re.sub(r"(?<=[A-Za-z0-9)]) ?\bper\b ?(?=[A-Za-z(])", "/", text)


def readings(text: str) -> Iterator[str]:
    """What a unit in plain letters may mean in the library's spelling; first the one that takes no word apart."""
    yield from _expressions(text, lambda word: [_name(word), *_apart(word)])


def _name(word: str) -> str:
    """A word as the library spells it: a name may begin with a capital letter, a symbol of a unit may not."""
    known = _OTHER_NAMES.get(word, word)
    return known.lower() if len(known) > _LONGEST_SYMBOL and known[1:].islower() else known


def guesses(text: str) -> Iterator[str]:
    """What was probably meant by a unit that is none: other capital letters, or the weight of a mass."""
    parts = {part.lower(): part for part in reversed(_PARTS)}

    def likely(word: str) -> list[str]:
        lower = word.lower()
        cased = [part for part in _PARTS if part.lower() == lower] or _apart(lower, parts)
        return list(dict.fromkeys([word, *filter(None, [_LOOK_ALIKES.get(lower)]), *cased, *_apart(word), lower]))

    yield from _expressions(text, likely)


def angles(expression: str) -> int:
    """How often a unit has an angle in it, each power counted; the library does not count it as a dimension."""
    powers = re.findall(r"([A-Za-z]+)(?:\^[-+]?([0-9]{1,3}))?", expression)
    return sum(int(power or 1) for word, power in powers if {word, word.removesuffix("s")} & _ANGLES)


def cyclic(expression: str) -> bool:
    """Whether a unit may count either turns or radians: a frequency, or a rate by the minute."""
    words = _words(expression)
    return bool(_CYCLES & {*words}) or ("min" in words and not angles(expression))


def grains(expression: str) -> bool:
    """Whether a unit has grains in it, which the library reads where people mean grams."""
    return "gr" in _words(expression)


def _words(expression: str) -> list[str]:
    return re.findall(r"[A-Za-z]+", expression)


def _expressions(text: str, meanings: Callable[[str], list[str]]) -> Iterator[str]:
    """The products of all meanings of the words of a unit, in the order of the meanings."""
    choices: list[list[str]] = []
    for token in _TOKEN.finditer(text):
        if token["word"]:
            choices.append(meanings(token["word"]))
        elif token["power"]:
            choices.append([f"^{token['power']}"])
        else:
            choices.append([(token["mark"].replace(" ", "") or "*").replace("-", "*")])
    yield from dict.fromkeys("".join(chosen) for chosen in islice(product(*choices), _MOST_READINGS))


def _apart(word: str, parts: Mapping[str, str] = _SINGLE) -> list[str]:
    """The products of units that a word may be, of which none is there twice; none for a word that is one unit.

    ``parts``: how each unit is written.
    """

    def further(rest: str, before: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
        if not rest and len(before) > 1:
            yield before
        taken = {_PARTS[unit] for unit in before}
        for written, unit in parts.items() if len(before) < _MOST_PARTS else ():
            if rest.startswith(written) and _PARTS[unit] not in taken:
                yield from further(rest[len(written) :], (*before, unit))

    return [] if word in parts else ["*".join(units) for units in further(word, ())]


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
