"""A run that is watched for stop conditions: where one triggers, the run ends, at a time that is found exactly.

The native loop writes some points of each step by its dense output; conditions are looked at there, many steps at once.
Where one triggers between two points, that step is taken again (the same step, bit by bit) and asked for points ever
closer together, until two neighbours in time hold the change between them.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.loops.time_loop import CELLS, SEEN, Status
from tmodes.integrate.registry import integrator
from tmodes.simulation.native_run import NativeRun
from tmodes.simulation.parts import RunChange, Trajectory
from tmodes.simulation.stops import STOPPED, Instants, Stops

__all__ = ["WatchedRun"]

Array = NDArray[np.float64]

_PIECE = 256
"""Steps between two looks: they are few enough to be taken again."""

_PARTS = 16
"""Parts into which what holds a change is divided at once."""

_ROUNDS = 12
"""How often the surroundings of a highest value are divided."""


class _Points(NamedTuple):
    """Points of steps in order: times (n,), segments of the input (n,), states (n, size)."""

    times: Array
    segments: NDArray[np.int64]
    states: Array


class WatchedRun:
    """A run and its stop conditions."""

    def __init__(self, run: NativeRun, stops: Stops) -> None:
        """Raises :class:`tmodes.errors.SimulationError` where a condition holds at the start already."""
        self.run, self.stops = run, stops
        self.ended = np.zeros(3)
        """Which condition ended the run, its value just before, and its value there."""
        if run.cell("steps") == 0:
            stops.refuse_at_start(self._instants(self._here()))

    def advance(self, steps: int) -> None:
        """Advance by at most so many steps, or to where a condition triggers."""
        before, first = _kept(self.run), self._here()
        self._looked(min(steps, _PIECE))
        bracket = self._first_change(self._seen(first), before)
        if bracket is not None:
            self._end(*bracket, before)

    def _here(self) -> _Points:
        """Where the run is."""
        run = self.run
        segment = min(int(run.cell("segment")), len(run.rows) - 1)
        return _Points(np.array([run.cell("t")]), np.array([segment]), run.state[None, :].copy())

    def _seen(self, first: _Points) -> _Points:
        """What the loop wrote, after the point where it began. At a jump of the input both sides have a point."""
        count, width = int(self.run.seen[0]), len(SEEN) + len(self.run.state)
        info = self.run.seen[1 : 1 + count * width].reshape(count, width)
        written = _Points(info[:, 0], info[:, 1].astype(np.int64), info[:, len(SEEN) :])
        times, segments, states = _joined(first, written)
        jumps = np.flatnonzero(np.diff(segments))
        order = np.sort(np.concatenate([np.arange(len(times)), jumps]))
        later = np.insert(segments, jumps + 1, segments[jumps + 1])
        return _Points(times[order], later, states[order])

    def _instants(self, points: _Points) -> Instants:
        return Instants(points.times, points.states, self.run.rows[points.segments])

    def _beyond(self, points: _Points) -> Array:
        return self.stops.beyond(self._instants(points))

    def _first_change(self, points: _Points, before: _Kept) -> tuple[_Points, _Points] | None:
        """The last point at which no condition holds, and the first at which one does; None where none triggers."""
        beyond = self._beyond(points)
        holds = np.flatnonzero((beyond > 0).any(axis=1))
        end = int(holds[0]) if len(holds) else len(beyond)
        for k, which in _peaks(beyond[:end]):
            for a, b in ((_one(points, k - 1), _one(points, k)), (_one(points, k), _one(points, k + 1))):
                if found := self._moment(a, b, which, before):
                    return found
        return None if not len(holds) else (_one(points, max(end - 1, 0)), _one(points, end))

    def _moment(self, a: _Points, b: _Points, which: int, before: _Kept) -> tuple[_Points, _Points] | None:
        """The same between two points of one step at which no condition holds, about the highest value of one."""
        start = self._before_step(b.times[0], before)
        for _ in range(_ROUNDS):
            line = self._line(a, b, start)
            beyond = self._beyond(line)
            if len(holds := np.flatnonzero((beyond > 0).any(axis=1))):
                return _one(line, int(holds[0]) - 1), _one(line, int(holds[0]))
            values = beyond[:, which]
            k = int(values.argmax())
            left, right = max(k - 1, 0), min(k + 1, len(values) - 1)
            if -values[k] >= 2 * values[k] - values[left] - values[right]:
                return None
            a, b = _one(line, left), _one(line, right)
        return None

    def _line(self, a: _Points, b: _Points, start: _Kept) -> _Points:
        """Two points of the step from ``start``, and those between that part their time."""
        times = np.unique(np.linspace(a.times[0], b.times[0], _PARTS + 1)[1:-1])
        finer = self._dense(start, times[(times > a.times[0]) & (times < b.times[0])], a.segments[0])
        return _joined(a, finer, b)

    def _narrowed(self, a: _Points, b: _Points, start: _Kept) -> tuple[_Points, _Points]:
        """Neighbours among points between two of the step from ``start``, of which only the second is beyond."""
        line = self._line(a, b, start)
        place = int((self._beyond(line) > 0).any(axis=1).argmax())
        return _one(line, max(place - 1, 0)), _one(line, place)

    def _before_step(self, end: float, before: _Kept) -> _Kept:
        """What the run had before the step in which it came to the time ``end``."""
        run, after = self.run, _kept(self.run)
        _put(run, before)
        kept = before
        while run.running and run.cell("t") < end:
            kept = _kept(run)
            self._looked(1)
        _put(run, after)
        return kept

    def _looked(self, steps: int) -> None:
        """Advance, with points that are looked at: a step that is taken again is the same only with them."""
        run, looks = self.run, integrator(self.run.settings.method).looks
        run.looks, run.seen = float(looks), np.zeros(1 + steps * looks * (len(SEEN) + len(run.state)))
        run.advance(steps)
        run.looks = 0.0

    def _dense(self, start: _Kept, times: Array, segment: np.int64) -> _Points:
        """The motion at some times within the step from ``start``."""
        run, after = self.run, _kept(self.run)
        _put(run, start)
        states = np.zeros((len(times), len(run.state)))
        info = run.arguments(1) | {"times": times, "out": states, "samples": len(times)}
        run.memory[[CELLS.index(name) for name in ("sample", "pause")]] = 0.0
        run.loop(*(value if isinstance(value, int) else value.ctypes.data for value in info.values()))
        _put(run, after)
        return _Points(times, np.full(len(times), segment), states)

    def _end(self, a: _Points, b: _Points, before: _Kept) -> None:
        """End the run where the condition triggers, between two points: there its last sample is."""
        run = self.run
        if a.times[0] < b.times[0]:
            start, close = self._before_step(b.times[0], before), np.spacing(run.first.duration)
            while b.times[0] - a.times[0] > close:
                a, b = self._narrowed(a, b, start)
        time = float(b.times[0])
        _put(run, before)
        while run.running and run.cell("t") < time:
            self._looked(1)
        which = int((self._beyond(b)[0] > 0).argmax())
        self.ended[:] = which, *(self.stops.values(self._instants(point))[0, which] for point in (a, b))
        run.stop_at(time, b.states[0])

    def end(self) -> Trajectory:
        """The run after it ended by itself, or by a condition."""
        run = self.run
        if run.status is not Status.STOPPED_BY_CONDITION:
            return run.end()
        stop = self.stops.stops[int(self.ended[0])]
        info = stop.info(run.cell("t"), *self.ended[1:]) + run.change.words(run.cell("stiff_time"))
        return replace(run.trajectory(STOPPED, info), ended_by=stop.text)

    def record(self) -> dict[str, Array]:
        """All that the run needs to continue."""
        return self.run.record() | {"ended": self.ended}

    def resume(self, record: dict[str, Array]) -> None:
        """Continue where a record ends."""
        self.run.resume(record)
        self.ended[:] = record["ended"]


def _one(points: _Points, k: int) -> _Points:
    here = slice(k, k + 1)
    return _Points(points.times[here], points.segments[here], points.states[here])


def _joined(*parts: _Points) -> _Points:
    return _Points(*(np.concatenate(values) for values in zip(*parts, strict=True)))


class _Kept(NamedTuple):
    """What a step changes, its samples not counted: they are written again as they were."""

    arrays: tuple[Array, ...]
    changes: tuple[RunChange, ...]


def _kept(run: NativeRun) -> _Kept:
    return _Kept(tuple(array.copy() for array in _changing(run)), run.changes)


def _put(run: NativeRun, kept: _Kept) -> None:
    for array, before in zip(_changing(run), kept.arrays, strict=True):
        array[:] = before
    run.changes = kept.changes


def _changing(run: NativeRun) -> tuple[Array, ...]:
    return run.memory, run.state, run.slope, run.parts


def _peaks(beyond: Array) -> list[tuple[int, int]]:
    """Points next to which a condition may hold for a moment, each with the condition, in the order of time.

    Those are the highest around, and nearer to holding than a parabola may rise: between three points at equal distance
    that is an eighth of what the outer two lie lower together; a half is left for other motions and distances.
    """
    middle, left, right = beyond[1:-1], beyond[:-2], beyond[2:]
    drop = (middle - left) + (middle - right)
    near = (middle >= left) & (middle >= right) & (drop > 0) & (-middle < drop / 2)
    return [(int(k) + 1, int(which)) for k, which in np.argwhere(near)]
