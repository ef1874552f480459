"""Units as people write them (``Nms/rad``, ``kg·m²``, ``N-m``, ``oz in``), in the spelling of the unit library.

A unit is a product of words with whole powers. A word may be several units run together (``Nm``); which ones is found
by trying, because ``Nmm`` is a torque and ``Nms`` an angular momentum: whoever converts takes the reading of the right
dimension. A word that is one unit by itself (``mN``, ``ms``) is never taken apart.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from itertools import islice, product

__all__ = ["UNIT", "angles", "cyclic", "grains", "guesses", "readings", "spelt"]

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
