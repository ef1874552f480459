"""Read a YAML file into plain data, with the line of every key.

A data sheet needs maps, lists and scalars; anchors (&), aliases (*) and merge keys (<<) repeat them. What an alias
stands for counts like what is written out, and everything else that YAML can do (tags, many documents) is refused, so a
hostile file costs a bounded time and memory: the data is built here, from the parser's events. Long lists of numbers, a
line for each, do not go through the parser, which would take a second for 10,000 of them.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from tmodes.errors import InputError
from tmodes.io.files import read_bytes
from tmodes.io.units import scalar
from tmodes.io.words import shown, shown_path

__all__ = ["Positions", "nearest_line", "parse_yaml", "read_yaml", "yaml_events"]


def yaml_events(text: str, source: str) -> Iterator[Any]:
    """Events of the YAML parser; each of its errors becomes ours."""
    from ruamel.yaml import YAML
    from ruamel.yaml.error import MarkedYAMLError
    from ruamel.yaml.reader import ReaderError

    hint = "look there for a missing quote, bracket or colon, a tab, or wrong indentation"
    try:
        yield from YAML(typ="safe", pure=True).parse(text)
    except ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        got = f"the character {shown(text[error.position : error.position + 1])}"
        raise InputError("the file", got, "printable text", "remove it", f"{source}:{line}") from None
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        place = f"{source}:{mark.line + 1}" if mark else source
        problem = " ".join(str(error.problem or error.context or "something else").split())
        raise InputError("the file", f"broken YAML ({problem})", "YAML 1.2", hint, place) from None
    except InputError:
        raise
    except Exception as error:  # the parser lets raw IndexError, AssertionError... through on some junk
        raise InputError("the file", f"junk ({type(error).__name__})", "YAML 1.2", hint, source) from None


Positions = dict[str, int]
"""Line of every key and list item, by its dotted path; the path of the whole file is empty."""

MOST_BYTES = 4 * 2**20
MOST_EVENTS = 40_000
"""Keys, values and brackets of a file: a robot of 500 joints has some 34,000, which are read in a second."""

MOST_NUMBERS = 400_000
"""Numbers in long lists of a file, such as the samples of a trajectory."""

_MARK = "\ue000"
_NUMBER = r"-?[0-9]+\.[0-9]+(?:[eE][-+]?[0-9]+)?"
_NUMBERS = re.compile(rf"^( *)- {_NUMBER}\n(?:\1- {_NUMBER}\n){{15,}}", re.MULTILINE)
"""A list of at least 16 numbers, a line for each, and the letter that stands for one in the text that is parsed."""

MOST_EVENTS_2010 = 5_000
"""The same for a sheet without ``kind`` and ``urdf``: that of the 2010 robot has some 200."""


MOST_DEPTH = 40
LONGEST_LINE = 10_000
LONGEST_SCALAR = 5_000


def read_yaml(path: str | os.PathLike[str]) -> tuple[dict[str, Any], Positions]:
    """Plain data of a YAML 1.2 file (maps, lists, scalars) and the line of each key; else InputError with its line."""
    source = shown_path(path)
    return parse_yaml(_decoded(read_bytes(path, MOST_BYTES), source), source)


def parse_yaml(text: str, source: str) -> tuple[dict[str, Any], Positions]:
    """The same of a YAML text; ``source`` is its name in messages."""
    for number, line in enumerate(text.splitlines(), 1):  # the scanner needs time of the square of a line's length
        if len(line) > LONGEST_LINE:
            got, most = f"a line of {len(line)} characters", f"at most {LONGEST_LINE} characters"
            raise InputError("the file", got, most, "break the line", f"{source}:{number}")
    try:
        builder = _YamlBuilder(source, text)
        data = builder.document(yaml_events(builder.text, source))
    except _MarkedTextError:
        builder = _YamlBuilder(source, text, lists=False)
        data = builder.document(yaml_events(text, source))
    if not isinstance(data, dict):
        raise builder.error(1, "the file", shown(data), "keys and values, such as `gravity: 9.81`", "see the examples")
    if builder.count > MOST_EVENTS_2010 and not {"kind", "urdf"} & data.keys():
        raise builder.too_many(1, MOST_EVENTS_2010, "check that this is a data sheet; one of an arm has `kind: arm`")
    return data, builder.positions


def nearest_line(path: str, positions: Mapping[str, int], default: int = 0) -> int:
    """The line of a dotted path, or of the nearest group around it; ``default`` when there is none."""
    while path and path not in positions:
        path = path.rpartition(".")[0]
    return positions.get(path, default)


def _decoded(content: bytes, source: str) -> str:
    if not content.strip():
        raise InputError("the file", "an empty file", "a data sheet", "start from a published robot", source)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        got = f"the byte 0x{content[error.start]:02x}, which is not UTF-8"
        hint = "save the file as UTF-8 text"
        raise InputError("the file", got, "text in UTF-8", hint, f"{source}:{line}") from None


class _MarkedTextError(Exception):
    """The lines of what looked like a list of numbers are part of a text."""


class _YamlBuilder:
    """Builds plain data from events and keeps the lines.

    In ``text`` a mark stands for each long list of numbers, and empty lines, so that all others keep their number.
    """

    def __init__(self, source: str, text: str, *, lists: bool = True) -> None:
        self.source = source
        self.lists: dict[str, list[Any]] = {}
        self.text = _NUMBERS.sub(self._marked, text) if lists and _MARK not in text else text
        self.numbers = 0
        self.positions: Positions = {"": 1}
        self.count = 0
        self._anchors: dict[str, list[Any]] = {}
        self._recorded: list[list[Any]] = []

    def _marked(self, found: re.Match[str]) -> str:
        mark, lines = f"{_MARK}{len(self.lists)}", found[0].splitlines()
        self.lists[mark] = [scalar(line.partition("- ")[2]) for line in lines]
        return f"{found[1]}- {mark}" + "\n" * len(lines)

    def too_many(self, line: int, most: int, hint: str) -> InputError:
        return self.error(line, "the file", f"more than {most} items", f"at most {most}", hint)

    def error(self, line: int, which: str, got: str, expected: str, hint: str) -> InputError:
        return InputError(which, got, expected, hint, f"{self.source}:{line}")

    def document(self, events: Iterator[Any]) -> Any:
        """The data of the one document of a file."""
        events = self._counted(events)
        for event in events:
            match type(event).__name__:
                case "StreamStartEvent":
                    pass
                case "DocumentStartEvent":
                    if event.tags or event.version not in (None, (1, 2)):
                        got, hint = "a %YAML or %TAG directive", "remove the line that starts with %"
                        raise self.error(_line(event), "the file", got, "YAML 1.2 without directives", hint)
                    break
                case _:
                    raise self.error(1, "the file", "no data", "a data sheet", "start from a published robot")
        data = self._node(next(events), events, "", 0)
        for event in events:
            if type(event).__name__ == "DocumentStartEvent":
                got, hint = "a second document (`---`)", "keep one robot in a file"
                raise self.error(_line(event), "the file", got, "one document", hint)
        return data

    def _counted(self, events: Iterator[Any]) -> Iterator[Any]:
        """The events, each also kept by all anchors in whose node it stands."""
        for event in self._bounded(events):
            for kept in self._recorded:
                kept.append(event)
            yield event

    def _bounded(self, events: Iterable[Any]) -> Iterator[Any]:
        for event in events:
            self.count += 1
            if self.count > MOST_EVENTS:
                raise self.too_many(_line(event), MOST_EVENTS, "check that this is a data sheet")
            yield event

    def _node(self, event: Any, events: Iterator[Any], path: str, depth: int) -> Any:
        self._check_plain(event, path, depth)
        anchor = getattr(event, "anchor", None)
        if type(event).__name__ == "AliasEvent":
            return self._repeated(event, path, depth)
        if anchor is None:
            return self._value(event, events, path, depth)
        self._recorded.append(kept := [event])
        value = self._value(event, events, path, depth)
        self._recorded.pop()
        self._anchors[anchor] = kept
        return value

    def _repeated(self, alias: Any, path: str, depth: int) -> Any:
        """What an alias stands for, built again; within the anchor's own node there is none yet."""
        if alias.anchor not in self._anchors:
            got, hint = f"the alias *{alias.anchor:.40}", f"write &{alias.anchor:.40} before it, or put it in quotes"
            raise self.error(_line(alias), path or "the file", got, "an alias of an anchor above it", hint)
        first, *others = self._anchors[alias.anchor]
        outer, self._recorded = self._recorded, []
        events = self._bounded(others)
        value = self._value(first, events, path, depth)
        self._recorded = outer
        return value

    def _value(self, event: Any, events: Iterator[Any], path: str, depth: int) -> Any:
        match type(event).__name__:
            case "ScalarEvent":
                if self.lists and _MARK in event.value:
                    raise _MarkedTextError
                return scalar(event.value) if event.style in (None, "") else event.value
            case "SequenceStartEvent":
                return self._list(events, path, depth)
            case _:
                return self._map(events, path, depth)

    def _check_plain(self, event: Any, path: str, depth: int) -> None:
        which, line = path or "the file", _line(event)
        if getattr(event, "tag", None) is not None:
            hint = "remove it, or put text with ! in quotes"
            raise self.error(line, which, f"the tag {shown(str(event.tag))}", "a plain value", hint)
        if depth > MOST_DEPTH:
            raise self.error(line, which, f"more than {MOST_DEPTH} levels", "a shallow file", "remove brackets")
        if type(event).__name__ == "ScalarEvent" and len(event.value) > LONGEST_SCALAR:
            got, most = f"{len(event.value)} characters", f"at most {LONGEST_SCALAR}"
            raise self.error(line, which, got, most, "shorten it, or look for a missing quote")

    def _list(self, events: Iterator[Any], path: str, depth: int) -> list[Any]:
        items: list[Any] = []
        for event in events:
            if type(event).__name__ == "SequenceEndEvent":
                break
            if type(event).__name__ == "ScalarEvent" and event.value in self.lists and event.anchor is None:
                items += self._long(event, path, len(items))
                continue
            here = _join(path, str(len(items)))
            self.positions[here] = _line(event)
            items.append(self._node(event, events, here, depth + 1))
        return items

    def _long(self, event: Any, path: str, first: int) -> list[Any]:
        """The long list of numbers at a mark."""
        found, line = self.lists[event.value], _line(event)
        self.numbers += len(found)
        if self.numbers > MOST_NUMBERS:
            raise self.too_many(line, MOST_NUMBERS, "check that this is a data sheet")
        self.positions |= {_join(path, str(first + k)): line + k for k in range(len(found))}
        return found

    def _map(self, events: Iterator[Any], path: str, depth: int) -> dict[str, Any]:
        pairs: dict[str, Any] = {}
        merged: list[tuple[dict[str, Any], Positions]] = []
        for event in events:
            if type(event).__name__ == "MappingEndEvent":
                break
            self._check_plain(event, path, depth)
            if type(event).__name__ == "AliasEvent" or event.anchor is not None:
                hint = "write the key out, or put text with & or * in quotes"
                raise self.error(_line(event), path or "the file", "an anchor (&) or an alias (*)", "a key", hint)
            if type(event).__name__ != "ScalarEvent":
                got, hint = "a list or group as a key", "write `name: value`"
                raise self.error(_line(event), path or "the file", got, "a word as a key", hint)
            if event.value == "<<" and event.style in (None, ""):
                merged += self._merged(next(events), events, path, depth + 1)
                continue
            here = _join(path, event.value)
            if event.value in pairs:
                first = self.positions[here]
                hint = "keep one of the two lines"
                raise self.error(_line(event), here, f"a second one (the first in line {first})", "written once", hint)
            self.positions[here] = _line(event)
            pairs[event.value] = self._node(next(events), events, here, depth + 1)
        for group, lines in merged:  # what the group itself says wins, then the first of those that are merged
            pairs |= {key: value for key, value in group.items() if key not in pairs}
            for where, line in lines.items():
                self.positions.setdefault(where, line)
        return pairs

    def _merged(
        self, event: Any, events: Iterator[Any], path: str, depth: int
    ) -> list[tuple[dict[str, Any], Positions]]:
        """The group, or the groups of a list, of a merge key, each with the lines of its keys."""
        if type(event).__name__ == "SequenceStartEvent":
            groups = []
            while type(node := next(events)).__name__ != "SequenceEndEvent":
                groups += self._merged(node, events, path, depth + 1)
            return groups
        outer, self.positions = self.positions, {}
        value = self._node(event, events, path, depth)
        lines, self.positions = self.positions, outer
        if not isinstance(value, dict):
            hint = "write <<: *name, where &name marks a group"
            raise self.error(_line(event), path or "the file", f"{shown(value)} after <<", "a group to merge", hint)
        return [(value, lines)]


def _join(path: str, name: str) -> str:
    return f"{path}.{name}" if path else name


def _line(event: Any) -> int:
    return event.start_mark.line + 1
