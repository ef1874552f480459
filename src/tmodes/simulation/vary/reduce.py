"""Many cases of one sheet, each reduced to some numbers while it runs: memory does not grow with the samples."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Collection, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, DISTANCES, OWN, Outputs
from tmodes.errors import InputError, SimulationError
from tmodes.io.arguments import checked_arguments
from tmodes.sheet import Robot
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.batch.result import COUNTS
from tmodes.simulation.batch.runner import PROCESSOR, Runner
from tmodes.simulation.batch.simulate import thread_count
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.reductions import Reduction, refuse_unknown_rules
from tmodes.simulation.start import run_setup
from tmodes.simulation.vary.alone import run_alone
from tmodes.simulation.vary.kept import Kept, kept_cases
from tmodes.simulation.vary.programs import refused_cases
from tmodes.simulation.vary.reducing import Reducing
from tmodes.simulation.vary.simulate import changes_of, checked, prepared
from tmodes.simulation.vary.tables import Nominal, nominal_side, own_tip, setpoints
from tmodes.simulation.vary.values import Whole

__all__ = ["Kept", "Reduced", "Reduction", "reduced"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]


@dataclass(frozen=True, eq=False)
class Reduced:
    """Numbers of k cases: ``values`` (k,) of each reduction, not-a-number where a case has none, and their ``units``.

    ``status``: finished, stopped_by_condition, diverged, stopped (a limit of the settings), interrupted, failed (it
    could not start), refused (the sheet takes no such number), and ``message`` what happened, for each case. Only cases
    of the first two have values. ``statistics``: steps, rejected, evaluations (k,) of the actual robot, ``method`` (k,)
    by which it was integrated, ``seconds`` (k,) of the processor, a share of those of the cases that ran at once.
    ``errors`` (k,): sum of the estimated errors of all steps, as a share of the size of what is integrated (at least
    absolute over relative tolerance), not-a-number by fixed steps and of cases that run by themselves.
    ``kept``: motions of some cases, by index.
    """

    values: dict[Reduction, Array]
    units: dict[Reduction, str]
    status: tuple[str, ...]
    message: tuple[str, ...]
    statistics: dict[str, NDArray[np.int64]]
    method: tuple[str, ...]
    seconds: Array
    errors: Array
    kept: dict[int, Kept] = field(default_factory=dict)

    @property
    def size(self) -> int:
        """Number of cases."""
        return len(self.status)


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
    runner: Runner = PROCESSOR,
) -> Reduced:
    """Run k cases of one sheet and reduce their series to numbers; ``vary`` as of :func:`tmodes.simulate_batch`.

    Series are outputs by name (``joint.position``, ``tip.speed``, ``joint.effort``, ``contact.force``,
    ``energy.total``; :func:`tmodes.outputs` lists them), and three are distances of the tip [m]: ``deviation``
    from the nominal tip of the same case, ``tip_difference`` from the sheet's own run, ``tip_error`` from the commanded
    path. Numbers are those of :func:`tmodes.run` within the tolerance of the integration.

    Cases run side by side, or by themselves where they are stiff; each is run as :func:`tmodes.run` does where stop
    conditions or the energy may end it, and for what is at stations along links, which is slow. ``kept``:
    indices of cases whose motions are kept. ``wrong``: what becomes of cases that the sheet refuses: an ``error``
    before anything runs, or a ``row`` with the status ``refused``. ``whole``: where these cases are part of more,
    what of; what can be found once for all is then kept.
    ``runner``: what runs the cases, but for those that run by themselves and the sheet's own.

    Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for wrong numbers and unknown names,
    :class:`tmodes.errors.SimulationError` where no case can start.
    """
    refuse_other(sheet)
    refuse_unknown_rules(reductions)
    if wrong not in ("error", "row"):
        raise InputError("wrong", repr(wrong), "`error` or `row`", "leave it out")
    values, count = checked(vary), thread_count(threads)
    size = len(next(iter(values.values())))
    _refuse_absent(kept, size)
    if kept and _watched(sheet):
        expected = "no kept motions where stop conditions or the energy may end a run"
        raise InputError("kept", f"{len(kept)} cases", expected, "run these cases by themselves")
    rows = _Rows(sheet, values, size, tuple(dict.fromkeys(reductions)), count, whole, runner)
    if wrong == "row":
        rows.refuse(refused_cases(sheet, values))
    rows.run(progress)
    found = rows.found()
    found.kept.update(kept_cases(sheet, values, kept, found.status, threads=count, progress=progress))
    return found


def _refuse_absent(kept: Collection[int], size: int) -> None:
    for index in kept:
        if not 0 <= index < size:
            raise InputError("kept", str(index), f"indices from 0 to {size - 1}", "count cases from 0")


class _Rows:
    """The rows of all cases, filled as they come."""

    def __init__(
        self, sheet: Robot, values: dict[str, Array], size: int, reductions: tuple[Reduction, ...], threads: int,
        whole: Whole | None, runner: Runner,
    ) -> None:  # fmt: skip
        self.sheet, self.values, self.reductions, self.threads = sheet, values, reductions, threads
        self.whole, self.runner = whole, runner
        self.columns = {one: np.full(size, np.nan) for one in reductions}
        self.status, self.message, self.method = ([""] * size for _ in range(3))
        self.counts = {name: np.zeros(size, dtype=np.int64) for name in COUNTS}
        self.seconds, self.errors = np.zeros(size), np.full(size, np.nan)
        self.units: dict[str, str] = {}

    def refuse(self, messages: Mapping[int, str]) -> None:
        """These cases are rows with their reason."""
        for index, why in messages.items():
            self.status[index], self.message[index] = "refused", why

    def run(self, progress: Progress) -> None:
        """Run all that are not refused."""
        going = np.array([k for k, status in enumerate(self.status) if not status], dtype=np.int64)
        if not len(going):
            raise InputError(
                "vary", f"{len(self.status)} cases that are all refused", "some that can run", self.message[0]
            )
        values = {path: numbers[going] for path, numbers in self.values.items()}
        names = list(dict.fromkeys(one.series for one in self.reductions))
        self._learn(values, names)
        heads = {name.partition(".")[0] for name in names}
        own = own_tip(_unwatched(self.sheet), self.threads) if OWN in heads else None
        if _watched(self.sheet):
            self._alone(going, own, progress)
            return
        lanes = prepared(self.sheet, values, keep=False, progress=progress, threads=self.threads, whole=self.whole)
        distances = [name for name in DISTANCES if name in heads]
        if COMMANDED in heads and any(setpoints(lot.like) is None for lot in lanes.lots):
            distances.remove(COMMANDED)
        nominal, planned = None, [name for name in (DEVIATION, COMMANDED) if name in distances]
        if planned:
            nominal = Nominal.of(
                self.sheet, values, nominal_side(self.sheet, values, planned), planned, self.threads, progress,
                self.whole,
            )  # fmt: skip
        work = Reducing(lanes, self.reductions, own, nominal, self.threads, self.runner)
        for places, runs, numbers in work.parts(progress):
            self._take(going[places], runs, numbers)
        self._alone(going[work.left], own, progress)

    def _learn(self, values: Mapping[str, Array], names: Sequence[str]) -> None:
        """Units of the series, from the first case that can start."""
        first = ""
        for index in range(len(next(iter(values.values())))):
            try:
                setup = run_setup(self.sheet.with_(changes_of(values, index)).pair().real)
                break
            except SimulationError as error:
                first = first or str(error)
        else:
            raise SimulationError(f"no case can start; the first one: {first}")
        outputs = Outputs(setup.model.loop, tuple(DISTANCES))
        self.units = {name: outputs.find(name, "reductions").unit for name in names}

    def _take(self, places: NDArray[np.int64], runs: Sequence[Trajectory], numbers: Mapping[Reduction, Array]) -> None:
        for one, found in numbers.items():
            self.columns[one][places] = found
        for index, run in zip(places.tolist(), runs, strict=True):
            self.status[index], self.message[index], self.seconds[index] = run.status, run.message, run.seconds
            for name in COUNTS:
                self.counts[name][index] = run.statistics[name]
            self.method[index] = run.statistics.get("method", "")
            self.errors[index] = run.statistics.get("errors", np.nan)

    def _alone(self, indices: NDArray[np.int64], own: Array | None, progress: Progress) -> None:
        """Run cases by themselves, over threads."""
        if not len(indices):
            return
        tip = None if own is None else own[0]

        def one(index: int) -> None:
            began = clock.thread_time()
            done = run_alone(self.sheet, changes_of(self.values, index), self.reductions, tip)
            self.status[index], self.message[index], self.method[index] = done.status, done.message, done.method
            for name, count in done.counts.items():
                self.counts[name][index] = count
            for reduction, value in done.values.items():
                self.columns[reduction][index] = value
            self.seconds[index] = clock.thread_time() - began

        with ThreadPoolExecutor(self.threads, "tmodes-cases") as pool:
            for done, _ in enumerate(pool.map(one, indices.tolist()), 1):
                progress("running", done / len(indices))

    def found(self) -> Reduced:
        """All rows."""
        units = {one: one.unit_of(self.units[one.series]) for one in self.reductions}
        info = tuple(self.status), tuple(self.message), self.counts, tuple(self.method), self.seconds, self.errors
        return Reduced(self.columns, units, *info)


def _watched(sheet: Robot) -> bool:
    """Whether something may end a run early."""
    settings = sheet.integration
    return bool(settings.stop or settings.stop_at_limits or settings.energy_stop)


def _unwatched(sheet: Robot) -> Robot:
    """The sheet without what may end a run early."""
    settings = {"stop": (), "stop_at_limits": False, "energy_stop": False}
    return sheet.model_copy(update={"integration": sheet.integration.model_copy(update=settings)})
