"""What a plan is: from the parameters of a study to its cases.

A plan of a user's own is a class with the field ``type`` and one method::

    @PLANS.register
    class Corners(Plan):
        type: Literal["corners"] = Field(description="kind of plan")

        def cases(self, space: Space) -> int:
            return 2 ** len(space.names)

        def design(self, space: Space) -> Design:
            shares = np.array([*itertools.product((0.0, 1.0), repeat=len(space.names))])
            return Design(space.between(shares))
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from tmodes.io.words import meant
from tmodes.kinds.schema.kind import Kind
from tmodes.kinds.schema.quantity import Issue, quantity

__all__ = [
    "MOST_CASES",
    "PLANS",
    "Array",
    "Design",
    "Plan",
    "Space",
    "count",
    "seed_field",
    "unit_shares",
    "unknown_names",
]

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
    def chosen(self) -> frozenset[str]:
        """Names of those that are chosen from a list; their values are the numbers of the entries, from 0."""
        ...

    @property
    def nominal(self) -> Array:
        """Their values in the robot's own sheet, (d,); of one without a path its median, of a choice the first."""
        ...

    def drawn(self, shares: Array) -> Array:
        """Values (k, d) of independent uniform ``shares`` (k, d): by each distribution, and correlated as asked."""
        ...

    def between(self, shares: Array) -> Array:
        """Values (k, d) at shares (k, d) of the way from the least to the largest value of each; no correlation."""
        ...

    def levels(self, name: str, points: int) -> Array:
        """Evenly spaced values of a parameter, its ends included; of one with a list of values, all of them."""
        ...


@dataclass(frozen=True, eq=False)
class Design:
    """The cases of a study: ``values`` (k, d) of the parameters. ``info``: what an analysis has to know, plain data.

    ``labels``: how a case came about (``nominal``, ``gear low``), by its index, for tables and figures. ``notices``:
    what a person should know of this plan, in sentences.
    """

    values: Array
    info: Mapping[str, Any] = field(default_factory=dict)
    labels: Mapping[int, str] = field(default_factory=dict)
    notices: tuple[str, ...] = ()


class Plan(Kind, family="plan", key="type"):
    """Which cases a study runs."""

    draws: ClassVar[bool] = False
    """Whether its cases come as often as the distributions say, so that their percentiles are those of the robots."""

    analysis: ClassVar[str] = ""
    """The sensitivity that follows from its cases, if any: ``sobol`` or ``morris``."""

    repeats: ClassVar[bool] = False
    """Whether its cases share values, so that they are less certain of a percentile than as many independent ones."""

    def cases(self, space: Space) -> int:
        """How many cases it has: asked before anything is made, so that a plan that is too large allocates nothing."""
        raise NotImplementedError

    def design(self, space: Space) -> Design:
        """The cases, the same each time. Where the plan says so the first of a longer one are those of a shorter."""
        raise NotImplementedError

    def issues(self, space: Space) -> Iterator[Issue]:  # noqa: ARG002
        """What is wrong with the plan for these parameters, by its own fields; nothing for most."""
        yield from ()


def count(symbol: str, meaning: str, most: int = MOST_CASES, *, least: int = 1, **more: Any) -> Any:
    """A field that is a whole number from ``least`` to ``most``."""
    return quantity("-", symbol, meaning, at_least=least, at_most=most, smallest=least, span=True, **more)


def seed_field() -> Any:
    """The field of a random plan from which the same cases follow each time."""
    return count("seed", "same seed, same cases", 2**53 - 1, least=0, default=0)


def unit_shares(names: Sequence[str], runs: int, seed: int) -> Array:
    """Uniform shares (runs, d), each parameter by a stream of its own.

    The first of more runs are those of fewer, and a parameter that is added changes no other.
    """
    streams = [np.random.Generator(np.random.PCG64([seed, *name.encode()])) for name in names]
    return np.column_stack([stream.random(runs) for stream in streams])


PLANS = Plan.registry
"""Those of tmodes, and what a user registers: ``@PLANS.register``."""


def unknown_names(field: str, names: Iterable[str], space: Space) -> Iterator[Issue]:
    """An issue for each name that no parameter has, at its key in a field."""
    for name in names:
        if name not in space.names:
            hint = meant(name, space.names, "write the name of a parameter")
            yield Issue(f"{field}.{name}", "an unknown key", f"one of {', '.join(space.names)}", hint)
