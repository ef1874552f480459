"""Groups of lanes that advance together: in the vectors of the processor, each with steps of its own, or one alone."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import replace
from math import prod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.lanes.lanes_loop import LANE_ARGUMENTS, LANE_OPTIONS
from tmodes.compile.lanes.series import SUMS
from tmodes.compile.loops.time_loop import CELLS, Status
from tmodes.compile.native import WIDTH
from tmodes.integrate.settings import Integration
from tmodes.simulation import native_run
from tmodes.simulation.case_results import COUNTS, CaseResults
from tmodes.simulation.native_run import BOUND, NativeRun
from tmodes.simulation.parts import Trajectory, completed
from tmodes.simulation.problem import Problem

__all__ = ["LINE", "NO_SUMS", "LaneGroup", "SimdBatch", "SingleRun", "ended", "lane_group", "lane_run", "private"]

Array = NDArray[np.float64]

NO_SUMS = np.array([-np.inf, np.inf, 0.0, 0.0, np.nan, np.nan])
"""What a series is reduced to before its first sample (:data:`tmodes.compile.lanes.series.SUMS`)."""

LINE = 128
"""Bytes that processors fetch together: a line of the cache and its neighbour."""

_FRESH = {"sample": 1.0, "fresh": 1.0, "old_error": math.log2(1e-4)}


def private(*shape: int) -> Array:
    """Zeros that begin on such a line and have their last one for themselves.

    Vectors across two lines are slow to load, and a line that two threads write wanders between their cores.
    """
    item = np.dtype(np.float64).itemsize
    lines = -(-prod(shape) * item // LINE) + 1
    room = np.zeros(lines * LINE // item)
    start = -(room.ctypes.data // item) % (LINE // item)
    return room[start : start + prod(shape)].reshape(shape)


class LaneGroup(ABC):
    """The memory of one thread for some lanes of a work that advance together; one group after the other."""

    @abstractmethod
    def begin(self, lanes: range) -> None:
        """Take the numbers of these lanes."""

    @abstractmethod
    def advance(self, steps: int) -> None:
        """Do at most so many steps; no lock of Python is held."""

    @property
    @abstractmethod
    def going(self) -> bool:
        """Whether any lane may continue."""

    @property
    @abstractmethod
    def times(self) -> Any:
        """How far each lane came [s]."""

    @abstractmethod
    def end(self, results: CaseResults, elapsed: float) -> None:
        """Put down each run as it stands, after so much time by the clock [s]."""


def lane_group(work: Problem) -> LaneGroup:
    """Lanes side by side where the method and the model allow it, else one after the other."""
    return SimdBatch(work) if work.model.goes_side_by_side(work.settings.method) else SingleRun(work)


class SimdBatch(LaneGroup):
    """As many lanes as vectors have; where they are fewer, the others are over at once."""

    def __init__(self, work: Problem) -> None:
        method, size, wanted = work.settings.method, work.starts.shape[1], work.wanted
        library = work.model.lane_loop(method) if wanted is None else wanted.library(work.model, method)
        table = series = 0
        if wanted is not None:
            size, series, table = work.model.side(wanted.shown).layout.size, len(wanted.shown), len(wanted.table)
        self.loop, self.work, self.apart = library[method], work, table > 1
        shapes = {
            "memory": (len(CELLS), WIDTH), "y": (size, WIDTH), "k1": (size, WIDTH), "places": (WIDTH,),
            "p": (work.parameters.shape[1], WIDTH), "work": (_scratch_size(library, method),),
            "options": (len(LANE_OPTIONS),), "sums": (series, len(SUMS), WIDTH),
        }  # fmt: skip
        self.arrays = {name: private(*shape) for name, shape in shapes.items()}
        self.arrays |= {"times": work.times, "out": work.states} | dict.fromkeys(("table", "weights"), np.zeros(1))
        if wanted is not None:
            self.arrays["table"] = np.empty((WIDTH, *wanted.table.shape[1:])) if self.apart else wanted.table[0]
            self.arrays |= {"weights": wanted.weights} | ({} if wanted.folds else {"out": wanted.out})
        self.arrays["options"][:] = _options(work.settings)
        self.memory, self.state = self.arrays["memory"], self.arrays["y"]
        self._given: dict[str, int] = {}

    def begin(self, lanes: range) -> None:
        """Take the numbers of these lanes."""
        work, arrays, self.lanes = self.work, self.arrays, lanes
        which = [min(lane, lanes.stop - 1) for lane in range(lanes.start, lanes.start + WIDTH)]
        places, span = work.places[which], slice(lanes.start, lanes.stop)
        self.state[:], arrays["p"][:] = work.starts[which, : len(self.state)].T, work.parameters[which].T
        arrays["k1"][:], self.memory[:], arrays["places"][:] = 0.0, 0.0, places
        for name, value in _FRESH.items():
            self.cell(name)[:] = value
        if work.wanted is not None:
            self.cell("sample")[:] = 0.0  # the start is a sample like any other
            arrays["sums"][:] = NO_SUMS[:, None]
            if self.apart:
                np.take(work.wanted.table, places, axis=0, out=arrays["table"])
        if len(work.schedules) > 1 or not self._given:
            self._take_schedules(which if len(work.schedules) > 1 else which[:1])
        self.cell("status")[: len(lanes)][~np.isfinite(work.starts[span]).all(axis=1)] = float(Status.DIVERGED)
        self.cell("status")[len(lanes) :] = float(Status.FINISHED)
        if work.wanted is None:
            work.states[work.places[span], 0] = work.starts[span]

    def cell(self, name: str) -> Array:
        """A number of the loop's memory, of each lane."""
        return self.memory[CELLS.index(name)]

    def advance(self, steps: int) -> None:
        """Let the native loop do at most so many steps."""
        self.arrays["options"][LANE_OPTIONS.index("chunk")] = steps
        self.loop(*self._given.values())

    @property
    def going(self) -> bool:
        """Whether any lane may continue."""
        tried = self.cell("steps") + self.cell("rejected")
        return bool(((self.cell("status") == float(Status.RUNNING)) & (tried < self.work.settings.max_steps)).any())

    @property
    def times(self) -> Any:
        """How far each lane came [s]."""
        return self.cell("t")[: len(self.lanes)]

    def _take_schedules(self, which: list[int]) -> None:
        """Knots and rows of lanes, padded to the longest, and the arguments of the loop; one schedule serves all."""
        apart = len(which) > 1
        knots, rows, counts = padded(self.work, which)
        segments = np.resize(counts.astype(float), WIDTH)
        self.arrays |= {"knots": knots, "rows": rows, "segments": segments}
        given: dict[str, int] = {name: array.ctypes.data for name, array in self.arrays.items()}
        given |= {"knot_stride": apart * knots.shape[1], "row_stride": apart * rows[0].size}
        given |= {"table_stride": self.apart * self.arrays["table"][0].size, "samples": len(self.work.times)}
        self._given = {name: given[name] for name in LANE_ARGUMENTS}

    def end(self, results: CaseResults, elapsed: float) -> None:
        """Put down each run as it stands."""
        wanted = self.work.wanted
        if wanted is not None and wanted.folds:
            sums = self.arrays["sums"][:, :, : len(self.lanes)]
            wanted.out[self.work.places[self.lanes.start : self.lanes.stop]] = sums.transpose(2, 0, 1)
        ended(self.work, self.lanes, self.memory, self.state, results, elapsed)


class SingleRun(LaneGroup):
    """A lane by itself."""

    def __init__(self, work: Problem) -> None:
        self.work = work

    def begin(self, lanes: range) -> None:
        """Take the numbers of the first lane."""
        self.lane, self.run = lanes.start, lane_run(self.work, lanes.start)
        if not np.isfinite(self.work.starts[self.lane]).all():
            self.run.memory[CELLS.index("status")] = float(Status.DIVERGED)

    def advance(self, steps: int) -> None:
        """Do at most so many steps."""
        self.run.advance(steps)

    @property
    def going(self) -> bool:
        """Whether it may continue."""
        return self.run.running and not self.run.exhausted(0.0)

    @property
    def times(self) -> float:
        """How far it came [s]."""
        return self.run.cell("t")

    def end(self, results: CaseResults, elapsed: float) -> None:
        """Put down the run as it stands."""
        run_ended(self.work, self.lane, self.run, results, elapsed)


def padded(work: Problem, which: list[int]) -> tuple[Array, Array, NDArray[np.int64]]:
    """Knots (k, pieces + 1) and rows (k, pieces, row) of lanes, padded to the longest, and pieces of each."""
    schedules = [work.schedule(lane) for lane in which]
    counts = np.array([len(schedule.coefficients) for schedule in schedules])
    knots = np.zeros((len(which), counts.max() + 1))
    rows = np.zeros((len(which), counts.max(), schedules[0].coefficients.shape[1] + 1))
    for lane, (schedule, count) in enumerate(zip(schedules, counts.tolist(), strict=True)):
        knots[lane, : count + 1] = schedule.knots
        rows[lane, :count, 0], rows[lane, :count, 1:] = schedule.knots[:-1], schedule.coefficients
    return knots, rows, counts


def _options(s: Integration) -> list[float]:
    """Those of the native loop, in its order; ``chunk`` is set for each call."""
    info = {"step": s.step, "rtol": s.relative_tolerance, "atol": s.absolute_tolerance, "most": s.max_steps, "chunk": 0}
    info |= {"bound": BOUND, "most_events": native_run.MOST_EVENTS, "event_time": native_run.EVENT_TIME}
    return [float(info[name]) for name in LANE_OPTIONS]


def _scratch_size(library: Any, method: str) -> int:
    size = np.zeros(1)
    library[f"{method}.work"](size.ctypes.data)
    return int(size[0])


def ended(
    work: Problem, lanes: range, memory: Array, state: Array, results: CaseResults, elapsed: float,
    samples: Array | None = None,
) -> None:  # fmt: skip
    """Put down how lanes ended, from the ``memory`` (cells, lanes) and ``state`` (size, lanes) that their loop left.

    ``samples`` (lanes, n, size): where outputs are wanted that no loop has made, they are made of these.
    """
    places, cells = work.places[lanes.start : lanes.stop], dict(zip(CELLS, memory[:, : len(lanes)], strict=False))
    finished = cells["status"] == float(Status.FINISHED)
    results.status[places], results.message[places] = "finished", completed(work.settings.duration)
    results.samples[places], results.errors[places] = len(work.times), _error_sum(cells["errors"], work.settings)
    for name in COUNTS:
        results.statistics[name][places] = cells[name]
    for lane in np.flatnonzero(~finished | (samples is not None)).tolist():
        run = lane_run(work, lanes[lane])
        run.memory[:], run.state[: len(state)] = memory[: len(CELLS), lane], state[:, lane]
        if samples is not None:
            run.samples[:] = samples[lane]
        run_ended(work, lanes[lane], run, results, elapsed, made=samples is None)


def run_ended(
    work: Problem, lane: int, run: NativeRun, results: CaseResults, elapsed: float, *, made: bool = False
) -> None:
    """Put down how one run ended, and the outputs that are wanted where they are not ``made`` yet."""
    done, place = info(run, elapsed), int(work.places[lane])
    if work.wanted is not None and not made:
        work.wanted.take(work.model, run.parameters, work.schedule(lane), done, place)
    results.end(place, done)


def lane_run(work: Problem, lane: int) -> NativeRun:
    """A lane as a run by itself, before its first step; its samples are those of the batch."""
    return NativeRun(work, lane, alone=False)


def info(run: NativeRun, elapsed: float) -> Trajectory:
    """A run as it ended, or was left after so much time by the clock [s]; samples that it lacks are no numbers."""
    begun = np.isfinite(run.samples[0]).all()
    run.samples[run.done if begun else 0 :] = np.nan
    if not run.running:
        done = run.end()
    elif reason := run.exhausted(elapsed):
        done = run.trajectory("stopped", reason)
    else:
        done = run.trajectory("interrupted", f"interrupted at t = {run.cell('t'):.6g} s; what was done is kept")
    done.statistics["errors"] = float(_error_sum(run.cell("errors"), run.first))
    return done if begun else replace(done, times=done.times[:0], states=done.states[:0])


def _error_sum(errors: ArrayLike, settings: Integration) -> Array:
    """Sums of the estimated errors of steps as shares of what is integrated; not-a-number where none is estimated."""
    found = np.asarray(errors, dtype=float) * settings.relative_tolerance
    return np.where(found > 0, found, np.nan)
