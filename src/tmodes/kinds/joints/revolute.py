"""The revolute joint: rotation about an axis."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.kinds.joints.contract import JOINTS, Array, JointKind
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.spatial import Force

__all__ = ["Revolute"]


@JOINTS.register
class Revolute(JointKind):
    """One angle [rad] about the joint's axis."""

    name = "revolute"
    summary = "turns about its axis"
    turns = True
    drawing = "cylinder"

    def place(self, q: Any, numbers: Any) -> tuple[v.Matrix, v.Vector]:
        """Rotation about the axis."""
        return v.rodrigues(v.vec(numbers), cos(q[0]), sin(q[0])), v.zero()

    def subspace(self, q: Any, numbers: Any) -> list[Force]:
        """The axis."""
        del q
        return [Force(v.vec(numbers), v.zero())]

    def commutes(self, axis: Array, rotation: Array, position: Array) -> bool:
        """Where the axis meets the offset frame."""
        del rotation
        return not np.any(np.cross(axis, position))
