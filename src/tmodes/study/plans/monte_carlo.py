"""Independent random cases."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.study.plans.contract import MOST_CASES, PLANS, Design, Plan, Space

__all__ = ["MonteCarlo"]


@PLANS.register
class MonteCarlo(Plan):
    """``runs`` cases by the distributions of the parameters."""

    type: Literal["monte_carlo"] = Field(description="kind of plan")
    runs: int = Field(ge=1, le=MOST_CASES, description="number of cases")
    seed: int = Field(default=0, ge=0, le=2**63 - 1, description="same seed, same cases")

    def cases(self, dimension: int) -> int:
        """As many as are asked for."""
        return self.runs

    def design(self, space: Space) -> Design:
        """The first of a longer plan are those of a shorter one; a parameter that is added changes no other."""
        streams = [np.random.Generator(np.random.PCG64([self.seed, *name.encode()])) for name in space.names]
        return Design(space.drawn(np.column_stack([stream.random(self.runs) for stream in streams])))
