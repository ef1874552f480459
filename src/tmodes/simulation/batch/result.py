"""BatchRun: what a batch of runs gave, lane by lane."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tmodes.simulation.parts import Trajectory

__all__ = ["COUNTS", "BatchRun", "gathered", "not_begun"]

COUNTS = ("steps", "rejected", "evaluations")
"""Statistics of each lane."""


@dataclass(frozen=True, eq=False)
class BatchRun:
    """k runs of one structure, sampled at the same times.

    ``times`` (n,) [s]; ``states`` (k, n, nx): coordinates, their rates, and what else is integrated, not-a-number where
    a lane has no sample; a motor whose gear is rigid in a lane moves as its joint. ``counts`` (k,): samples of each
    lane. ``status``: finished, diverged, stopped (a limit of the settings), interrupted, or failed (it could not
    start), and ``message`` what happened, for each lane.
    ``statistics``: steps, rejected, evaluations (k,). ``values``: numbers that differ between the lanes, (k,) each, by
    path of the data sheet. ``tips`` (k, n, 3): position of the tip in the world [m], or None. ``folder``: where the
    batch lies on disk, or None.
    """

    coordinates: tuple[str, ...]
    times: NDArray[np.float64]
    states: NDArray[np.float64]
    counts: NDArray[np.int64]
    status: tuple[str, ...]
    message: tuple[str, ...]
    statistics: dict[str, NDArray[np.int64]]
    values: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    tips: NDArray[np.float64] | None = None
    folder: Path | None = None

    @property
    def size(self) -> int:
        """Number of lanes."""
        return len(self.status)

    @property
    def finished(self) -> NDArray[np.bool_]:
        """Which lanes reached their end, (k,)."""
        return np.array([status == "finished" for status in self.status])

    def lane(self, index: int) -> Trajectory:
        """One lane as a run by itself."""
        count = int(self.counts[index])
        info = {name: float(values[index]) for name, values in self.statistics.items()}
        states = self.states[index, :count]
        return Trajectory(self.times[:count], states, self.status[index], self.message[index], info)


def not_begun(states: NDArray[np.float64], message: str) -> Trajectory:
    """A run that could not start; ``states`` (n, nx), its room, is left without a number."""
    states[:] = np.nan
    return Trajectory(np.zeros(0), states[:0], "failed", message, dict.fromkeys(COUNTS, 0.0))


def gathered(
    coordinates: tuple[str, ...], times: NDArray[np.float64], states: NDArray[np.float64], runs: Sequence[Trajectory]
) -> BatchRun:
    """The batch of these runs, whose samples are in ``states`` already."""
    return BatchRun(
        coordinates,
        times,
        states,
        np.array([len(run.times) for run in runs], dtype=np.int64),
        tuple(run.status for run in runs),
        tuple(run.message for run in runs),
        {name: np.array([int(run.statistics[name]) for run in runs], dtype=np.int64) for name in COUNTS},
    )
