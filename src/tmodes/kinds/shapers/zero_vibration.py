"""Shapers that leave no vibration at the frequency they are made for: ZV; ZVD and ZVDD with flat residuals about it."""

from __future__ import annotations

from math import comb
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.noted.functions import array
from tmodes.kinds.shapers.contract import SHAPERS, Impulses, Shaper, decay

__all__ = ["ZV", "ZVD", "ZVDD"]


class _Binomial(Shaper):
    """``count`` impulses half a damped period apart, binomial numbers times powers of the decay in between.

    Residual and its derivatives by the frequency, up to the order ``count`` - 2, are zero: Singer and Seering (1990).
    """

    count: ClassVar[int]

    def of_mode(self, damping: Any) -> Impulses:
        """Amplitudes over their sum, (1 + K)^(count - 1)."""
        last, ratio = self.count - 1, decay(damping)
        sizes = [comb(last, k) * ratio**k / (1 + ratio) ** last for k in range(self.count)]
        return Impulses(np.arange(self.count) / 2, array(sizes))


@SHAPERS.register
class ZV(_Binomial):
    """Two impulses: zero vibration at the frequency; half a period longer."""

    type: Literal["zv"] = Field(description="kind of shaper")
    count: ClassVar[int] = 2


@SHAPERS.register
class ZVD(_Binomial):
    """Three impulses: zero vibration and zero slope of it; a period longer."""

    type: Literal["zvd"] = Field(description="kind of shaper")
    count: ClassVar[int] = 3


@SHAPERS.register
class ZVDD(_Binomial):
    """Four impulses: zero vibration, slope and curvature of it; one and a half periods longer."""

    type: Literal["zvdd"] = Field(description="kind of shaper")
    count: ClassVar[int] = 4
