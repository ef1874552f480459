"""Independent random cases."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from tmodes.study.plans.contract import PLANS, Design, Plan, Space, count, seed_field, unit_shares

__all__ = ["MonteCarlo"]


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
