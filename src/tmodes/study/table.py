"""The table of a study: one Parquet file, written block by block, read by columns or rows, larger than memory."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write, file_error
from tmodes.io.plain_file import regular_file
from tmodes.study.extra import needed
from tmodes.study.rows import GOOD, OWN_COLUMNS, STATUS, Rows, joined
from tmodes.study.store import TABLE, Folder

if TYPE_CHECKING:
    from tmodes.study.blocks import Cover, Part
    from tmodes.study.store import Folder
    from tmodes.study.study import Study

__all__ = [
    "ROW_GROUP",
    "TableColumns",
    "facts_of",
    "grouped",
    "merged",
    "refuse_names",
    "rows_of",
    "table_of",
    "write_table",
]


def rows_of(folder: Folder, part: Part) -> Rows:
    """The rows of a part, with the quantities of the study in its order. A block that has vanished is an error."""
    return merged([folder.block(label).rows for label in part.labels], list(folder.keys))


def merged(parts: list[Rows], quantities: list[str]) -> Rows:
    """One set of rows of the same cases, whose quantities were computed apart.

    A case is as bad as in the worst of them: of the first that is not finished its status and reason are taken;
    seconds are added.
    """
    first = parts[0]
    columns = {name: values for rows in reversed(parts) for name, values in rows.quantities.items()}
    units = {name: unit for rows in reversed(parts) for name, unit in rows.units.items()}
    worst = [
        next((k for k, s in enumerate(each) if s not in GOOD), 0)
        for each in zip(*(p.status for p in parts), strict=True)
    ]
    status, reason = ([getattr(parts[k], of)[row] for row, k in enumerate(worst)] for of in ("status", "reason"))
    method = [next((word for word in words if word), "") for words in zip(*(p.method for p in parts), strict=True)]
    return Rows(
        first.case, first.parameters, {name: columns[name] for name in quantities if name in columns}, units,
        status, reason, method, seconds=np.sum([rows.seconds for rows in parts], axis=0),
        kept={case: motion for rows in parts for case, motion in rows.kept.items()},
        errors=np.fmax.reduce([rows.errors for rows in parts]),
    )  # fmt: skip


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


_AT_ONCE = 100_000
"""Words that are in memory one by one."""


@dataclass(frozen=True, eq=False)
class _Words(Sequence[str]):
    """Many words of which few differ: ``codes`` (k,) are their places in ``known``."""

    codes: NDArray[np.int32]
    known: list[str]

    def __len__(self) -> int:
        return len(self.codes)

    @overload
    def __getitem__(self, index: int) -> str: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[str]: ...
    def __getitem__(self, index: int | slice) -> str | Sequence[str]:
        found = self.codes[index]
        return self.known[int(found)] if np.ndim(found) == 0 else _Words(np.asarray(found), self.known)

    def __iter__(self) -> Iterator[str]:
        for first in range(0, len(self.codes), _AT_ONCE):
            yield from map(self.known.__getitem__, self.codes[first : first + _AT_ONCE].tolist())


@dataclass(frozen=True, eq=False)
class _Read(Mapping[str, NDArray[np.float64]]):
    """Columns of numbers by their names."""

    columns: TableColumns
    names: Sequence[str]

    def __len__(self) -> int:
        return len(self.names)

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        return self.columns.numbers(name)


@dataclass(frozen=True)
class TableColumns:
    """The columns of a table.parquet; nothing is kept in memory."""

    path: Path

    @contextmanager
    def _file(self) -> Iterator[Any]:
        """The table, open; what cannot be read of it is an error of the file."""
        pa, pq = needed("pyarrow", "study"), needed("pyarrow.parquet", "study")
        try:
            with regular_file(self.path, sys.maxsize) as (opened, _):
                yield pq.ParquetFile(opened)
        except (OSError, pa.ArrowException) as error:
            hint = "run the study again: the same command writes the table from what is stored"
            raise file_error(self.path, f"no table ({error})", "the table of a study", hint) from error

    @property
    def cases(self) -> int:
        """How many rows it has."""
        with self._file() as file:
            return int(file.metadata.num_rows)

    def numbers(self, name: str) -> NDArray[np.float64]:
        """A column of numbers (k,), not-a-number where a case has none."""
        with self._file() as file:
            found, first = np.empty(file.metadata.num_rows), 0
            for part in file.iter_batches(columns=[name]):
                values = part.column(0).to_numpy(zero_copy_only=False)
                found[first : first + len(values)] = values
                first += len(values)
        return found

    def words(self, name: str) -> Sequence[str]:
        """A column of words, each kept once."""
        known = dict[str, int]()
        with self._file() as file:
            codes, first = np.empty(file.metadata.num_rows, dtype=np.int32), 0
            for part in file.iter_batches(columns=[name]):
                found = part.column(0).dictionary_encode()
                own = [known.setdefault(word, len(known)) for word in found.dictionary.to_pylist()]
                codes[first : first + len(found)] = np.array(own, dtype=np.int32)[found.indices.to_numpy()]
                first += len(found)
        return _Words(codes, list(known))

    def rows(self, parameters: Sequence[str], quantities: Sequence[str]) -> Rows:
        """All rows, without motions; a column of numbers is read when it is asked for, and not kept."""
        units = {name: self.unit(name) for name in quantities}
        nothing = np.broadcast_to(np.nan, (self.cases,))
        return Rows(
            np.arange(self.cases), _Read(self, parameters), _Read(self, quantities), units,
            self.words("status"), self.words("reason"), self.words("method"), self.numbers("seconds"), errors=nothing,
        )  # fmt: skip

    def unit(self, name: str) -> str:
        """Unit of a column, empty where none is known."""
        with self._file() as file:
            return ((file.schema_arrow.field(name).metadata or {}).get(b"unit") or b"").decode()

    def counts(self) -> dict[str, int]:
        """How many cases ended in which way, those of which there is any."""
        found: Counter[str] = Counter()
        with self._file() as file:
            for part in file.iter_batches(columns=["status"]):
                found.update({one["values"]: one["counts"] for one in part.column(0).value_counts().to_pylist()})
        return {status: found[status] for status in STATUS if found[status]}

    def lost(self, most: int) -> list[dict[str, Any]]:
        """``case``, ``status`` and ``reason`` of the first cases that did not reach their end."""
        found: list[dict[str, Any]] = []
        with closing(self._lost()) as parts:
            for part in parts:
                found += part
                if len(found) >= most:
                    break
        return found[:most]

    def _lost(self) -> Generator[Sequence[dict[str, Any]]]:
        columns, pa = ["case", "status", "reason"], needed("pyarrow", "study")
        good = needed("pyarrow.compute", "study")
        with self._file() as file:
            for part in file.iter_batches(columns=columns):
                ended = good.is_in(part.column(1), value_set=pa.array(GOOD))
                yield part.filter(good.invert(ended)).to_pylist()
