"""The dynamic environment: a body on a spring and damper that the tip presses, on a sphere about the base point C.

It is bilateral, as in the paper: the tip is held to the sphere, so the radial force may take either sign.
"""

from __future__ import annotations

from enum import StrEnum
from typing import Any

from pydantic import Field

from tmodes.kinds.schema.quantity import DataSheet, any_sign, dissipation, not_negative, positive

__all__ = ["DynamicEnvironment", "FrictionLaw"]


class FrictionLaw(StrEnum):
    """How the normal force enters friction.

    ``signed`` is the formula as it stands (mu Fc): with Fc < 0 it feeds power in. ``magnitude`` is the physical
    option (mu |Fc|), which always takes power.
    """

    SIGNED = "signed"
    MAGNITUDE = "magnitude"


class DynamicEnvironment(DataSheet):
    """Mass, damping, preload and stiffness along the radius, and friction across it."""

    mass: float = not_negative("kg", "me", "mass of the environment that moves with the tip's radius")
    damping: float = dissipation("N*s/m", "be", "damping along the radius")
    preload: float = any_sign("N", "Fc_o", "force at zero radial deviation; positive presses outwards")
    stiffness: float = positive("N/m", "ka1", "stiffness along the radius")
    friction: float = not_negative("-", "mu", "friction coefficient, along the tip's velocity", at_most=10.0)
    friction_velocity: float = positive("m/s", "veps", "speed below which friction is smoothed", plausible=(1e-6, 0.1))
    friction_law: FrictionLaw = Field(
        default=FrictionLaw.SIGNED, strict=False, description="how the normal force enters friction"
    )

    def radial_force(self, deviation: Any, rate: Any, acceleration: Any) -> Any:
        """Radial force Fc by the tip on the environment [N], from kappa - (l1 + l2) [m] and its two derivatives.

        Slip (p. 61): Fc = me kappa'' + be kappa' + Fc_o + ka1 Delta_kappa with Delta_kappa = (l1 + l2) - kappa is a
        negative stiffness; the deviation here is kappa - (l1 + l2) {test_slip_contact_stiffness_sign}
        """
        return self.mass * acceleration + self.damping * rate + self.preload + self.stiffness * deviation

    def slip_ratio(self, speed_squared: Any, square_root: Any) -> Any:
        """mu/sqrt(v.v + veps^2) [s/m]: friction force per normal force and tip velocity, smooth at rest.

        ``speed_squared`` v.v [m^2/s^2]; ``square_root`` is that of the arithmetic in use: numbers or symbols.

        Slip (40): the friction -mu kappa'/|kappa'| Fc, put as it stands into (40), injects power; the friction
        part of the force by the tip on the environment points along the tip's velocity {test_slip_friction_sign}
        """
        return self.friction / square_root(speed_squared + self.friction_velocity**2)
