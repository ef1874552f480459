"""One lane of a batch on the loop of a single run, and how a case is reported that did not simply finish."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmodes.compile.loops.time_loop import CELLS, Status
from tmodes.simulation.batch.work import LaneNumbers, Work
from tmodes.simulation.trajectory import NativeRun, Trajectory

__all__ = ["Alone", "info", "lane_run"]


class Alone:
    """A lane by itself, advanced piece by piece."""

    def __init__(self, work: Work, lane: int) -> None:
        self.run = lane_run(work, lane)
        if not np.isfinite(work.inputs.starts[lane]).all():
            self.run.memory[CELLS.index("status")] = float(Status.DIVERGED)

    def advance(self, steps: int) -> None:
        """Do at most so many steps."""
        self.run.advance(steps)

    @property
    def going(self) -> bool:
        """Whether it may go on."""
        tried = self.run.cell("steps") + self.run.cell("rejected")
        return self.run.running and tried < self.run.settings.max_steps

    @property
    def times(self) -> float:
        """How far it came [s]."""
        return self.run.cell("t")

    def ended(self, seconds: float) -> list[Trajectory]:
        """The run as it stands, after so much time of computing [s]."""
        return [info(self.run, seconds)]


def lane_run(work: Work, lane: int) -> NativeRun:
    """A lane as a run by itself, before its first step; its samples are those of the batch."""
    inputs = work.inputs
    numbers = LaneNumbers(inputs.parameters[lane])
    return NativeRun(
        work.model, numbers, inputs.schedule(lane), inputs.starts[lane], work.settings, work.states[work.places[lane]]
    )


def info(run: NativeRun, seconds: float) -> Trajectory:
    """A run as it ended, or was left; samples that it does not have are no numbers."""
    begun = np.isfinite(run.samples[0]).all()
    run.samples[run.done if begun else 0 :] = np.nan
    if not run.running:
        ended = run.end()
    elif reason := run.exhausted(seconds):
        ended = run.trajectory("stopped", reason)
    else:
        ended = run.trajectory("interrupted", f"interrupted at t = {run.cell('t'):.6g} s; what was done is kept")
    return ended if begun else replace(ended, times=ended.times[:0], states=ended.states[:0])
