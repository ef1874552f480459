"""Cases of Sobol's sequence, which fills all parameters evenly."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from tmodes.study.plans.contract import PLANS, Design, Plan, Space, count, seed_field

__all__ = ["Sobol"]


@PLANS.register
class Sobol(Plan):
    """The first ``runs`` points of Sobol's sequence, scrambled by ``seed``; a longer plan extends a shorter one.

    Sobol', USSR Computational Mathematics 7, 1967; scrambled after Owen, Journal of Complexity 14, 1998. It is balanced
    where ``runs`` is a power of two.
    """

    draws: ClassVar[bool] = True

    type: Literal["sobol"] = Field(description="kind of plan")
    runs: int = count("N", "number of cases, best a power of two")
    seed: int = seed_field()

    def cases(self, space: Space) -> int:  # noqa: ARG002
        """As many as are asked for."""
        return self.runs

    def design(self, space: Space) -> Design:
        """The points at the shares of each distribution, correlated as asked."""
        from scipy.stats.qmc import Sobol as Sequence

        power = (self.runs - 1).bit_length()
        shares = Sequence(len(space.names), rng=self.seed).random_base2(power)[: self.runs]
        near = (1 << power) >> 1, 1 << power
        notice = (
            f"{self.runs} runs are no power of two, for which Sobol's sequence is balanced: take {near[0]} or {near[1]}"
        )
        return Design(space.drawn(shares), notices=(notice,) if self.runs != 1 << power else ())
