"""Straight lines of the tip through points, with rounded corners."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from tmodes.kinds.paths.blend import lines
from tmodes.kinds.paths.contract import PATHS, Course, Number, Path, Place, Point, numbers, points
from tmodes.kinds.paths.turn import great_circle
from tmodes.kinds.schema.quantity import positive

__all__ = ["Via"]


@PATHS.register
class Via(Path):
    """Lines of the tip through points to the last of them, past the corners in between without a stop."""

    type: Literal["via"] = Field(description="kind of path")
    points: tuple[Point, ...] = points("m", "p", "points in the world")
    blend: float = positive("m", "b", "how far from a corner it leaves the line")
    rpy: tuple[Number, Number, Number] | None = numbers(
        "rad", "rpy", "roll, pitch, yaw of the tip at the end about fixed axes; none: it turns as it likes", 3,
        default=None,
    )  # fmt: skip

    def course(self, start: Place) -> Course:
        """From the start through the points."""
        turn = great_circle(start.rotation, self.rpy)
        return lines([start.point, *self.points], self.blend, turn=turn)
