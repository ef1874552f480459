"""Cases that were prepared, reduced part by part: series are folded in the loops, or written for rules on samples."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.lanes.series import SUMS
from tmodes.equations.loop.outputs import DEVIATION, OWN, Output, Outputs
from tmodes.simulation.batch.result import not_begun
from tmodes.simulation.batch.runner import Runner
from tmodes.simulation.batch.wanted import Wanted
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.reductions import Reduction, of_samples, of_sums
from tmodes.simulation.vary.lots import Indices, Lot
from tmodes.simulation.vary.simulate import Prepared
from tmodes.simulation.vary.tables import Nominal, Table

__all__ = ["Part", "Reducing"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

_WHOLE = 64
"""Parts have a multiple of so many cases."""


class Part(NamedTuple):
    """Cases by their ``places``: how their runs ended, and their numbers."""

    places: Indices
    runs: list[Trajectory]
    numbers: dict[Reduction, Array]


@dataclass(frozen=True, eq=False)
class Reducing:
    """Prepared cases and what is wanted of them.

    ``own`` (1, n, 3): tip of the sheet's own run; ``nominal``: the nominal robots, where they are asked for.
    ``runner``: what runs the cases.
    """

    lanes: Prepared
    reductions: tuple[Reduction, ...]
    own: Array | None
    nominal: Nominal | None
    threads: int
    runner: Runner

    @cached_property
    def _names(self) -> list[str]:
        return list(dict.fromkeys(one.series for one in self.reductions))

    @cached_property
    def _given(self) -> tuple[str, ...]:
        """Distances, in the order of the table."""
        return (*(self.nominal.names if self.nominal else ()), *((OWN,) if self.own is not None else ()))

    @cached_property
    def _shown(self) -> dict[int, dict[str, Output] | None]:
        """The outputs that are wanted, by the lot's structure; None where lanes do not give all that it has."""
        found: dict[int, dict[str, Output] | None] = {}
        for lot in self.lanes.lots:
            outputs = Outputs(lot.like.model.loop, self._given)
            wanted = {name: outputs[name] for name in self._names if name in outputs}
            found[id(lot.like)] = None if any(one.further for one in wanted.values()) else wanted
        return found

    @cached_property
    def left(self) -> Indices:
        """Cases that must run by themselves."""
        places = [lot.places for lot in self.lanes.lots if self._shown[id(lot.like)] is None]
        return np.concatenate([np.zeros(0, dtype=np.int64), *places])

    @cached_property
    def _folds(self) -> bool:
        return all(one.sampled is None for one in self.reductions)

    @cached_property
    def _common(self) -> bool:
        """Whether one table serves all cases."""
        return self.nominal is None or self.nominal.same

    @cached_property
    def _at_once(self) -> int:
        """Cases of a part."""
        numbers = (0 if self._common else 3 * len(self._given)) + (0 if self._folds else len(self._names))
        longest = self.runner.longest
        most = self.runner.room // (8 * len(self.lanes.times) * numbers) if numbers else longest
        return min(max(most // _WHOLE, 1) * _WHOLE, longest, self.lanes.size)

    def parts(self, progress: Progress) -> Iterator[Part]:
        """Part after part, in the same room; those after an interruption are not begun."""
        width = 3 * len(self.nominal.names) if self.nominal else 0
        room = np.empty((1 if self._common else self._at_once, len(self.lanes.times), width))
        table, ended = None, False
        for first in range(0, self.lanes.size, self._at_once):
            lanes = self.lanes.part(first, min(first + self._at_once, self.lanes.size))

            def tell(stage: str, share: float, first: int = first, size: int = lanes.size) -> None:
                progress(stage, (first + share * size) / self.lanes.size)

            if not ended and (table is None or not self._common):
                table = self._table(room, first, lanes.size, lambda share, tell=tell: tell("nominal", share))
                ended = table.interrupted
            if ended or table is None:
                part = _interrupted(lanes, self.reductions)
            else:
                part = self._part(lanes, table, lambda share, tell=tell: tell("running", share))
                ended = any(run.status == "interrupted" for run in part.runs)
            yield part._replace(places=first + part.places)

    def _table(self, room: Array, first: int, size: int, progress: Callable[[float], None]) -> Table:
        table = Table(room[:1], {}, np.zeros(1))
        if self.nominal is not None:
            table = self.nominal.part(first, first + size).table(room, self.threads, progress, self.runner)
        if self.own is not None:
            shape = (len(table.numbers), *self.own.shape[1:])
            table = table._replace(numbers=np.concatenate([table.numbers, np.broadcast_to(self.own, shape)], axis=2))
        return table

    def _part(self, lanes: Prepared, table: Table, progress: Callable[[float], None]) -> Part:
        going = [(lot, shown) for lot in lanes.lots if (shown := self._shown[id(lot.like)]) is not None]
        wanted = [self._wanted(tuple(shown.values()), lanes, table) for _, shown in going]
        empty = np.empty((lanes.size, 0, 0))
        works = [lot.work(lanes.times, empty, one) for (lot, _), one in zip(going, wanted, strict=True)]
        done = self.runner.run(works, self.threads, progress) if works else {}
        runs = {index: not_begun(empty[index], why) for index, why in lanes.failed.items()}
        numbers = {one: np.full(lanes.size, np.nan) for one in self.reductions}
        for (lot, shown), one in zip(going, wanted, strict=True):
            runs |= _named(done, lot)
            ended = [place for place in lot.places.tolist() if done[place].status == "finished"]
            self._fill(numbers, list(shown), one, np.array(ended, dtype=np.int64))
        if not self._common:
            runs = {place: _after(run, table.seconds[place]) for place, run in runs.items()}
        self._without_nominal(runs, numbers, table)
        places = np.array(sorted(runs), dtype=np.int64)
        found = {one: values[places] for one, values in numbers.items()}
        return Part(places, [runs[place] for place in places.tolist()], found)

    def _wanted(self, shown: tuple[Output, ...], lanes: Prepared, table: Table) -> Wanted:
        each = (len(shown), len(SUMS)) if self._folds else (len(lanes.times), len(shown))
        return Wanted(shown, table.numbers, lanes.times, np.empty((lanes.size, *each)), self._folds)

    def _fill(self, numbers: Mapping[Reduction, Array], names: list[str], wanted: Wanted, ended: Indices) -> None:
        """The numbers of the cases that came to their end."""
        for one, values in numbers.items():
            if one.series not in names or not len(ended):
                continue
            k = names.index(one.series)
            if self._folds:
                values[ended] = of_sums(one, wanted.out[ended, k])
            else:
                values[ended] = of_samples(one, wanted.out[ended, :, k], wanted.times)

    def _without_nominal(self, runs: dict[int, Trajectory], numbers: Mapping[Reduction, Array], table: Table) -> None:
        """Cases whose nominal run came to no end have no deviation, and say why."""
        lost = dict.fromkeys(runs, table.lost[0]) if self._common and table.lost else table.lost
        for place, why in lost.items():
            for one, values in numbers.items():
                if one.series.partition(".")[0] == DEVIATION:
                    values[place] = np.nan
            if place in runs:
                message = f"{runs[place].message}; there is no nominal run: {why}"
                runs[place] = replace(runs[place], message=message)


def _named(runs: Mapping[int, Trajectory], lot: Lot) -> dict[int, Trajectory]:
    """Runs of a lot with the name of its method."""
    method = lot.like.robot.integration.method
    for place in lot.places.tolist():
        runs[place].statistics.setdefault("method", method)
    return {place: runs[place] for place in lot.places.tolist()}


def _after(run: Trajectory, seconds: np.float64) -> Trajectory:
    """A run that took so many seconds more."""
    return replace(run, seconds=run.seconds + float(seconds))


def _interrupted(lanes: Prepared, reductions: Sequence[Reduction]) -> Part:
    empty = np.empty((0, 0))
    runs = [not_begun(empty, "interrupted", "interrupted") for _ in range(lanes.size)]
    return Part(np.arange(lanes.size), runs, {one: np.full(lanes.size, np.nan) for one in reductions})
