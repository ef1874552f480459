"""A block of cases that are on a device at the same time: their numbers there and back, launch by launch."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.gpu.case_loop import CASE_OPTIONS, CaseLoop, CaseSeries
from tmodes.compile.gpu.cuda import Device
from tmodes.compile.loops.time_loop import CELLS, Status
from tmodes.integrate.method import EXPLICIT
from tmodes.integrate.registry import integrator
from tmodes.integrate.settings import Integration
from tmodes.simulation import native_run
from tmodes.simulation.batch.simd_batch import NO_SUMS, ended, padded
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.problem import Problem

__all__ = ["DeviceBlock", "bytes_per_case", "loop_of", "suits_gpu"]

Array = NDArray[np.float64]

_FRESH = {"fresh": 1.0, "old_error": 1e-4}
_READ = ("status", "t", "steps", "rejected")
"""What is looked at after each launch."""

_AT_ONCE = 64_000_000
"""Bytes of samples that are brought back at once."""


def suits_gpu(method: str) -> bool:
    """Whether runs by a method gain from a GPU: explicit ones do.

    The others give the same results there, but one thread computes one after the other what a processor computes in
    vectors.
    """
    return integrator(method).asks == EXPLICIT


def loop_of(work: Problem) -> CaseLoop:
    """The code of a work's cases; series are made on the device where the method is explicit and nothing sticks."""
    model, method, wanted = work.model, work.settings.method, work.wanted
    if wanted is None or model.loop.modes or not suits_gpu(method):
        return model.case_loop(method)
    return model.lean_case_loop(method, wanted.shown, wanted.given, folds=wanted.folds)


def bytes_per_case(work: Problem, loop: CaseLoop) -> int:
    """Bytes that a case takes of a device's memory, samples included; what all cases share is little."""
    count = len(work.times)
    numbers = len(CELLS) + 2 * loop.size + loop.parameters + count * loop.size + 2
    if loop.series is not None:
        numbers += loop.series.numbers(count)
    if loop.series is not None and work.wanted is not None and len(work.wanted.table) > 1:
        numbers += count * loop.series.given
    if len(work.schedules) > 1:
        pieces, width = _longest(work), work.schedules[0].coefficients.shape[1] + 1
        numbers += pieces * (width + 1) + 1
    return 8 * numbers


def _longest(work: Problem) -> int:
    """Pieces of the schedule that has most."""
    return max(len(schedule.coefficients) for schedule in work.schedules)


class DeviceBlock:
    """Some lanes of a work, as their loops left them; ``begin`` brings them to a device, ``end`` back."""

    def __init__(self, work: Problem, loop: CaseLoop, lanes: range) -> None:
        self.work, self.loop, self.lanes, size = work, loop, lanes, len(lanes)
        self.starts = work.starts[lanes.start : lanes.stop, : loop.size]
        self.places = work.places[lanes.start : lanes.stop]
        self.memory, self.state = np.zeros((len(CELLS), size)), np.array(self.starts.T, order="C")
        for name, value in _FRESH.items():
            self.cell(name)[:] = value
        self.cell("sample")[:] = float(loop.series is None)  # of series the start is a sample like any other
        self.cell("status")[~np.isfinite(self.starts).all(axis=1)] = float(Status.DIVERGED)
        if work.wanted is None:
            work.states[self.places, 0] = self.starts
        self._asked = np.zeros(0, dtype=np.int64)
        self._rooms: dict[str, Any] = {}
        self._begun = False
        self._samples = np.zeros((0, 0, loop.size))

    def cell(self, name: str) -> Array:
        """A number of the loop's memory, of each case."""
        return self.memory[CELLS.index(name)]

    @property
    def going(self) -> NDArray[np.int64]:
        """Which cases may continue."""
        tried = self.cell("steps") + self.cell("rejected")
        running = self.cell("status") == float(Status.RUNNING)
        return np.flatnonzero(running & (tried < self.work.settings.max_steps))

    def begin(self, device: Device) -> None:
        """Take the memory of the device, and bring all numbers there."""
        self.device, size = device, len(self.lanes)
        settings = self.work.settings
        parameters = self.work.parameters[self.lanes.start : self.lanes.stop].T
        arrays = {"memory": self.memory, "y": self.state, "k1": np.zeros_like(self.state), "p": parameters}
        arrays |= {"times": self.work.times, "options": _options(settings, 0)}
        schedules, strides = self._schedules()
        self._whole = {
            "cases": size,
            "case_stride": 1,
            "number_stride": size,
            "samples": len(self.work.times),
        } | strides
        wanted, self._whole["table_stride"] = self._series()
        for name, array in (arrays | schedules | wanted).items():
            self._rooms[name] = device.uploaded(array)
        self._rooms["which"] = device.empty(8 * size)
        self._rooms["out"] = device.empty(8 * size * len(self.work.times) * len(self.state))
        self._begun = True

    def _series(self) -> tuple[dict[str, Array], int]:
        """What series are made with, and what they come to; nothing where none are wanted."""
        series, wanted, size = self.loop.series, self.work.wanted, len(self.lanes)
        if series is None or wanted is None:
            return dict.fromkeys(("table", "weights", "series"), np.zeros(1)), 0
        apart = len(wanted.table) > 1
        table = wanted.table[self.places] if apart else wanted.table
        found = np.full((size, len(self.work.times), series.count), np.nan)
        if series.folds:
            found = np.repeat(np.tile(NO_SUMS, series.count)[:, None], size, axis=1)
        arrays = {"table": table, "weights": wanted.weights, "series": found}
        return arrays, apart * table[0].size

    def _schedules(self) -> tuple[dict[str, NDArray[Any]], dict[str, int]]:
        """Knots and rows of the cases, padded to the longest; of one for all, all cases read the same."""
        own, lanes = len(self.work.schedules) > 1, [*self.lanes]
        knots, rows, counts = padded(self.work, lanes if own else lanes[:1])
        strides = {"knot_stride": own * knots.shape[1], "row_stride": own * rows[0].size, "segment_stride": int(own)}
        return {"knots": knots, "rows": rows, "segments": counts}, strides

    def advance(self, steps: int) -> None:
        """One launch: at most so many steps of each case that may continue."""
        device, going = self.device, self.going
        if len(going) != len(self._asked):  # who is over never continues
            device.upload(going, self._rooms["which"])
            self._asked = going
        device.upload(_options(self.work.settings, steps), self._rooms["options"])
        device.launch(self.loop, self._rooms, self._whole | {"threads": len(going)})
        for name in _READ:
            place = CELLS.index(name)
            device.download(self._rooms["memory"], place * self.memory[0].nbytes, self.memory[place])

    def end(self) -> None:
        """Bring back what the cases came to, and their samples; where none was brought there, all is as it was."""
        if not self._begun:
            return
        self.device.download(self._rooms["memory"], 0, self.memory)
        self.device.download(self._rooms["y"], 0, self.state)
        if self.loop.series is not None:
            self._end_series(self.loop.series)
            return
        kept = self.work.states
        if self.work.wanted is not None:
            kept = self._samples = np.empty((len(self.lanes), len(self.work.times), len(self.state)))
        for cases, samples in self._brought("out", (len(self.work.times), len(self.state))):
            samples[:, 0] = self.starts[cases]
            kept[self.places[cases] if self.work.wanted is None else cases] = samples

    def _end_series(self, series: CaseSeries) -> None:
        wanted = self.work.wanted
        assert wanted is not None  # noqa: S101
        if series.folds:
            sums = np.empty((series.count, len(NO_SUMS), len(self.lanes)))
            self.device.download(self._rooms["series"], 0, sums)
            wanted.out[self.places] = sums.transpose(2, 0, 1)
            return
        for cases, found in self._brought("series", (len(self.work.times), series.count)):
            wanted.out[self.places[cases]] = found

    def _brought(self, name: str, shape: tuple[int, int]) -> Iterator[tuple[slice, Array]]:
        """The numbers of the cases from a room, some cases at a time."""
        each = 8 * shape[0] * shape[1]
        count, size = max(1, _AT_ONCE // each), len(self.lanes)
        for first in range(0, size, count):
            cases = slice(first, min(first + count, size))
            found = np.empty((cases.stop - first, *shape))
            self.device.download(self._rooms[name], first * each, found)
            yield cases, found

    def release(self) -> None:
        """Give the memory of the device back."""
        rooms = [*self._rooms.values()]
        self._rooms.clear()
        if rooms:
            self.device.release(rooms)

    def ended(self, results: CaseResults, seconds: float) -> None:
        """Put down each run as it stands, after so much time of computing [s]."""
        samples = self._samples if len(self._samples) else None
        ended(self.work, self.lanes, self.memory, self.state, results, seconds, samples)
        results.seconds[self.places] = seconds / len(self.lanes)


def _options(s: Integration, steps: int) -> Array:
    """Those of the native loop, in its order, for at most so many steps."""
    info = {"step": s.step, "rtol": s.relative_tolerance, "atol": s.absolute_tolerance, "most": s.max_steps}
    info |= {"chunk": steps, "bound": native_run.BOUND, "watch": 0, "looks": 0}
    info |= {"most_events": native_run.MOST_EVENTS, "event_time": native_run.EVENT_TIME}
    return np.array([info[name] for name in CASE_OPTIONS], dtype=float)
