"""Equally likely between two values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, level, ordered

__all__ = ["Uniform"]


@DISTRIBUTIONS.register
class Uniform(Distribution):
    """Equally likely from ``low`` to ``high``."""

    type: Literal["uniform"] = Field(description="kind of distribution")
    low: float = level("a", "least value")
    high: float = level("b", "largest value")

    def _issues(self) -> Iterator[Issue]:
        yield from ordered(self.low, self.high)

    def at(self, share: Array) -> Array:
        """Low and share times the range."""
        return self.low + (self.high - self.low) * share

    @property
    def ends(self) -> tuple[float, float]:
        """Both ends."""
        return self.low, self.high
