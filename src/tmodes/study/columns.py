"""Columns: what is read of a study's table, one column or some rows at a time, however long it is."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from tmodes.io.atomic import file_error
from tmodes.io.plain_file import regular_file
from tmodes.study.extra import needed
from tmodes.study.rows import GOOD, STATUS, Rows

__all__ = ["Columns"]

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

    columns: Columns
    names: Sequence[str]

    def __len__(self) -> int:
        return len(self.names)

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        return self.columns.numbers(name)


@dataclass(frozen=True)
class Columns:
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
