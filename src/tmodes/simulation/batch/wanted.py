"""What a batch is wanted for where its samples are not: series of each run, or what they are reduced to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.lanes.lanes_loop import WIDTH
from tmodes.compile.lanes.series import SUMS
from tmodes.compile.native import Library
from tmodes.equations.loop.lean import Shown
from tmodes.kinds.signals.schedule import Schedule
from tmodes.model.passes import evaluate_wide
from tmodes.simulation.batch.private import private
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import Trajectory

__all__ = ["Given", "Wanted", "folded", "time_weights"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Wanted:
    """m series of all runs at n samples: written into ``out`` (all, n, m), or reduced into it (``folds``, all, m, 6).

    ``table`` (1 or all, n, given): what they are compared with; ``times`` (n,) [s] of the samples. A series of a run
    that did not come to its end has no number behind it.
    """

    shown: tuple[Shown, ...]
    table: Array
    times: Array
    out: Array
    folds: bool

    @property
    def given(self) -> int:
        """Numbers that are given for each sample."""
        return self.table.shape[2]

    def library(self, model: LoopModel, method: str) -> Library:
        """The native loop of runs side by side."""
        return model.lean_lane_loop(method, self.shown, self.given, folds=self.folds)

    def take(self, model: LoopModel, parameters: Array, schedule: Schedule, run: Trajectory, place: int) -> None:
        """The series of one run from its samples."""
        times, table = run.times, self.table[place if len(self.table) > 1 else 0]
        count, size = len(times), model.lean.layout.size
        if not count:
            self.out[place] = np.nan
            return
        wanted = model.series(self.shown, self.given, after=model.plan.is_sampled)
        blocks = {
            "time": times[:, None], "state": np.hstack([run.states[:, :size], table[:count]]),
            "row": schedule.rows_at(times), "step": np.zeros((count, 1)),
        }  # fmt: skip
        found = evaluate_wide(parameters, wanted, blocks, count)["series"]
        if self.folds:
            self.out[place] = folded(found, times)
        else:
            self.out[place, :count], self.out[place, count:] = found, np.nan


def time_weights(times: Array) -> Array:
    """Weights (n,) of samples in a mean over time, by the trapezoidal rule; the last may follow a shorter step."""
    if len(times) < 2:
        return np.ones(len(times))
    steps = np.diff(times) / (times[-1] - times[0])
    return (np.append(steps, 0.0) + np.insert(steps, 0, 0.0)) / 2


def folded(series: Array, times: Array) -> Array:
    """What series (n, m) are reduced to, (m, 6), in the order of :data:`tmodes.compile.lanes.series.SUMS`."""
    if not len(series):
        return np.full((series.shape[1], len(SUMS)), np.nan)
    weights, last = time_weights(times), series[-1]
    sums = series.max(axis=0), series.min(axis=0), weights @ series, weights @ series**2, last
    return np.column_stack([*sums, times[series.argmax(axis=0)]])


class Given:
    """The room of one thread for what runs side by side are compared with, and what their series are reduced to."""

    def __init__(self, wanted: Wanted) -> None:
        self.wanted, each = wanted, wanted.table.shape[1:]
        self.apart = len(wanted.table) > 1
        self.table = np.empty((WIDTH, *each)) if self.apart else wanted.table[0]
        self.weights = time_weights(wanted.times)
        self.sums = private(len(wanted.shown), len(SUMS), WIDTH)

    @property
    def stride(self) -> int:
        """How far the numbers of a lane are from those of the lane before."""
        return self.apart * self.table[0].size

    @property
    def arrays(self) -> dict[str, Array]:
        """Arguments of the native loop."""
        found = {"table": self.table, "weights": self.weights, "sums": self.sums}
        return found if self.wanted.folds else found | {"out": self.wanted.out}

    def take(self, places: NDArray[np.int64]) -> None:
        """What belongs to these runs."""
        if self.apart:
            np.take(self.wanted.table, places, axis=0, out=self.table)
        self.sums[:] = np.array([-np.inf, np.inf, 0.0, 0.0, np.nan, np.nan])[:, None]

    def keep(self, places: NDArray[np.int64]) -> None:
        """What the runs came to."""
        if self.wanted.folds:
            self.wanted.out[places] = self.sums[:, :, : len(places)].transpose(2, 0, 1)
