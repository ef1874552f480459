"""Many cases of one sheet, each reduced to some numbers while it runs: memory does not grow with the samples."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.lanes.series import SUMS
from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, DISTANCES, OWN, Output, Outputs
from tmodes.errors import InputError, SimulationError
from tmodes.io.arguments import checked_arguments
from tmodes.sheet import Robot
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.batch.executor import PROCESSOR, Executor, thread_count
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.output_request import OutputRequest
from tmodes.simulation.reductions import Reduction, of_samples, of_sums, refuse_unknown_rules
from tmodes.simulation.solve import solve
from tmodes.simulation.vary.case_group import Indices
from tmodes.simulation.vary.programs import refused_cases
from tmodes.simulation.vary.simulate import Prepared, changes_of, checked, kept_cases, prepared
from tmodes.simulation.vary.single_case import single_case
from tmodes.simulation.vary.tables import GivenTable, Nominal, follows_nominal, nominal_variant, own_tip, setpoints
from tmodes.simulation.vary.values import RobotVariant, Whole

__all__ = ["Reduction", "reduced"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

_WHOLE = 64
"""Parts have a multiple of so many cases."""


@checked_arguments
def reduced(
    sheet: Robot,
    vary: Mapping[str, ArrayLike],
    reductions: Sequence[Reduction],
    *,
    threads: int | None = None,
    progress: Progress = lambda stage, share: None,
    kept: Collection[int] = (),
    wrong: str = "error",
    whole: Whole | None = None,
    executor: Executor = PROCESSOR,
) -> CaseResults:
    """Run k cases of one sheet and reduce their series to numbers; ``vary`` as of :func:`tmodes.simulate_batch`.

    Series are outputs by name (``joint.position``, ``tip.speed``, ``joint.effort``, ``contact.force``,
    ``energy.total``; :func:`tmodes.outputs` lists them), and three are distances of the tip [m]: ``deviation``
    from the nominal tip of the same case, ``tip_difference`` from the sheet's own run, ``tip_error`` from the commanded
    path. Numbers are those of :func:`tmodes.run` within the tolerance of the integration; ``values`` (k,) of the
    result has them by reduction, and only cases that finished or were stopped by a condition have some.

    Cases run side by side, or by themselves where they are stiff; each is run as :func:`tmodes.run` does where stop
    conditions or the energy may end it, which is slow. ``kept``:
    indices of cases whose motions are kept. ``wrong``: what becomes of cases that the sheet refuses: an ``error``
    before anything runs, or a ``row`` with the status ``refused``. ``whole``: where these cases are part of
    more, what of; what can be found once for all is then kept.
    ``executor``: what runs the cases, but for those that run by themselves and the sheet's own.

    Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for wrong numbers and unknown names,
    :class:`tmodes.errors.SimulationError` where no case can start.
    """
    refuse_other(sheet)
    refuse_unknown_rules(reductions)
    if wrong not in ("error", "row"):
        raise InputError("wrong", repr(wrong), "`error` or `row`", "leave it out")
    values, count, asked = checked(vary), thread_count(threads), tuple(dict.fromkeys(reductions))
    results = CaseResults.of_all(len(next(iter(values.values()))))
    _refuse_kept(sheet, kept, len(results))
    if wrong == "row":
        results.put(refused_cases(sheet, values), "refused")
    going = np.flatnonzero(results.status == "")
    if not len(going):
        expected, hint = "some that can run", str(results.message[0])
        raise InputError("vary", f"{len(results)} cases that are all refused", expected, hint)
    values_of = {path: numbers[going] for path, numbers in values.items()}
    units = _units(sheet, values_of, dict.fromkeys(one.series for one in asked))
    results.units |= {one: one.unit_of(units[one.series]) for one in asked}
    results.values |= {one: np.full(len(results), np.nan) for one in asked}
    own = own_tip(_unwatched(sheet), count) if OWN in {one.series.partition(".")[0] for one in asked} else None
    if _watched(sheet):
        _one_by_one(sheet, values, asked, own, going, results, count, progress)
    else:
        work = _Reducing.of(sheet, values_of, asked, own, count, executor, progress, whole)
        for places, part in work.parts(progress):
            results.take(going[places], part)
    results.kept |= kept_cases(sheet, values, kept, results.status.tolist(), count, progress)
    return results


def _refuse_kept(sheet: Robot, kept: Collection[int], size: int) -> None:
    for index in kept:
        if not 0 <= index < size:
            raise InputError("kept", str(index), f"indices from 0 to {size - 1}", "count cases from 0")
    if kept and _watched(sheet):
        expected = "no kept motions where stop conditions or the energy may end a run"
        raise InputError("kept", f"{len(kept)} cases", expected, "run these cases by themselves")


def _units(sheet: Robot, values: Mapping[str, Array], names: Collection[str]) -> dict[str, str]:
    """Units of the series, from the first case that can start."""
    first = ""
    for index in range(len(next(iter(values.values())))):
        try:
            setup = run_setup(sheet.with_(changes_of(values, index)).pair().real)
        except SimulationError as error:
            first = first or str(error)
            continue
        outputs = Outputs(setup.model.loop, tuple(DISTANCES))
        return {name: outputs.find(name, "reductions").unit for name in names}
    raise SimulationError(f"no case can start; the first one: {first}")


def _one_by_one(
    sheet: Robot, values: Mapping[str, Array], reductions: Sequence[Reduction], own: Array | None, indices: Indices,
    results: CaseResults, threads: int, progress: Progress,
) -> None:  # fmt: skip
    """Run cases by themselves, over threads."""
    tip = None if own is None else own[0]

    def one(index: int) -> None:
        began = clock.thread_time()
        done = single_case(sheet, changes_of(values, index), reductions, tip)
        done.seconds[:] = clock.thread_time() - began
        results.take([index], done)

    with ThreadPoolExecutor(threads, "tmodes-cases") as pool:
        for done, _ in enumerate(pool.map(one, indices.tolist()), 1):
            progress("running", done / len(indices))


def _watched(sheet: Robot) -> bool:
    """Whether something may end a run early."""
    settings = sheet.integration
    return bool(settings.stop or settings.stop_at_limits or settings.energy_stop)


def _unwatched(sheet: Robot) -> Robot:
    """The sheet without what may end a run early."""
    settings = {"stop": (), "stop_at_limits": False, "energy_stop": False}
    return sheet.model_copy(update={"integration": sheet.integration.model_copy(update=settings)})


@dataclass(frozen=True, eq=False)
class _Reducing:
    """Prepared cases, reduced part by part: series are folded in the loops, or written for rules on samples.

    ``own`` (1, n, 3): tip of the sheet's own run; ``nominal``: the nominal robots, where they are asked for.
    """

    lanes: Prepared
    reductions: tuple[Reduction, ...]
    own: Array | None
    nominal: Nominal | None
    threads: int
    executor: Executor

    @classmethod
    def of(
        cls, sheet: Robot, values: Mapping[str, Array], reductions: tuple[Reduction, ...], own: Array | None,
        threads: int, executor: Executor, progress: Progress, whole: Whole | None,
    ) -> _Reducing:  # fmt: skip
        """Prepare the cases, and the nominal robots where distances from them are asked for."""
        heads = {one.series.partition(".")[0] for one in reductions}
        shown = tuple(dict.fromkeys(one.series for one in reductions if "@" in one.series))
        lanes = prepared(sheet, values, keep=False, progress=progress, threads=threads, whole=whole, shown=shown)
        names, nominal = [name for name in (DEVIATION, COMMANDED) if name in heads], None
        variant = nominal_variant(sheet, values, names) if names else RobotVariant.ACTUAL
        planned = variant is RobotVariant.PLANNED
        if not all(setpoints(one.like) is not None or (planned and follows_nominal(one.like)) for one in lanes.groups):
            names = [name for name in names if name != COMMANDED]
        if names:
            nominal = Nominal.of(sheet, values, variant, names, threads, progress, whole)
        return cls(lanes, reductions, own, nominal, threads, executor)

    @cached_property
    def _shown(self) -> dict[int, dict[str, Output]]:
        """The outputs that are wanted, by the group's structure."""
        found: dict[int, dict[str, Output]] = {}
        given = (*(self.nominal.names if self.nominal else ()), *((OWN,) if self.own is not None else ()))
        for group in self.lanes.groups:
            outputs = Outputs(group.like.model.loop, given)
            wanted = {one.series: outputs[one.series] for one in self.reductions if one.series in outputs}
            found[id(group.like)] = wanted
        return found

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
        given = 3 * (len(self.nominal.names) if self.nominal else 0) + (0 if self.own is None else 3)
        series = len({one.series for one in self.reductions})
        numbers = (0 if self._common else given) + (0 if self._folds else series)
        longest = self.executor.longest
        most = self.executor.room // (8 * len(self.lanes.times) * numbers) if numbers else longest
        return min(max(most // _WHOLE, 1) * _WHOLE, longest, self.lanes.size)

    def parts(self, progress: Progress) -> Iterator[tuple[Indices, CaseResults]]:
        """Places and results of part after part, in the same room; those after an interruption are not begun."""
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
            part = CaseResults.of_all(lanes.size, "interrupted", "interrupted")
            if not ended and table is not None:
                part = self._part(lanes, table, lambda share, tell=tell: tell("running", share))
                ended = "interrupted" in part.status.tolist()
            which = np.flatnonzero(part.status != "")
            yield first + which, part.part(which)

    def _table(self, room: Array, first: int, size: int, progress: Callable[[float], None]) -> GivenTable:
        table = GivenTable(room[:1], {}, np.zeros(1))
        if self.nominal is not None:
            table = self.nominal.part(first, first + size).table(room, self.threads, progress, self.executor)
        if self.own is not None:
            shape = (len(table.numbers), *self.own.shape[1:])
            table = table._replace(numbers=np.concatenate([table.numbers, np.broadcast_to(self.own, shape)], axis=2))
        return table

    def _part(self, lanes: Prepared, table: GivenTable, progress: Callable[[float], None]) -> CaseResults:
        """Results of some cases."""
        going = [(group, self._shown[id(group.like)]) for group in lanes.groups]
        wanted = [self._wanted(tuple(shown.values()), lanes, table) for _, shown in going]
        empty = np.empty((lanes.size, 0, 0))
        works = [group.work(empty, one) for (group, _), one in zip(going, wanted, strict=True)]
        part = solve(works, lanes.size, executor=self.executor, threads=self.threads, progress=progress)
        part.put(lanes.failed, "failed")
        for (group, shown), one in zip(going, wanted, strict=True):
            part.method[group.places] = group.like.robot.integration.method
            self._fill(part, list(shown), one, group.places[part.status[group.places] == "finished"])
        if not self._common:
            part.seconds += table.seconds
        self._without_nominal(part, table)
        return part

    def _wanted(self, shown: tuple[Output, ...], lanes: Prepared, table: GivenTable) -> OutputRequest:
        each = (len(shown), len(SUMS)) if self._folds else (len(lanes.times), len(shown))
        return OutputRequest(shown, table.numbers, lanes.times, np.empty((lanes.size, *each)), self._folds)

    def _fill(self, part: CaseResults, names: list[str], wanted: OutputRequest, ended: Indices) -> None:
        """The numbers of the cases that came to their end."""
        for one in self.reductions:
            values = part.value(one)
            if one.series not in names or not len(ended):
                continue
            k = names.index(one.series)
            if self._folds:
                values[ended] = of_sums(one, wanted.out[ended, k])
            else:
                values[ended] = of_samples(one, wanted.out[ended, :, k], wanted.times)

    def _without_nominal(self, part: CaseResults, table: GivenTable) -> None:
        """Cases whose nominal run came to no end have no deviation, and say why."""
        lost = dict.fromkeys(range(len(part)), table.lost[0]) if self._common and table.lost else table.lost
        for place, why in lost.items():
            for one, values in part.values.items():
                if one.series.partition(".")[0] == DEVIATION:
                    values[place] = np.nan
            if part.status[place]:
                part.message[place] = f"{part.message[place]}; there is no nominal run: {why}"
