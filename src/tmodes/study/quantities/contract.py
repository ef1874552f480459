"""What a quantity of interest is: what it needs of a case, and its value from that.

A quantity of a user's own is a class with the field ``type``::

    @QUANTITIES.register
    class Ratio(Quantity):
        type: Literal["ratio"] = Field(description="kind of quantity")
        over: str = Field(description="name of a quantity")
        under: str = Field(description="name of a quantity")

        def needs(self) -> Needs:
            return Needs(names=(self.over, self.under))

        def values(self, asked: Asked) -> Found:
            return asked.values[self.over] / asked.values[self.under], {}
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.errors import TmodesError
from tmodes.io.words import meant
from tmodes.kinds.schema.kind import Kind
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet import Robot

__all__ = ["MOST", "QUANTITIES", "Array", "Asked", "Found", "Needs", "Quantity", "in_any"]

Array = NDArray[np.float64]

Found = tuple[Array, Mapping[int, str]]
"""Values (m,), and why a case has none, by its index, where there is a reason of its own."""


@dataclass(frozen=True)
class Needs:
    """What a quantity needs of each case; the union of all says by which way the cases are computed.

    ``reductions``: pairs of a series and how it is reduced, folded in the native loop. ``static``: names of numbers
    that need no simulation. ``result``: the whole result of a run (slow), of which :meth:`Quantity.of_result` is asked;
    ``errors``: with the estimated errors of integration and model. ``names``: parameters and other quantities.
    """

    reductions: tuple[tuple[str, str], ...] = ()
    static: tuple[str, ...] = ()
    result: bool = False
    errors: frozenset[str] = frozenset()
    names: tuple[str, ...] = ()

    def __or__(self, other: Needs) -> Needs:
        """What both need, each once."""
        return Needs(
            tuple(dict.fromkeys((*self.reductions, *other.reductions))),
            tuple(dict.fromkeys((*self.static, *other.static))),
            self.result or other.result,
            self.errors | other.errors,
            tuple(dict.fromkeys((*self.names, *other.names))),
        )


@dataclass(frozen=True, eq=False)
class Asked:
    """What m cases gave: arrays (m,), not-a-number where a case has none.

    ``values``: parameters and the quantities that this one needs, by name, in the units in which they are given;
    ``reductions`` by series and reduction and ``static`` by name, with ``units`` of both; ``own``: what
    :meth:`Quantity.of_result` gave of each case, with the unit and why it gave none.
    """

    values: Mapping[str, Array] = field(default_factory=dict)
    reductions: Mapping[tuple[str, str], Array] = field(default_factory=dict)
    static: Mapping[str, Array] = field(default_factory=dict)
    units: Mapping[Any, str] = field(default_factory=dict)
    own: Array | None = None
    own_unit: str = "-"
    own_reasons: Mapping[int, str] = field(default_factory=dict)


def in_any(robots: Iterable[Robot], issues: Callable[[Robot], Iterator[Issue]]) -> Iterator[Issue]:
    """What is wrong with a name that none of the robots has: that of the first; a robot that cannot run is left out."""
    first: list[Issue] = []
    for robot in robots:
        try:
            found = list(issues(robot))
        except TmodesError:  # which is said, with the case, where it is run
            continue
        if not found:
            return
        first = first or found
    yield from first


MOST = 1e150
"""Largest magnitude of a number that a formula or a function gives: the squares of more overflow."""


class Quantity(Kind, family="quantity of interest", key="type"):
    """A number of each case."""

    named: ClassVar[str] = ""
    """The field for which the key of the kind stands, where ``type`` is left out: ``{static: sag}``."""

    unit: str | None = Field(
        default=None, min_length=1, max_length=40, description="unit in which it is given; else that of SI"
    )
    title: str = Field(default="", max_length=200, description="what it is, for tables and figures")

    def needs(self) -> Needs:
        """What it needs of each case."""
        raise NotImplementedError

    def own_unit(self, asked: Asked) -> str:  # noqa: ARG002
        """Its unit before it is converted to ``unit``; by default it has the one that is written."""
        return self.unit or "-"

    def values(self, asked: Asked) -> Found:
        """Its values (m,) in its own unit, and why a case has none, by its index, where it has a reason of its own."""
        raise NotImplementedError

    def function(self) -> str:
        """Name of the Python function that is called with each result; empty: none."""
        return ""

    def of_result(self, result: Any, function: Callable[[Any], float] | None = None) -> tuple[float, str, str]:
        """Of a kind that needs the ``result``: the number that one gives, its unit, and why there is none, if so.

        ``function``: what stands for the name that :meth:`function` gives.
        """
        raise NotImplementedError

    def name_issues(self, names: Sequence[str]) -> Iterator[Issue]:
        """What is wrong with the names that it needs; ``names`` of all parameters and quantities."""
        for name in self.needs().names:
            if name not in names:
                hint = meant(name, names, "write the name of a parameter or of a quantity")
                yield Issue("", f"the unknown name {name!r}", f"one of {', '.join(names[:12])}", hint)

    def robot_issues(self, robots: Iterable[Robot]) -> Iterator[Issue]:  # noqa: ARG002
        """What is wrong with the names of the robot that it needs: none of the ``robots`` of the study has them."""
        yield from ()

    def digest(self, others: Mapping[str, str]) -> str:
        """Digest of all that its values follow from; ``others``: digests of what it needs, by name."""
        own = self.model_dump(mode="json", exclude={"title"})
        needed = {name: others.get(name, "") for name in self.needs().names}
        text = json.dumps([self.fingerprint(), own, needed], sort_keys=True)
        return hashlib.sha256(text.encode()).hexdigest()


QUANTITIES = Quantity.registry
"""Those of tmodes, and what a user registers: ``@QUANTITIES.register``."""
