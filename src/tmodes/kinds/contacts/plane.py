"""Plane surfaces: any plane, and a vertical wall in front of the base."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.contacts.contract import SURFACES, Meeting, Surface
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.noted.functions import cos, hypot, sin
from tmodes.kinds.schema.frames import Vector, list_of_numbers
from tmodes.kinds.schema.quantity import Issue, any_sign, positive

__all__ = ["Plane", "Wall"]


class _Flat(Surface):
    """Numbers: unit vector into it, and its distance from the origin along that."""

    @property
    def shape(self) -> str:
        """A wall is a plane."""
        return "plane"

    def meet(self, p: Any, place: v.Vector, velocity: v.Vector) -> Meeting:
        """Penetration of a plane; see :meth:`Surface.meet`."""
        direction = v.vec(p)
        return Meeting(direction, v.dot(direction, place) - p[3], v.dot(direction, velocity), 0.0)


@SURFACES.register
class Plane(_Flat):
    """A plane through a point; it pushes along its normal."""

    type: Literal["plane"] = Field(description="kind of surface")
    position: Vector = list_of_numbers("m", "p", "a point of the plane, in the world")
    normal: Vector = list_of_numbers("-", "n", "its normal, towards the side where the robot is")

    def _issues(self) -> Iterator[Issue]:
        if not any(self.normal):
            yield Issue("normal", "a normal of zeros", "a direction", "write [0, 0, 1] for a floor")

    def numbers(self) -> tuple[float, float, float, float]:
        """Direction into the plane, and its distance from the origin."""
        size = hypot(*self.normal)
        x, y, z = (-part / size for part in self.normal)
        return x, y, z, v.dot([x, y, z], list(self.position))

    def drawing(self) -> dict[str, Any]:
        """A plane."""
        return {"kind": "plane", "position": list(self.position), "normal": list(self.normal)}

    @property
    def steep_axis(self) -> int:
        """The axis along which its normal is longest."""
        return max(range(3), key=lambda k: abs(self.normal[k]))


@SURFACES.register
class Wall(_Flat):
    """A vertical wall in front of the base."""

    type: Literal["wall"] = Field(description="kind of surface")
    distance: float = positive("m", "d", "distance from the world's z axis", plausible=(1e-3, 50.0))
    heading: float = any_sign("rad", "psi", "direction of the wall about z, 0: along x", default=0.0)

    def numbers(self) -> tuple[float, float, float, float]:
        """Direction into the wall, and its distance."""
        return cos(self.heading), sin(self.heading), 0.0, self.distance

    def drawing(self) -> dict[str, Any]:
        """A plane."""
        x, y, z, distance = self.numbers()
        return {"kind": "plane", "position": [distance * x, distance * y, distance * z], "normal": [-x, -y, -z]}
