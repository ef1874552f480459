"""Cases from which Sobol' indices are estimated."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.study.plans.contract import PLANS, Array, Design, Plan, Space, count, seed_field

__all__ = ["REPLICATES", "Saltelli"]

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
