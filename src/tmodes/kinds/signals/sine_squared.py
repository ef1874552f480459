"""From rest to rest with the speed of a squared sine."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_value
from tmodes.kinds.signals.fit import fitted_sine
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["SineSquared"]


@SIGNALS.register
class SineSquared(Signal):
    """From rest to rest with the speed 2 D/T sin^2(pi t/T): x - sin(2 pi x)/(2 pi) of its way."""

    type: Literal["sine_squared"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value at the start")
    end: float = signal_value("u_1", "value at the end")
    duration: float = positive("s", "T", "duration of the move", at_most=1e6, smallest=1e-6)

    def pieces(self, until: float) -> SignalPieces:
        """Pieces of degree 7, exact to 1e-13 of the way."""
        del until
        way, wave = self.end - self.start, fitted_sine(-1 / (2 * np.pi), 1.0, 0.0, 0.0, 1.0)
        unit = wave.coefficients.copy()
        unit[:, 0] += wave.knots[:-1]
        unit[:, 1] += 1.0
        powers = way * unit / self.duration ** np.arange(unit.shape[1])
        rise = np.zeros(unit.shape)
        rise[:, 0] = 1.0
        return SignalPieces(self.duration * wave.knots, powers + self.start * rise)

    def length(self, reach: float = 1.0) -> float:
        """Its duration."""
        return reach * self.duration
