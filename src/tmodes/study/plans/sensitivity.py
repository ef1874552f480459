"""Plans of sensitivity analyses: Morris trajectories, and Saltelli's cases for Sobol' indices."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.plans.contract import PLANS, Array, Design, Plan, Space, count, seed_field

__all__ = ["REPLICATES", "Morris", "Saltelli"]

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


REPLICATES = 16
"""Independent randomizations of the sequence: from how much they differ the confidence intervals follow."""


@PLANS.register
class Saltelli(Plan):
    """``samples`` pairs of points A and B, and each A with one parameter after the other taken from B.

    The points are of Sobol' sequences in twice as many dimensions, randomized 16 times (A. B. Owen's scrambling). Of
    each sample come A, then A with each parameter of B, with ``second_order`` B with each parameter of A, then B: A.
    Saltelli, Making best use of model evaluations to compute sensitivity indices, Comput. Phys. Commun. 145 (2002).
    """

    draws: ClassVar[bool] = True
    repeats: ClassVar[bool] = True
    analysis: ClassVar[str] = "sobol"

    type: Literal["saltelli"] = Field(description="kind of plan")
    samples: int = count("N", "a power of two", 2**22, least=4 * REPLICATES, default=1024)
    seed: int = seed_field()
    second_order: bool = Field(default=False, description="true: also for indices of pairs of parameters")

    def _issues(self) -> Iterator[Issue]:
        if self.samples & (self.samples - 1):
            near = 2 ** round(np.log2(self.samples))
            hint = f"take {near}: only then are the points of a Sobol' sequence balanced"
            yield Issue("samples", repr(self.samples), "a power of two", hint)

    def cases(self, space: Space) -> int:
        """Samples times the parameters and 2; with indices of pairs, twice the parameters and 2."""
        return self.samples * ((1 + self.second_order) * len(space.names) + 2)

    def design(self, space: Space) -> Design:
        """Cases of a plan of fewer samples are the first of a longer one."""
        dimension = len(space.names)
        base = self._base(dimension)
        cases = _mixed(base[:, :dimension], base[:, dimension:], second_order=self.second_order)
        info = {"samples": self.samples, "second_order": self.second_order, "replicates": REPLICATES}
        return Design(space.drawn(cases.reshape(-1, dimension)), info)

    def _base(self, dimension: int) -> Array:
        """Points A and B of all samples, (samples, 2 d), the randomizations by turns; within ]0, 1[."""
        from scipy.stats import qmc

        points = self.samples // REPLICATES
        streams = [np.random.default_rng([self.seed, k]) for k in range(REPLICATES)]
        parts = [qmc.Sobol(2 * dimension, scramble=True, rng=stream).random(points) for stream in streams]
        return np.clip(np.stack(parts, axis=1).reshape(self.samples, -1), 1e-12, 1 - 1e-12)


def _mixed(a: Array, b: Array, *, second_order: bool) -> Array:
    """All cases of each sample, (samples, cases, d)."""
    dimension = a.shape[1]

    def swapped(of: Array, other: Array) -> list[Array]:
        own = np.eye(dimension, dtype=bool)
        return [np.where(own[i], other, of) for i in range(dimension)]

    return np.stack([a, *swapped(a, b), *(swapped(b, a) if second_order else ()), b], axis=1)
