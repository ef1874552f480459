"""The universal joint (Cardan, Hooke): two crossing axes at right angles."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.joints.contract import JOINTS, Coordinate, JointKind
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.spatial import Force

__all__ = ["Universal"]


@JOINTS.register
class Universal(JointKind):
    """An angle ``x`` [rad] about x of the joint frame, then an angle ``y`` [rad] about the turned y axis."""

    name = "universal"
    summary = "turns about x and y of its frame"
    coordinates = (Coordinate("x"), Coordinate("y"))
    has_axis = False

    def place(self, q: Any, numbers: Any) -> tuple[v.Matrix, v.Vector]:
        """Rx(x) Ry(y)."""
        del numbers
        return v.matmul(v.about(0, cos(q[0]), sin(q[0])), v.about(1, cos(q[1]), sin(q[1]))), v.zero()

    def subspace(self, q: Any, numbers: Any) -> list[Force]:
        """The first axis, seen from the link, turns with the second angle."""
        del numbers
        return [Force([cos(q[1]), 0.0, sin(q[1])], v.zero()), Force(v.unit(1), v.zero())]

    def bias(self, q: Any, rates: Any, numbers: Any) -> Force:
        """Rate of change of the first column times its rate."""
        del numbers
        both = rates[0] * rates[1]
        return Force([-(sin(q[1]) * both), 0.0, cos(q[1]) * both], v.zero())
