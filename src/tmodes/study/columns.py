"""Columns: what is read of a study's table, one column or some rows at a time, however long it is."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.io.atomic import file_error
from tmodes.study.extra import needed
from tmodes.study.rows import GOOD, STATUS

__all__ = ["Columns"]


@dataclass(frozen=True)
class Columns:
    """The columns of a table.parquet; nothing is kept in memory."""

    path: Path

    def _file(self) -> Any:
        try:
            return needed("pyarrow.parquet", "study").ParquetFile(self.path)
        except (OSError, ValueError) as error:
            hint = "run the study again: the same command writes the table from what is stored"
            raise file_error(self.path, f"no table ({error})", "the table of a study", hint) from error

    @property
    def cases(self) -> int:
        """How many rows it has."""
        return int(self._file().metadata.num_rows)

    def numbers(self, name: str) -> NDArray[np.float64]:
        """A column of numbers (k,), not-a-number where a case has none."""
        file = self._file()
        found, first = np.empty(file.metadata.num_rows), 0
        for part in file.iter_batches(columns=[name]):
            values = part.column(0).to_numpy(zero_copy_only=False)
            found[first : first + len(values)] = values
            first += len(values)
        return found

    def unit(self, name: str) -> str:
        """Unit of a column, empty where none is known."""
        return ((self._file().schema_arrow.field(name).metadata or {}).get(b"unit") or b"").decode()

    def counts(self) -> dict[str, int]:
        """How many cases ended in which way, those of which there is any."""
        found: Counter[str] = Counter()
        for part in self._file().iter_batches(columns=["status"]):
            found.update({one["values"]: one["counts"] for one in part.column(0).value_counts().to_pylist()})
        return {status: found[status] for status in STATUS if found[status]}

    def lost(self, most: int) -> list[dict[str, Any]]:
        """``case``, ``status`` and ``reason`` of the first cases that did not reach their end."""
        found: list[dict[str, Any]] = []
        for part in self._lost():
            found += part
            if len(found) >= most:
                break
        return found[:most]

    def _lost(self) -> Iterator[Sequence[dict[str, Any]]]:
        columns, pa = ["case", "status", "reason"], needed("pyarrow", "study")
        good = needed("pyarrow.compute", "study")
        for part in self._file().iter_batches(columns=columns):
            ended = good.is_in(part.column(1), value_set=pa.array(GOOD))
            yield part.filter(good.invert(ended)).to_pylist()
