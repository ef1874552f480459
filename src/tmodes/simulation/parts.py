"""What a run is given and what it gives: a journal, samples, and their error."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.settings import Integration

__all__ = ["ErrorEstimate", "Journal", "Trajectory", "sample_times"]


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

    ``status``: finished, stopped_by_condition (at its last time), diverged, step_too_small, not_converged, chattering,
    stopped (steps or time of computing are used up), interrupted.
    ``statistics``: steps, rejected, evaluations, ...; the same for the same run, whatever the machine. ``error``: None
    where it is not known. ``seconds``: of computing in this process, for each simulated second; no part of a result.
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
