"""A jump from one value to another."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_time, signal_value
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Step"]


@SIGNALS.register
class Step(Signal):
    """A jump from one value to another."""

    type: Literal["step"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value before the jump")
    end: float = signal_value("u_1", "value from the jump on")
    time: float = signal_time("t_1", "time of the jump")

    def pieces(self, until: float) -> SignalPieces:
        """Two pieces with the jump on their knot; one where it comes first or after ``until`` [s]."""
        if not 0 < self.time < until:
            return SignalPieces(np.array([0.0, until]), np.array([[self.start if self.time >= until else self.end]]))
        return SignalPieces(np.array([0.0, self.time, until]), np.array([[self.start], [self.end]]))
