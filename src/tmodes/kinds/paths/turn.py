"""A turn of the tip where it is, about one axis: on a great circle of orientations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.errors import InputError
from tmodes.frame import rotation_vector
from tmodes.kinds.paths.contract import PATHS, Course, Number, Path, Place, Way, numbers
from tmodes.kinds.schema.frames import rpy_matrix

__all__ = ["Turn", "great_circle"]

Array = NDArray[np.float64]


@PATHS.register
class Turn(Path):
    """The tip stays where it is and turns to ``rpy`` about one axis, the shortest way."""

    type: Literal["turn"] = Field(description="kind of path")
    rpy: tuple[Number, Number, Number] = numbers(
        "rad", "rpy", "roll, pitch, yaw of the tip at the end about fixed axes", 3
    )

    def course(self, start: Place) -> Course:
        """Its length is the angle [rad]."""
        turn = great_circle(start.rotation, self.rpy)
        angle = 0.0 if turn is None else float(np.linalg.norm(turn))
        if not angle > 0:
            raise InputError("path", "a turn by 0 rad", "another orientation than that at the start", "leave it out")
        still = Way(start.point, np.zeros(3), np.zeros(3))
        return Course(angle, lambda way: still, turn=turn)


def great_circle(rotation: Array, rpy: Sequence[float] | None) -> Array | None:
    """The rotation vector (3,) [rad], world axes, from a rotation (3, 3) to one of given angles; None for none."""
    return None if rpy is None else rotation_vector(rpy_matrix(*rpy) @ rotation.T)
