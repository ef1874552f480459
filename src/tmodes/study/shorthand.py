"""What a study's file may leave out, and what stands in tables: written out in its plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from tmodes.errors import InputError
from tmodes.io.files import Folders
from tmodes.io.words import nearest
from tmodes.io.yaml_file import nearest_line
from tmodes.study.quantities import QUANTITIES
from tmodes.study.tables import Table, read_table

__all__ = ["Shorthands", "expanded"]

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
    filled: dict[str, Table] = field(default_factory=dict)
    written: dict[str, str] = field(default_factory=dict)

    def place(self, path: str) -> str:
        """File and line of a path."""
        return f"{self.source}:{nearest_line(path, self.positions)}" if self.source else ""

    def as_written(self, error: InputError) -> InputError:
        """An error by the key that stands in the file."""
        return replace(error, which=self.written.get(error.which, error.which))

    def table(self, name: str, which: str) -> Table | None:
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


def _entries(table: Table, place: str, found: Shorthands) -> list[dict[str, Any]]:
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
