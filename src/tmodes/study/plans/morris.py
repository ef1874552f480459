"""Cases from which elementary effects are found: one parameter after the other changes by a large step."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.plans.contract import PLANS, Array, Design, Plan, Space, count, seed_field

__all__ = ["Morris"]

_EDGE = 0.005
"""Share of the distribution that is left out at both ends, of which some have no end."""


@PLANS.register
class Morris(Plan):
    """``trajectories`` of one more case than there are parameters: from a random start each parameter steps once.

    The parameters stand on ``levels`` evenly spaced shares of their distributions, from 0.005 to 0.995, and step by
    half of the levels. M. D. Morris, Factorial sampling plans for preliminary computational experiments, Technometrics
    33 (1991).
    """

    analysis: ClassVar[str] = "morris"

    type: Literal["morris"] = Field(description="kind of plan")
    trajectories: int = count("r", "number of trajectories", 1_000_000, least=4, default=64)
    levels: int = count("p", "an even number of levels of each parameter", 100, least=2, default=4)
    seed: int = seed_field()

    def _issues(self) -> Iterator[Issue]:
        if self.levels % 2:
            hint = "only then is each level as likely as any other"
            yield Issue("levels", repr(self.levels), "an even number", hint)

    def cases(self, space: Space) -> int:
        """Trajectories times one more than there are parameters."""
        return self.trajectories * (len(space.names) + 1)

    def design(self, space: Space) -> Design:
        """The trajectories; ``steps`` (trajectories, d): by which share each parameter steps, ``order``: when."""
        dimension = len(space.names)
        drawn = [self._trajectory(k, dimension) for k in range(self.trajectories)]
        shares, order, steps = (np.stack(parts) for parts in zip(*drawn, strict=True))
        info = {"samples": self.trajectories, "order": order.tolist(), "steps": steps.tolist()}
        return Design(space.drawn(shares.reshape(-1, dimension)), info)

    def _trajectory(self, number: int, dimension: int) -> tuple[Array, NDArray[np.int64], Array]:
        """Shares (d + 1, d) of one trajectory, the order (d,) in which the parameters step, and their steps (d,)."""
        random = np.random.default_rng([self.seed, number])
        half = self.levels // 2
        start = random.integers(0, self.levels, dimension)
        steps = np.where(start < half, half, -half)
        order = random.permutation(dimension)
        level = np.tile(start, (dimension + 1, 1))
        for done, which in enumerate(order, start=1):
            level[done:, which] += steps[which]
        unit = (1 - 2 * _EDGE) / (self.levels - 1)
        return _EDGE + unit * level.astype(float), order, unit * steps.astype(float)
