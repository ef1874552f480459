"""The arrays that a native time loop works on, and what follows from them: how a run ended, and what it took."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.loops.time_loop import ARGUMENTS, CELLS, OPTIONS, Status
from tmodes.integrate.choice import COUNTED, MethodChange
from tmodes.integrate.registry import integrator
from tmodes.integrate.settings import Integration
from tmodes.simulation.parts import (
    MOST_CHANGES,
    LostRun,
    RunChange,
    Trajectory,
    chattered,
    completed,
    sample_times,
    used_up,
)
from tmodes.simulation.problem import Problem

__all__ = ["BOUND", "EVENT_TIME", "MOST_EVENTS", "NativeRun", "pieces"]

Array = NDArray[np.float64]

BOUND = 1e8
"""A coordinate [rad] or rate [rad/s] beyond this is no motion any more: the run has diverged."""

MOST_EVENTS, EVENT_TIME = 1000, 1e-3
"""A contact that starts and ends more often than this within this time [s] chatters: no motion gets through that."""

_FIRST_PIECE, _PIECE_SECONDS = 500, 0.05


def pieces(
    limit: float = np.inf, clock: Callable[[], float] = time.monotonic, first: int | None = None
) -> Iterator[int]:
    """Numbers of steps that each take about 50 ms to do, so that a wish to stop is soon heard; within ``limit`` [s]."""
    began, piece = clock(), first or _FIRST_PIECE
    while clock() - began < limit:
        started = clock()
        yield piece
        piece = max(1, int(piece * min(4.0, _PIECE_SECONDS / max(clock() - started, 1e-6))))


class NativeRun:
    """One run, advanced piece by piece: its settings, the memory of its loop, and its samples."""

    def __init__(self, problem: Problem, lane: int = 0, *, alone: bool = True) -> None:
        """A case of a ``problem`` before its first step; its samples are written where those of the problem are.

        ``alone``: it continues by another method where the motion turns out stiff.
        """
        settings, schedule, model = problem.settings, problem.schedule(lane), problem.model
        self.first, self.parameters, self.model = settings, np.ascontiguousarray(problem.parameters[lane]), model
        otherwise, state = problem.otherwise if alone else None, problem.starts[lane]
        samples = None if problem.wanted else problem.states[problem.places[lane]]
        self.change = MethodChange(settings, otherwise)
        self.parts = self.change.kept
        self.times = sample_times(settings)
        self.knots = np.ascontiguousarray(schedule.knots)
        self.rows = np.ascontiguousarray(np.column_stack([schedule.knots[:-1], schedule.coefficients]))
        self.memory, self.slope = np.zeros(len(CELLS)), np.zeros(len(state))
        self.state = np.array(state, dtype=float)
        self.samples = np.zeros((len(self.times), len(self.state))) if samples is None else samples
        self.samples[0] = self.state
        self.looks, self.seen, self.segments = 0.0, np.zeros(1), len(self.rows)
        self.changes: tuple[RunChange, ...] = ()
        self._put(sample=1.0, fresh=1.0, old_error=1e-4)

    def cell(self, name: str) -> float:
        """A number of the loop's memory."""
        return float(self.memory[CELLS.index(name)])

    def _put(self, **values: float) -> None:
        for name, value in values.items():
            self.memory[CELLS.index(name)] = value

    @property
    def settings(self) -> Integration:
        """Those of the present part of the run."""
        return self.change.settings

    @property
    def status(self) -> Status:
        """As the loop left it."""
        return Status(int(self.cell("status")))

    @property
    def running(self) -> bool:
        """Whether something is left to do."""
        return self.status is Status.RUNNING

    @property
    def done(self) -> int:
        """Number of samples written."""
        return int(self.cell("sample"))

    @property
    def loop(self) -> Any:
        """The native loop of the present part of the run."""
        return self.model.loops[self.settings.method]

    def advance(self, steps: int) -> None:
        """Let the native loop do at most so many steps, and no more than the settings allow."""
        steps = min(steps, max(1, self.first.max_steps - self._tried))
        end = self._tried + self.change.most(steps, self.cell)
        going = True
        while going:
            values = self.arguments(end - self._tried).values()
            self.loop(*(value if isinstance(value, int) else value.ctypes.data for value in values))
            going = self._paused() and self._tried < end
        self.settle()

    def settle(self) -> None:
        """After the native loop returned: keep a change at which it paused, and choose the method to continue with."""
        self._paused()
        if self.status is Status.STIFF:
            self._put(status=float(Status.RUNNING), **self.change.switched(self.cell))
        elif self.running:
            self._put(**self.change.judged(self.cell))

    @property
    def _tried(self) -> int:
        return int(self.cell("steps") + self.cell("rejected"))

    def keep_changes(self) -> None:
        """Keep what changes from now on: see :class:`RunChange`."""
        self._put(pause=1.0)

    def _paused(self) -> bool:
        """Whether the loop only paused at a change, which is kept then; also one at the end of the run."""
        paused, ended = self.cell("met") == 2.0, not self.running
        if not self.cell("pause") or not (paused or (ended and self.cell("met"))):
            return False
        before = self.slope if self.model.loop.modes and paused else self.state
        self.changes = (*self.changes, RunChange(self.cell("t"), before.copy(), self.state.copy()))
        self._put(met=0.0, pause=float(len(self.changes) < MOST_CHANGES))
        return paused

    def arguments(self, steps: int) -> dict[str, Any]:
        """Those of the native loop, for at most so many steps: arrays, and whole numbers."""
        s = self.settings
        watch = self.change.possible and self.cell("stiff_time") == 0
        chosen = {
            "step": s.step, "rtol": s.relative_tolerance, "atol": s.absolute_tolerance, "chunk": float(steps),
            "bound": BOUND, "watch": float(watch), "most_events": MOST_EVENTS, "event_time": EVENT_TIME,
            "looks": self.looks,
        }  # fmt: skip
        given: dict[str, Any] = {
            "memory": self.memory, "y": self.state, "k1": self.slope, "p": self.parameters, "knots": self.knots,
            "rows": self.rows, "times": self.times, "out": self.samples, "seen": self.seen,
            "segments": self.segments, "samples": len(self.times),
            "options": np.array([chosen[name] for name in OPTIONS], dtype=float),
        }  # fmt: skip
        return {name: given[name] for name in ARGUMENTS}

    def exhausted(self, seconds: float) -> str:
        """Why the run must stop, or nothing."""
        s, t = self.first, self.cell("t")
        if self.cell("steps") + self.cell("rejected") >= s.max_steps:
            return used_up(t, s.duration, "max_steps", f"{s.max_steps}")
        if seconds >= s.max_wall_time:
            return used_up(t, s.duration, "max_wall_time", f"{s.max_wall_time:g} s")
        return ""

    def record(self) -> dict[str, Array]:
        """All that the run needs to continue."""
        return {
            "memory": self.memory, "state": self.state, "slope": self.slope, "parts": self.parts,
            "samples": self.samples[: self.done],
            "changes": np.array([[time, *before, *after] for time, before, after in self.changes]),
        }  # fmt: skip

    def resume(self, record: dict[str, Array]) -> None:
        """Continue where a record ends."""
        self.memory[:], self.state[:], self.slope[:] = record["memory"], record["state"], record["slope"]
        self.parts[:], self.samples[: self.done] = record["parts"], record["samples"]
        halves = (np.split(row[1:], 2) for row in record["changes"])
        self.changes = tuple(RunChange(row[0], *half) for row, half in zip(record["changes"], halves, strict=True))
        if self.status is Status.STOPPED_BY_CONDITION:
            self.times[self.done - 1] = self.cell("t")

    def stop_at(self, time: float, state: Array) -> None:
        """End the run at a time [s] within its last step: there its last sample is."""
        self.state[:] = state
        near = time - 1e-9 * self.first.output_step  # as close to a sample, it takes its place
        done = max(int(np.searchsorted(self.times, near)), int(time > 0))
        self.times[done], self.samples[done] = time, state
        self.changes = tuple(change for change in self.changes if change.time <= time)
        self._put(t=time, sample=done + 1.0, status=float(Status.STOPPED_BY_CONDITION))

    def end(self) -> Trajectory:
        """The run after its loop ended by itself."""
        return self.trajectory(*self._ending())

    def trajectory(self, status: str, message: str) -> Trajectory:
        """The run so far."""
        samples = slice(self.done)
        known = self.times[samples], self.samples[samples], status, message, self.statistics()
        return Trajectory(*known, changes=self.changes)

    def _ending(self) -> tuple[str, str]:
        if self.status is Status.FINISHED:
            return "finished", completed(self.first.duration) + self.change.words(self.cell("stiff_time"))
        if self.status is Status.CHATTERING:
            return chattered(self.cell("t"), MOST_EVENTS, EVENT_TIME)
        names = self.model.coordinates
        accelerations = self._rates_now()[len(names) : 2 * len(names)]
        return LostRun(self.cell("t"), self.cell("h"), accelerations, names, BOUND).info(self.status)

    def statistics(self) -> dict[str, Any]:
        """What the run took, and how; the smallest step is that of all which no knot cut short [s]."""
        steps, t = self.cell("steps"), self.cell("t")
        info: dict[str, Any] = {name: int(self.cell(name)) for name in COUNTED}
        info |= {"method": self.settings.method, "mean_step_s": t / steps if steps else None}
        info["smallest_step_s"] = self.change.smallest(self.cell) or info["mean_step_s"]
        if not integrator(self.settings.method).adaptive:
            info["step"] = self.cell("h")
        if self.cell("passes"):
            info["passes"] = int(self.cell("passes"))
        if self.cell("events"):
            info["contact_changes"] = int(self.cell("events"))
        if self.cell("switches"):
            info["switches"] = int(self.cell("switches"))
        if self.cell("stiff_time") > 0:
            info["stiff_from_s"] = self.cell("stiff_time")
        if self.change.parts > 1:
            info["parts"] = self.change.info(self.cell)
        return info

    def _rates_now(self) -> Array:
        segment = min(int(self.cell("segment")), len(self.rows) - 1)
        return self.model.rate([self.cell("t")], self.state, self.rows[segment], self.parameters)[0]
