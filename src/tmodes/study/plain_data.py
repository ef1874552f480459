"""Plain data of a study file: what it may leave out, and the CSV tables that it names, written out."""

from __future__ import annotations

import csv
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from tmodes.errors import InputError
from tmodes.io.files import Folders, read_bytes
from tmodes.io.units import scalar
from tmodes.io.words import meant, nearest, shown
from tmodes.io.yaml_file import nearest_line
from tmodes.study.quantities import QUANTITIES

__all__ = ["MOST_ROWS", "CsvTable", "Shorthands", "expanded", "filled_places", "read_table"]

MOST_BYTES = 4 * 2**20
MOST_ROWS = 100_000
MOST_COLUMNS = 300
LONGEST_CELL = 1_000

_HEADER = re.compile(r"(.*?)\s*\[([^\[\]]{1,40})\]\s*")
"""A name with a unit in brackets."""


@dataclass(frozen=True)
class CsvTable:
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


def read_table(folders: Folders, name: str, which: str, place: str) -> CsvTable:
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
    return CsvTable(name, dict(zip(names, cells, strict=True)), tuple(line for line, _ in body))


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


USUAL_RUNS = 1000
"""Cases of a study that does not say which."""


@dataclass
class Shorthands:
    """Where a study's data comes from, and what is found on the way: ``errors`` in tables, places they have ``filled``.

    ``written``: keys as they stand in the file, by those for which they stand.
    """

    positions: dict[str, int]
    source: str
    folders: Folders | None
    errors: list[InputError] = field(default_factory=list)
    filled: dict[str, CsvTable] = field(default_factory=dict)
    written: dict[str, str] = field(default_factory=dict)

    def place(self, path: str) -> str:
        """File and line of a path."""
        return f"{self.source}:{nearest_line(path, self.positions)}" if self.source else ""

    def as_written(self, error: InputError) -> InputError:
        """An error by the key that stands in the file."""
        return replace(error, which=self.written.get(error.which, error.which))

    def table(self, name: str, which: str) -> CsvTable | None:
        """The table of a file; what is wrong with it is kept as an error."""
        try:
            if self.folders is None:
                hint = "write the values themselves, or read the study from its file"
                raise InputError(which, f"the file {name!r}", "no file, in a study without a folder", hint)
            return read_table(self.folders, name, which, self.place(which))
        except InputError as error:
            self.errors.append(error)
            return None


def expanded(data: dict[str, Any], found: Shorthands) -> dict[str, Any]:
    """The plain data, with the types of quantities and what stands in tables written out."""
    plain = {**data}
    if isinstance(groups := data.get("quantities"), Mapping):
        plain["quantities"] = {name: _typed(name, group, found) for name, group in groups.items()}
    if isinstance(groups := data.get("parameters"), Mapping):
        plain["parameters"] = {name: _with_table(name, group, found) for name, group in groups.items()}
    if isinstance(plan := data.get("plan", _usual_plan(groups)), Mapping):
        plain["plan"] = _with_cases(plan, found)
    return plain


def _usual_plan(parameters: Any) -> dict[str, Any]:
    """The plan of a study without one: all combinations where all is chosen, else cases as they are distributed."""
    varied = [*parameters.values()] if isinstance(parameters, Mapping) else []
    chosen = [isinstance(group, Mapping) and ("choices" in group or "catalogue" in group) for group in varied]
    return {"type": "grid"} if varied and all(chosen) else {"type": "monte_carlo", "runs": USUAL_RUNS}


def _typed(name: str, group: Any, found: Shorthands) -> Any:
    """A quantity with its ``type``: the kind that one of its keys names, which stands for the field of that name."""
    if not isinstance(group, Mapping) or "type" in group:
        return group
    group, positions = _corrected(name, group, found), found.positions
    for kind, member in QUANTITIES.items():
        if kind in group and member.named:
            found.written[f"quantities.{name}.{member.named}"] = f"quantities.{name}.{kind}"
            line = positions.get(f"quantities.{name}.{kind}")
            if line is not None:
                positions[f"quantities.{name}.{member.named}"] = line
            others = {key: value for key, value in group.items() if key != kind}
            return {"type": kind, member.named: group[kind], **others}
    return group


def _corrected(name: str, group: Mapping[Any, Any], found: Shorthands) -> Mapping[Any, Any]:
    """A quantity whose kind is misspelt, as it was meant, so that the rest of it is looked at; that is an error."""
    kinds = [kind for kind, member in QUANTITIES.items() if member.named]
    fields = {field for member in QUANTITIES.values() for field in member.model_fields}
    if any(kind in group for kind in kinds):
        return group
    for key in group:
        if isinstance(key, str) and key not in fields and (close := nearest(key, kinds)):
            which = f"quantities.{name}.{key}"
            hint = f"did you mean `{close}`?"
            found.errors.append(
                InputError(which, "an unknown key", f"one of {', '.join(kinds)}", hint, found.place(which))
            )
            return {close if each == key else each: value for each, value in group.items()}
    return group


def _with_table(name: str, group: Any, found: Shorthands) -> Any:
    """A parameter with the entries of its catalogue, or the values of a file of its distribution."""
    if not isinstance(group, Mapping):
        return group
    place = f"parameters.{name}"
    if isinstance(file := group.get("catalogue"), str) and not group.get("choices"):
        table = found.table(file, f"{place}.catalogue")
        rest = {key: value for key, value in group.items() if key != "catalogue"}
        return rest | {"choices": _entries(table, place, found) if table else [{"name": "none", "set": {}}]}
    if isinstance(group.get("distribution"), Mapping):
        return {**group, "distribution": _with_values(group["distribution"], f"{place}.distribution", found)}
    return {**group}


def _entries(table: CsvTable, place: str, found: Shorthands) -> list[dict[str, Any]]:
    """The entries of a catalogue; empty cells set nothing."""
    paths = [path for path in table.columns if path != "name"]
    try:
        names = table.column("name", f"{place}.catalogue", found.place(f"{place}.catalogue"))
    except InputError as error:
        found.errors.append(error)
        return [{"name": "none", "set": {}}]
    found.filled[f"{place}.choices"] = table
    return [
        {
            "name": str(name),
            "set": {path: table.columns[path][k] for path in paths if table.columns[path][k] is not None},
        }
        for k, name in enumerate(names)
    ]


def _with_values(group: Mapping[str, Any], place: str, found: Shorthands) -> dict[str, Any]:
    """A distribution with the values of its file, or of that of the one that it truncates."""
    if isinstance(group.get("distribution"), Mapping):
        return {**group, "distribution": _with_values(group["distribution"], f"{place}.distribution", found)}
    file, column = group.get("file"), group.get("column")
    if not isinstance(file, str) or group.get("values"):
        return {**group}
    rest = {key: value for key, value in group.items() if key not in ("file", "column")}
    table = found.table(file, f"{place}.file")
    if table is None:
        return rest | {"values": [0.0, 1.0]}
    name = column if isinstance(column, str) else next(iter(table.columns))
    try:
        cells = table.column(name, f"{place}.column", found.place(f"{place}.column"))
    except InputError as error:
        found.errors.append(error)
        return rest | {"values": [0.0, 1.0]}
    found.filled[f"{place}.values"] = table
    return rest | {"values": list(cells)}


def _with_cases(plan: Mapping[str, Any], found: Shorthands) -> dict[str, Any]:
    """A plan with the cases of its file."""
    if not isinstance(file := plan.get("file"), str) or plan.get("rows"):
        return {**plan}
    rest = {key: value for key, value in plan.items() if key != "file"}
    table = found.table(file, "plan.file")
    if table is None:
        return rest | {"rows": [{}]}
    found.filled["plan.rows"] = table
    rows = zip(*table.columns.values(), strict=True)
    named = [dict(zip(table.columns, row, strict=True)) for row in rows]
    return rest | {"rows": [{key: cell for key, cell in row.items() if cell is not None} for row in named]}


_NUMBERS = ("distribution",)
"""Groups of a parameter in which numbers with units stand."""


def filled_places(plain: Mapping[str, Any], filled: Collection[str]) -> tuple[str, ...]:
    """Dotted paths of the parts of plain data to look at: long tables were read already, and choices hold none."""
    return tuple(_places(plain, filled))


def _places(plain: Mapping[str, Any], filled: Collection[str]) -> Iterator[str]:
    for key, value in plain.items():
        if key == "parameters" and isinstance(value, Mapping):
            for name, group in value.items():
                yield from (
                    place
                    for part in _NUMBERS
                    if isinstance(group, Mapping) and part in group
                    for place in _without(group[part], f"parameters.{name}.{part}", filled)
                )
        elif key == "plan":
            yield from _without(value, "plan", filled)
        else:
            yield key


def _without(value: Any, path: str, filled: Collection[str]) -> Iterator[str]:
    """A path, or of a group in which something is filled the paths of all else in it."""
    if path in filled:
        return
    if isinstance(value, Mapping) and any(place.startswith(f"{path}.") for place in filled):
        for key, inner in value.items():
            yield from _without(inner, f"{path}.{key}", filled)
    else:
        yield path
