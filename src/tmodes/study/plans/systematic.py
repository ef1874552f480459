"""Plans without randomness: grid, one at a time, tolerance stack-up, a list of cases."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.quantity import LARGEST, Issue
from tmodes.sheet.parts import by_name
from tmodes.study.plans.contract import PLANS, Array, Design, Plan, Space, count, unknown_names

__all__ = ["Grid", "ListOfCases", "OneAtATime", "Tolerance"]

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


@PLANS.register
class OneAtATime(Plan):
    """The nominal case, then ``points`` values of each parameter between its ends, the others nominal."""

    type: Literal["one_at_a_time"] = Field(description="kind of plan")
    points: int = count("n", "values of each parameter", 100_000, default=5)

    def cases(self, space: Space) -> int:
        """One, and the values of all parameters."""
        return 1 + sum(len(space.levels(name, self.points)) for name in space.names)

    def design(self, space: Space) -> Design:
        """``info``: the cases of each parameter, from the first to the one before the last number, by its name."""
        rows, ranges, labels = [space.nominal[None]], {}, {0: "nominal"}
        first = 1
        for k, name in enumerate(space.names):
            values = space.levels(name, self.points)
            part = np.tile(space.nominal, (len(values), 1))
            part[:, k] = values
            ranges[name] = [first, first + len(values)]
            labels |= {first + i: f"{name} {i + 1} of {len(values)}" for i in range(len(values))}
            first += len(values)
            rows.append(part)
        return Design(np.concatenate(rows), {"nominal": 0, "ranges": ranges}, labels)


_MOST_CORNERS = 12
"""Parameters of which all corners are run: 4,096 cases."""


@PLANS.register
class Tolerance(Plan):
    """The nominal case, each parameter at its least and its largest value, then all corners of up to 12 parameters.

    :func:`tmodes.study.statistics.tolerance_stack` makes of it the worst case and the root of the sum of squares.
    """

    type: Literal["tolerance"] = Field(description="kind of plan")
    corners: bool = Field(default=True, description="also all combinations of ends, of up to 12 parameters")

    def _has_corners(self, space: Space) -> bool:
        return self.corners and 1 < len(space.names) <= _MOST_CORNERS

    def cases(self, space: Space) -> int:
        """One, two for each parameter, and the corners."""
        return 1 + 2 * len(space.names) + (2 ** len(space.names) if self._has_corners(space) else 0)

    def design(self, space: Space) -> Design:
        """``info``: the numbers of the ``nominal`` case, of each ``low`` and ``high``, and of the ``corners``."""
        count = len(space.names)
        low, high = space.between(np.array([np.zeros(count), np.ones(count)]))
        single = np.tile(space.nominal, (2 * count, 1))
        single[2 * np.arange(count), np.arange(count)] = low
        single[2 * np.arange(count) + 1, np.arange(count)] = high
        rows, info = [space.nominal[None], single], {"nominal": 0, "corners": [1 + 2 * count, 1 + 2 * count]}
        if self._has_corners(space):
            ends = np.array([*itertools.product((0, 1), repeat=count)])
            rows.append(np.where(ends, high, low))
            info["corners"] = [1 + 2 * count, 1 + 2 * count + len(ends)]
        info["low"] = {name: 1 + 2 * k for k, name in enumerate(space.names)}
        info["high"] = {name: 2 + 2 * k for k, name in enumerate(space.names)}
        labels = {0: "nominal"} | {info[end][name]: f"{name} {end}" for end in ("low", "high") for name in space.names}
        more = self.corners and count > _MOST_CORNERS
        notice = f"{count} parameters have too many corners to run them all (at most {_MOST_CORNERS})"
        return Design(np.concatenate(rows), info, labels, (notice,) if more else ())

    def issues(self, space: Space) -> Iterator[Issue]:
        """A choice has no ends."""
        if chosen := sorted(space.chosen):
            yield Issue(
                "type", f"`tolerance` with the choice {chosen[0]}", "a plan for parameters with ends, or no choice",
                "take the plan `grid` or `one_at_a_time`, or remove the choice",
            )  # fmt: skip


@PLANS.register
class ListOfCases(Plan):
    """The ``cases``, each with values of parameters by name, or a CSV ``file`` with a column for each of them.

    What a case leaves out is nominal. A choice is given by its name or its number.
    """

    type: Literal["list"] = Field(description="kind of plan")
    rows: tuple[dict[str, Value], ...] = list_of_numbers(
        "parameter", "x", "values by parameter, for each case", default=()
    )
    file: str | None = Field(default=None, min_length=1, max_length=200, description="CSV file in the study's folder")

    def _issues(self) -> Iterator[Issue]:
        if bool(self.rows) == bool(self.file):
            got = "both" if self.file else "neither"
            yield Issue("", got, "either rows or a file", "write `rows: [{gear: 0.8}, {gear: 1.2}]`, or `file`")

    def cases(self, space: Space) -> int:  # noqa: ARG002
        """Those that are written."""
        return len(self.rows)

    def design(self, space: Space) -> Design:
        """The values of each, nominal where none is given."""
        values = np.tile(space.nominal, (len(self.rows), 1))
        for k, row in enumerate(self.rows):
            for name, value in row.items():
                values[k, list(space.names).index(name)] = value
        return Design(values)

    def issues(self, space: Space) -> Iterator[Issue]:
        """Names that no parameter has, and numbers of choices that there are not."""
        for k, row in enumerate(self.rows):
            yield from unknown_names(f"rows.{k}", row, space)
            for name in space.chosen & row.keys():
                most = len(space.levels(name, 1)) - 1
                if row[name] not in range(most + 1):
                    got = repr(row[name])
                    yield Issue(f"rows.{k}.{name}", got, f"a whole number from 0 to {most}", "count entries from 0")
