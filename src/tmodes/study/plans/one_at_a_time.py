"""Each parameter by itself, all others as in the sheet."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.study.plans.contract import PLANS, Design, Plan, Space, count

__all__ = ["OneAtATime"]


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
