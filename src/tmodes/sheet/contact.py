"""What a point of an arm touches: a surface on a spring and damper."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from tmodes.kinds.schema.frames import Vector, list_of_numbers
from tmodes.kinds.schema.quantity import DataSheet, Issue, any_sign, dissipation, not_negative, positive, refuse

__all__ = ["Ball", "ContactLaw", "ContactSheet", "Plane", "Shape", "Wall"]


class ContactLaw(StrEnum):
    """``bilateral``: the point is held to the surface; ``unilateral``: the surface only pushes."""

    BILATERAL = "bilateral"
    UNILATERAL = "unilateral"


class Plane(DataSheet):
    """A plane through a point; it pushes along its normal."""

    type: Literal["plane"] = Field(description="kind of surface")
    position: Vector = list_of_numbers("m", "p", "a point of the plane, in the world")
    normal: Vector = list_of_numbers("-", "n", "its normal, towards the side where the arm is")

    @model_validator(mode="after")
    def _has_a_normal(self) -> Self:
        if not any(self.normal):
            refuse([Issue("normal", "a normal of zeros", "a direction", "write [0, 0, 1] for a floor")])
        return self


class Ball(DataSheet):
    """A sphere; the arm is outside of it, or inside."""

    type: Literal["ball"] = Field(description="kind of surface")
    center: Vector = list_of_numbers("m", "C", "its center, in the world")
    radius: float = positive("m", "r", "its radius", plausible=(1e-4, 50.0))
    inside: bool = Field(default=False, description="true: the arm is inside and presses outwards")


class Wall(DataSheet):
    """A vertical wall in front of the base."""

    type: Literal["wall"] = Field(description="kind of surface")
    distance: float = positive("m", "d", "distance from the world's z axis", plausible=(1e-3, 50.0))
    heading: float = any_sign("rad", "psi", "direction of the wall about z, 0: along x", default=0.0)


Shape = Annotated[Plane | Ball | Wall, Field(discriminator="type")]


class ContactSheet(DataSheet):
    """Contact of one point with one surface."""

    point: str = Field(default="tip", min_length=1, max_length=100, description="which point touches")
    shape: Shape
    law: ContactLaw = Field(strict=False, description="bilateral or unilateral")
    stiffness: float = positive("N/m", "ka", "stiffness along the normal", plausible=(1.0, 1e9))
    damping: float = dissipation("N*s/m", "be", "damping along the normal")
    preload: float = any_sign("N", "Fc_o", "force at zero penetration", default=0.0)
    mass: float = not_negative("kg", "me", "mass of the surface that moves with the point", default=0.0)
    friction: float = not_negative("-", "mu", "friction coefficient", default=0.0, at_most=10.0)
    friction_velocity: float | None = positive(
        "m/s", "veps", "speed below which friction is smoothed", default=None, plausible=(1e-6, 0.1)
    )

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        if self.friction and self.friction_velocity is None:
            hint = "add `friction_velocity: 0.001`"
            refuse([Issue("friction_velocity", "nothing", "a speed, because there is friction", hint)])
        return self
