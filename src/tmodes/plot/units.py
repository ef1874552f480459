"""Units in which values read well: mm, mrad, kN·m."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.io.printed import NEVER_LARGE, pretty

__all__ = ["NEVER_LARGE", "PREFIXES", "Unit", "largest_value", "pretty", "readable", "with_prefix"]

PREFIXES = ((1e4, 1e-3, "k"), (0.1, 1.0, ""), (1e-4, 1e3, "m"), (1e-7, 1e6, "µ"), (1e-11, 1e9, "n"))
"""From this largest value on: the factor on the SI value, and the prefix of the unit."""


@dataclass(frozen=True)
class Unit:
    """A readable unit: ``name`` as labels write it, ``factor`` on the SI value."""

    name: str
    factor: float

    def of(self, values: ArrayLike) -> NDArray[np.float64]:
        """SI values, in this unit."""
        return np.asarray(values, dtype=float) * self.factor


def readable(unit: str, *values: ArrayLike) -> Unit:
    """The unit in which the largest of ``values`` [``unit``, SI] reads well; all zero stays as it is."""
    largest = max(map(largest_value, values), default=0.0)
    for least, factor, prefix in PREFIXES:
        if largest >= least and not (prefix == "k" and unit.split("/", maxsplit=1)[0] in NEVER_LARGE):
            return with_prefix(prefix, unit, factor)
    return with_prefix("", unit, 1.0)


def with_prefix(prefix: str, unit: str, factor: float) -> Unit:
    """The SI unit with a prefix, and the factor that belongs to it."""
    return Unit(prefix + pretty(unit), factor)


def largest_value(values: ArrayLike) -> float:
    """The largest size of any of the values; 0 of none."""
    return float(np.max(np.abs(np.asarray(values, dtype=float)), initial=0.0))
