"""An arc of a circle of the tip."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.paths.contract import PATHS, Course, Number, Path, Place, Way, numbers
from tmodes.kinds.paths.turn import great_circle

__all__ = ["Arc"]


@PATHS.register
class Arc(Path):
    """The arc of a circle from the start through one point to another."""

    type: Literal["arc"] = Field(description="kind of path")
    through: tuple[Number, Number, Number] = numbers("m", "p", "a point on the way, in the world", 3)
    to: tuple[Number, Number, Number] = numbers("m", "p", "where it ends, in the world", 3)
    rpy: tuple[Number, Number, Number] | None = numbers(
        "rad", "rpy", "roll, pitch, yaw of the tip at the end about fixed axes; none: it turns as it likes", 3,
        default=None,
    )  # fmt: skip

    def course(self, start: Place) -> Course:
        """Raises :class:`tmodes.errors.InputError` for three points on a line."""
        a, b, c = start.point, np.array(self.through), np.array(self.to)
        ab, ac = b - a, c - a
        normal = np.cross(ab, ac)
        size = np.linalg.norm(normal)
        if not size > 1e-9 * np.linalg.norm(ab) * np.linalg.norm(ac):
            hint = "move `through` off the line, or take the path `line`"
            raise InputError("path.through", "three points on a line", "three points of a circle", hint)
        centre = a + np.cross(normal, np.dot(ac, ac) * ab - np.dot(ab, ab) * ac) / (2 * size**2)
        x = a - centre
        radius = float(np.linalg.norm(x))
        x = x / radius
        y = np.cross(normal / size, x)
        angle = float(np.arctan2(np.dot(c - centre, y), np.dot(c - centre, x))) % (2 * np.pi)

        def at(way: float) -> Way:
            cos, sin = np.cos(way / radius), np.sin(way / radius)
            out = cos * x + sin * y
            return Way(centre + radius * out, cos * y - sin * x, -out / radius)

        return Course(radius * angle, at, turn=great_circle(start.rotation, self.rpy))
