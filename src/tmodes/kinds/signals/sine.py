"""A harmonic oscillation."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from tmodes.kinds.schema.quantity import any_sign, positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_value
from tmodes.kinds.signals.fit import fitted_sine
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Sine"]


@SIGNALS.register
class Sine(Signal):
    """offset + amplitude sin(2 pi frequency t + phase)."""

    type: Literal["sine"] = Field(description="kind of signal")
    amplitude: float = signal_value("A", "amplitude")
    frequency: float = positive("Hz", "f", "frequency", plausible=(1e-3, 1e4))
    phase: float = any_sign("rad", "phi", "phase at time 0", default=0.0, at_least=-1e3, at_most=1e3)
    offset: float = signal_value("u_0", "value that it swings about", default=0.0)

    def pieces(self, until: float) -> SignalPieces:
        """Pieces of degree 7, exact to 1e-12 of the amplitude, up to ``until`` [s]."""
        return fitted_sine(self.amplitude, self.frequency, self.phase, self.offset, until)
