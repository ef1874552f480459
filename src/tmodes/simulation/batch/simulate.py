"""Many runs of one structure by the same native code: spans of lanes over threads, each of which keeps a core busy.

The native loops run without Python's lock.
"""

from __future__ import annotations

import os
import time as clock
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from pathlib import Path
from threading import Event

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.native import WIDTH
from tmodes.errors import InputError
from tmodes.integrate.registry import AUTO
from tmodes.integrate.settings import Integration, refuse_stops
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.batch.result import BatchRun, gathered, room_for, stored
from tmodes.simulation.batch.side_by_side import Alone, Room, SideBySide
from tmodes.simulation.batch.wanted import Wanted
from tmodes.simulation.batch.work import Work, inputs
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import Trajectory, sample_times

__all__ = ["prepare_loops", "run_all", "run_lanes", "simulate_lanes", "spans", "thread_count"]

Array = NDArray[np.float64]

_PIECE_SECONDS = 0.05
_FIRST_PIECE = 500

_SPANS, _LONGEST = 8, 64
"""Spans that each thread gets, so that none waits long for the last; groups of lanes in the longest."""

_MOST_THREADS = 1024

_PATIENCE = 0.1
"""Seconds between two words about the progress."""


def thread_count(threads: int | None) -> int:
    """Threads of a batch; None: as many as this process may use cores. Raises InputError for none, or too many."""
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not 1 <= threads <= _MOST_THREADS:
        raise InputError("threads", str(threads), f"1 to {_MOST_THREADS}", "leave it out to use all cores")
    return threads


def run_all(works: Sequence[Work], threads: int, progress: Callable[[float], None]) -> dict[int, Trajectory]:
    """Run all lanes of all works, each with its place; Ctrl-C ends them with what they have (``interrupted``).

    ``progress`` is given the share of all lanes' time that is done; what it raises stops the batch.
    """
    for work in works:
        prepare_loops(work.model, work.settings.method, work.wanted)
    lanes = [(work, span) for work in works for span in spans(work, threads)]
    reached, stop = np.zeros(len(works[0].states) if works else 0), Event()
    whole = sum(work.inputs.size * work.settings.duration for work in works)
    with ThreadPoolExecutor(threads, "tmodes-batch") as pool:
        futures = [pool.submit(run_lanes, work, span, stop.is_set, reached) for work, span in lanes]
        try:
            _watch(futures, lambda: progress(float(reached.sum()) / whole))
        except KeyboardInterrupt:
            stop.set()
        except BaseException:
            stop.set()
            pool.shutdown(cancel_futures=True)
            raise
    done: dict[int, Trajectory] = {}
    for (work, span), future in zip(lanes, futures, strict=True):
        done |= zip(work.places[span.start : span.stop].tolist(), future.result(), strict=True)
    if stop.is_set() and not any(one.status == "interrupted" for one in done.values()):
        raise KeyboardInterrupt  # all ended first: what comes next must not begin
    return done


def _watch(futures: list[Future[list[Trajectory]]], tell: Callable[[], None]) -> None:
    """Wait for one after the other, which costs nothing however many there are; what one raises is raised."""
    info = clock.monotonic()
    for future in futures:
        while not future.done():
            wait([future], _PATIENCE)
            if clock.monotonic() - info >= _PATIENCE:
                tell()
                info = clock.monotonic()
        future.result()
    tell()


def spans(work: Work, threads: int) -> list[range]:
    """Lanes that a thread takes at once: many, so that threads seldom ask for more; whole groups side by side."""
    side, lanes = _side(work), work.inputs.size
    groups = -(-lanes // side)
    size = side * min(max(1, groups // (threads * _SPANS)), _LONGEST)
    return [range(first, min(first + size, lanes)) for first in range(0, lanes, size)]


def _side(work: Work) -> int:
    """Lanes that go at once."""
    return WIDTH if work.model.goes_side_by_side(work.settings.method) else 1


def run_lanes(work: Work, lanes: range, wish: Callable[[], bool], reached: Array) -> list[Trajectory]:
    """Run a span of lanes to their ends, or until ``wish`` to stop; ``reached`` (all,) gets their times [s].

    How spans and pieces are cut, and what else the machine does, changes no bit of the samples, unless a limit on time
    ends the run.
    """
    side = _side(work)
    room = Room(work) if side > 1 else None
    runs: list[Trajectory] = []
    for first in range(lanes.start, lanes.stop, side):
        group = range(first, min(first + side, lanes.stop))
        running = SideBySide(room, group) if room else Alone(work, first)
        runs += _run_group(running, work.settings.max_wall_time, wish, reached, work.places[group.start : group.stop])
    return runs


def _run_group(
    group: SideBySide | Alone, limit: float, wish: Callable[[], bool], reached: Array, places: NDArray[np.int64]
) -> list[Trajectory]:
    """Pieces that take about the same time, so that a wish is soon heard."""
    began, piece, going, own = clock.monotonic(), _FIRST_PIECE, True, clock.thread_time()
    while going and not wish() and clock.monotonic() - began < limit:
        started = clock.monotonic()
        group.advance(piece)
        spent = clock.monotonic() - started
        piece = max(1, int(piece * min(4.0, _PIECE_SECONDS / max(spent, 1e-6))))
        going, reached[places] = group.going, group.times
    return group.ended(clock.monotonic() - began, clock.thread_time() - own)


def simulate_lanes(
    model: LoopModel,
    parameters: ArrayLike,
    schedules: SignalPieces | Sequence[SignalPieces],
    states: ArrayLike,
    settings: Integration,
    *,
    threads: int | None = None,
    out: str | os.PathLike[str] | None = None,
    progress: Callable[[float], None] = lambda share: None,
) -> BatchRun:
    """Run k robots of one structure, with ``parameters`` (k, size), from ``states`` (k, nx) on, by k schedules.

    What is given once is the same for all. By methods with a tableau some robots run side by side, each with steps of
    its own; where none is named it is dormand_prince. No bit of a robot's samples depends on the other robots, on their
    number or on ``threads`` (None: one for each core). A run that cannot continue keeps what it had and disturbs no
    other: look at ``status`` and ``message``. ``out``: an empty folder for the samples, where they are too many for
    memory. ``progress`` is given the share that is done. Ctrl-C ends all with what they have (``interrupted``).

    Raises :class:`tmodes.errors.InputError` for shapes that do not agree and for what is too large, and
    :class:`tmodes.errors.ResultFileError` for a folder that cannot be written.
    """
    if settings.method == AUTO:
        settings = settings.chosen("dormand_prince")
    refuse_stops(settings, "all lanes of a batch run")
    lanes = inputs(parameters, schedules, states, settings.duration, model.batch_widths)
    count, times = thread_count(threads), sample_times(settings)
    folder = None if out is None else Path(out)
    with room_for((lanes.size, len(times), lanes.starts.shape[1]), folder) as room:
        work = Work(model, lanes, settings, times, room, np.arange(lanes.size))
        runs = run_all([work], count, progress)
        batch = gathered(model.coordinates, times, room, [runs[lane] for lane in range(lanes.size)])
    return stored(batch, folder)


def prepare_loops(model: LoopModel, method: str, wanted: Wanted | None = None) -> None:
    """Compile once, before the threads want the loop."""
    if model.goes_side_by_side(method):
        wanted.library(model, method) if wanted else model.lane_loop(method)
    else:
        model.loops[method]
