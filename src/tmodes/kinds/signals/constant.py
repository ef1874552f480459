"""One value at all times."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_value
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Constant"]


@SIGNALS.register
class Constant(Signal):
    """One value at all times."""

    type: Literal["constant"] = Field(description="kind of signal")
    value: float = signal_value("u", "value")

    @property
    def keeps_rate(self) -> bool:
        """It is."""
        return True

    def pieces(self, until: float) -> SignalPieces:
        """One piece up to ``until`` [s]."""
        return SignalPieces(np.array([0.0, until]), np.array([[self.value]]))
