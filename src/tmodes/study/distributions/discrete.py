"""Distributions over given values: discrete by weights, and empirical."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.quantity import LARGEST, Issue
from tmodes.study.distributions.contract import DISTRIBUTIONS, Array, Distribution, levels

__all__ = ["Discrete", "Empirical"]

Weight = Annotated[float, Field(gt=0, le=LARGEST)]


@DISTRIBUTIONS.register
class Discrete(Distribution):
    """One of ``values``, by ``weights`` (any positive numbers; left out: all equally likely). A grid takes each."""

    type: Literal["discrete"] = Field(description="kind of distribution")
    values: tuple[float, ...] = levels("x", "values, in rising order")
    weights: tuple[Weight, ...] = list_of_numbers("-", "w", "how likely each is", default=())

    def _issues(self) -> Iterator[Issue]:
        if not self.values:
            yield Issue("values", "an empty list", "one value or more", "write the values")
        elif any(high <= low for low, high in zip(self.values, self.values[1:], strict=False)):
            yield Issue("values", "values that do not rise", "values in rising order, each once", "sort them")
        if self.weights and len(self.weights) != len(self.values):
            got = f"{len(self.weights)} weights for {len(self.values)} values"
            yield Issue("weights", got, "one for each value", "add or remove some, or leave them out")

    def _steps(self) -> Array:
        """The share up to each value."""
        weights = np.array(self.weights or [1.0] * len(self.values))
        return np.cumsum(weights) / weights.sum()

    def at(self, share: Array) -> Array:
        """The first value up to which the share lies."""
        places = np.searchsorted(self._steps(), np.asarray(share), side="left")
        return np.array(self.values)[np.minimum(places, len(self.values) - 1)]

    @property
    def ends(self) -> tuple[float, float]:
        """The first and the last value."""
        return self.values[0], self.values[-1]

    @property
    def listed(self) -> tuple[float, ...]:
        """All of them."""
        return self.values


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
