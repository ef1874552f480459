"""Read an XML file into plain elements that know their line; nothing of XML that can harm is understood.

A robot's file needs elements, attributes and a few short texts. A document type (with it every entity, and every file
or address that an entity could name) is refused; size, depth and number of elements are bounded, long texts are cut.
Attributes are read as names, numbers and triples, each refused with its file, line, element and fix.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from tmodes.errors import InputError
from tmodes.io.files import FilePath, read_bytes
from tmodes.io.units import COMMA, FLOAT, finite_float
from tmodes.io.words import nearest, shown, shown_path

__all__ = ["Element", "parse_xml", "read_xml"]

MOST_BYTES = 8 * 1024 * 1024
MOST_ELEMENTS = 200_000
MOST_DEPTH = 100
MOST_ATTRIBUTES = 100
LONGEST_ATTRIBUTE = 20_000
LONGEST_NAME = 100
MOST_TEXTS = 5
"""Pieces of text that are kept of an element: a number or a name comes in one."""

MOST_MAGNITUDE = 1e12


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Element:
    """One element of a file: its tag as written (with its prefix), attributes, children and place.

    What reads a value takes ``which``, its name in messages, and raises :class:`tmodes.errors.InputError`.
    """

    tag: str
    attributes: dict[str, str]
    source: str
    line: int
    children: list[Element] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)

    @property
    def place(self) -> str:
        """Where it stands, as ``file:line``."""
        return f"{self.source}:{self.line}"

    @property
    def label(self) -> str:
        """Its tag in brackets, for messages."""
        return f"<{self.tag[:60]}>"

    def fault(self, which: str, got: str, expected: str, hint: str) -> InputError:
        """An error at its place."""
        return InputError(which, got, expected, hint, self.place)

    def wrong(self, got: str, expected: str, hint: str) -> InputError:
        """An error about the element itself."""
        return self.fault(self.label, got, expected, hint)

    def all(self, tag: str) -> list[Element]:
        """Its children with this tag, in the order of the file."""
        return [child for child in self.children if child.tag == tag]

    def first(self, tag: str) -> Element | None:
        """Its first child with this tag, None where there is none."""
        return next((child for child in self.children if child.tag == tag), None)

    def only(self, tag: str, which: str, known: Collection[str] = ()) -> Element | None:
        """Its one child with this tag, None where there is none; a second one and misspelt attributes are refused."""
        found = self.all(tag)
        if len(found) > 1:
            got = f"a second <{tag}> (first in line {found[0].line})"
            raise found[1].fault(which, got, f"one <{tag}>", "keep one of the two")
        for one in found if known else ():
            one.check_attributes(known, f"{which}: {tag}")
        return found[0] if found else None

    def within(self) -> Iterator[Element]:
        """The element itself and everything inside it, in the order of the file."""
        waiting: list[Element] = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(element.children))

    def text(self, name: str, which: str) -> str:
        """The text of an attribute that must be there and not empty."""
        text = self.attributes.get(name, "").strip()
        if not text:
            got = "an empty text" if name in self.attributes else f"<{self.tag}> without the attribute `{name}`"
            raise self.fault(which, got, f'{name}="..."', f'write <{self.tag} {name}="...">')
        if len(text) > LONGEST_NAME or not text.isprintable():
            got, most = f"a text of {len(text)} characters", f"at most {LONGEST_NAME} printable characters"
            raise self.fault(which, got, most, "shorten it, or look for a missing quote")
        return text

    @property
    def content(self) -> str:
        """The text inside, without space around it."""
        return "".join(self.texts).strip()

    def value(self, which: str) -> float:
        """The finite number that it stands for: its attribute ``value``, or the text inside."""
        return self._finite(self.attributes.get("value", self.content).strip(), which)

    def number(self, name: str, which: str, default: float | None = None) -> float:
        """The finite number of an attribute, ``default`` where it is missing and may be."""
        text = self.attributes.get(name)
        if text is not None:
            return self._finite(text.strip(), which)
        if default is None:
            got = f"<{self.tag}> without the attribute `{name}`"
            raise self.fault(which, got, f'{name}="a number"', f'write <{self.tag} {name}="...">')
        return default

    def triple(self, name: str, which: str) -> list[float]:
        """Three finite numbers of an attribute, zeros where it is missing."""
        words = self.attributes.get(name, "0 0 0").split()
        if len(words) != 3:
            hint = "write three numbers with spaces between them, with a point for decimals"
            raise self.fault(which, f"{len(words)} words", f'{name}="x y z"', hint)
        return [self._finite(word, which) for word in words]

    def origin(self, which: str) -> dict[str, list[float]]:
        """Position [m] and fixed-axis angles [rad] of the ``<origin>`` inside; zeros where there is none."""
        origin = self.only("origin", which)
        if origin is None:
            return {"position": [0.0, 0.0, 0.0], "rpy": [0.0, 0.0, 0.0]}
        if unknown := [name for name in origin.attributes if name not in {"xyz", "rpy"}]:
            hint = "write the position as xyz and the angles as rpy"
            raise origin.fault(f"{which}: origin", f"the attribute {shown(unknown[0])}", "xyz and rpy", hint)
        triples = {"position": "xyz", "rpy": "rpy"}
        return {key: origin.triple(name, f"{which}: origin {name}") for key, name in triples.items()}

    def check_attributes(self, known: Collection[str], which: str) -> None:
        """Refuse attributes that are misspelt; others belong to some other program."""
        for name in self.attributes:
            if meant := _misspelt(name, known):
                raise self.fault(
                    which, f"the unknown attribute {shown(name)}", f"`{meant}`", f"did you mean `{meant}`?"
                )

    def check_children(self, known: Collection[str], which: str, *, closed: bool = False) -> None:
        """Refuse children that are misspelt, or, where the group is ``closed``, all that do not belong to it."""
        for child in self.children:
            meant = _misspelt(child.tag, known)
            if meant or (closed and child.tag not in known):
                expected = f"<{meant}>" if meant else f"one of {', '.join(f'<{name}>' for name in sorted(known))}"
                hint = f"did you mean <{meant}>?" if meant else "remove it, or put it where it belongs"
                raise child.fault(which, f"the unknown element {child.label}", expected, hint)

    def _finite(self, text: str, which: str) -> float:
        value = finite_float(text)
        if value is not None and abs(value) <= MOST_MAGNITUDE:
            return value
        raise self.fault(which, *_no_number(text))


def _misspelt(name: str, known: Collection[str]) -> str | None:
    """The known name that was surely meant. Other programs' names are long compounds (`gear_velocity`): not close."""
    meant = None if name in known else nearest(name, known)
    if meant is None or abs(len(meant) - len(name)) > 2:
        return None
    return meant if difflib.SequenceMatcher(None, name.lower(), meant).ratio() > 0.7 else None


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


def read_xml(path: FilePath) -> Element:
    """The root element of an XML file; InputError with ``file:line`` for everything that is not plain XML."""
    return parse_xml(read_bytes(path, MOST_BYTES), shown_path(path))


def parse_xml(content: bytes, source: str) -> Element:
    """The root element of the bytes of an XML file; ``source`` is its name in messages."""
    if not content.strip():
        raise InputError("the file", "an empty file", "an XML file", "check that this is the file you mean", source)
    builder = _XmlBuilder(source)
    try:
        builder.parser.Parse(content, True)
    except expat.ExpatError as error:
        raise builder.broken(error) from None
    except (LookupError, ValueError) as error:  # an encoding that Python does not know, or cannot use here
        got = f"text that cannot be decoded ({shown(str(error))})"
        raise InputError("the file", got, "text in UTF-8", "save it as UTF-8", source) from None
    return builder.top[0]


class _XmlBuilder:
    """Builds elements from the parser's calls, and refuses what is too much."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.count = 0
        self.top: list[Element] = []
        self.open: list[Element] = []
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = lambda _: self.open.pop()
        self.parser.CharacterDataHandler = self._text
        self.parser.StartDoctypeDeclHandler = self._document_type

    def error(self, got: str, expected: str, hint: str) -> InputError:
        return InputError("the file", got, expected, hint, f"{self.source}:{self.parser.CurrentLineNumber}")

    def broken(self, error: expat.ExpatError) -> InputError:
        """What the parser found wrong; for a file that ends too early also which element is still open."""
        problem = expat.ErrorString(error.code) or "something else"
        inside = f" inside <{self.open[-1].tag}> of line {self.open[-1].line}" if self.open else ""
        hint = "look there for a missing quote, > or closing tag; a file that was cut off must be fetched again"
        got = f"broken XML ({problem}{inside})"
        return InputError("the file", got, "well-formed XML", hint, f"{self.source}:{error.lineno}")

    def _document_type(self, *_: object) -> None:
        hint = "remove the <!DOCTYPE ...> and write the values out"
        raise self.error("a document type (<!DOCTYPE), which can hold entities", "plain elements", hint)

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self.count += 1
        self._bound("elements", self.count, MOST_ELEMENTS)
        self._bound("levels of elements", len(self.open) + 1, MOST_DEPTH)
        if attributes:
            self._bound("attributes of one element", len(attributes), MOST_ATTRIBUTES)
            self._bound("characters in one attribute", max(map(len, attributes.values())), LONGEST_ATTRIBUTE)
        element = Element(tag, attributes, self.source, self.parser.CurrentLineNumber)
        (self.open[-1].children if self.open else self.top).append(element)
        self.open.append(element)

    def _text(self, text: str) -> None:
        texts = self.open[-1].texts
        if len(texts) < MOST_TEXTS and not text.isspace():
            texts.append(text[:LONGEST_NAME])

    def _bound(self, what: str, count: int, most: int) -> None:
        if count > most:
            raise self.error(f"{count} {what}", f"at most {most}", "check that this is a robot's file")
