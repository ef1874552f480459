"""Plans that sample: Monte Carlo, uniform random, Latin hypercube, Sobol' sequence."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from tmodes.study.plans.contract import PLANS, Design, Plan, Space, count, seed_field, unit_shares

__all__ = ["LatinHypercube", "MonteCarlo", "Random", "Sobol"]


@PLANS.register
class MonteCarlo(Plan):
    """``runs`` cases by the distributions of the parameters, correlated as asked; a longer plan extends a shorter."""

    draws: ClassVar[bool] = True

    type: Literal["monte_carlo"] = Field(description="kind of plan")
    runs: int = count("N", "number of cases")
    seed: int = seed_field()

    def cases(self, space: Space) -> int:  # noqa: ARG002
        """As many as are asked for."""
        return self.runs

    def design(self, space: Space) -> Design:
        """The first of a longer plan are those of a shorter one; a parameter that is added changes no other."""
        return Design(space.drawn(unit_shares(space.names, self.runs, self.seed)))


@PLANS.register
class Random(Plan):
    """``runs`` cases, uniform between the ends of each parameter whatever its distribution; to look at responses.

    Correlations are left out. A longer plan extends a shorter one.
    """

    type: Literal["random"] = Field(description="kind of plan")
    runs: int = count("N", "number of cases")
    seed: int = seed_field()

    def cases(self, space: Space) -> int:  # noqa: ARG002
        """As many as are asked for."""
        return self.runs

    def design(self, space: Space) -> Design:
        """The first of a longer plan are those of a shorter one; a parameter that is added changes no other."""
        return Design(space.between(unit_shares(space.names, self.runs, self.seed)))


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
