"""Another distribution, between limits alone."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, level, ordered, share_of

__all__ = ["Truncated"]

_LEAST = 1e-9
"""Least share of the whole that may be left."""


@DISTRIBUTIONS.register
class Truncated(Distribution):
    """Those values of another ``distribution`` that are between ``low`` and ``high``, one of which may be left out."""

    type: Literal["truncated"] = Field(description="kind of distribution")
    distribution: Distribution = Field(description="the whole distribution")
    low: float | None = level("a", "least value", default=None)
    high: float | None = level("b", "largest value", default=None)

    def _issues(self) -> Iterator[Issue]:
        if self.low is None and self.high is None:
            yield Issue("", "no limit", "`low`, `high` or both", "write the limits, or the distribution by itself")
        elif self.low is not None and self.high is not None and not self.low < self.high:
            yield from ordered(self.low, self.high)
        elif (left := self._shares[1] - self._shares[0]) < _LEAST:
            got = f"limits that leave a share of {left:.3g} of the distribution"
            yield Issue("", got, f"limits that leave at least {_LEAST:g}", "widen them, or check their unit")

    @cached_property
    def _shares(self) -> tuple[float, float]:
        """Shares of the whole below both limits."""
        low = 0.0 if self.low is None else share_of(self.distribution, self.low)
        high = 1.0 if self.high is None else share_of(self.distribution, float(np.nextafter(self.high, np.inf)))
        return low, high

    def at(self, share: Array) -> Array:
        """The whole distribution at shares between those of the limits."""
        low, high = self._shares
        inside = np.clip(low + (high - low) * share, np.nextafter(0, 1), np.nextafter(1, 0))
        return np.clip(self.distribution.at(inside), self.low, self.high)

    @property
    def ends(self) -> tuple[float, float]:
        """The limits; where one is left out, the end of the whole."""
        low, high = self.distribution.ends
        return low if self.low is None else max(self.low, low), high if self.high is None else min(self.high, high)

    @property
    def listed(self) -> tuple[float, ...]:
        """Of a whole that has only some values, those between the limits."""
        low, high = self.ends
        return tuple(value for value in self.distribution.listed if low <= value <= high)
