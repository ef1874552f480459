"""StudyResult: what a study folder holds; its rows, its table, the motions that it keeps."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from tmodes.errors import InputError
from tmodes.io.arguments import checked_arguments
from tmodes.io.atomic import file_error
from tmodes.study.blocks import Block, Label
from tmodes.study.completed_blocks import Cover
from tmodes.study.plans import Design
from tmodes.study.rows import STATUS, Kept, Rows, joined
from tmodes.study.store import BLOCKS, TABLE, Folder, description
from tmodes.study.study import Study
from tmodes.study.table import Columns, grouped, table_of

__all__ = ["StudyResult", "load_study"]


@dataclass(eq=False)
class StudyResult:
    """A study and what was computed of it. ``design``: its cases; those that are not computed yet have no row."""

    study: Study
    folder: Path
    design: Design
    stored: Folder = field(repr=False)
    _open: Block | None = field(default=None, repr=False)

    @cached_property
    def cover(self) -> Cover:
        """Which cases are stored."""
        return self.stored.cover()

    @property
    def complete(self) -> bool:
        """Whether every case has all of its quantities."""
        return self.cover.complete

    @cached_property
    def rows(self) -> Rows:
        """All rows that are there, sorted by case, without motions; all in memory (:meth:`blocks`: some at a time).

        Raises :class:`tmodes.errors.ResultFileError` where there is none.
        """
        parts = [*self.blocks()]
        if not parts:
            hint = "run it: tmodes study STUDY.yaml --out FOLDER"
            raise file_error(f"folder {self.folder}", "no case that is computed", "a study that has run", hint)
        return joined(parts)

    @property
    def shown_rows(self) -> Rows:
        """The same for what takes one column at a time: read from the table, where it is whole and of these cases."""
        if not self.stored.has_table:
            return self.rows
        return Columns(self.parquet).rows(self.study.names, list(self.study.sheet.quantities))

    def blocks(self) -> Iterator[Rows]:
        """The rows in order, some 100,000 at a time."""
        return grouped(self.stored, self.cover)

    def table(self) -> Any:
        """All rows as a pyarrow.Table with units in the metadata of its fields."""
        return table_of(self.study, self.rows, self.design.labels)

    @property
    def parquet(self) -> Path:
        """The table as a file; there once the study was complete."""
        return self.folder / TABLE

    @cached_property
    def counts(self) -> dict[str, int]:
        """How many cases ended in which way, those of which there is any."""
        found = Counter(status for rows in self.blocks() for status in rows.status)
        return {status: found[status] for status in STATUS if found[status]}

    @cached_property
    def kept_cases(self) -> tuple[int, ...]:
        """The cases whose whole motion is stored."""
        blocks = {label.name: label for label in self._keepers.values()}
        return tuple(sorted(case for label in blocks.values() for case in self.stored.block(label).rows.kept))

    @cached_property
    def _keepers(self) -> dict[int, Label]:
        return self.stored.keepers()

    @checked_arguments
    def kept(self, case: int) -> Kept:
        """The whole motion of a case. Raises :class:`tmodes.errors.InputError` where it was not kept."""
        label = self._keepers.get(case)
        if label is not None and (self._open is None or self._open.label != label):
            self._open = self.stored.block(label)
        motion = None if label is None or self._open is None else self._open.rows.kept.get(case)
        if motion is None:
            hint = "name it under keep.cases in the study, and run it again"
            raise InputError("case", str(case), "a case whose motion was kept", hint)
        return motion


@checked_arguments
def load_study(
    folder: str | os.PathLike[str], functions: Mapping[str, Callable[[Any], float]] | None = None
) -> StudyResult:
    """A study from its folder, as far as it was computed, by the engine that has computed it.

    ``functions``: those of the study that are Python functions, which no folder holds. Raises
    :class:`tmodes.errors.ResultFileError` for a folder that is damaged, foreign or newer than this program.
    """
    path = Path(folder)
    info = description(path)
    study = Study.from_data(info["data"], functions=functions or {})
    design = study.design()
    stored = Folder.of(path, study, design.values)
    if info["base"] != stored.base or info["cases"] != len(design.values):
        hint = "read it with the version of tmodes that has written it, or run the study again"
        raise file_error(path / BLOCKS, "a study whose data mean something else here", "the same study", hint)
    stored.engine, stored.table = info["engine"], info["table"]
    return StudyResult(study, path, design, stored)
