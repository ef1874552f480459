"""The clock of a sampled controller as a signal: the time since its last sample."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tmodes.errors import InputError
from tmodes.kinds.signals.schedule import Schedule

__all__ = ["Clock"]

MOST_SAMPLES = 1_000_000

_SAME = 1e-9
"""A sample nearer to a time of the output than this share of the output step is taken at that time."""


@dataclass(frozen=True)
class Clock:
    """A saw tooth that is exactly 0 at each sample and rises by 1 s/s; ``output_step`` [s] of the run."""

    period: float
    output_step: float

    def schedule(self, until: float) -> Schedule:
        """A piece from each sample to the next, up to ``until`` [s].

        Raises :class:`tmodes.errors.InputError` for more than a million samples.
        """
        count = int(np.ceil(until / self.period * (1 - 1e-12)))
        if count > MOST_SAMPLES:
            got, most = f"{self.period:g} s, {count} samples in {until:g} s", f"at most {MOST_SAMPLES} samples"
            raise InputError("sample_time", got, most, "sample less often, or shorten the run")
        times = self.period * np.arange(count)
        shown = np.round(times / self.output_step) * self.output_step
        starts = np.where(np.abs(times - shown) < _SAME * self.output_step, shown, times)
        return Schedule(np.append(starts, until), np.tile([0.0, 1.0], (count, 1)))

    def move_ends(self, reach: float = 1.0) -> float | None:
        """Never."""
        del reach
