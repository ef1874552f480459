"""What a quantity of interest is: what it needs of a case, and its value from that."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.kinds.schema.kind import Kind

__all__ = ["QUANTITIES", "Array", "Asked", "Needs", "Quantity"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Needs:
    """What a quantity needs of each case; the union of all says by which way the cases are computed.

    ``reductions``: pairs of a series and how it is reduced, folded in the native loop. ``static``: names of numbers
    that need no simulation. ``result``: the whole result of a run (slow). ``names``: parameters and other quantities.
    """

    reductions: tuple[tuple[str, str], ...] = ()
    static: tuple[str, ...] = ()
    result: bool = False
    names: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Asked:
    """What m cases gave: arrays (m,), not-a-number where a case has none.

    ``values``: parameters and the quantities before this one, by name; ``reductions`` by series and reduction;
    ``static`` by name; ``results``: a :class:`tmodes.Result` of each case, or None.
    """

    values: Mapping[str, Array]
    reductions: Mapping[tuple[str, str], Array] = field(default_factory=dict)
    static: Mapping[str, Array] = field(default_factory=dict)
    results: tuple[Any, ...] = ()
    units: Mapping[Any, str] = field(default_factory=dict)


class Quantity(Kind, family="quantity of interest", key="type"):
    """A number of each case."""

    unit: str | None = Field(default=None, max_length=40, description="unit in which it is given; else that of SI")
    title: str = Field(default="", max_length=200, description="what it is, for tables and figures")

    def needs(self) -> Needs:
        """What it needs of each case."""
        raise NotImplementedError

    def own_unit(self, units: Mapping[Any, str]) -> str:
        """Its unit before it is converted to ``unit``; ``units`` of what it needs."""
        raise NotImplementedError

    def values(self, asked: Asked) -> tuple[Array, Mapping[int, str]]:
        """Its values (m,) in its own unit, and why a case has none, by its index, where there is a reason of its own."""
        raise NotImplementedError


QUANTITIES = Quantity.registry
"""Those of tmodes, and what a user registers: ``@QUANTITIES.register``."""
