"""Some lanes of a batch on the native loops: side by side where the method has such a loop, else one by one."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tmodes.batch.result import COUNTS
from tmodes.batch.work import LaneNumbers, Work
from tmodes.compile.lanes_loop import LANE_ARGUMENTS, LANE_CELLS, LANE_METHODS, LANE_OPTIONS, WIDTH
from tmodes.compile.time_loop import CELLS, Status
from tmodes.trajectory import BOUND, NativeRun, Trajectory

__all__ = ["groups", "run_lanes"]

Array = NDArray[np.float64]

_PIECE_SECONDS = 0.05
_FIRST_PIECE = 500


class _Advancing(Protocol):
    """Runs that go on piece by piece."""

    def advance(self, steps: int) -> None:
        """Do at most so many steps."""
        ...

    def reached(self) -> tuple[bool, Any]:
        """Whether any may go on, and the time of each [s]."""
        ...

    def ended(self, seconds: float) -> list[Trajectory]:
        """Each run as it stands, after so much time of computing [s]."""
        ...


def groups(work: Work) -> list[range]:
    """Lanes that run together."""
    side = WIDTH if work.settings.method.value in LANE_METHODS else 1
    lanes = work.inputs.size
    return [range(first, min(first + side, lanes)) for first in range(0, lanes, side)]


def run_lanes(work: Work, lanes: range, wish: Callable[[], bool], reached: Array) -> list[Trajectory]:
    """Run some lanes to their ends, or until ``wish`` to stop; ``reached`` (all,) is told their times [s].

    How the pieces are cut, and what else the machine does, changes no bit of the samples, unless a limit on time ends
    the run.
    """
    kind = _SideBySide if work.settings.method.value in LANE_METHODS else _Alone
    group: _Advancing = kind(work, lanes)
    began, piece, going = clock.monotonic(), _FIRST_PIECE, True
    while going and not wish() and clock.monotonic() - began < work.settings.max_wall_time:
        started = clock.monotonic()
        group.advance(piece)
        spent = clock.monotonic() - started
        piece = max(1, int(piece * min(4.0, _PIECE_SECONDS / max(spent, 1e-6))))
        going, reached[work.places[lanes.start : lanes.stop]] = group.reached()
    return group.ended(clock.monotonic() - began)


def _ended(run: NativeRun, seconds: float) -> Trajectory:
    """A run as it ended; samples that it does not have are no numbers."""
    begun = np.isfinite(run.samples[0]).all()
    run.samples[run.done if begun else 0 :] = np.nan
    if run.status is not Status.RUNNING:
        ended = run.end()
    elif reason := run.exhausted(seconds):
        ended = run.trajectory("stopped", reason)
    else:
        ended = run.trajectory("interrupted", f"interrupted at t = {run.cell('t'):.6g} s; what was done is kept")
    return ended if begun else replace(ended, times=ended.times[:0], states=ended.states[:0])


def _native(work: Work, lane: int) -> NativeRun:
    inputs = work.inputs
    numbers = LaneNumbers(inputs.parameters[lane])
    return NativeRun(
        work.model, numbers, inputs.schedule(lane), inputs.starts[lane], work.settings, work.states[work.places[lane]]
    )


class _Alone:
    """One lane on the loop of a single run."""

    def __init__(self, work: Work, lanes: range) -> None:
        self.run = _native(work, lanes.start)
        if not np.isfinite(work.inputs.starts[lanes.start]).all():
            self.run.memory[CELLS.index("status")] = float(Status.DIVERGED)

    def advance(self, steps: int) -> None:
        self.run.advance(steps)

    def reached(self) -> tuple[bool, Any]:
        tried = self.run.cell("steps") + self.run.cell("rejected")
        going = self.run.status is Status.RUNNING and tried < self.run.settings.max_steps
        return going, self.run.cell("t")

    def ended(self, seconds: float) -> list[Trajectory]:
        return [_ended(self.run, seconds)]


class _SideBySide:
    """Lanes at once; of the last group some may be empty: they are over before they begin."""

    def __init__(self, work: Work, lanes: range) -> None:
        self.work, self.lanes = work, lanes
        method = work.settings.method.value
        library = work.model.lane_loops
        self.loop = library[method]
        which = [min(lane, lanes.stop - 1) for lane in range(lanes.start, lanes.start + WIDTH)]
        self.memory = self._memory()
        self.state = np.ascontiguousarray(work.inputs.starts[which].T)
        self.slope, self.parameters = np.zeros_like(self.state), np.ascontiguousarray(work.inputs.parameters[which].T)
        self.scratch = _aligned(_scratch_size(library, method))
        work.states[work.places[lanes.start : lanes.stop], 0] = self._starts()
        self.places = work.places[which].astype(float)
        self._take_schedules(which)

    def _memory(self) -> Array:
        memory = np.zeros((len(LANE_CELLS), WIDTH))
        for name, value in {"sample": 1.0, "fresh": 1.0, "old_error": math.log2(1e-4)}.items():
            memory[LANE_CELLS.index(name)] = value
        status = memory[LANE_CELLS.index("status")]
        status[: len(self.lanes)][~np.isfinite(self._starts()).all(axis=1)] = float(Status.DIVERGED)
        status[len(self.lanes) :] = float(Status.FINISHED)
        return memory

    def _starts(self) -> Array:
        return self.work.inputs.starts[self.lanes.start : self.lanes.stop]

    def _take_schedules(self, which: list[int]) -> None:
        """Knots and rows of each lane, padded to the longest."""
        schedules = [self.work.inputs.schedule(lane) for lane in which]
        pieces = max(len(schedule.coefficients) for schedule in schedules)
        self.segments = np.array([len(schedule.coefficients) for schedule in schedules], dtype=float)
        self.knots = np.zeros((WIDTH, pieces + 1))
        self.rows = np.zeros((WIDTH, pieces, schedules[0].coefficients.shape[1] + 1))
        for lane, schedule in enumerate(schedules):
            count = len(schedule.coefficients)
            self.knots[lane, : count + 1] = schedule.knots
            self.rows[lane, :count, 0], self.rows[lane, :count, 1:] = schedule.knots[:-1], schedule.coefficients

    def advance(self, steps: int) -> None:
        s = self.work.settings
        told = {"step": s.step, "rtol": s.relative_tolerance, "atol": s.absolute_tolerance, "most": float(s.max_steps)}
        told |= {"chunk": float(steps), "bound": BOUND}
        options = np.array([told[name] for name in LANE_OPTIONS])
        arrays = {
            "memory": self.memory, "y": self.state, "k1": self.slope, "p": self.parameters, "work": self.scratch,
            "knots": self.knots, "rows": self.rows, "segments": self.segments, "times": self.work.times,
            "out": self.work.states, "places": self.places, "options": options,
        }  # fmt: skip
        addresses = {name: array.ctypes.data for name, array in arrays.items()}
        counts = {"knot_stride": self.knots.shape[1], "row_stride": self.rows[0].size, "samples": len(self.work.times)}
        self.loop(*((addresses | counts)[name] for name in LANE_ARGUMENTS))

    def reached(self) -> tuple[bool, Any]:
        status, steps, rejected = (self.memory[LANE_CELLS.index(name)] for name in ("status", "steps", "rejected"))
        going = (status == float(Status.RUNNING)) & (steps + rejected < self.work.settings.max_steps)
        return bool(going.any()), self.memory[LANE_CELLS.index("t"), : len(self.lanes)]

    def ended(self, seconds: float) -> list[Trajectory]:
        finished = self.memory[LANE_CELLS.index("status")] == float(Status.FINISHED)
        like: Trajectory | None = None
        runs = []
        for place, lane in enumerate(self.lanes):
            if like is not None and finished[place]:
                runs.append(self._finished(place, lane, like))
                continue
            runs.append(_ended(self._run(place, lane), seconds))
            like = runs[-1] if finished[place] else like
        return runs

    def _finished(self, place: int, lane: int, like: Trajectory) -> Trajectory:
        """What most lanes come to, in short: all the same words."""
        counts = {name: float(self.memory[LANE_CELLS.index(name), place]) for name in COUNTS}
        return Trajectory(like.times, self.work.states[self.work.places[lane]], like.status, like.message, counts)

    def _run(self, place: int, lane: int) -> NativeRun:
        run = _native(self.work, lane)
        run.memory[:] = self.memory[: len(CELLS), place]
        run.state[:] = self.state[:, place]
        return run


def _scratch_size(library: Any, method: str) -> int:
    size = np.zeros(1)
    library[f"{method}.work"](size.ctypes.data)
    return int(size[0])


def _aligned(size: int) -> Array:
    """Zeros that begin on a line of the processor's cache: vectors across two lines are slow to load."""
    line = 8
    room = np.zeros(size + line)
    start = -(room.ctypes.data // room.itemsize) % line
    return room[start : start + size]
