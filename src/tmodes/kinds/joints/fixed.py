"""The fixed joint, which does not move."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.joints.contract import JOINTS, Array, JointKind
from tmodes.kinds.kernel import vectors as v

__all__ = ["Fixed"]


@JOINTS.register
class Fixed(JointKind):
    """No coordinate."""

    name = "fixed"
    summary = "does not move"
    coordinates = ()
    has_axis = False
    drawing = "none"

    def place(self, q: Any, numbers: Any) -> tuple[v.Matrix, v.Vector]:
        """Nothing changes."""
        del q, numbers
        return v.identity(), v.zero()

    def commutes(self, axis: Array, rotation: Array, position: Array) -> bool:
        """Always."""
        del axis, rotation, position
        return True
