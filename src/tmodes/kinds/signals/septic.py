"""From rest to rest, smooth up to the jerk; or between given rates, accelerations and jerks."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from tmodes.kinds.schema.quantity import positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_value
from tmodes.kinds.signals.quintic import between
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Septic"]


@SIGNALS.register
class Septic(Signal):
    """From rest to rest, smooth up to the jerk: 35 x^4 - 84 x^5 + 70 x^6 - 20 x^7; other rates at its ends if given."""

    type: Literal["septic"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value at the start")
    end: float = signal_value("u_1", "value at the end")
    duration: float = positive("s", "T", "duration of the move", at_most=1e6, smallest=1e-6)
    start_rate: float | None = signal_value("v_0", "rate at the start [per s]", default=None)
    end_rate: float | None = signal_value("v_1", "rate at the end, where it then stands [per s]", default=None)
    start_acceleration: float | None = signal_value("a_0", "acceleration at the start [per s^2]", default=None)
    end_acceleration: float | None = signal_value("a_1", "acceleration at the end [per s^2]", default=None)
    start_jerk: float | None = signal_value("j_0", "jerk at the start [per s^3]", default=None)
    end_jerk: float | None = signal_value("j_1", "jerk at the end [per s^3]", default=None)

    def pieces(self, until: float) -> SignalPieces:
        """The move."""
        del until
        first = self.start, self.start_rate, self.start_acceleration, self.start_jerk
        last = self.end, self.end_rate, self.end_acceleration, self.end_jerk
        return between(first, last, self.duration)

    def length(self, reach: float = 1.0) -> float:
        """Its duration."""
        return reach * self.duration
