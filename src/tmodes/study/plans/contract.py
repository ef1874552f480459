"""What a plan is: from the parameters of a study to its cases.

A plan of a user's own is a class with the field ``type`` and one method::

    @PLANS.register
    class Corners(Plan):
        type: Literal["corners"] = Field(description="kind of plan")

        def design(self, space: Space) -> Design:
            shares = np.array([*itertools.product((0.0, 1.0), repeat=len(space.names))])
            return Design(space.between(shares))
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.schema.kind import Kind

__all__ = ["MOST_CASES", "PLANS", "Array", "Design", "Plan", "Space"]

Array = NDArray[np.float64]

MOST_CASES = 20_000_000
"""Cases of one study: their table has some 2 GB."""


class Space(Protocol):
    """The parameters of a study, as plans see them."""

    @property
    def names(self) -> Sequence[str]:
        """Their names, in order."""
        ...

    @property
    def nominal(self) -> Array:
        """Their values in the robot's own sheet, (d,); of one without a path its median."""
        ...

    def drawn(self, shares: Array) -> Array:
        """Values (k, d) of independent uniform ``shares`` (k, d): by each distribution, and correlated as asked."""
        ...

    def between(self, shares: Array) -> Array:
        """Values (k, d) at shares (k, d) of the way from the least to the largest value of each; no correlation."""
        ...

    def levels(self, name: str, points: int) -> Array:
        """Evenly spaced values of a parameter, its ends included; of one that is chosen from a list, all of them."""
        ...


@dataclass(frozen=True, eq=False)
class Design:
    """The cases of a study: ``values`` (k, d) of the parameters. ``info``: what an analysis has to know of them.

    ``labels``: how a case came about (``nominal``, ``gear low``), by its index, for tables and figures.
    """

    values: Array
    info: Mapping[str, Any] = field(default_factory=dict)
    labels: Mapping[int, str] = field(default_factory=dict)


class Plan(Kind, family="plan", key="type"):
    """Which cases a study runs."""

    def cases(self, dimension: int) -> int:
        """How many cases it has of so many parameters: asked before anything is made."""
        raise NotImplementedError

    def design(self, space: Space) -> Design:
        """The cases. Of a random plan the first of a longer one are those of a shorter one: a study is extended."""
        raise NotImplementedError


PLANS = Plan.registry
"""Those of tmodes, and what a user registers: ``@PLANS.register``."""
