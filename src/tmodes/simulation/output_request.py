"""Outputs that are wanted of a batch in place of its samples: as series of each run, or reduced."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.native import Library
from tmodes.equations.loop.outputs import Output
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.model.passes import evaluate_wide
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.reductions import folded, time_weights

__all__ = ["OutputRequest"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class OutputRequest:
    """m series of all runs at n samples: written into ``out`` (all, n, m), or reduced into it (``folds``, all, m, 6).

    ``table`` (1 or all, n, given): what they are compared with; ``times`` (n,) [s] of the samples. A series of a run
    that did not come to its end has no number behind it.
    """

    shown: tuple[Output, ...]
    table: Array
    times: Array
    out: Array
    folds: bool
    _last: list[tuple[SignalPieces, Array]] = field(default_factory=list, repr=False)

    @property
    def given(self) -> int:
        """Numbers that are given for each sample."""
        return self.table.shape[2]

    def library(self, model: LoopModel, method: str) -> Library:
        """The native loop of runs side by side."""
        return model.lean_lane_loop(method, self.shown, self.given, folds=self.folds)

    def take(self, model: LoopModel, parameters: Array, schedule: SignalPieces, run: Trajectory, place: int) -> None:
        """The series of one run from its samples."""
        times, table = run.times, self.table[place if len(self.table) > 1 else 0]
        count, size = len(times), model.side(self.shown).layout.size
        if not count:
            self.out[place] = np.nan
            return
        whole = np.array_equal(times, self.times)
        rows = self._rows(schedule) if whole else schedule.rows_at(times)
        wanted = model.series(self.shown, self.given, after=model.plan.is_sampled).schedule
        blocks = {
            "time": times[:, None], "state": np.hstack([run.states[:, :size], table[:count]]),
            "row": rows, "step": np.zeros((count, 1)),
        }  # fmt: skip
        found = evaluate_wide(parameters, wanted, blocks, count)["series"]
        if self.folds:
            self.out[place] = folded(found, times, self.weights if whole else time_weights(times))
        else:
            self.out[place, :count], self.out[place, count:] = found, np.nan

    @cached_property
    def weights(self) -> Array:
        """Weights (n,) of all samples in a mean over time."""
        return time_weights(self.times)

    def _rows(self, schedule: SignalPieces) -> Array:
        """Its rows at all samples; those of the last one are kept, which is most often that of all runs."""
        known, rows = self._last[0] if self._last else (None, self.times)
        if known is not schedule:
            rows = schedule.rows_at(self.times)
            self._last[:] = [(schedule, rows)]  # at once: other threads read it
        return rows
