"""Straight lines of the joints through points, with rounded corners."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.paths.blend import lines
from tmodes.kinds.paths.contract import PATHS, Course, Path, Place, Values, points
from tmodes.kinds.schema.quantity import Issue, positive

__all__ = ["Joints"]


@PATHS.register
class Joints(Path):
    """Lines in the space of the joints, in the order of the drives, past the corners without a stop."""

    type: Literal["joints"] = Field(description="kind of path")
    points: tuple[Values, ...] = points("rad", "q", "values of all driven joints at each point")
    blend: float = positive("rad", "b", "how far from a corner it leaves the line", default=0.1)

    def _issues(self) -> Iterator[Issue]:
        if len({len(point) for point in self.points}) > 1:
            yield Issue("points", "points of different lengths", "one value for each drive", "complete them")

    def course(self, start: Place) -> Course:
        """Its length is that in the space of the joints [rad, m]."""
        if len(self.points[0]) != len(start.joints):
            got, expected = f"points of {len(self.points[0])} values", f"{len(start.joints)} values, one for each drive"
            raise InputError("path.points", got, expected, "give the values in the order of the drives")
        return lines([start.joints, *self.points], self.blend, of_joints=True)
