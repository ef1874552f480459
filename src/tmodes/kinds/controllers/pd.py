"""Proportional-derivative control of a drive's own position."""

from __future__ import annotations

from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured
from tmodes.kinds.schema.quantity import any_sign, not_negative

__all__ = ["PD"]


@CONTROLLERS.register
class PD(Controller):
    """Proportional-derivative control; gains in V/rad where the motor has a resistance, else in N*m/rad.

    u = Kp (wanted - th) + Kv (wanted' - th'), and a constant ``offset`` where one is given, such as the load that is
    known. Numbers: Kp, Kv, and the offset.

    Eq. (41) [stated]: u = Klp (theta_o - theta) + Klv (theta_o' - theta'). {test_local_pd}
    """

    needs_joint: ClassVar[bool] = True

    type: Literal["pd"] = Field(description="kind of controller")
    position_gain: float = not_negative("gain", "Kp", "position gain")
    velocity_gain: float = not_negative("gain*s", "Kv", "velocity gain")
    offset: float | None = any_sign("command", "u_0", "constant command that is added; none: nothing", default=None)

    def numbers(self) -> tuple[float, ...]:
        """Kp, Kv, and the offset where there is one."""
        gains = self.position_gain, self.velocity_gain
        return gains if self.offset is None else (*gains, self.offset)

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """As above."""
        del x
        command = p[0] * (m.wanted - m.position) + p[1] * (m.wanted_rate - m.velocity)
        return command if self.offset is None else command + p[2]

    def local_gains(self) -> tuple[float, float]:
        """Kp, Kv."""
        return self.position_gain, self.velocity_gain
