"""A surface on a spring and a damper that holds a point, or that only pushes it.

Normal force be x' + ka x + F0, and me x'' of the mass that moves with the point; friction along the surface is mu times
the magnitude of the force of spring, damper and preload. At rest it is what keeps the point there, up to mu_s times
that; with a ``friction_velocity`` it is a smooth function of the slip instead.
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
    """What both laws have in common; numbers: ka, be, F0, mu, veps, mu_s."""

    stiffness: float = positive("N/m", "ka", "stiffness along the normal", plausible=(1.0, 1e9))
    damping: float = dissipation("N*s/m", "be", "damping along the normal")
    preload: float = any_sign("N", "Fc_o", "force at zero penetration", default=0.0)
    mass: float = not_negative("kg", "me", "mass of the surface that moves with the point", default=0.0)
    friction: float = not_negative("-", "mu", "friction coefficient in slip", default=0.0, at_most=10.0)
    static_friction: float | None = not_negative(
        "-", "mu_s", "friction coefficient at rest; none: as in slip", default=None, at_most=10.0
    )
    friction_velocity: float | None = positive(
        "m/s",
        "veps",
        "speed below which friction is smoothed; none: true stick and slip",
        default=None,
        plausible=(1e-6, 0.1),
    )

    def _issues(self) -> Iterator[Issue]:
        if self.static_friction is None:
            return
        if self.friction_velocity is not None:
            hint = "remove `friction_velocity`, or `static_friction`"
            yield Issue("static_friction", f"{self.static_friction:g}", "none next to `friction_velocity`", hint)
        if self.static_friction < self.friction:
            got, expected = f"{self.static_friction:g}", f"at least `friction`, {self.friction:g}"
            yield Issue("static_friction", got, expected, "exchange the two")

    def numbers(self) -> tuple[float, ...]:
        """ka, be, F0, mu, veps (0: none), mu_s."""
        static = self.friction if self.static_friction is None else self.static_friction
        return self.stiffness, self.damping, self.preload, self.friction, self.friction_velocity or 0.0, static

    def normal_force(self, p: Any, depth: Any, rate: Any) -> Any:
        """Spring, damper and preload."""
        return p[1] * rate + p[0] * depth + p[2]

    @property
    def moving_mass(self) -> float:
        """As the sheet gives it."""
        return self.mass

    @property
    def is_rough(self) -> bool:
        """Whether a friction coefficient is not zero."""
        return self.friction > 0 or bool(self.static_friction)

    @property
    def sticks(self) -> bool:
        """Unless friction is smoothed."""
        return self.is_rough and self.friction_velocity is None

    def static_limit(self, p: Any, normal: Any) -> Any:
        """The coefficient at rest times the magnitude of the normal force."""
        return p[5] * f.fabs(normal)

    def friction_force(self, p: Any, normal: Any, slip: v.Vector, velocity: v.Vector) -> v.Vector:
        """Along the slip, mu times the magnitude of the normal force."""
        del velocity
        return v.scale(p[3] * f.fabs(normal) / f.sqrt(v.dot(slip, slip) + p[4] * p[4]), slip)

    def resting(self) -> Contact:
        """Without mass and friction."""
        return self.model_copy(update={"mass": 0.0, "friction": 0.0, "static_friction": None})

    def friction_width(self, p: Any) -> Any | None:
        """The speed of smoothing."""
        return p[4] if self.is_rough and not self.sticks else None

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
    restitution: float = not_negative(
        "-", "e", "of a surface with mass: speed of parting over that of meeting", default=0.0, at_most=1.0
    )

    def _issues(self) -> Iterator[Issue]:
        yield from super()._issues()
        if self.restitution and not self.mass:
            hint = "add `mass`: without it the spring gives the point back"
            yield Issue("restitution", f"{self.restitution:g}", "none of a surface without mass", hint)
        if self.preload and self.mass:
            hint = "remove `preload`, or take `law: bilateral`"
            yield Issue("preload", f"{self.preload:g}", "0 for a surface with mass that only pushes", hint)

    def numbers(self) -> tuple[float, ...]:
        """Those of all, and e."""
        return (*super().numbers(), self.restitution)

    def restitution_of(self, p: Any) -> Any:
        """As the sheet gives it."""
        return p[6]

    @property
    def jumps(self) -> bool:
        """A spring alone starts from zero."""
        return self.damping > 0 or self.preload > 0 or self.mass > 0
