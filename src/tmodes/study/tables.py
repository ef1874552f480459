"""CSV tables that a study names: catalogues, measured values, cases; inside of its folder, bounded in size."""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from tmodes.errors import InputError
from tmodes.io.files import Folders, read_bytes
from tmodes.io.units import scalar
from tmodes.io.words import meant, shown

__all__ = ["MOST_ROWS", "Table", "read_table"]

MOST_BYTES = 4 * 2**20
MOST_ROWS = 100_000
MOST_COLUMNS = 300
LONGEST_CELL = 1_000

_HEADER = re.compile(r"(.*?)\s*\[([^\[\]]{1,40})\]\s*")
"""A name with a unit in brackets."""


@dataclass(frozen=True)
class Table:
    """The cells of a CSV file by column, each number with the unit in the header's brackets as text.

    ``source``: its name in messages; ``lines``: the line of each row.
    """

    source: str
    columns: Mapping[str, tuple[Any, ...]]
    lines: tuple[int, ...]

    def column(self, name: str, which: str, place: str) -> tuple[Any, ...]:
        """The cells of a column; raises :class:`tmodes.errors.InputError` with the nearest name for none."""
        if name not in self.columns:
            hint = meant(name, self.columns, "write one of these names")
            expected = f"one of the columns of {self.source}: {', '.join(list(self.columns)[:12])}"
            raise InputError(which, f"the unknown column {shown(name)}", expected, hint, place)
        return self.columns[name]


def read_table(folders: Folders, name: str, which: str, place: str) -> Table:
    """The table of a CSV file, whose first line names its columns, ``name`` or ``name [unit]``.

    Raises :class:`tmodes.errors.InputError` for a file outside of the folders, one that is too large, a name that
    stands twice, and a row with another number of cells.
    """
    path = folders.find(name, which, place)
    if path is None or not path.is_file():
        raise InputError(which, f"{shown(name)}, where no file is", "a CSV file in the folder of the study", "", place)
    try:
        content = read_bytes(path, MOST_BYTES)
    except InputError as error:
        raise InputError(which, f"{shown(name)}, {error.got}", error.expected, error.hint, place) from None
    rows = _rows(_text(content, name), name)
    if not rows:
        raise InputError(which, "a file without a header", "a line of names, then rows", "add them", name)
    (_, header), *body = rows
    names, units = _names(header, name)
    for line, row in body:
        if len(row) != len(names):
            got = f"{len(row)} cells"
            raise InputError(
                "the row", got, f"{len(names)}, as in the header", "add or remove commas", f"{name}:{line}"
            )
    if not body:
        got, hint = "a header without a row below it", "add rows, or name another file"
        raise InputError(which, f"{shown(name)}, {got}", "a file with rows", hint, place)
    cells = [tuple(_cell(row[k], units[k]) for _, row in body) for k in range(len(names))]
    return Table(name, dict(zip(names, cells, strict=True)), tuple(line for line, _ in body))


def _text(content: bytes, name: str) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        got = f"the byte 0x{content[error.start]:02x}, which is not UTF-8"
        raise InputError("the file", got, "text in UTF-8", "save the file as UTF-8", f"{name}:{line}") from None


def _rows(text: str, name: str) -> list[tuple[int, list[str]]]:
    """The rows that are not empty, each with its line."""
    first = text.partition("\n")[0]
    reader = csv.reader(text.splitlines(keepends=True), delimiter="," if "," in first or ";" not in first else ";")
    found: list[tuple[int, list[str]]] = []
    try:
        for row in reader:
            if not any(cell.strip() for cell in row):
                continue
            found.append((reader.line_num, [cell.strip() for cell in row]))
            _refuse_many(found, name)
    except csv.Error as error:
        place = f"{name}:{reader.line_num}"
        raise InputError("the file", str(error), "comma-separated cells", "correct the quotes", place) from None
    return found


def _refuse_many(found: list[tuple[int, list[str]]], name: str) -> None:
    line, row = found[-1]
    longest = max(map(len, row))
    for size, most, what in (
        (len(found) - 1, MOST_ROWS, "rows"), (len(row), MOST_COLUMNS, "columns"),
        (longest, LONGEST_CELL, "characters in a cell"),
    ):  # fmt: skip
        if size > most:
            got, hint = f"more than {most:,} {what}", "take a part of it"
            raise InputError("the file", got, f"at most {most:,} {what}", hint, f"{name}:{line}")


def _names(header: list[str], name: str) -> tuple[list[str], list[str]]:
    """Names of the columns, and the unit of each, empty for none."""
    pairs = [match.groups() if (match := _HEADER.fullmatch(cell)) else (cell, "") for cell in header]
    names = [one for one, _ in pairs]
    for one in names:
        if not one or names.count(one) > 1:
            got = f"the column {one!r} twice" if one else "a column without a name"
            raise InputError("the header", got, "a name for each column, each once", "rename it", f"{name}:1")
    return names, [unit for _, unit in pairs]


def _cell(text: str, unit: str) -> Any:
    """A number, a word, true or false; a number in a column with a unit as text with that unit."""
    value = scalar(text)
    plain = isinstance(value, (int, float)) and not isinstance(value, bool)
    return f"{text} {unit}" if unit and plain else value
