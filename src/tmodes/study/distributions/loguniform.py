"""Logarithm equally likely between two values: as many between 1 and 10 as between 10 and 100."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, ordered, size

__all__ = ["LogUniform"]


@DISTRIBUTIONS.register
class LogUniform(Distribution):
    """A number whose logarithm is equally likely from that of ``low`` to that of ``high``."""

    type: Literal["loguniform"] = Field(description="kind of distribution")
    low: float = size("a", "least value")
    high: float = size("b", "largest value")

    def _issues(self) -> Iterator[Issue]:
        yield from ordered(self.low, self.high)

    def at(self, share: Array) -> Array:
        """Low times a power of the ratio of both ends."""
        return self.low * (self.high / self.low) ** share

    @property
    def ends(self) -> tuple[float, float]:
        """Both ends."""
        return self.low, self.high
