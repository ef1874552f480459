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
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.batch.result import BatchRun, check_room, gathered, not_begun, room_for, stored
from tmodes.simulation.batch.simulate import prepare_loops, run_all, thread_count
from tmodes.simulation.batch.work import Work, inputs
from tmodes.simulation.motion_run import tip_positions
from tmodes.simulation.parts import sample_times
from tmodes.simulation.start import RunSetup, run_setup
from tmodes.simulation.vary.lanes import Columns, changed_sheet, structure_of

__all__ = ["Prepared", "prepared", "run_prepared", "simulate_batch"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]


def simulate_batch(
    sheet: Robot,
    vary: Mapping[str, ArrayLike],
    *,
    tips: bool = False,
    threads: int | None = None,
    out: str | os.PathLike[str] | None = None,
    progress: Progress = lambda stage, share: None,
) -> BatchRun:
    """Run k robots of one sheet at once: ``vary`` holds k numbers for each path that differs.

    Paths are those of ``with_`` and of ``--set`` (``gear.stiffness``, ``real.gear.stiffness``), but for
    ``integration``, which all share. Each lane is checked like a sheet, and runs as the actual robot of
    :func:`tmodes.run`, without a reference. ``tips``: also where the tip was. ``threads``: None for one on each core.
    ``out``: a folder for the samples, where they are too many for memory. ``progress`` is given the stage and its
    share.

    Lanes may differ in their coordinates, as with a rigid gear next to elastic ones: the batch has those of all lanes,
    a motor without one of its own moves as its joint, and of a link they are zero. A lane that cannot start
    (``failed``) or cannot continue keeps what it had and disturbs no other: look at ``status`` and ``message``. Raises
    :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for wrong numbers, reporting their lane;
    :class:`tmodes.errors.SimulationError` where none can start.
    """
    return run_prepared(
        prepared(sheet, vary, out=out, progress=progress), tips=tips, threads=threads, progress=progress
    )


@dataclass(frozen=True, eq=False)
class Prepared:
    """Lanes that were checked and can run, or why not; ``values`` is what the batch describes them, by path.

    ``times`` (n,) [s]: of the samples; ``folder``: where they go, or None.
    """

    lanes: Sequence[RunSetup | str]
    columns: Columns
    values: dict[str, Array]
    times: Array
    folder: Path | None


def prepared(
    sheet: Robot,
    vary: Mapping[str, ArrayLike] | None,
    *,
    out: str | os.PathLike[str] | None = None,
    progress: Progress = lambda stage, share: None,
) -> Prepared:
    """All that can be wrong with a batch is reported here, before anything runs; see :func:`simulate_batch`.

    ``vary`` None: the sheet as it stands, as a batch of one lane. The room is asked for as soon as the size of a state
    is known.
    """
    refuse_other(sheet)
    values, folder = {} if vary is None else _checked(vary), None if out is None else Path(out)
    size = len(next(iter(values.values()))) if values else 1
    refuse_stops(sheet.integration, "all lanes of a batch run")
    if sheet.integration.energy_stop:
        hint = "leave it out, or run the lane by itself (tmodes run)"
        raise InputError("integration.energy_stop", "true", "false: a batch watches no energy", hint)
    lanes: list[RunSetup | str] = []
    times, columns = sample_times(sheet.integration), None
    for index in range(size):
        changes = {path: _plain(numbers[index]) for path, numbers in values.items()}
        lanes.append(lane := _lane(sheet, changes, index))
        if isinstance(lane, RunSetup) and (columns is None or not columns.have(lane)):
            columns = Columns.of_all([one for one in lanes if isinstance(one, RunSetup)], index)
            check_room((size, len(times), columns.width), folder)
        progress("preparing", (index + 1) / size)
    if columns is None:
        raise SimulationError(f"no case can start; case 0: {lanes[0]}")
    return Prepared(lanes, columns, values, times, folder)


def run_prepared(
    batch: Prepared, *, tips: bool, threads: int | None = None, progress: Progress = lambda stage, share: None
) -> BatchRun:
    """Run lanes that were prepared; see :func:`simulate_batch`."""
    count = thread_count(threads)
    with room_for((len(batch.lanes), len(batch.times), batch.columns.width), batch.folder) as room:
        done = replace(_run(batch, room, count, progress), values=batch.values)
        if tips:
            done = replace(done, tips=_tips(done, batch, progress))
    return stored(done, batch.folder)


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


def _lane(sheet: Robot, changes: Mapping[str, float | int], index: int) -> RunSetup | str:
    """A lane, or why it cannot start."""
    real = changed_sheet(sheet, changes, index)
    try:
        return run_setup(real).chosen()
    except SimulationError as error:
        return str(error)


def _run(batch: Prepared, room: Array, threads: int, progress: Progress) -> BatchRun:
    """Run the lanes that could start, those of one structure together."""
    groups: dict[object, list[int]] = {}
    done = {}
    for index, lane in enumerate(batch.lanes):
        if isinstance(lane, RunSetup):
            groups.setdefault(structure_of(lane), []).append(index)
        else:
            done[index] = not_begun(room[index], lane)
    works = [_work(batch, members, room) for members in groups.values()]
    done |= run_all(works, threads, lambda share: progress("running", share))
    for work, members in zip(works, groups.values(), strict=True):
        if work.states is not room:
            room[members] = batch.columns.filled(work.states[members], work.model.coordinates)
    return gathered(batch.columns.coordinates, batch.times, room, [done[index] for index in range(len(batch.lanes))])


def _work(batch: Prepared, members: list[int], room: Array) -> Work:
    """Lanes of one structure; those with other coordinates than the batch have a room of their own at first."""
    setups = [lane for lane in (batch.lanes[index] for index in members) if isinstance(lane, RunSetup)]
    model, settings = setups[0].model, setups[0].robot.integration
    prepare_loops(model, settings.method)
    info = inputs(
        np.stack([setup.model.numbers for setup in setups]),
        [setup.planned.schedule for setup in setups],
        np.stack([setup.start for setup in setups]),
        settings.duration,
        model.batch_widths,
    )
    if model.coordinates != batch.columns.coordinates:
        room = np.empty((len(room), len(batch.times), info.starts.shape[1]))  # of rows that nobody writes, no memory
    return Work(model, info, settings, batch.times, room, np.array(members))


def _tips(done: BatchRun, batch: Prepared, progress: Progress) -> Array:
    tips = np.full((done.size, len(done.times), 3), np.nan)
    for index, lane in enumerate(batch.lanes):
        run = done.lane(index)
        if isinstance(lane, RunSetup) and len(run.times):
            states = run.states[:, batch.columns.of(lane.model.coordinates)]
            tips[index, : len(run.times)] = tip_positions(lane, run.times, states)
        progress("tips", (index + 1) / done.size)
    return tips
