"""A series of the run, reduced to one number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet import Robot
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.reductions import Reduction, refuse_unknown_rules
from tmodes.study.quantities.contract import QUANTITIES, Asked, Found, Needs, Quantity, in_any

__all__ = ["SeriesQuantity"]


@QUANTITIES.register
class SeriesQuantity(Quantity):
    """A ``series`` such as ``deviation``, ``tip.z`` or ``joint.effort``, reduced by ``reduce``."""

    named: ClassVar[str] = "series"

    type: Literal["series"] = Field(description="kind of quantity")
    series: str = Field(min_length=1, max_length=200, description="name of a series, as stop conditions know it")
    reduce: str = Field(
        min_length=1,
        max_length=20,
        description="max, min, max_abs, mean, rms, end, range, time_of_max, percentile:P, settling:B",
    )

    def needs(self) -> Needs:
        """One reduction."""
        return Needs(reductions=((self.series, self.reduce),))

    def name_issues(self, names: Sequence[str]) -> Iterator[Issue]:  # noqa: ARG002
        """A rule that is none; the series themselves depend on the robot."""
        try:
            refuse_unknown_rules([Reduction(self.series, self.reduce)])
        except InputError as error:
            yield Issue("reduce", error.got, error.expected, error.hint)

    def robot_issues(self, robots: Iterable[Robot]) -> Iterator[Issue]:
        """A series that a run of the robot has not."""

        def issues(robot: Robot) -> Iterator[Issue]:
            try:
                robot_outputs(robot).find(self.series, "series")
            except InputError as error:
                yield Issue("series", error.got, error.expected, error.hint)

        yield from in_any(robots, issues)

    def own_unit(self, asked: Asked) -> str:
        """That of the series; of a time s."""
        return asked.units[self.series, self.reduce]

    def values(self, asked: Asked) -> Found:
        """As the loop has folded it; a robot without drives has no commanded path, and so no error against it."""
        values = asked.reductions[self.series, self.reduce]
        return values, dict.fromkeys(np.flatnonzero(np.isnan(values)).tolist(), f"the run has no {self.series}")
