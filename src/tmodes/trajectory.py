"""A run of one model over time: calls the native loop piece by piece, and tells how it ended."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.time_loop import ARGUMENTS, CELLS, OPTIONS, Status
from tmodes.integrate.settings import Integration, Method
from tmodes.reference.schedule import Schedule

__all__ = ["BOUND", "Journal", "Moving", "Numbers", "Trajectory", "begun", "integrate", "sample_times"]

BOUND = 1e8
"""A coordinate [rad] or rate [rad/s] beyond this is no motion any more: the run has diverged."""

_PIECE_SECONDS = 0.05
_FIRST_PIECE = 500


class Journal(Protocol):
    """Where a long run keeps its progress, so that nothing finished is lost."""

    def restore(self) -> dict[str, NDArray[np.float64]] | None:
        """Memory, state and samples so far of the same run, or None."""
        ...

    def keep(self, record: dict[str, NDArray[np.float64]], *, last: bool = False, now: bool = False) -> None:
        """Keep the progress, when it is time to; ``last``: nothing follows; ``now``: whatever the time."""
        ...


class Numbers(Protocol):
    """The numbers of a robot, as its compiled code reads them."""

    @property
    def vector(self) -> NDArray[np.float64]:
        """All of them."""
        ...


class Moving(Protocol):
    """What a run needs of a model: its native loops, its right-hand side, and the names of its coordinates.

    A state holds the coordinates, then their rates, then what else is integrated.
    """

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        ...

    @property
    def loops(self) -> Any:
        """A native loop for each method."""
        ...

    def rate(self, time: Any, state: Any, row: Any, parameters: Any) -> NDArray[np.float64]:
        """Derivative of the state by time, (n, size)."""
        ...


@dataclass
class Trajectory:
    """Samples of a run: ``times`` (n,) [s], ``states`` (n, size).

    ``status``: finished, diverged, stopped, interrupted.
    """

    times: NDArray[np.float64]
    states: NDArray[np.float64]
    status: str
    message: str
    statistics: dict[str, float] = field(default_factory=dict)


def sample_times(settings: Integration) -> NDArray[np.float64]:
    """Times of the samples [s]: every ``output_step``, and the end, which is a sample even where it is no multiple."""
    count = math.floor(settings.duration / settings.output_step * (1 + 1e-12))
    times = np.arange(count + 1, dtype=np.float64) * np.float64(settings.output_step)
    if settings.duration - times[-1] > 1e-9 * settings.output_step:
        return np.append(times, settings.duration)
    times[-1] = settings.duration
    return times


def integrate(
    model: Moving,
    parameters: Numbers,
    schedule: Schedule,
    state: NDArray[np.float64],
    settings: Integration,
    progress: Callable[[float], None] = lambda share: None,
    journal: Journal | None = None,
) -> Trajectory:
    """Integrate from ``state`` (size,) over ``settings.duration``.

    ``progress`` is told the share of the time that is done. Ctrl-C ends the run with what it has (``interrupted``).
    Stopping, continuing from a journal, and the pieces in which the loop is called change no bit of the samples.
    """
    run = _Run(model, parameters, schedule.until(settings.duration), state, settings)
    if journal and (record := journal.restore()):
        run.resume(record)
    began, piece = clock.monotonic(), _FIRST_PIECE
    try:
        while run.status is Status.RUNNING:
            started = clock.monotonic()
            run.advance(piece)
            spent = clock.monotonic() - started
            piece = max(1, int(piece * min(4.0, _PIECE_SECONDS / max(spent, 1e-6))))
            progress(run.cell("t") / settings.duration)
            if journal:
                journal.keep(run.record(), last=run.status is not Status.RUNNING)
            reason = run.exhausted(clock.monotonic() - began)
            if reason and run.status is Status.RUNNING:
                return run.trajectory("stopped", reason)
    except KeyboardInterrupt:
        if journal:
            journal.keep(run.record(), now=True)
        return run.trajectory("interrupted", f"interrupted at t = {run.cell('t'):.6g} s; what was done is kept")
    return run.end()


def begun(
    model: Moving, parameters: Numbers, schedule: Schedule, state: NDArray[np.float64], settings: Integration
) -> _Run:
    """A run before its first step, for one that advances it itself."""
    return _Run(model, parameters, schedule.until(settings.duration), state, settings)


class _Run:
    """The arrays that a native loop works on."""

    def __init__(
        self,
        model: Moving,
        parameters: Numbers,
        schedule: Schedule,
        state: NDArray[np.float64],
        settings: Integration,
    ) -> None:
        self.settings, self.parameters, self.model = settings, parameters, model
        self.times = sample_times(settings)
        self.knots = np.ascontiguousarray(schedule.knots)
        self.rows = np.ascontiguousarray(np.column_stack([schedule.knots[:-1], schedule.coefficients]))
        self.memory, self.slope = np.zeros(len(CELLS)), np.zeros(len(state))
        self.state = np.array(state, dtype=float)
        self.samples = np.zeros((len(self.times), len(self.state)))
        self.samples[0] = self.state
        for name, value in {"sample": 1.0, "fresh": 1.0, "old_error": 1e-4}.items():
            self.memory[CELLS.index(name)] = value
        self.loop = model.loops[settings.method.value]

    def cell(self, name: str) -> float:
        return float(self.memory[CELLS.index(name)])

    @property
    def status(self) -> Status:
        return Status(int(self.cell("status")))

    @property
    def done(self) -> int:
        """Number of samples written."""
        return int(self.cell("sample"))

    def advance(self, steps: int) -> None:
        """Let the native loop do at most so many steps."""
        values = self.arguments(steps).values()
        self.loop(*(value if isinstance(value, int) else value.ctypes.data for value in values))

    def arguments(self, steps: int) -> dict[str, Any]:
        """Those of the native loop, for at most so many steps."""
        s = self.settings
        chosen = {"step": s.step, "rtol": s.relative_tolerance, "atol": s.absolute_tolerance}
        options = np.array([{**chosen, "chunk": float(steps), "bound": BOUND}[name] for name in OPTIONS])
        arrays: dict[str, Any] = {
            "memory": self.memory, "y": self.state, "k1": self.slope, "p": self.parameters.vector, "knots": self.knots,
            "rows": self.rows, "times": self.times, "out": self.samples, "options": options,
        }  # fmt: skip
        counts = {"segments": len(self.rows), "samples": len(self.times)}
        return {name: (arrays | counts)[name] for name in ARGUMENTS}

    def exhausted(self, seconds: float) -> str:
        """Why the run may not go on, or nothing."""
        where = f"at t = {self.cell('t'):.6g} s of {self.settings.duration:g} s"
        if self.cell("steps") + self.cell("rejected") >= self.settings.max_steps:
            return f"stopped {where}: integration.max_steps = {self.settings.max_steps} is used up"
        if seconds >= self.settings.max_wall_time:
            return f"stopped {where}: integration.max_wall_time = {self.settings.max_wall_time:g} s is used up"
        return ""

    def record(self) -> dict[str, NDArray[np.float64]]:
        """All that the run needs to go on."""
        return {
            "memory": self.memory, "state": self.state, "slope": self.slope, "samples": self.samples[: self.done],
        }  # fmt: skip

    def resume(self, record: dict[str, NDArray[np.float64]]) -> None:
        """Go on where a record ends."""
        self.memory[:], self.state[:], self.slope[:] = record["memory"], record["state"], record["slope"]
        self.samples[: self.done] = record["samples"]

    def end(self) -> Trajectory:
        """The run after its loop ended by itself."""
        if self.status is Status.FINISHED:
            return self.trajectory("finished", f"reached the end, t = {self.settings.duration:g} s")
        return self.trajectory("diverged", self._cause())

    def _cause(self) -> str:
        """Where and in which coordinate the motion was lost."""
        names = self.model.coordinates
        accelerations = self._rates_now()[len(names) : 2 * len(names)]
        wildest = int(np.argmax(np.where(np.isfinite(accelerations), np.abs(accelerations), np.inf)))
        where = f"diverged at t = {self.cell('t'):.6g} s in coordinate {names[wildest]}"
        value = f"its acceleration is {accelerations[wildest]:.3g} rad/s^2"
        if self.status is Status.STEP_TOO_SMALL:
            return f"{where}: {value} and no step is small enough (last {self.cell('h'):.3g} s)"
        return f"{where}: {value}; its next step leaves {BOUND:g} rad or rad/s"

    def _rates_now(self) -> NDArray[np.float64]:
        segment = min(int(self.cell("segment")), len(self.rows) - 1)
        return self.model.rate([self.cell("t")], self.state, self.rows[segment], self.parameters)[0]

    def trajectory(self, status: str, message: str) -> Trajectory:
        counts: dict[str, float] = {name: int(self.cell(name)) for name in ("steps", "rejected", "evaluations")}
        if self.settings.method is Method.RK4:
            counts["step"] = self.cell("h")
        return Trajectory(self.times[: self.done], self.samples[: self.done], status, message, counts)
