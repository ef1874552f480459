"""What a distribution is: its quantile function, from which every plan draws.

A distribution of a user's own is a class with the field ``type`` and one method::

    @DISTRIBUTIONS.register
    class Logistic(Distribution):
        type: Literal["logistic"] = Field(description="kind of distribution")
        mean: float = level("mu", "mean")
        scale: float = size("s", "scale")

        def at(self, share: Array) -> Array:
            return self.mean + self.scale * np.log(share / (1 - share))
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.kind import Kind
from tmodes.kinds.schema.quantity import Issue, any_sign, positive

__all__ = ["DISTRIBUTIONS", "EDGE", "Array", "Distribution", "level", "levels", "ordered", "share_of", "size"]

Array = NDArray[np.float64]

EDGE = 0.0013498980316300946
"""Share beyond each end of a distribution that has none: that of a normal beyond three deviations."""


class Distribution(Kind, family="distribution", key="type"):
    """How likely each value of a parameter is [the unit of the parameter]."""

    logarithmic: ClassVar[bool] = False
    """Whether ratios of its values count, not differences: a search goes by their logarithms."""

    def at(self, share: Array) -> Array:
        """The values (...) below which these shares (...) of all lie, 0 < share < 1: the quantile function."""
        raise NotImplementedError

    @property
    def ends(self) -> tuple[float, float]:
        """Least and largest value, between which grids are; where there is none, as of a normal's three deviations."""
        low, high = self.at(np.array([EDGE, 1 - EDGE])).tolist()
        return low, high

    @property
    def middle(self) -> float:
        """The median."""
        return float(self.at(np.array([0.5]))[0])

    @property
    def listed(self) -> tuple[float, ...]:
        """The only values that it has; empty where it has all between its ends."""
        return ()


def level(symbol: str, meaning: str, **more: Any) -> Any:
    """A field of the parameter's own unit; in a file also text with a unit."""
    return any_sign("parameter", symbol, meaning, **more)


def size(symbol: str, meaning: str, **more: Any) -> Any:
    """A field of the parameter's own unit that must be greater than zero, such as a deviation."""
    return positive("parameter", symbol, meaning, **more)


def levels(symbol: str, meaning: str, **more: Any) -> Any:
    """A list of numbers of the parameter's own unit."""
    return list_of_numbers("parameter", symbol, meaning, **more)


def ordered(low: float, high: float, key: str = "high") -> Iterator[Issue]:
    """An issue where ``low`` is not less than ``high``, at the field ``key``."""
    if not low < high:
        yield Issue(key, repr(high), f"more than low, {low!r}", "exchange them; for one value leave the parameter out")


def share_of(distribution: Distribution, value: float) -> float:
    """The share of all that lies below a value, from the quantile function, by bisection."""
    low, high = 0.0, 1.0
    while (middle := 0.5 * (low + high)) not in (low, high):
        below = float(distribution.at(np.array([middle]))[0]) < value
        low, high = (middle, high) if below else (low, middle)
    return high


DISTRIBUTIONS = Distribution.registry
"""Those of tmodes, and what a user registers: ``@DISTRIBUTIONS.register``."""
