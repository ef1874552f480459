"""The dynamic environment of Filipovic & Djuric 2010: a body on a spring and damper to which a point is held.

Normal force: Fc = me x'' + be x' + ka x + F0. Friction mu Fc v/sqrt(v.v + veps^2) along the point's velocity
v, where Fc has the acceleration's part in it: the accelerations are found together with it.
"""

from __future__ import annotations

from enum import StrEnum
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.contacts.contract import CONTACTS, Contact
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.schema.quantity import any_sign, dissipation, not_negative, positive

__all__ = ["DynamicEnvironment", "FrictionLaw"]


class FrictionLaw(StrEnum):
    """How the normal force enters friction.

    ``signed`` is the paper's formula (mu Fc): with Fc < 0 it feeds power in. ``magnitude`` is the physical option
    (mu |Fc|), which always takes power.
    """

    SIGNED = "signed"
    MAGNITUDE = "magnitude"


@CONTACTS.register
class DynamicEnvironment(Contact):
    """Mass, damping, preload and stiffness along the normal, and friction of the whole normal force.

    Numbers: ka, be, F0, mu, veps.
    """

    unilateral: ClassVar[bool] = False
    rubs_with_mass: ClassVar[bool] = True

    law: Literal["dynamic_environment"] = Field(description="contact law")
    mass: float = not_negative("kg", "me", "mass of the environment that moves with the point along the normal")
    damping: float = dissipation("N*s/m", "be", "damping along the normal")
    preload: float = any_sign("N", "Fc_o", "force at zero penetration; positive presses into the surface")
    stiffness: float = positive("N/m", "ka", "stiffness along the normal", plausible=(1.0, 1e9))
    friction: float = not_negative("-", "mu", "friction coefficient, along the point's velocity", at_most=10.0)
    friction_velocity: float = positive("m/s", "veps", "speed below which friction is smoothed", plausible=(1e-6, 0.1))
    friction_law: FrictionLaw = Field(
        default=FrictionLaw.SIGNED, strict=False, description="how the normal force enters friction"
    )

    def numbers(self) -> tuple[float, ...]:
        """ka, be, F0, mu, veps."""
        return self.stiffness, self.damping, self.preload, self.friction, self.friction_velocity

    def normal_force(self, p: Any, depth: Any, rate: Any) -> Any:
        """Spring, damper and preload.

        Slip (p. 61): Fc = me kappa'' + be kappa' + Fc_o + ka1 Delta_kappa with Delta_kappa = (l1 + l2) - kappa is a
        negative stiffness; the penetration here is kappa - (l1 + l2) {test_slip_contact_stiffness_sign}
        """
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
        """Along the whole velocity of the point.

        Slip (40): the friction -mu kappa'/|kappa'| Fc, put as it stands into (40), injects power; the friction
        part of the force by the point on the environment points along its velocity {test_slip_friction_sign}
        """
        del slip
        size = normal if self.friction_law is FrictionLaw.SIGNED else f.fabs(normal)
        return v.scale(p[3] * size / f.sqrt(v.dot(velocity, velocity) + p[4] * p[4]), velocity)

    def friction_width(self, p: Any) -> Any | None:
        """The speed of smoothing."""
        return p[4] if self.is_rough else None

    def spring(self) -> tuple[float, float, float]:
        """Stiffness, damping, preload."""
        return self.stiffness, self.damping, self.preload

    @property
    def structure(self) -> str:
        """The law of friction is part of the code."""
        return f"{super().structure} {self.friction_law}"
