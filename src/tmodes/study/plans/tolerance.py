"""Tolerance stack-up: each parameter at its ends by itself, and all of them together."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.plans.contract import PLANS, Design, Plan, Space

__all__ = ["Tolerance"]

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
