"""What a distribution is: its quantile function, from which every plan draws.

A distribution of a user's own is a class with the field ``type`` and one method::

    @DISTRIBUTIONS.register
    class Logistic(Distribution):
        type: Literal["logistic"] = Field(description="kind of distribution")
        mean: float = level("mu", "mean")
        scale: float = level("s", "scale")

        def at(self, share: Array) -> Array:
            return self.mean + self.scale * np.log(share / (1 - share))
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.schema.kind import Kind
from tmodes.kinds.schema.quantity import any_sign

__all__ = ["DISTRIBUTIONS", "Array", "Distribution", "level"]

Array = NDArray[np.float64]

_EDGE = 1e-12
"""Share from which on an end that is not finite is left out."""


class Distribution(Kind, family="distribution", key="type"):
    """How likely each value of a parameter is [the unit of the parameter]."""

    def at(self, share: Array) -> Array:
        """The values (...) below which these shares (...) of all lie, 0 < share < 1: the quantile function."""
        raise NotImplementedError

    @property
    def ends(self) -> tuple[float, float]:
        """Least and largest value; of a distribution without an end, those of a share of 1e-12."""
        low, high = self.at(np.array([_EDGE, 1 - _EDGE])).tolist()
        return low, high

    @property
    def middle(self) -> float:
        """The median."""
        return float(self.at(np.array([0.5]))[0])


def level(symbol: str, meaning: str, **more: Any) -> float:
    """A field of the parameter's own unit; in a file also text with a unit."""
    return any_sign("parameter", symbol, meaning, **more)


DISTRIBUTIONS = Distribution.registry
"""Those of tmodes, and what a user registers: ``@DISTRIBUTIONS.register``."""
