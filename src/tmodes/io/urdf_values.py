"""Values of a URDF's attributes: numbers, triples and names, each refused with its file, line, element and fix."""

from __future__ import annotations

import difflib
import math
from collections.abc import Collection, Iterable

from tmodes.errors import InputError
from tmodes.io.scalars import FLOAT, finite_float
from tmodes.io.units import COMMA
from tmodes.io.words import nearest, shown
from tmodes.io.xml_file import Element

__all__ = ["check_attributes", "check_children", "fault", "number_at", "only", "origin_at", "text_at", "triple_at"]

LONGEST_NAME = 100
MOST_MAGNITUDE = 1e12


def fault(element: Element, which: str, got: str, expected: str, hint: str) -> InputError:
    """An error of ours at an element's place."""
    return InputError(which, got, expected, hint, element.place)


def text_at(element: Element, name: str, which: str) -> str:
    """The text of an attribute that must be there; InputError where it is missing or empty."""
    text = element.attributes.get(name, "").strip()
    if not text:
        got = "an empty text" if name in element.attributes else f"<{element.tag}> without the attribute `{name}`"
        raise fault(element, which, got, f'{name}="..."', f'write <{element.tag} {name}="...">')
    if len(text) > LONGEST_NAME or not text.isprintable():
        got, most = f"a text of {len(text)} characters", f"at most {LONGEST_NAME} printable characters"
        raise fault(element, which, got, most, "shorten it, or look for a missing quote")
    return text


def number_at(element: Element, name: str, which: str, default: float | None = None) -> float:
    """The finite number of an attribute, ``default`` where it is missing and may be."""
    text = element.attributes.get(name)
    if text is None and default is not None:
        return default
    if text is None:
        got = f"<{element.tag}> without the attribute `{name}`"
        raise fault(element, which, got, f'{name}="a number"', f'write <{element.tag} {name}="...">')
    return _finite(element, text.strip(), which)


def triple_at(element: Element, name: str, which: str) -> list[float]:
    """Three finite numbers of an attribute, zeros where it is missing."""
    words = element.attributes.get(name, "0 0 0").split()
    if len(words) != 3:
        hint = "write three numbers with spaces between them, with a point for decimals"
        raise fault(element, which, f"{len(words)} words", f'{name}="x y z"', hint)
    return [_finite(element, word, which) for word in words]


def origin_at(element: Element, which: str) -> dict[str, list[float]]:
    """Position [m] and fixed-axis angles [rad] of the ``<origin>`` inside an element; zeros where there is none."""
    origin = only(element, "origin", which)
    if origin is None:
        return {"position": [0.0, 0.0, 0.0], "rpy": [0.0, 0.0, 0.0]}
    if unknown := [name for name in origin.attributes if name not in {"xyz", "rpy"}]:
        hint = "write the position as xyz and the angles as rpy"
        raise fault(origin, f"{which}: origin", f"the attribute {shown(unknown[0])}", "xyz and rpy", hint)
    triples = {"position": "xyz", "rpy": "rpy"}
    return {key: triple_at(origin, name, f"{which}: origin {name}") for key, name in triples.items()}


def only(element: Element, tag: str, which: str) -> Element | None:
    """The one child with this tag, None where there is none; a second one is refused."""
    found = element.all(tag)
    if len(found) > 1:
        got = f"a second <{tag}> (first in line {found[0].line})"
        raise fault(found[1], which, got, f"one <{tag}>", "keep one of the two")
    return found[0] if found else None


def check_attributes(element: Element, known: Collection[str], which: str) -> None:
    """Refuse attributes that are misspelt; others belong to some other program."""
    for name in element.attributes:
        if meant := _misspelt(name, known):
            raise fault(
                element, which, f"the unknown attribute {shown(name)}", f"`{meant}`", f"did you mean `{meant}`?"
            )


def check_children(element: Element, known: Collection[str], which: str, *, closed: bool = False) -> None:
    """Refuse children that are misspelt, or, where the group is ``closed``, all that do not belong to it."""
    for child in element.children:
        meant = _misspelt(child.tag, known)
        if meant or (closed and child.tag not in known):
            expected = f"<{meant}>" if meant else f"one of {', '.join(f'<{name}>' for name in sorted(known))}"
            hint = f"did you mean <{meant}>?" if meant else "remove it, or put it where it belongs"
            raise fault(child, which, f"the unknown element <{child.tag[:60]}>", expected, hint)


def _misspelt(name: str, known: Iterable[str]) -> str | None:
    """The known name that was surely meant. Other programs' names are long compounds (`gear_velocity`): not close."""
    if name in known:
        return None
    meant = nearest(name, known)
    if meant is None or abs(len(meant) - len(name)) > 2:
        return None
    return meant if difflib.SequenceMatcher(None, name.lower(), meant).ratio() > 0.7 else None


def _finite(element: Element, text: str, which: str) -> float:
    value = finite_float(text)
    if value is not None and abs(value) <= MOST_MAGNITUDE:
        return value
    raise fault(element, which, *_no_number(text))


def _no_number(text: str) -> tuple[str, str, str]:
    """What a text is that is no number of sensible size: got, expected, fix."""
    expected = f"a finite number of at most {MOST_MAGNITUDE:g}"
    if comma := COMMA.fullmatch(text):
        return shown(text), expected, f"write a decimal point instead of the comma: {comma[1]}.{comma[2]}"
    try:
        value = float(text)
    except ValueError:
        return f"the text {shown(text)}", expected, "write a number in SI units, without the unit"
    if math.isfinite(value) and not FLOAT.fullmatch(text):
        return f"{shown(text)}, not a number as URDF writes it", expected, "write digits, a point and an exponent only"
    got = f"{shown(text)}, which no double can hold" if not math.isnan(value) else f"{shown(text)} (not a number)"
    return got, expected, "write a finite number of sensible size in SI units"
