"""Many runs of one structure: the same native code, with other numbers in each lane."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from tmodes.compile.loops.loops import goes_side_by_side
from tmodes.integrate.registry import AUTO
from tmodes.integrate.settings import Integration, refuse_stops
from tmodes.kinds.signals.schedule import Schedule
from tmodes.simulation.batch.result import BatchRun, gathered, load_batch, room_for, write_batch
from tmodes.simulation.batch.work import Work, inputs
from tmodes.simulation.batch.workers import run_all, thread_count
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import sample_times

__all__ = ["prepare_loops", "simulate_lanes"]


def simulate_lanes(
    model: LoopModel,
    parameters: ArrayLike,
    schedules: Schedule | Sequence[Schedule],
    states: ArrayLike,
    settings: Integration,
    *,
    threads: int | None = None,
    out: str | os.PathLike[str] | None = None,
    progress: Callable[[float], None] = lambda share: None,
) -> BatchRun:
    """Run k robots of one structure, with ``parameters`` (k, size), from ``states`` (k, nx) on, by k schedules.

    What is given once is the same for all. By methods with a tableau
    some robots run side by side, each with steps of its own; by others they run one by one; where none is named it is
    dormand_prince. No bit of a robot's samples depends on the other robots, on their number or on ``threads`` (None:
    one for each core). A run that cannot continue keeps what it had and disturbs no other: look at ``status`` and
    ``message``. ``out``: an empty folder for the samples, where they are too many for memory. ``progress`` is given the
    share that is done. Ctrl-C ends all with what they have (``interrupted``).

    Raises :class:`tmodes.errors.InputError` for shapes that do not agree and for what is too large, and
    :class:`tmodes.errors.ResultFileError` for a folder that cannot be written.
    """
    if settings.method == AUTO:
        settings = settings.chosen("dormand_prince")
    refuse_stops(settings, "all lanes of a batch run")
    lanes = inputs(parameters, schedules, states, settings.duration, model.batch_widths)
    count, times = thread_count(threads), sample_times(settings)
    prepare_loops(model, settings.method)
    folder = None if out is None else Path(out)
    with room_for((lanes.size, len(times), lanes.starts.shape[1]), folder) as room:
        work = Work(model, lanes, settings, times, room, np.arange(lanes.size))
        runs = run_all([work], count, progress)
        batch = gathered(model.coordinates, times, room, [runs[lane] for lane in range(lanes.size)])
    if folder is None:
        return batch
    write_batch(batch, folder)
    return load_batch(folder)


def prepare_loops(model: LoopModel, method: str) -> None:
    """Compile once, before the threads want the loop."""
    if goes_side_by_side(method):
        model.lane_loop(method)
    else:
        model.loops[method]
