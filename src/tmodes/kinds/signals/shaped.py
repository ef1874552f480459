"""A motion through a shaper: the sum of its delayed copies, which leaves a mode at rest."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.noted.functions import number
from tmodes.kinds.schema.quantity import Issue
from tmodes.kinds.shapers.registry import Shaper
from tmodes.kinds.signals.contract import SIGNALS, Signal, delayed
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.kinds.signals.sums import summed

__all__ = ["Shaped"]


@SIGNALS.register
class Shaped(Signal):
    """A signal through a shaper: sum of A_i u(t - t_i), exactly; later than the signal by the last t_i."""

    type: Literal["shaped"] = Field(description="kind of signal")
    signal: Signal = Field(description="the motion that is shaped")
    shaper: Shaper = Field(description="what makes its copies, such as zv, zvd, zvdd or ei")

    def _issues(self) -> Iterator[Issue]:
        if not self.shaper.frequencies:
            hint = "write `frequencies: [5.0]`; `tmodes shaper` finds them"
            yield Issue("shaper.frequencies", "nothing", "the frequency of each mode [Hz]", hint)

    @property
    def keeps_rate(self) -> bool:
        """Only of one value: the copies of a ramp set in one after the other."""
        return self.signal.is_steady and not self.signal.schedule(1.0).coefficients[:, 1:].any()

    def pieces(self, until: float) -> SignalPieces:
        """The pieces of all copies, on all their knots."""
        try:
            one = self.signal.schedule(until)
        except InputError as error:
            raise InputError(f"signal.{error.which}", error.got, error.expected, error.hint, error.where) from error
        try:
            times, sizes = self.shaper.impulses()
        except InputError as error:
            raise InputError(f"shaper.{error.which}", error.got, error.expected, error.hint, error.where) from error
        return summed([
            SignalPieces(copy.knots, size * copy.coefficients)
            for time, size in zip(times, sizes, strict=True)
            for copy in [delayed(one, number(time), until)]
        ])  # fmt: skip

    def length(self, reach: float = 1.0) -> float | None:
        """Until the last copy is at its end."""
        end = self.signal.move_ends(reach)
        return None if end is None else end + self.shaper.delay
