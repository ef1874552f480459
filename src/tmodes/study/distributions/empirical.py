"""Values that were measured, each as likely as any other."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, levels

__all__ = ["Empirical"]

_FEWEST = 2


@DISTRIBUTIONS.register
class Empirical(Distribution):
    """One of ``values``, each as likely as any other; they stand here or in a ``column`` of a CSV ``file``.

    Draws are values that were measured, nothing between them: the quantile function is that of the steps.
    """

    type: Literal["empirical"] = Field(description="kind of distribution")
    values: tuple[float, ...] = levels("x", "measured values", default=())
    file: str | None = Field(default=None, min_length=1, max_length=200, description="CSV file in the study's folder")
    column: str | None = Field(default=None, min_length=1, max_length=200, description="its column, by the first line")

    def _issues(self) -> Iterator[Issue]:
        if bool(self.values) == bool(self.file):
            got = "both" if self.file else "neither"
            yield Issue(
                "", got, "either values or a file with a column", "write `values: [..]`, or `file` and `column`"
            )
        elif self.values and len(self.values) < _FEWEST:
            yield Issue("values", f"{len(self.values)} value", f"at least {_FEWEST}", "add values")
        elif self.values and min(self.values) == max(self.values):
            hint = "leave the parameter out, and set the value"
            yield Issue("values", f"{self.values[0]!r} alone", "values that differ", hint)

    def at(self, share: Array) -> Array:
        """The value that this share of all does not exceed."""
        known = _sorted(self.values)
        count = len(known)
        return known[np.clip(np.ceil(np.asarray(share) * count).astype(int) - 1, 0, count - 1)]

    @property
    def ends(self) -> tuple[float, float]:
        """Least and largest of the values."""
        return min(self.values), max(self.values)


@lru_cache(maxsize=32)
def _sorted(values: tuple[float, ...]) -> Array:
    return np.sort(np.array(values))
