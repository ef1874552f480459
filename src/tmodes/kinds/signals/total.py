"""The sum of other signals."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.signals.contract import SIGNALS, Signal
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.kinds.signals.sums import summed

__all__ = ["Sum"]

MOST_PARTS = 20


@SIGNALS.register
class Sum(Signal):
    """The sum of signals, such as a move with noise on it."""

    type: Literal["sum"] = Field(description="kind of signal")
    signals: tuple[Signal, ...] = Field(
        strict=False, min_length=1, max_length=MOST_PARTS, description="signals that are added"
    )

    @property
    def keeps_rate(self) -> bool:
        """Whether all of them are."""
        return all(signal.is_steady for signal in self.signals)

    def pieces(self, until: float) -> SignalPieces:
        """The pieces of all, on all their knots, up to ``until`` [s]."""
        parts = []
        for index, signal in enumerate(self.signals):
            try:
                parts.append(signal.schedule(until))
            except InputError as error:
                which = f"signals.{index}.{error.which}"
                raise InputError(which, error.got, error.expected, error.hint, error.where) from error
        return summed(parts)

    def length(self, reach: float = 1.0) -> float | None:
        """When the last of the moves in it is at its end."""
        ends = [end for signal in self.signals if (end := signal.move_ends(reach)) is not None]
        return max(ends) if ends else None
