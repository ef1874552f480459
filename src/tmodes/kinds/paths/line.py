"""A straight line of the tip."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from tmodes.kinds.paths.blend import lines
from tmodes.kinds.paths.contract import PATHS, Course, Number, Path, Place, numbers
from tmodes.kinds.paths.turn import great_circle

__all__ = ["Line"]


@PATHS.register
class Line(Path):
    """A straight line of the tip; with ``rpy`` it turns to there on the shortest way, at a rate in proportion."""

    type: Literal["line"] = Field(description="kind of path")
    to: tuple[Number, Number, Number] = numbers("m", "p", "where it ends, in the world", 3)
    rpy: tuple[Number, Number, Number] | None = numbers(
        "rad", "rpy", "roll, pitch, yaw of the tip at the end about fixed axes; none: it turns as it likes", 3,
        default=None,
    )  # fmt: skip

    def course(self, start: Place) -> Course:
        """From the start to ``to``."""
        return lines([start.point, self.to], 0.0, turn=great_circle(start.rotation, self.rpy))
