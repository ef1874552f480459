"""The lognormal distribution: a number that is positive, with a normal logarithm."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from tmodes.kinds.schema.quantity import Issue, positive
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, size

__all__ = ["LogNormal"]

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
