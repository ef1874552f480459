"""Many robots of one data sheet with some numbers varied: a sweep, or a Monte Carlo study."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from itertools import accumulate
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError, SimulationError, TmodesError, error_words
from tmodes.integrate.settings import refuse_stops
from tmodes.io.arguments import checked_arguments
from tmodes.io.words import shown
from tmodes.sheet import Robot
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.batch.executor import thread_count
from tmodes.simulation.batch.result import BatchRun, check_room, room_for, stored
from tmodes.simulation.case_results import CaseResults, Kept
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.parts import sample_times
from tmodes.simulation.solve import solve
from tmodes.simulation.vary.arrays import array_groups, family_of
from tmodes.simulation.vary.case_group import CaseGroup, Indices, StateColumns, grouped
from tmodes.simulation.vary.values import RobotVariant, Whole, changed_sheet, changes_of, checked

__all__ = ["Prepared", "kept_cases", "prepared", "run_prepared", "simulate_batch"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]
Figures = Callable[[BatchRun], Mapping[str, Array]]

_ROOM = 128_000_000
"""Bytes of the samples that figures are made of at once."""

_WHOLE = 64
"""Lanes that are taken at once, or a multiple of it."""


@checked_arguments
def simulate_batch(
    sheet: Robot,
    vary: Mapping[str, ArrayLike],
    *,
    tips: bool = False,
    threads: int | None = None,
    out: str | os.PathLike[str] | None = None,
    figures: Figures | None = None,
    progress: Progress = lambda stage, share: None,
) -> BatchRun:
    """Run k robots of one sheet at once: ``vary`` holds k numbers for each path that differs.

    Paths are those of ``with_`` and of ``--set`` (``gear.stiffness``, ``real.gear.stiffness``), but for
    ``integration``, which all share. Each lane is checked like a sheet, and runs as the actual robot of
    :func:`tmodes.run`, without a reference. ``tips``: also where the tip was. ``threads``: None for one on each core.
    ``out``: a folder for the samples, where they are too many for memory. ``figures``: what is wanted in place of them:
    it is given one part of the batch after the other, with states (and tips), and gives numbers (k,) of its lanes by
    name. ``progress`` is given the stage and its share.

    Lanes may differ in their states, as with a rigid gear next to elastic ones: the batch has those of all lanes, a
    motor without a coordinate of its own moves as its joint, those of a link are zero, others (as of a longer delay)
    not-a-number. A lane that cannot start
    (``failed``) or cannot continue keeps what it had and disturbs no other: look at ``status`` and ``message``. Raises
    :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for wrong numbers, reporting their lane;
    :class:`tmodes.errors.SimulationError` where none can start.

    >>> tmodes.simulate_batch(robot, {"joints.joint.gear.stiffness": [80.0, 120.0]}).status
    ('finished', 'finished')
    """
    if figures and out is not None:
        raise InputError("out", "a folder", "no folder where figures are asked for", "leave out one of the two")
    lanes = prepared(
        sheet.commanded(progress, vary), vary, out=out, keep=figures is None, progress=progress, threads=threads
    )
    return run_prepared(lanes, tips=tips, threads=threads, figures=figures, progress=progress)


@dataclass(frozen=True, eq=False)
class Prepared:
    """Lanes that were checked and can run, and why others cannot; ``values`` (k,) describe them, by path.

    ``failed``: messages by place. ``times`` (n,) [s]: of the samples; ``folder``: where they go, or None.
    """

    size: int
    groups: Sequence[CaseGroup]
    failed: Mapping[int, str]
    columns: StateColumns
    values: dict[str, Array]
    times: Array
    folder: Path | None

    def part(self, first: int, stop: int) -> Prepared:
        """Some lanes, as a batch of their own in memory."""
        failed = {index - first: why for index, why in self.failed.items() if first <= index < stop}
        groups = [part for group in self.groups if len((part := group.part(first, stop)).places)]
        values = {path: numbers[first:stop] for path, numbers in self.values.items()}
        return replace(self, size=stop - first, groups=groups, failed=failed, values=values, folder=None)


def prepared(
    sheet: Robot,
    vary: Mapping[str, ArrayLike] | None,
    *,
    out: str | os.PathLike[str] | None = None,
    keep: bool = True,
    progress: Progress = lambda stage, share: None,
    variant: RobotVariant = RobotVariant.ACTUAL,
    threads: int | None = None,
    whole: Whole | None = None,
    shown: tuple[str, ...] = (),
) -> Prepared:
    """All that can be wrong with a batch is reported here, before anything runs; see :func:`simulate_batch`.

    ``vary`` None: the sheet as it stands, as a batch of one lane. The room of samples to ``keep`` is asked for as soon
    as the size of a state is known. ``side``: which robot runs. ``whole``: what this batch is a part of, for
    which programs are found once. ``shown``: outputs that the lanes are to give.
    """
    refuse_other(sheet)
    values, folder = {} if vary is None else checked(vary), None if out is None else Path(out)
    count = thread_count(threads)
    size = len(next(iter(values.values()))) if values else 1
    refuse_stops(sheet.integration, "all lanes of a batch run")
    if sheet.integration.energy_stop:
        hint = "leave it out, or run the lane by itself (tmodes run)"
        raise InputError("integration.energy_stop", "true", "false: a batch watches no energy", hint)
    lanes: dict[int, RunSetup | str] = {}
    times, columns = sample_times(sheet.integration), None

    def one(index: int) -> RunSetup | str:
        nonlocal columns
        if index not in lanes:
            lanes[index] = lane = _lane(sheet, changes_of(values, index), variant, index)
            if isinstance(lane, RunSetup) and (columns is None or not columns.have(lane)):
                columns = StateColumns.of_all([lane for lane in lanes.values() if isinstance(lane, RunSetup)])
                check_room((size if keep else 1, len(times), columns.width), folder)
        return lanes[index]

    one(0)
    family = None
    if whole and values.keys() <= whole.ends.keys():
        own = whole._replace(ends={path: whole.ends[path] for path in values})
        family = family_of(sheet, variant, own, lambda changes: _lane(sheet, _plain_all(changes), variant, 0), shown)
    tell = partial(progress, "preparing")
    groups = array_groups(sheet, values, one, tell, variant, count, family, shown) if values else []
    done = np.zeros(size, dtype=bool)
    for group in groups:
        done[group.places] = True
    for index in np.flatnonzero(~done).tolist():
        one(index)
        progress("preparing", (index + 1) / size)
    if columns is None:
        raise SimulationError(f"no case can start; case 0: {lanes[0]}")
    left = {index: lane for index, lane in sorted(lanes.items()) if not done[index]}
    failed = {index: lane for index, lane in left.items() if isinstance(lane, str)}
    groups += grouped({index: lane for index, lane in left.items() if isinstance(lane, RunSetup)}, shown)
    return Prepared(size, groups, failed, columns, values, times, folder)


def run_prepared(
    batch: Prepared,
    *,
    tips: bool,
    threads: int | None = None,
    figures: Figures | None = None,
    progress: Progress = lambda stage, share: None,
) -> BatchRun:
    """Run lanes that were prepared; see :func:`simulate_batch`."""
    count = thread_count(threads)
    if figures:
        return _figures(batch, figures, count, progress, tips=tips)
    with room_for((batch.size, len(batch.times), batch.columns.width), batch.folder) as room:
        results = _run(batch, room, count, progress)
        done = _gathered(batch, room, results, _tips(batch, room, count, progress) if tips else None)
    return stored(done, batch.folder)


def _gathered(batch: Prepared, states: Array, results: CaseResults, tips: Array | None) -> BatchRun:
    done = BatchRun.of(batch.columns.coordinates, batch.times, states, results)
    return replace(done, values=batch.values, tips=tips)


def _figures(batch: Prepared, figures: Figures, threads: int, progress: Progress, *, tips: bool) -> BatchRun:
    """Run part after part in the same room, and keep the figures of each."""
    shape, results, found = (len(batch.times), batch.columns.width), CaseResults.of_all(batch.size), []
    room = np.empty((at_once := min(max(1, _ROOM // (8 * shape[0] * shape[1])), batch.size), *shape))
    for first in range(0, batch.size, at_once):
        part = batch.part(first, min(first + at_once, batch.size))

        def tell(stage: str, share: float, part: Prepared = part, first: int = first) -> None:
            progress(stage, (first + share * part.size) / batch.size)

        if len(results.ended("interrupted")):
            room[: part.size], some = np.nan, CaseResults.of_all(part.size, "interrupted", "interrupted")
        else:
            some = _run(part, room, threads, tell)
        where = _tips(part, room[: part.size], threads, tell) if tips else None
        found.append(_kept(figures, _gathered(part, room[: part.size], some, where)))
        results.take(np.arange(first, first + part.size), some)
    done = _gathered(batch, np.empty((batch.size, 0, shape[1])), results, None)
    return replace(done, figures={name: np.concatenate([one[name] for one in found]) for name in found[0]})


def _kept(figures: Figures, part: BatchRun) -> dict[str, Array]:
    """What ``figures`` gives of some lanes."""
    expected = f"arrays by their names, each with a row for each of {part.size} lanes"
    try:
        answer = figures(part)
    except TmodesError:
        raise
    except Exception as error:
        raise InputError("figures", error_words(error), expected, "correct the function") from error
    if not isinstance(answer, Mapping) or any(np.shape(one)[:1] != (part.size,) for one in answer.values()):
        raise InputError("what figures returns", shown(answer), expected, "correct the function")
    return dict(answer)


def _run(batch: Prepared, room: Array, threads: int, progress: Progress) -> CaseResults:
    """Run the lanes that could start, into a ``room`` (k, n, nx)."""
    room[[*batch.failed]] = np.nan
    width, shape = [*range(room.shape[2])], room.shape[:2]  # lanes with other states have rooms of their own,
    works = [  # at first of rows that take no memory
        group.work(room if batch.columns.of(group.like) == width else np.empty((*shape, group.starts.shape[1])))
        for group in batch.groups
    ]
    results = solve(works, batch.size, threads=threads, progress=lambda share: progress("running", share))
    results.put(batch.failed, "failed")
    for work, group in zip(works, batch.groups, strict=True):
        if work.states is not room:
            room[work.places] = batch.columns.filled(work.states[work.places], group.like)
    return results


def _tips(batch: Prepared, room: Array, threads: int, progress: Progress) -> Array:
    tips = np.full((*room.shape[:2], 3), np.nan)

    def fill(group: CaseGroup, which: Indices) -> int:
        columns, places = batch.columns.of(group.like), group.places[which].tolist()
        whole = columns == [*range(room.shape[2])]
        tips[places] = group.tips(which, batch.times, [room[k] if whole else room[k][:, columns] for k in places])
        return len(places)

    pieces = [(group, every[k : k + _WHOLE]) for group in batch.groups if len(every := np.arange(len(group.places)))
              for k in range(0, len(every), _WHOLE)]  # fmt: skip
    with ThreadPoolExecutor(threads, "tmodes-tips") as pool:
        for done in accumulate(pool.map(lambda piece: fill(*piece), pieces)):
            progress("tips", done / batch.size)
    return tips


def _plain_all(changes: Mapping[str, float]) -> dict[str, float | int]:
    return changes_of({path: np.array([value]) for path, value in changes.items()}, 0)


def _lane(sheet: Robot, changes: Mapping[str, float | int], variant: RobotVariant, index: int) -> RunSetup | str:
    """A lane, or why it cannot start."""
    robot = changed_sheet(sheet, changes, index, variant)
    try:
        return run_setup(robot, variant.follow).chosen()
    except SimulationError as error:
        return str(error)


def kept_cases(
    sheet: Robot, values: Mapping[str, Array], indices: Collection[int], status: Sequence[str],
    threads: int, progress: Progress,
) -> dict[int, Kept]:  # fmt: skip
    """The motions of some of the cases that have any, run again with all their samples."""
    chosen = [index for index in sorted({*indices}) if status[index] not in ("refused", "failed", "interrupted")]
    if not chosen:
        return {}
    some = {path: numbers[chosen] for path, numbers in values.items()}
    batch = run_prepared(prepared(sheet, some), tips=True, threads=threads, progress=lambda _, x: progress("kept", x))
    assert batch.tips is not None  # noqa: S101
    found: dict[int, Kept] = {}
    for k, index in enumerate(chosen):
        count = int(batch.counts[k])
        found[index] = Kept(batch.times[:count], batch.states[k, :count], batch.tips[k, :count], batch.coordinates)
    return found
