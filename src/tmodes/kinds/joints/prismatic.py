"""The prismatic joint: translation along an axis."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.joints.contract import JOINTS, Array, Coordinate, JointKind
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.spatial import Force

__all__ = ["Prismatic"]


@JOINTS.register
class Prismatic(JointKind):
    """One distance [m] along the joint's axis."""

    name = "prismatic"
    summary = "slides along its axis"
    coordinates = (Coordinate(unit="m"),)
    slides = True
    drawing = "box"

    def place(self, q: Any, numbers: Any) -> tuple[v.Matrix, v.Vector]:
        """Translation along the axis."""
        return v.identity(), v.scale(q[0], v.vec(numbers))

    def subspace(self, q: Any, numbers: Any) -> list[Force]:
        """The axis."""
        del q
        return [Force(v.zero(), v.vec(numbers))]

    def commutes(self, axis: Array, rotation: Array, position: Array) -> bool:
        """Always: a translation is the same seen from everywhere."""
        del axis, rotation, position
        return True
