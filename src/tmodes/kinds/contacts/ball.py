"""A sphere that a point presses from outside (a ball) or from inside (a bowl)."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.contacts.contract import SURFACES, Meeting, Surface
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.schema.frames import Vector, list_of_numbers
from tmodes.kinds.schema.quantity import positive

__all__ = ["Ball"]


@SURFACES.register
class Ball(Surface):
    """A sphere; the robot is outside of it, or inside."""

    type: Literal["ball"] = Field(description="kind of surface")
    center: Vector = list_of_numbers("m", "C", "its center, in the world")
    radius: float = positive("m", "r", "its radius", plausible=(1e-4, 50.0))
    inside: bool = Field(default=False, description="true: the robot is inside and presses outwards")

    @property
    def shape(self) -> str:
        """A ball and a bowl push in opposite directions."""
        return "bowl" if self.inside else "ball"

    def numbers(self) -> tuple[float, float, float, float]:
        """Center and radius."""
        x, y, z = self.center
        return x, y, z, self.radius

    def meet(self, p: Any, place: v.Vector, velocity: v.Vector) -> Meeting:
        """Penetration along the radius; see :meth:`Surface.meet`."""
        side = 1.0 if self.inside else -1.0
        arm = v.sub(place, v.vec(p))
        distance = f.sqrt(v.dot(arm, arm))
        direction = v.scale(side / distance, arm)
        rate = v.dot(direction, velocity)
        curving = side * (v.dot(velocity, velocity) - rate * rate) / distance
        return Meeting(direction, side * (distance - p[3]), rate, curving)

    def drawing(self) -> dict[str, Any]:
        """A ball."""
        return {"kind": "ball", "center": list(self.center), "radius": self.radius, "inside": self.inside}
