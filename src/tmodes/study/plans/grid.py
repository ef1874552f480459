"""All combinations of some values of each parameter."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import LARGEST, Issue
from tmodes.sheet.parts import by_name
from tmodes.study.plans.contract import PLANS, Array, Design, Plan, Space, count
from tmodes.study.plans.named import unknown_names

__all__ = ["Grid"]

_MOST_LEVELS = 100_000

Value = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
Values = Annotated[tuple[Value, ...], Field(strict=False)]
Levels = Annotated[int, Field(ge=1, le=_MOST_LEVELS)]


@PLANS.register
class Grid(Plan):
    """All combinations of ``levels`` evenly spaced values of each parameter, the last parameter fastest.

    ``levels_of`` gives the number of some of them, ``points`` their values; one that is chosen from a list takes all.
    """

    type: Literal["grid"] = Field(description="kind of plan")
    levels: int = count("n", "values of each parameter", _MOST_LEVELS, default=5)
    levels_of: dict[str, Levels] = by_name("-", "n", "number of values, by parameter")
    points: dict[str, Values] = by_name("parameter", "x", "values, by parameter")

    def _axis(self, space: Space, name: str) -> Array:
        points = self.points.get(name)
        return np.array(points) if points else space.levels(name, self.levels_of.get(name, self.levels))

    def cases(self, space: Space) -> int:
        """The product of the numbers of values."""
        return math.prod(len(self._axis(space, name)) for name in space.names)

    def design(self, space: Space) -> Design:
        """All combinations."""
        axes = [self._axis(space, name) for name in space.names]
        mesh = np.meshgrid(*axes, indexing="ij")
        return Design(np.column_stack([values.ravel() for values in mesh]), {"axes": [axis.tolist() for axis in axes]})

    def issues(self, space: Space) -> Iterator[Issue]:
        """Names that no parameter has, and lists without a value."""
        yield from unknown_names("levels_of", self.levels_of, space)
        yield from unknown_names("points", self.points, space)
        for name, points in self.points.items():
            if not points:
                yield Issue(f"points.{name}", "an empty list", "one value or more", "write the values, or leave it out")
