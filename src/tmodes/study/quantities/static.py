"""A number that needs no simulation: sag, natural frequency, mass."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet import Robot
from tmodes.simulation.vary.static_cases import masses_of
from tmodes.simulation.vary.static_numbers import refuse_unknown_numbers
from tmodes.study.quantities.contract import QUANTITIES, Asked, Found, Needs, Quantity, in_any

__all__ = ["Static"]


@QUANTITIES.register
class Static(Quantity):
    """A number of the robot at rest by its ``name``: ``sag``, ``frequency.locked.1``, ``mass``."""

    named: ClassVar[str] = "name"

    type: Literal["static"] = Field(description="kind of quantity")
    name: str = Field(min_length=1, max_length=200, description="sag, sag.z, frequency.locked.1, mass, mass.links")

    def needs(self) -> Needs:
        """One static number."""
        return Needs(static=(self.name,))

    def robot_issues(self, robots: Iterable[Robot]) -> Iterator[Issue]:
        """A number that the robot at rest has not."""

        def issues(robot: Robot) -> Iterator[Issue]:
            try:
                refuse_unknown_numbers([self.name], masses_of(robot))
            except InputError as error:
                yield Issue("name", error.got, error.expected, error.hint)

        yield from in_any(robots, issues)

    def own_unit(self, asked: Asked) -> str:
        """That of the number."""
        return asked.units[self.name]

    def values(self, asked: Asked) -> Found:
        """As it was found for all cases; a robot may have fewer frequencies."""
        values = asked.static[self.name]
        return values, dict.fromkeys(np.flatnonzero(np.isnan(values)).tolist(), f"the robot has no {self.name}")
