"""From rest to rest, smooth up to the acceleration; or between given rates and accelerations."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.noted.functions import array
from tmodes.kinds.schema.quantity import positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_value
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Quintic", "between", "hermite"]


@SIGNALS.register
class Quintic(Signal):
    """From rest to rest, smooth up to the acceleration: 10 x^3 - 15 x^4 + 6 x^5; other rates at its ends if given."""

    type: Literal["quintic"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value at the start")
    end: float = signal_value("u_1", "value at the end")
    duration: float = positive("s", "T", "duration of the move", at_most=1e6, smallest=1e-6)
    start_rate: float | None = signal_value("v_0", "rate at the start [per s]", default=None)
    end_rate: float | None = signal_value("v_1", "rate at the end, where it then stands [per s]", default=None)
    start_acceleration: float | None = signal_value("a_0", "acceleration at the start [per s^2]", default=None)
    end_acceleration: float | None = signal_value("a_1", "acceleration at the end [per s^2]", default=None)

    def pieces(self, until: float) -> SignalPieces:
        """The move."""
        del until
        first = self.start, self.start_rate, self.start_acceleration
        return between(first, (self.end, self.end_rate, self.end_acceleration), self.duration)

    def length(self, reach: float = 1.0) -> float:
        """Its duration."""
        return reach * self.duration


_RISES = {
    3: ((10.0, -15.0, 6.0), (-4.0, 7.0, -3.0), (0.5, -1.0, 0.5)),
    4: ((35.0, -84.0, 70.0, -20.0), (-15.0, 39.0, -34.0, 10.0), (2.5, -7.0, 6.5, -2.0), (-1 / 6, 0.5, -0.5, 1 / 6)),
}
"""By n: coefficients of x^n, ... whose first n derivatives vanish at 0, and of which one is 1 at x = 1."""


def between(start: tuple[Any, ...], end: tuple[Any, ...], duration: Any) -> SignalPieces:
    """The polynomial of degree 2 n - 1 with n given derivatives (value first) at its start and after ``duration`` [s].

    n = 3 or 4; those that are None are 0. Hermite interpolation.
    """
    start, end = (tuple(0.0 if one is None else one for one in side) for side in (start, end))
    return SignalPieces(array([0.0, duration]), hermite(start, end, duration)[None, :])


def hermite(start: tuple[Any, ...], end: tuple[Any, ...], duration: Any) -> Any:
    """Powers (..., 2 n) of the polynomial of :func:`between`, or of many: each number may be an array (...)."""
    count, factorials = len(start), np.cumprod([1.0, 1.0, 2.0, 3.0])
    low = [start[k] * duration**k / factorials[k] for k in range(count)]
    high: Any = 0.0
    for order in range(count):
        kept = sum(low[k] * (factorials[k] / factorials[k - order]) for k in range(order, count) if k or order)
        left = end[0] - start[0] - kept if order == 0 else end[order] * duration**order - kept
        high = high + np.multiply.outer(left, np.array(_RISES[count][order]))
    powers = array([*low, *np.moveaxis(high, -1, 0)])
    powers = np.moveaxis(powers, 0, -1) / np.power.outer(duration, np.arange(2 * count))
    powers[..., 0] = start[0]
    return powers
