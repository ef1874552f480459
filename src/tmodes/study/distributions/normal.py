"""The normal distribution."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, level, size

__all__ = ["Normal"]


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
