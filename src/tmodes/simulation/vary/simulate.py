"""Many robots of one data sheet with some numbers varied: a sweep, or a Monte Carlo study."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError, SimulationError
from tmodes.integrate.settings import refuse_stops
from tmodes.sheet import Robot
from tmodes.simulation.batch.result import BatchRun, check_room, gathered, load_batch, not_begun, room_for, write_batch
from tmodes.simulation.batch.simulate import prepare_loops
from tmodes.simulation.batch.work import Work, inputs
from tmodes.simulation.batch.workers import run_all, thread_count
from tmodes.simulation.parts import sample_times
from tmodes.simulation.vary.lanes import Lane, changed_sheet, lane_of

__all__ = ["Prepared", "prepared", "prepared_alone", "run_prepared", "simulate_batch"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]
Changes = Mapping[str, float | int]


def simulate_batch(
    sheet: Robot,
    vary: Mapping[str, ArrayLike],
    *,
    tips: bool = False,
    threads: int | None = None,
    out: str | os.PathLike[str] | None = None,
    progress: Progress = lambda stage, share: None,
) -> BatchRun:
    """Run k robots or arms of one sheet at once: ``vary`` holds k numbers for each path that differs.

    Paths are those of ``with_`` and of ``--set`` (``gear.stiffness``, ``real.gear.stiffness``), but for
    ``integration``, which all share. Each lane is checked like a sheet, becomes the real robot, and runs as
    :func:`tmodes.simulation.simulate.simulate_motion` runs it, without a
    reference run.
    ``tips``: also where the tip was. ``threads``: None for one on each core. ``out``: a folder for the samples, where
    they are too many for memory. ``progress`` is given the stage and its share.

    A lane that cannot start (``failed``) or cannot go on keeps what it had and disturbs no other: look at ``status``
    and ``message``. Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for wrong numbers,
    reporting their lane, and for lanes whose coordinates differ; :class:`tmodes.errors.SimulationError` where none can
    start.
    """
    return run_prepared(
        prepared(sheet, vary, out=out, progress=progress), tips=tips, threads=threads, progress=progress
    )


@dataclass(frozen=True, eq=False)
class Prepared:
    """Lanes that were checked and can run, or why not; ``values`` is what the batch describes them, by path.

    ``times`` (n,) [s]: of the samples; ``folder``: where they go, or None.
    """

    lanes: Sequence[Lane | str]
    values: dict[str, Array]
    times: Array
    folder: Path | None


def prepared(
    sheet: Robot,
    vary: Mapping[str, ArrayLike],
    *,
    out: str | os.PathLike[str] | None = None,
    progress: Progress = lambda stage, share: None,
) -> Prepared:
    """All that can be wrong with a batch is reported here, before anything runs; see :func:`simulate_batch`."""
    values = _checked(vary)
    size = len(next(iter(values.values())))
    changes = [{path: _plain(numbers[lane]) for path, numbers in values.items()} for lane in range(size)]
    return _prepared(sheet, changes, values, None if out is None else Path(out), progress)


def prepared_alone(sheet: Robot, progress: Progress = lambda stage, share: None) -> Prepared:
    """The sheet as it stands, as a batch of one lane."""
    return _prepared(sheet, [{}], {}, None, progress)


def run_prepared(
    batch: Prepared, *, tips: bool, threads: int | None = None, progress: Progress = lambda stage, share: None
) -> BatchRun:
    """Run lanes that were prepared; see :func:`simulate_batch`."""
    lanes, count = batch.lanes, thread_count(threads)
    with room_for((len(lanes), len(batch.times), _common_width(lanes)), batch.folder) as room:
        done = replace(_run(lanes, batch.times, room, count, progress), values=batch.values)
        if tips:
            done = replace(done, tips=_tips(done, lanes, progress))
    if batch.folder is None:
        return done
    write_batch(done, batch.folder)
    return load_batch(batch.folder)


def _prepared(
    sheet: Robot,
    changes: Sequence[Changes],
    values: dict[str, Array],
    folder: Path | None,
    progress: Progress,
) -> Prepared:
    """All lanes; the room is asked for as soon as the size of a state is known."""
    refuse_stops(sheet.integration, "all lanes of a batch run")
    if sheet.integration.energy_stop:
        hint = "leave it out, or run the lane by itself (tmodes run)"
        raise InputError("integration.energy_stop", "true", "false: a batch watches no energy", hint)
    lanes: list[Lane | str] = []
    times, checked = sample_times(sheet.integration), False
    for index, info in enumerate(changes):
        lanes.append(_lane(sheet, info, index))
        width = _common_width(lanes)
        if width and not checked:
            check_room((len(changes), len(times), width), folder)
            checked = True
        progress("preparing", (index + 1) / len(changes))
    if not checked:
        raise SimulationError(f"no case can start; case 0: {lanes[0]}")
    return Prepared(lanes, values, times, folder)


def _checked(vary: Mapping[str, ArrayLike]) -> dict[str, Array]:
    """The numbers of each path, (k,)."""
    if not vary:
        raise InputError("vary", "no path", "paths, each with its numbers", 'write vary={"payload.mass": [0.4, 0.5]}')
    values: dict[str, Array] = {}
    for path, given in vary.items():
        try:
            values[path] = np.array(given, dtype=float)
        except (TypeError, ValueError):
            raise InputError(f"vary: {path}", repr(given)[:60], "numbers", "give one number for each lane") from None
        if path.partition(".")[0] == "integration":
            hint = "set it in the sheet"
            raise InputError(f"vary: {path}", "settings that differ", "one integration for all lanes", hint)
    lengths = {path: numbers.shape for path, numbers in values.items()}
    first = next(iter(lengths.values()))
    if any(shape != first or len(shape) != 1 or not shape[0] for shape in lengths.values()):
        raise InputError("vary", f"shapes {lengths}", "lists of the same length", "give one number for each lane")
    return values


def _plain(value: np.float64) -> float | int:
    """A number as a sheet has it; where it is whole, it may also stand for a count."""
    number = float(value)
    return int(number) if number.is_integer() and abs(number) < 2**53 else number


def _lane(sheet: Robot, changes: Changes, index: int) -> Lane | str:
    """A lane, or why it cannot start."""
    real = changed_sheet(sheet, changes, index)
    try:
        return lane_of(real)
    except SimulationError as error:
        return str(error)


def _common_width(lanes: Sequence[Lane | str]) -> int:
    """Numbers of a state, the same in all lanes; 0 while no lane could start."""
    ready = [(index, lane) for index, lane in enumerate(lanes) if isinstance(lane, Lane)]
    if not ready:
        return 0
    first, last = ready[0], ready[-1]
    info = [(lane.model.coordinates, len(lane.start)) for _, lane in (first, last)]
    if info[0] != info[1]:
        got = f"{info[0][1]} numbers in the state of case {first[0]}, {info[1][1]} in that of case {last[0]}"
        hint = "vary what keeps the coordinates: no rigid elements next to elastic ones"
        raise InputError("vary", got, "the same coordinates in all cases", hint)
    return len(first[1].start)


def _run(lanes: Sequence[Lane | str], times: Array, room: Array, threads: int, progress: Progress) -> BatchRun:
    """Run the lanes that could start, those of one structure together."""
    groups: dict[object, list[int]] = {}
    done = {}
    for index, lane in enumerate(lanes):
        if isinstance(lane, Lane):
            groups.setdefault(lane.key, []).append(index)
        else:
            done[index] = not_begun(room[index], lane)
    works = [_work(lanes, members, times, room) for members in groups.values()]
    done |= run_all(works, threads, lambda share: progress("running", share))
    names = next((lane.model.coordinates for lane in lanes if isinstance(lane, Lane)), ())
    return gathered(names, times, room, [done[index] for index in range(len(lanes))])


def _work(lanes: Sequence[Lane | str], members: list[int], times: Array, room: Array) -> Work:
    group = [lane for lane in (lanes[index] for index in members) if isinstance(lane, Lane)]
    model, settings = group[0].model, group[0].settings
    prepare_loops(model, settings.method)
    info = inputs(
        np.stack([lane.parameters for lane in group]),
        [lane.schedule for lane in group],
        np.stack([lane.start for lane in group]),
        settings.duration,
        model.batch_widths,
    )
    return Work(model, info, settings, times, room, np.array(members))


def _tips(batch: BatchRun, lanes: Sequence[Lane | str], progress: Progress) -> Array:
    tips = np.full((batch.size, len(batch.times), 3), np.nan)
    for index, lane in enumerate(lanes):
        run = batch.lane(index)
        if isinstance(lane, Lane) and len(run.times):
            tips[index, : len(run.times)] = lane.tip(run.times, run.states)
        progress("tips", (index + 1) / batch.size)
    return tips
