"""Lanes that go at once in the vectors of the processor, each with steps of its own."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.lanes.lanes_loop import LANE_ARGUMENTS, LANE_OPTIONS
from tmodes.compile.loops.time_loop import CELLS, Status
from tmodes.compile.native import WIDTH
from tmodes.integrate.settings import Integration
from tmodes.simulation import native_run
from tmodes.simulation.batch.private import private
from tmodes.simulation.batch.result import COUNTS
from tmodes.simulation.batch.wanted import Given
from tmodes.simulation.batch.work import Work
from tmodes.simulation.native_run import BOUND, NativeRun
from tmodes.simulation.parts import Trajectory

__all__ = ["Alone", "Room", "SideBySide", "error_sum", "info", "lane_run"]

Array = NDArray[np.float64]

NOTHING = np.zeros(1)
SERIES_ARGUMENTS = ("table", "weights", "sums")

_FRESH = {"sample": 1.0, "fresh": 1.0, "old_error": math.log2(1e-4)}


class Room:
    """What the native loop of one thread works on, and what is the same for all groups of lanes that go through it."""

    def __init__(self, work: Work) -> None:
        method, size, wanted = work.settings.method, work.inputs.starts.shape[1], work.wanted
        library = work.model.lane_loop(method) if wanted is None else wanted.library(work.model, method)
        if wanted is not None:
            size = work.model.side(wanted.shown).layout.size
        self.loop, self.work = library[method], work
        self.given = None if wanted is None else Given(wanted)
        self.memory, self.options = private(len(CELLS), WIDTH), private(len(LANE_OPTIONS))
        self.state, self.slope = private(size, WIDTH), private(size, WIDTH)
        self.parameters = private(work.inputs.parameters.shape[1], WIDTH)
        self.scratch, self.places = private(_scratch_size(library, method)), private(WIDTH)
        self.options[:] = list(_options(work.settings).values())
        self._take_schedules([0] if len(work.inputs.schedules) == 1 else [])
        self._given: dict[str, int] = {}

    def take(self, which: list[int]) -> None:
        """The numbers of these lanes."""
        inputs = self.work.inputs
        self.state[:], self.parameters[:] = inputs.starts[which, : len(self.state)].T, inputs.parameters[which].T
        self.slope[:], self.memory[:] = 0.0, 0.0
        self.places[:] = self.work.places[which]
        for name, value in _FRESH.items():
            self.cell(name)[:] = value
        if self.given is not None:
            self.cell("sample")[:] = 0.0  # the start is a sample like any other
            self.given.take(self.work.places[which])
        if len(inputs.schedules) > 1:
            self._take_schedules(which)
        if len(inputs.schedules) > 1 or not self._given:
            self._given = self._arguments()

    def cell(self, name: str) -> Array:
        """A number of the loop's memory, of each lane."""
        return self.memory[CELLS.index(name)]

    def advance(self, steps: int) -> None:
        """Let the native loop do at most so many steps; it holds no lock of Python."""
        self.options[LANE_OPTIONS.index("chunk")] = steps
        self.loop(*self._given.values())

    def _take_schedules(self, which: list[int]) -> None:
        """Knots and rows of lanes, padded to the longest; of one for all, all lanes read the same."""
        if not which:
            return
        schedules = [self.work.inputs.schedule(lane) for lane in which]
        pieces = max(len(schedule.coefficients) for schedule in schedules)
        self.segments = np.resize(np.array([len(each.coefficients) for each in schedules], dtype=float), WIDTH)
        self.knots = np.zeros((len(which), pieces + 1))
        self.rows = np.zeros((len(which), pieces, schedules[0].coefficients.shape[1] + 1))
        for lane, schedule in enumerate(schedules):
            count = len(schedule.coefficients)
            self.knots[lane, : count + 1] = schedule.knots
            self.rows[lane, :count, 0], self.rows[lane, :count, 1:] = schedule.knots[:-1], schedule.coefficients

    def _arguments(self) -> dict[str, int]:
        """Those of the native loop, in its order."""
        arrays = {
            "memory": self.memory, "y": self.state, "k1": self.slope, "p": self.parameters, "work": self.scratch,
            "knots": self.knots, "rows": self.rows, "segments": self.segments, "times": self.work.times,
            "out": self.work.states, "places": self.places, "options": self.options,
        } | dict.fromkeys(SERIES_ARGUMENTS, NOTHING)  # fmt: skip
        if self.given is not None:
            arrays |= self.given.arrays
        given: dict[str, int] = {name: array.ctypes.data for name, array in arrays.items()}
        apart = len(self.knots) > 1
        given |= {"knot_stride": apart * self.knots.shape[1], "row_stride": apart * self.rows[0].size}
        given |= {"table_stride": self.given.stride if self.given else 0, "samples": len(self.work.times)}
        return {name: given[name] for name in LANE_ARGUMENTS}


class SideBySide:
    """As many lanes as go at once, in the room of their thread; where they are fewer, the others are over at once."""

    def __init__(self, room: Room, lanes: range) -> None:
        self.room, self.work, self.lanes = room, room.work, lanes
        starts, status = self.work.inputs.starts[lanes.start : lanes.stop], room.cell("status")
        room.take([min(lane, lanes.stop - 1) for lane in range(lanes.start, lanes.start + WIDTH)])
        status[: len(lanes)][~np.isfinite(starts).all(axis=1)] = float(Status.DIVERGED)
        status[len(lanes) :] = float(Status.FINISHED)
        if self.work.wanted is None:
            self.work.states[self.work.places[lanes.start : lanes.stop], 0] = starts

    def advance(self, steps: int) -> None:
        """Do at most so many steps."""
        self.room.advance(steps)

    @property
    def going(self) -> bool:
        """Whether any lane may continue."""
        room, most = self.room, self.work.settings.max_steps
        running = room.cell("status") == float(Status.RUNNING)
        return bool((running & (room.cell("steps") + room.cell("rejected") < most)).any())

    @property
    def times(self) -> Any:
        """How far each lane came [s]."""
        return self.room.cell("t")[: len(self.lanes)]

    def ended(self, elapsed: float, seconds: float) -> list[Trajectory]:
        """Each run as it stands, after so much time [s] by the clock, and of the processor."""
        if self.room.given is not None:
            self.room.given.keep(self.work.places[self.lanes.start : self.lanes.stop])
        finished = (self.room.cell("status") == float(Status.FINISHED)).tolist()
        counts = {name: self.room.cell(name).tolist() for name in COUNTS}
        counts["errors"] = error_sum(self.room.cell("errors"), self.work.settings).tolist()
        like: Trajectory | None = None
        runs = []
        for place, lane in enumerate(self.lanes):
            if like is not None and finished[place]:
                own = {name: values[place] for name, values in counts.items()}
                runs.append(self._finished(lane, like, own))
                continue
            share = seconds / len(self.lanes)
            runs.append(self._without_samples(replace(info(self._run(place, lane), elapsed), seconds=share)))
            like = runs[-1] if finished[place] else like
        return runs

    def _without_samples(self, run: Trajectory) -> Trajectory:
        """A run without samples, where series are wanted in place of them."""
        return run if self.work.wanted is None else replace(run, states=run.states[:0].copy())

    def _finished(self, lane: int, like: Trajectory, counts: dict[str, float]) -> Trajectory:
        """What most lanes come to, in short: all the same words."""
        states = like.states if self.work.wanted else self.work.states[self.work.places[lane]]
        return Trajectory(like.times, states, like.status, like.message, counts, like.seconds)

    def _run(self, place: int, lane: int) -> NativeRun:
        run = lane_run(self.work, lane)
        run.memory[:] = self.room.memory[: len(CELLS), place]
        run.state[: len(self.room.state)] = self.room.state[:, place]
        return run


def _options(s: Integration) -> dict[str, float]:
    """Those of the native loop, in its order; ``chunk`` is set for each call."""
    info = {"step": s.step, "rtol": s.relative_tolerance, "atol": s.absolute_tolerance, "most": s.max_steps, "chunk": 0}
    info |= {"bound": BOUND, "most_events": native_run.MOST_EVENTS, "event_time": native_run.EVENT_TIME}
    return {name: float(info[name]) for name in LANE_OPTIONS}


def _scratch_size(library: Any, method: str) -> int:
    size = np.zeros(1)
    library[f"{method}.work"](size.ctypes.data)
    return int(size[0])


class Alone:
    """A lane by itself, advanced piece by piece."""

    def __init__(self, work: Work, lane: int) -> None:
        self.run, self.work, self.lane = lane_run(work, lane), work, lane
        if not np.isfinite(work.inputs.starts[lane]).all():
            self.run.memory[CELLS.index("status")] = float(Status.DIVERGED)

    def advance(self, steps: int) -> None:
        """Do at most so many steps."""
        self.run.advance(steps)

    @property
    def going(self) -> bool:
        """Whether it may continue."""
        tried = self.run.cell("steps") + self.run.cell("rejected")
        return self.run.running and tried < self.run.settings.max_steps

    @property
    def times(self) -> float:
        """How far it came [s]."""
        return self.run.cell("t")

    def ended(self, elapsed: float, seconds: float) -> list[Trajectory]:
        """The run as it stands, after so much time [s] by the clock, and of the processor."""
        done, work = replace(info(self.run, elapsed), seconds=seconds), self.work
        if work.wanted is None:
            return [done]
        work.wanted.take(work.model, self.run.parameters, work.inputs.schedule(self.lane), done, work.places[self.lane])
        return [replace(done, states=done.states[:0].copy())]


def lane_run(work: Work, lane: int) -> NativeRun:
    """A lane as a run by itself, before its first step; its samples are those of the batch."""
    inputs = work.inputs
    numbers = inputs.parameters[lane]
    samples = None if work.wanted else work.states[work.places[lane]]
    return NativeRun(work.model, numbers, inputs.schedule(lane), inputs.starts[lane], work.settings, samples)


def info(run: NativeRun, elapsed: float) -> Trajectory:
    """A run as it ended, or was left after so much time by the clock [s]; samples that it lacks are no numbers."""
    begun = np.isfinite(run.samples[0]).all()
    run.samples[run.done if begun else 0 :] = np.nan
    if not run.running:
        ended = run.end()
    elif reason := run.exhausted(elapsed):
        ended = run.trajectory("stopped", reason)
    else:
        ended = run.trajectory("interrupted", f"interrupted at t = {run.cell('t'):.6g} s; what was done is kept")
    ended.statistics["errors"] = float(error_sum(run.cell("errors"), run.first))
    return ended if begun else replace(ended, times=ended.times[:0], states=ended.states[:0])


def error_sum(errors: ArrayLike, settings: Integration) -> Array:
    """Sums of the estimated errors of steps as shares of what is integrated; not-a-number where none is estimated."""
    found = np.asarray(errors, dtype=float) * settings.relative_tolerance
    return np.where(found > 0, found, np.nan)
