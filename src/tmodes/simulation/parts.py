"""What a run is given and what it gives: a journal, and samples."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.loops.time_loop import Status
from tmodes.integrate.settings import Integration

__all__ = [
    "MOST_CHANGES",
    "Journal",
    "LostRun",
    "RunChange",
    "Trajectory",
    "chattered",
    "completed",
    "sample_times",
    "used_up",
]


class Journal(Protocol):
    """Where a long run keeps its progress, so that nothing finished is lost."""

    def restore(self) -> dict[str, NDArray[np.float64]] | None:
        """Memory, state and samples so far of the same run, or None."""
        ...

    def keep(self, record: dict[str, NDArray[np.float64]], *, last: bool = False, now: bool = False) -> None:
        """Keep the progress, when it is time to; ``last``: nothing follows; ``now``: whatever the time."""
        ...


MOST_CHANGES = 2000
"""Changes of a run that are kept."""


class RunChange(NamedTuple):
    """An instant [s] at which a force starts or ends, or something switches: the states (size,) before and after."""

    time: float
    before: NDArray[np.float64]
    after: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Trajectory:
    """Samples of a run: ``times`` (n,) [s], ``states`` (n, size).

    ``status``: finished, stopped_by_condition (at its last time), diverged, step_too_small, not_converged, chattering,
    stopped (steps or time of computing are used up), interrupted.
    ``statistics``: steps, rejected, evaluations, ...; the same for the same run, whatever the machine. ``seconds``: of
    computing in this process, for each simulated second, or of the run in a batch; no part of a result.
    ``changes``: the first :data:`MOST_CHANGES`, of a run by itself. ``ended_by``: the stop condition that ended it.
    """

    times: NDArray[np.float64]
    states: NDArray[np.float64]
    status: str
    message: str
    statistics: dict[str, Any] = field(default_factory=dict)
    seconds: float = 0.0
    changes: tuple[RunChange, ...] = ()
    ended_by: str = ""


def sample_times(settings: Integration) -> NDArray[np.float64]:
    """Times of the samples [s]: every ``output_step``, and the end, which is a sample even where it is no multiple."""
    count = math.floor(settings.duration / settings.output_step * (1 + 1e-12))
    times = np.arange(count + 1, dtype=np.float64) * np.float64(settings.output_step)
    if settings.duration - times[-1] > 1e-9 * settings.output_step:
        return np.append(times, settings.duration)
    times[-1] = settings.duration
    return times


class LostRun(NamedTuple):
    """Where a run could not continue: time and next step [s], accelerations (nq,), and their ``names``."""

    time: float
    step: float
    accelerations: NDArray[np.float64]
    names: Sequence[str]
    bound: float

    def info(self, status: Status) -> tuple[str, str]:
        """Status and sentence of a loop that ended by DIVERGED, STEP_TOO_SMALL or NOT_CONVERGED."""
        size = np.where(np.isfinite(self.accelerations), np.abs(self.accelerations), np.inf)
        k = int(np.argmax(size))
        value = f"its acceleration is {self.accelerations[k]:.3g} rad/s^2"
        kind, why, hint = self._kind(status)
        if kind != "diverged" and not size[k] < self.bound:  # what is lost makes steps small and iterations fail
            kind, hint = "diverged", "look for what drives it away, no number among the signals, or a vanishing mass"
        words = kind.replace("_", " ")
        return kind, f"{words} at t = {self.time:.6g} s in coordinate {self.names[k]}: {value}{why}; {hint}".rstrip(
            "; "
        )

    def _kind(self, status: Status) -> tuple[str, str, str]:
        """Status, cause and fix by the loop's own word."""
        if status is Status.NOT_CONVERGED:
            hint = "shorten integration.step, or loosen integration.relative_tolerance"
            return "not_converged", f" and the iterations of a step of {self.step:.3g} s do not converge", hint
        if status is Status.STEP_TOO_SMALL:
            hint = "raise integration.relative_tolerance where rounding alone is larger"
            return "step_too_small", f" and no step is small enough (last {self.step:.3g} s)", hint
        return "diverged", f"; its next step leaves {self.bound:g} rad or rad/s", ""


def completed(duration: float) -> str:
    """Sentence of a run that reached its end [s]; :func:`tmodes.integrate.choice.explained` adds to it."""
    return f"completed at t = {duration:g} s"


def chattered(time: float, most: int, within: float) -> tuple[str, str]:
    """Of a contact that changes ``most`` times ``within`` a time [s]: a bounce whose period shrinks to nothing."""
    return "chattering", (
        f"stopped at t = {time:.6g} s: the contact started or ended more than {most} times within {within:g} s, as a "
        "bounce does whose period shrinks to nothing; give the surface damping, or a lower stiffness"
    )


def used_up(time: float, duration: float, name: str, value: str) -> str:
    """Why a run stopped whose steps or seconds of computing are used up."""
    hint = "raise it, shorten integration.duration, loosen the tolerance, or look for what makes the motion stiff"
    return f"stopped at t = {time:.6g} s of {duration:g} s: integration.{name} = {value} is used up; {hint}"
