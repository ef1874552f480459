"""Continuous distributions: uniform, loguniform, normal, lognormal, triangular; and truncation of any."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue, positive
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, level, ordered, share_of, size

__all__ = ["LogNormal", "LogUniform", "Normal", "Triangular", "Truncated", "Uniform"]


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


@DISTRIBUTIONS.register
class LogUniform(Distribution):
    """A number whose logarithm is equally likely from that of ``low`` to that of ``high``."""

    logarithmic: ClassVar[bool] = True
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


@DISTRIBUTIONS.register
class Normal(Distribution):
    """Normal with ``mean`` and standard ``deviation``."""

    type: Literal["normal"] = Field(description="kind of distribution")
    mean: float = level("mu", "mean")
    deviation: float = size("sigma", "standard deviation")

    def at(self, share: Array) -> Array:
        """Mean and deviation times the quantile of the standard normal."""
        from scipy.special import ndtri

        return self.mean + self.deviation * ndtri(share)


_HINT = "write `median` and `sigma_log`, or `mean` and `deviation`"


@DISTRIBUTIONS.register
class LogNormal(Distribution):
    """Lognormal by one of two pairs of numbers.

    ``median`` and ``sigma_log``: exp of the mean of the logarithm, and the deviation of the natural logarithm [-].
    ``mean`` and ``deviation``: of the number itself, not of its logarithm.
    """

    type: Literal["lognormal"] = Field(description="kind of distribution")
    median: float | None = size("m", "median of the number", default=None)
    sigma_log: float | None = positive(
        "-", "s", "standard deviation of the natural logarithm", default=None, at_most=10.0
    )
    mean: float | None = size("mu", "mean of the number itself", default=None)
    deviation: float | None = size("sigma", "standard deviation of the number itself", default=None)

    def _issues(self) -> Iterator[Issue]:
        given = [key for key in ("median", "sigma_log", "mean", "deviation") if getattr(self, key) is not None]
        if given not in (["median", "sigma_log"], ["mean", "deviation"]):
            yield Issue("", " and ".join(given) or "no numbers", "one of two pairs of numbers", _HINT)

    @property
    def _of_logarithm(self) -> tuple[float, float]:
        """Median, and the deviation of the natural logarithm."""
        if self.median is not None and self.sigma_log is not None:
            return self.median, self.sigma_log
        assert self.mean is not None  # noqa: S101
        assert self.deviation is not None  # noqa: S101
        variance = math.log1p((self.deviation / self.mean) ** 2)
        return self.mean * math.exp(-variance / 2), math.sqrt(variance)

    def at(self, share: Array) -> Array:
        """Median times exp of the deviation times the quantile of the standard normal."""
        import numpy as np
        from scipy.special import ndtri

        median, deviation = self._of_logarithm
        return median * np.exp(deviation * ndtri(share))


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
