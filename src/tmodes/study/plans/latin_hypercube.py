"""Random cases that are spread evenly along each parameter."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from tmodes.study.plans.contract import PLANS, Design, Plan, Space, count, seed_field

__all__ = ["LatinHypercube"]


@PLANS.register
class LatinHypercube(Plan):
    """``runs`` cases of which each parameter has one in each of ``runs`` shares of its distribution.

    McKay, Beckman, Conover, Technometrics 21, 1979. Not nested: a longer plan has other cases, none of which are those
    of a shorter one; take ``sobol`` or ``monte_carlo`` for a study that is extended.
    """

    draws: ClassVar[bool] = True

    type: Literal["latin_hypercube"] = Field(description="kind of plan")
    runs: int = count("N", "number of cases")
    seed: int = seed_field()

    def cases(self, space: Space) -> int:  # noqa: ARG002
        """As many as are asked for."""
        return self.runs

    def design(self, space: Space) -> Design:
        """One random point in each share, the shares of each parameter in random order."""
        from scipy.stats.qmc import LatinHypercube as Sampler

        return Design(space.drawn(Sampler(len(space.names), rng=self.seed).random(self.runs)))
