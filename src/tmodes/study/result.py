"""StudyResult: what a study folder holds; its rows, its table, the motions that it keeps."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.io.arguments import checked_arguments
from tmodes.io.atomic import file_error
from tmodes.io.printed import CommandResult, Table
from tmodes.io.words import count_of
from tmodes.study.answers import quantity_answers, study_sentence
from tmodes.study.blocks import Block, Cover, Label
from tmodes.study.plans import Design
from tmodes.study.rows import GOOD, STATUS, Kept, Rows, joined
from tmodes.study.statistics import CONFIDENCE, statistics
from tmodes.study.store import BLOCKS, PAGE, TABLE, Folder, description
from tmodes.study.study import Study
from tmodes.study.table import TableColumns, grouped, table_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

__all__ = ["StudyResult", "load_study"]


PERCENTILES = (1, 5, 25, 50, 75, 95, 99)
SHOWN = (5, 50, 95)
"""Percentiles of the plain data, and those that the table shows."""

MOST_REPORTED = 5
"""Cases that did not finish, reported one by one."""


@dataclass(eq=False, repr=False)
class StudyResult(CommandResult):
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
        return TableColumns(self.parquet).rows(self.study.names, list(self.study.sheet.quantities))

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

    @property
    def unfinished(self) -> list[str]:
        """What is said of a study that was interrupted."""
        if self.complete:
            return []
        done, cases = self.cover.done, len(self.design.values)
        return [f"these are {done:,} of {cases:,} cases; the same `tmodes study` computes the others"]

    @cached_property
    def answers(self) -> dict[str, str]:
        """What is found of each quantity in words, by its name; none of one that no case has."""
        return quantity_answers(self.study, self.shown_rows)

    @property
    def sentence(self) -> str:
        """The same of the first quantities, and how many cases finished."""
        return study_sentence([*self.answers.values()], self.shown_rows)

    @property
    def files(self) -> dict[str, str]:
        """The table and the page that are there."""
        known = {"table": self.parquet, "page": self.folder / PAGE}
        return {what: str(file) for what, file in known.items() if file.is_file()}

    @property
    def warnings(self) -> list[str]:
        """The first cases without a result, and why."""
        return self._spread["warnings"]

    def info(self) -> dict[str, Any]:
        """Counts, percentiles of each quantity over the cases that have it, and the reasons of the others."""
        return self._spread | {"sentence": self.sentence, "files": self.files}

    @property
    def data(self) -> Dataset:
        """Along ``case``: parameters and quantities with their units, ``status`` and ``reason``."""
        from xarray import Dataset

        rows, units = self.shown_rows, self.study.parameter_units
        series: dict[str, Any] = {
            name: ("case", values, {"units": units[name]}) for name, values in rows.parameters.items()
        }
        series |= {name: ("case", values, {"units": rows.units[name]}) for name, values in rows.quantities.items()}
        series |= {name: ("case", list(getattr(rows, name))) for name in ("status", "reason")}
        return Dataset(series, {"case": rows.case})

    def plot(self, ax: Any = None, quantity: str | None = None, over: str | None = None) -> list[Any]:
        """A quantity of all cases ``over`` a parameter; the first ones where none are named."""
        from tmodes.plot.commands import points

        data = self.data
        name, across = quantity or next(iter(self.study.sheet.quantities)), over or self.study.names[0]
        words = (f"{one} [{data[one].attrs['units']}]" for one in (across, name))
        return points({"": (data[across], data[name])}, *words, title=self.study.sheet.name, ax=ax)

    def tables(self) -> Iterator[str | Table]:
        """What is found in a sentence, the counts, the quantities, and where the files are.

        Percentiles only where cases come as often as their distributions say.
        """
        info = self._spread
        yield self.sentence
        counts = ", ".join(f"{count:,} {status.replace('_', ' ')}" for status, count in info["status"].items())
        percents = SHOWN if info["drawn"] else ()
        head = ["quantity", "unit", "least", *(f"{p} %" for p in percents), "largest", "mean"]
        rows = [
            [
                name, found["unit"], _number(found["min"]), *(_percentile(found, f"p{p}") for p in percents),
                _number(found["max"]), _number(found["mean"]),
            ]
            for name, found in info["quantities"].items()
        ]  # fmt: skip
        yield Table(f"{info['study']}: {count_of(info['cases'], 'case')}: {counts}", head, rows)
        if info["confidence"]:
            sure = f"{100 * info['confidence']:.0f} % confidence"
            yield f"In brackets: intervals of the percentiles at {sure}; - where there are too few cases for an end."
        for what, where in self.files.items():
            yield f"{what.capitalize()}: {where}"

    @cached_property
    def _spread(self) -> dict[str, Any]:
        """Counts and percentiles; of the table one column at a time is in memory."""
        columns, plan = TableColumns(self.parquet), type(self.study.sheet.plan)
        counts, failures = columns.counts(), columns.lost(MOST_REPORTED)
        good = sum(counts.get(status, 0) for status in GOOD)
        cases = columns.cases
        more, certain = cases - good - len(failures), plan.draws and not plan.repeats
        return {
            "study": self.study.sheet.name,
            "cases": cases,
            "status": counts,
            "good": good,
            "drawn": plan.draws,
            "confidence": CONFIDENCE if certain else None,
            "quantities": {
                name: _numbers_of(columns.numbers(name), columns.unit(name), certain=certain)
                for name in self.study.sheet.quantities
            },
            "failures": failures,
            "warnings": [f"case {one['case']} {one['status']}: {one['reason']}" for one in failures]
            + ([f"and {more:,} more cases without a result; the table has their reasons"] if more else []),
        }


def _numbers_of(values: NDArray[np.float64], unit: str, *, certain: bool) -> dict[str, Any]:
    """Numbers of a column; ``certain``: with intervals of the percentiles, null where too few cases give an end."""
    found = statistics(values, PERCENTILES)
    percents = {f"p{percent}": found.percentiles[percent] for percent in PERCENTILES}
    spread = {
        "min": found.least, **{key: one.value for key, one in percents.items()}, "max": found.largest,
        "mean": found.mean, "deviation": found.deviation if found.count != 1 else 0.0,
    }  # fmt: skip
    intervals = {key: [_known(one.low), _known(one.high)] for key, one in percents.items()}
    return {
        "unit": unit, "known": found.count, **{key: _known(value) for key, value in spread.items()},
        **({"intervals": intervals} if certain else {}),
    }  # fmt: skip


def _known(value: float) -> float | None:
    return value if isfinite(value) else None


def _percentile(found: dict[str, Any], key: str) -> str:
    """A percentile and its interval."""
    value = _number(found[key])
    if value == "-" or "intervals" not in found:
        return value
    low, high = map(_number, found["intervals"][key])
    return f"{value} [{low}, {high}]"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"


@checked_arguments
def load_study(
    folder: str | os.PathLike[str], functions: Mapping[str, Callable[[Any], float]] | None = None
) -> StudyResult:
    """A study from its folder, as far as it was computed, by the engine that has computed it.

    ``functions``: those of the study that are Python functions, which no folder holds. Raises
    :class:`tmodes.errors.ResultFileError` for a folder that is damaged, foreign or newer than this program.

    >>> _ = tmodes.run_study("study.yaml", "kept")
    >>> tmodes.load_study("kept").complete
    True
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
