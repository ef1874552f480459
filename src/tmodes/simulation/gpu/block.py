"""A block of cases that are on a device at the same time: their numbers there and back, launch by launch."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.gpu.case_loop import CaseLoop
from tmodes.compile.gpu.device import Device
from tmodes.compile.gpu.one_case import CASE_OPTIONS
from tmodes.compile.loops.time_loop import CELLS, Status
from tmodes.integrate.settings import Integration
from tmodes.simulation import native_run
from tmodes.simulation.batch.result import COUNTS
from tmodes.simulation.batch.side_by_side import info, lane_run
from tmodes.simulation.batch.work import Work
from tmodes.simulation.parts import Trajectory

__all__ = ["Block", "bytes_per_case"]

Array = NDArray[np.float64]

_FRESH = {"sample": 1.0, "fresh": 1.0, "old_error": 1e-4}
_READ = ("status", "t", "steps", "rejected")
"""What is looked at after each launch."""

_AT_ONCE = 64_000_000
"""Bytes of samples that are brought back at once."""


def bytes_per_case(work: Work) -> int:
    """Bytes that a case takes of a device's memory, samples included; what all cases share is little."""
    size, parameters = work.inputs.starts.shape[1], work.inputs.parameters.shape[1]
    numbers = len(CELLS) + 2 * size + parameters + len(work.times) * size + 2
    if len(work.inputs.schedules) > 1:
        pieces, width = _longest(work), work.inputs.schedules[0].coefficients.shape[1] + 1
        numbers += pieces * (width + 1) + 1
    return 8 * numbers


def _longest(work: Work) -> int:
    """Pieces of the schedule that has most."""
    return max(len(schedule.coefficients) for schedule in work.inputs.schedules)


class Block:
    """Some lanes of a work, as their loops left them; ``begin`` brings them to a device, ``end`` back."""

    def __init__(self, work: Work, lanes: range) -> None:
        self.work, self.lanes, size = work, lanes, len(lanes)
        self.starts = work.inputs.starts[lanes.start : lanes.stop]
        self.memory, self.state = np.zeros((len(CELLS), size)), np.array(self.starts.T, order="C")
        for name, value in _FRESH.items():
            self.cell(name)[:] = value
        self.cell("status")[~np.isfinite(self.starts).all(axis=1)] = float(Status.DIVERGED)
        work.states[work.places[lanes.start : lanes.stop], 0] = self.starts
        self._asked = np.zeros(0, dtype=np.int64)
        self._rooms: dict[str, Any] = {}
        self._begun = False

    def cell(self, name: str) -> Array:
        """A number of the loop's memory, of each case."""
        return self.memory[CELLS.index(name)]

    @property
    def going(self) -> NDArray[np.int64]:
        """Which cases may continue."""
        tried = self.cell("steps") + self.cell("rejected")
        running = self.cell("status") == float(Status.RUNNING)
        return np.flatnonzero(running & (tried < self.work.settings.max_steps))

    def begin(self, device: Device, loop: CaseLoop) -> None:
        """Take the memory of the device, and bring all numbers there."""
        self.device, self.loop, size = device, loop, len(self.lanes)
        inputs, settings = self.work.inputs, self.work.settings
        parameters = inputs.parameters[self.lanes.start : self.lanes.stop].T
        arrays = {"memory": self.memory, "y": self.state, "k1": np.zeros_like(self.state), "p": parameters}
        arrays |= {"times": self.work.times, "options": _options(settings, 0)}
        schedules, strides = self._schedules()
        self._whole = {
            "cases": size,
            "case_stride": 1,
            "number_stride": size,
            "samples": len(self.work.times),
        } | strides
        for name, array in (arrays | schedules).items():
            self._rooms[name] = device.uploaded(array)
        self._rooms["which"] = device.empty(8 * size)
        self._rooms["out"] = device.empty(8 * size * len(self.work.times) * len(self.state))
        self._begun = True

    def _schedules(self) -> tuple[dict[str, NDArray[Any]], dict[str, int]]:
        """Knots and rows of the cases, padded to the longest; of one for all, all cases read the same."""
        inputs, own = self.work.inputs, len(self.work.inputs.schedules) > 1
        chosen = [inputs.schedule(lane) for lane in (self.lanes if own else self.lanes[:1])]
        pieces, width = _longest(self.work), chosen[0].coefficients.shape[1] + 1
        knots, rows = np.zeros((len(chosen), pieces + 1)), np.zeros((len(chosen), pieces, width))
        for case, schedule in enumerate(chosen):
            count = len(schedule.coefficients)
            knots[case, : count + 1] = schedule.knots
            rows[case, :count, 0], rows[case, :count, 1:] = schedule.knots[:-1], schedule.coefficients
        counts = np.array([len(schedule.coefficients) for schedule in chosen])
        strides = {"knot_stride": own * (pieces + 1), "row_stride": own * pieces * width, "segment_stride": int(own)}
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
        for cases, places in self._pieces():
            samples = np.empty((len(places), *self.work.states.shape[1:]))
            self.device.download(self._rooms["out"], cases.start * samples[0].nbytes, samples)
            samples[:, 0] = self.starts[cases]
            self.work.states[places] = samples

    def _pieces(self) -> Iterator[tuple[slice, NDArray[np.int64]]]:
        each = 8 * len(self.work.times) * len(self.state)
        count, size = max(1, _AT_ONCE // each), len(self.lanes)
        for first in range(0, size, count):
            cases = slice(first, min(first + count, size))
            yield cases, self.work.places[self.lanes.start + cases.start : self.lanes.start + cases.stop]

    def release(self) -> None:
        """Give the memory of the device back."""
        rooms = [*self._rooms.values()]
        self._rooms.clear()
        if rooms:
            self.device.release(rooms)

    def ended(self, seconds: float) -> list[Trajectory]:
        """Each run as it stands, after so much time of computing [s]."""
        finished = (self.cell("status") == float(Status.FINISHED)).tolist()
        counts = dict(zip(COUNTS, (self.cell(name).tolist() for name in COUNTS), strict=True))
        like: Trajectory | None = None
        runs = []
        for case, lane in enumerate(self.lanes):
            if like is not None and finished[case]:  # most are: all the same words
                samples, own = self.work.states[self.work.places[lane]], {name: n[case] for name, n in counts.items()}
                runs.append(Trajectory(like.times, samples, like.status, like.message, own))
                continue
            run = lane_run(self.work, lane)
            run.memory[:], run.state[:] = self.memory[:, case], self.state[:, case]
            runs.append(info(run, seconds))
            like = runs[-1] if finished[case] else like
        return runs


def _options(s: Integration, steps: int) -> Array:
    """Those of the native loop, in its order, for at most so many steps."""
    info = {"step": s.step, "rtol": s.relative_tolerance, "atol": s.absolute_tolerance, "most": s.max_steps}
    info |= {"chunk": steps, "bound": native_run.BOUND, "watch": 0, "looks": 0}
    info |= {"most_events": native_run.MOST_EVENTS, "event_time": native_run.EVENT_TIME}
    return np.array([info[name] for name in CASE_OPTIONS], dtype=float)
