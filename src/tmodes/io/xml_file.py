"""Read an XML file into plain elements that know their line; nothing of XML that can harm is understood.

A robot's file needs elements and attributes. A document type (with it every entity, and every file or address that an
entity could name) is refused, size, depth and number of elements are bounded, and text between elements is not kept.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from tmodes.errors import InputError
from tmodes.io.files import read_bytes
from tmodes.io.words import shown, shown_path

__all__ = ["Element", "parse_xml", "read_xml"]

MOST_BYTES = 8 * 1024 * 1024
MOST_ELEMENTS = 200_000
MOST_DEPTH = 100
MOST_ATTRIBUTES = 100
LONGEST_ATTRIBUTE = 20_000


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Element:
    """One element of a file: its tag as written (with its prefix), attributes, children and place."""

    tag: str
    attributes: dict[str, str]
    source: str
    line: int
    children: list[Element] = field(default_factory=list)

    @property
    def place(self) -> str:
        """Where it stands, as ``file:line``."""
        return f"{self.source}:{self.line}"

    def all(self, tag: str) -> list[Element]:
        """Its children with this tag, in the order of the file."""
        return [child for child in self.children if child.tag == tag]

    def first(self, tag: str) -> Element | None:
        """Its first child with this tag, None where there is none."""
        return next((child for child in self.children if child.tag == tag), None)

    def within(self) -> Iterator[Element]:
        """The element itself and everything inside it, in the order of the file."""
        waiting: list[Element] = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(element.children))


def read_xml(path: str | os.PathLike[str]) -> Element:
    """The root element of an XML file.

    Raises :class:`tmodes.errors.InputError` with ``file:line`` for everything that is not a plain XML file.
    """
    return parse_xml(read_bytes(path, MOST_BYTES), shown_path(path))


def parse_xml(content: bytes, source: str) -> Element:
    """The root element of the bytes of an XML file; ``source`` is its name in messages."""
    if not content.strip():
        raise InputError("the file", "an empty file", "an XML file", "check that this is the file you mean", source)
    builder = _Builder(source)
    try:
        builder.parser.Parse(content, True)
    except expat.ExpatError as error:
        raise builder.broken(error) from None
    except (LookupError, ValueError) as error:  # an encoding that Python does not know, or cannot use here
        got = f"text that cannot be decoded ({shown(str(error))})"
        raise InputError("the file", got, "text in UTF-8", "save it as UTF-8", source) from None
    return builder.top[0]


class _Builder:
    """Builds elements from the parser's calls, and refuses what is too much."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.count = 0
        self.top: list[Element] = []
        self.open: list[Element] = []
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
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

    def _end(self, _: str) -> None:
        self.open.pop()

    def _bound(self, what: str, count: int, most: int) -> None:
        if count > most:
            raise self.error(f"{count} {what}", f"at most {most}", "check that this is a robot's file")
