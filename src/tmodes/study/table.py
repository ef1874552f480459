"""The table of a study: one Parquet file, written block by block, so that it may be larger than memory."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write
from tmodes.study.extra import needed
from tmodes.study.parts import rows_of
from tmodes.study.rows import OWN_COLUMNS, Rows, joined
from tmodes.study.store import TABLE, Folder

if TYPE_CHECKING:
    from tmodes.study.cover import Cover
    from tmodes.study.study import Study

__all__ = ["ROW_GROUP", "facts_of", "grouped", "refuse_names", "table_of", "write_table"]

ROW_GROUP = 100_000
"""Rows that are in memory at once, as they are written."""

Progress = Callable[[str, float], None]


def write_table(folder: Folder, cover: Cover, labels: Mapping[int, str], progress: Progress) -> None:
    """Write table.parquet of all cases, sorted by case."""
    pq = needed("pyarrow.parquet", "study")
    done, total = 0, len(folder.values)
    with atomic_write(folder.path / TABLE) as path, path.open("wb") as file:
        writer = None
        try:
            for rows in grouped(folder, cover):
                progress("table", done / total)
                table = table_of(folder.study, rows, labels, facts_of(folder))
                writer = writer or pq.ParquetWriter(file, table.schema, compression="zstd")
                writer.write_table(table)
                done += len(rows)
        finally:
            if writer:
                writer.close()


def facts_of(folder: Folder) -> dict[str, str]:
    """Where a table comes from, for its metadata."""
    return {"tmodes.study": folder.study.sheet.name, "tmodes.engine": folder.engine, "tmodes.base": folder.base}


def grouped(folder: Folder, cover: Cover) -> Iterator[Rows]:
    """Rows in order without their motions, some 100,000 at a time, whatever the size of the blocks."""
    gathered: list[Rows] = []
    for part in cover.parts:
        gathered.append(replace(rows_of(folder, part), kept={}))
        if sum(map(len, gathered)) >= ROW_GROUP:
            yield joined(gathered)
            gathered = []
    if gathered:
        yield joined(gathered)


def table_of(study: Study, rows: Rows, labels: Mapping[int, str], facts: Mapping[str, str] = {}) -> Any:
    """Rows as a table of pyarrow: units and titles are in the metadata of the fields; no number is null."""
    pa = needed("pyarrow", "study")
    refuse_names(study)
    fields: list[Any] = []
    columns: list[Any] = []

    def add(name: str, values: Any, kind: Any, **about: str) -> None:
        said = {key: text for key, text in about.items() if text}
        fields.append(pa.field(name, kind, metadata=said or None))
        columns.append(pa.array(values, kind, from_pandas=True))

    add("case", rows.case, pa.int64())
    if labels:
        add("label", [labels.get(case) for case in rows.case.tolist()], pa.string())
    for name, values in rows.parameters.items():
        parameter = study.sheet.parameters[name]
        names = [choice.name for choice in parameter.choices]
        about = {"title": parameter.title, "role": "parameter"}
        if names:
            index = values.astype(np.int64)
            add(name, index, pa.int64(), **about)
            add(f"{name}.name", [names[each] for each in index.tolist()], pa.string(), **about)
        else:
            add(name, values, pa.float64(), unit=study.parameter_units[name], path=parameter.path or "", **about)
    for name, values in rows.quantities.items():
        about = {"title": study.sheet.quantities[name].title, "role": "quantity"}
        add(name, values, pa.float64(), unit=rows.units.get(name, ""), **about)
    for name in ("status", "reason", "method"):
        add(name, list(getattr(rows, name)), pa.string())
    add("seconds", rows.seconds, pa.float64(), unit="s")
    add("errors", rows.errors, pa.float64(), unit="-", title="sum of the estimated errors of all steps")
    return pa.Table.from_arrays(columns, schema=pa.schema(fields, metadata=dict(facts)))


def refuse_names(study: Study) -> None:
    """A parameter or quantity under the name of a column of ours, or twice, would hide one."""
    names = [*study.sheet.parameters, *study.sheet.quantities]
    names += [f"{name}.name" for name, parameter in study.sheet.parameters.items() if parameter.choices]
    for name in names:
        if name in OWN_COLUMNS or names.count(name) > 1:
            expected = f"a name of its own, none of {', '.join(OWN_COLUMNS)}"
            raise InputError(f"column {name}", "a name that the table has already", expected, "choose another name")
