"""A surface on a spring and a damper that holds a point, or that only pushes it.

Normal force be x' + ka x + F0, and me x'' of the mass that moves with the point; friction along the surface is mu times
the magnitude of the force of spring, damper and preload, smooth where the point stands still.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.contacts.contract import CONTACTS, Contact
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.schema.quantity import Issue, any_sign, dissipation, not_negative, positive

__all__ = ["Bilateral", "SpringDamper", "Unilateral"]


class SpringDamper(Contact):
    """What both laws have in common; numbers: ka, be, F0, mu, veps."""

    stiffness: float = positive("N/m", "ka", "stiffness along the normal", plausible=(1.0, 1e9))
    damping: float = dissipation("N*s/m", "be", "damping along the normal")
    preload: float = any_sign("N", "Fc_o", "force at zero penetration", default=0.0)
    mass: float = not_negative("kg", "me", "mass of the surface that moves with the point", default=0.0)
    friction: float = not_negative("-", "mu", "friction coefficient", default=0.0, at_most=10.0)
    friction_velocity: float | None = positive(
        "m/s", "veps", "speed below which friction is smoothed", default=None, plausible=(1e-6, 0.1)
    )

    def _issues(self) -> Iterator[Issue]:
        if self.friction and self.friction_velocity is None:
            hint = "add `friction_velocity: 0.001`"
            yield Issue("friction_velocity", "nothing", "a speed, because there is friction", hint)

    def numbers(self) -> tuple[float, ...]:
        """ka, be, F0, mu, veps."""
        return self.stiffness, self.damping, self.preload, self.friction, self.friction_velocity or 1.0

    def normal_force(self, p: Any, depth: Any, rate: Any) -> Any:
        """Spring, damper and preload."""
        return p[1] * rate + p[0] * depth + p[2]

    @property
    def moving_mass(self) -> float:
        """As the sheet gives it."""
        return self.mass

    @property
    def is_rough(self) -> bool:
        """Whether the friction coefficient is not zero."""
        return self.friction > 0

    def friction_force(self, p: Any, normal: Any, slip: v.Vector, velocity: v.Vector) -> v.Vector:
        """Along the slip, mu times the magnitude of the normal force."""
        del velocity
        return v.scale(p[3] * f.fabs(normal) / f.sqrt(v.dot(slip, slip) + p[4] * p[4]), slip)

    def spring(self) -> tuple[float, float, float]:
        """Stiffness, damping, preload."""
        return self.stiffness, self.damping, self.preload

    def start_notices(self, normal: float, depth: float) -> Iterator[str]:
        """Also where friction leaves out the mass."""
        if self.mass > 0 and self.friction > 0:
            yield "friction of the contact is taken from its spring, damper and preload, without the surface's inertia"
        yield from super().start_notices(normal, depth)


@CONTACTS.register
class Bilateral(SpringDamper):
    """The point is held to the surface, which pushes and pulls."""

    unilateral: ClassVar[bool] = False

    law: Literal["bilateral"] = Field(description="contact law")


@CONTACTS.register
class Unilateral(SpringDamper):
    """The surface only pushes."""

    law: Literal["unilateral"] = Field(description="contact law")

    @property
    def jumps(self) -> bool:
        """A spring alone starts from zero."""
        return self.damping > 0 or self.preload > 0
