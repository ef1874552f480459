"""A run of one model over time: calls the native loop piece by piece, and tells how it ended."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.settings import Integration
from tmodes.native_run import BOUND, Moving, NativeRun, Numbers
from tmodes.reference.schedule import Schedule

__all__ = ["BOUND", "ErrorEstimate", "Journal", "Moving", "Numbers", "Trajectory", "integrate", "sample_times"]

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


@dataclass(frozen=True)
class ErrorEstimate:
    """How far the states of a run may be from the exact ones: ``values`` (n, size), and ``how`` they were found.

    ``signed``: exact less computed, all components together; else the size of the error of each component by itself.
    """

    values: NDArray[np.float64]
    how: str
    signed: bool


@dataclass
class Trajectory:
    """Samples of a run: ``times`` (n,) [s], ``states`` (n, size).

    ``status``: finished, diverged, stopped, chattering, interrupted. ``statistics``: steps, rejected, evaluations, ...;
    the same for the same run, whatever the machine. ``error``: None where it is not known. ``seconds``: of computing
    in this process, for each simulated second; it is no part of a result.
    """

    times: NDArray[np.float64]
    states: NDArray[np.float64]
    status: str
    message: str
    statistics: dict[str, Any] = field(default_factory=dict)
    error: ErrorEstimate | None = None
    seconds: float = 0.0


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
    otherwise: Integration | None = None,
) -> Trajectory:
    """Integrate from ``state`` (size,) over ``settings.duration``.

    ``otherwise``: the settings to go on with where the motion turns out stiff for the explicit method of ``settings``.
    ``progress`` is told the share of the time that is done. Ctrl-C ends the run with what it has (``interrupted``).
    Stopping, continuing from a journal, and the pieces in which the loop is called change no bit of the samples.
    """
    schedule = schedule.until(settings.duration)
    run = NativeRun(model, parameters, schedule, state, sample_times(settings), settings, otherwise)
    if journal and (record := journal.restore()):
        run.resume(record)
    begun, began = run.cell("t"), clock.monotonic()
    status, message = _advanced(run, progress, journal, began)
    done = max(run.cell("t") - begun, 1e-300)
    return Trajectory(
        run.times[: run.done], run.samples[: run.done], status, message, run.statistics(),
        ErrorEstimate(run.errors_out[: run.done], "sum of the local errors", signed=False) if run.adaptive else None,
        (clock.monotonic() - began) / done,
    )  # fmt: skip


def _advanced(
    run: NativeRun, progress: Callable[[float], None], journal: Journal | None, began: float
) -> tuple[str, str]:
    """Let a run go on to its end; how it ended."""
    piece = _FIRST_PIECE
    try:
        while run.running:
            started = clock.monotonic()
            run.advance(piece)
            spent = clock.monotonic() - started
            piece = max(1, int(piece * min(4.0, _PIECE_SECONDS / max(spent, 1e-6))))
            progress(run.cell("t") / run.settings.duration)
            if journal:
                journal.keep(run.record(), last=not run.running)
            reason = run.exhausted(clock.monotonic() - began)
            if reason and run.running:
                return "stopped", reason
    except KeyboardInterrupt:
        if journal:
            journal.keep(run.record(), now=True)
        return "interrupted", f"interrupted at t = {run.cell('t'):.6g} s; what was done is kept"
    return run.ending()
