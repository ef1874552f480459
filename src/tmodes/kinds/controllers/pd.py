"""Proportional-derivative control of a drive's own position."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured
from tmodes.kinds.schema.quantity import not_negative

__all__ = ["PD"]


@CONTROLLERS.register
class PD(Controller):
    """Proportional-derivative control; gains in V/rad where the motor has a resistance, else in N*m/rad.

    u = Kp (wanted - th) + Kv (wanted' - th'). Numbers: Kp, Kv.

    Eq. (41) [stated]: u = Klp (theta_o - theta) + Klv (theta_o' - theta'). {test_local_pd}
    """

    type: Literal["pd"] = Field(description="kind of controller")
    position_gain: float = not_negative("gain", "Kp", "position gain")
    velocity_gain: float = not_negative("gain*s", "Kv", "velocity gain")

    def numbers(self) -> tuple[float, ...]:
        """Kp, Kv."""
        return self.position_gain, self.velocity_gain

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """As above."""
        del x
        return p[0] * (m.wanted - m.position) + p[1] * (m.wanted_rate - m.velocity)

    def local_gains(self) -> tuple[float, float]:
        """Kp, Kv."""
        return self.position_gain, self.velocity_gain
