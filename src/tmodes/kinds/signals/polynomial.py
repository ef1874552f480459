"""From rest to rest by one polynomial, as smooth as it is asked for."""

from __future__ import annotations

from math import comb
from typing import Literal

from pydantic import Field

from tmodes.kinds.noted.functions import array
from tmodes.kinds.schema.quantity import positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_value
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Polynomial"]


@SIGNALS.register
class Polynomial(Signal):
    """From rest to rest, n derivatives 0 at both ends: x^(n+1) sum_k C(n+k, k) C(2n+1, n-k) (-x)^k, degree 2n + 1.

    n = 2 is the quintic, 3 the septic; an exact inverse of elastic joints wants 4.
    """

    type: Literal["polynomial"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value at the start")
    end: float = signal_value("u_1", "value at the end")
    duration: float = positive("s", "T", "duration of the move", at_most=1e6, smallest=1e-6)
    smooth: int = Field(default=4, ge=1, le=10, description="n, how many derivatives vanish at both ends")

    def pieces(self, until: float) -> SignalPieces:
        """The move."""
        del until
        n, way = self.smooth, self.end - self.start
        rises = [(-1) ** k * comb(n + k, k) * comb(2 * n + 1, n - k) for k in range(n + 1)]
        powers = [
            self.start,
            *([0.0] * n),
            *(way * rise / self.duration ** (n + 1 + k) for k, rise in enumerate(rises)),
        ]
        return SignalPieces(array([0.0, self.duration]), array(powers)[None, :])

    def length(self, reach: float = 1.0) -> float:
        """Its duration."""
        return reach * self.duration
