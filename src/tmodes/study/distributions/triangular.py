"""Most likely at one value, and less so the nearer to two ends."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, level, ordered

__all__ = ["Triangular"]


@DISTRIBUTIONS.register
class Triangular(Distribution):
    """A density that rises in a line from ``low`` to ``mode`` and falls in a line to ``high``."""

    type: Literal["triangular"] = Field(description="kind of distribution")
    low: float = level("a", "least value")
    mode: float = level("c", "most likely value")
    high: float = level("b", "largest value")

    def _issues(self) -> Iterator[Issue]:
        yield from ordered(self.low, self.high)
        if not self.low <= self.mode <= self.high:
            yield Issue("mode", repr(self.mode), f"from low to high, {self.low!r} to {self.high!r}", "move it")

    def at(self, share: Array) -> Array:
        """Square roots of the shares, from either end."""
        low, mode, high = self.low, self.mode, self.high
        rising = low + np.sqrt(share * (high - low) * (mode - low))
        falling = high - np.sqrt((1 - share) * (high - low) * (high - mode))
        return np.where(share * (high - low) < mode - low, rising, falling)

    @property
    def ends(self) -> tuple[float, float]:
        """Both ends."""
        return self.low, self.high
