"""How named points move in the world: what the model gives, by name."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["PointMotion"]

Array = NDArray[np.float64]

_POINT = 24
"""Numbers reported of a point: pose (15), rate (3), acceleration (6)."""


class PointMotion(NamedTuple):
    """Motion of the named points in world axes: (n, points, 3), rotation (n, points, 3, 3) [SI]."""

    position: Array
    rotation: Array
    velocity: Array
    rate: Array
    acceleration: Array
    angular_acceleration: Array

    @classmethod
    def of(cls, info: Array) -> PointMotion:
        """From rows of the output ``points`` of the inertia pass."""
        rows = info.reshape(len(info), -1, _POINT)
        rotation = rows[..., :9].reshape(*rows.shape[:2], 3, 3)
        parts = (rows[..., k : k + 3] for k in (12, 15, 18, 21))
        return cls(rows[..., 9:12], rotation, *parts)
