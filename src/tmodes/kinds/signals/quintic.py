"""From rest to rest, smooth up to the acceleration."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, delayed, signal_time, signal_value
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Quintic"]


@SIGNALS.register
class Quintic(Signal):
    """From rest to rest, smooth up to the acceleration: 10 x^3 - 15 x^4 + 6 x^5."""

    type: Literal["quintic"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value at the start")
    end: float = signal_value("u_1", "value at the end")
    duration: float = positive("s", "T", "duration of the move", at_most=1e6, smallest=1e-6)
    delay: float = signal_time("t_0", "time at which it starts", default=0.0)

    def schedule(self, until: float) -> SignalPieces:
        """The delay, the move, and the last value, up to ``until`` [s]."""
        shape = (self.end - self.start) * np.array([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])
        move = shape / self.duration ** np.arange(6)
        move[0] = self.start
        return delayed(SignalPieces(np.array([0.0, self.duration]), move[None, :]), self.delay, until)

    def move_ends(self, reach: float = 1.0) -> float:
        """Delay and duration."""
        return self.delay + reach * self.duration
