"""Equally likely between two values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, level

__all__ = ["Uniform"]


@DISTRIBUTIONS.register
class Uniform(Distribution):
    """Equally likely from ``low`` to ``high``."""

    type: Literal["uniform"] = Field(description="kind of distribution")
    low: float = level("a", "least value")
    high: float = level("b", "largest value")

    def _issues(self) -> Iterator[Issue]:
        if not self.low < self.high:
            yield Issue("high", repr(self.high), f"more than low, {self.low!r}", "exchange them, or leave it out")

    def at(self, share: Array) -> Array:
        """Low and share times the range."""
        return self.low + (self.high - self.low) * share

    @property
    def ends(self) -> tuple[float, float]:
        """Both ends."""
        return self.low, self.high
