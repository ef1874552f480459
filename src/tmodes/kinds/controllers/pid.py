"""Proportional-integral-derivative control of a drive's own position, with limits that hold the integral."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured, OwnState
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.schema.quantity import not_negative, positive

__all__ = ["PID"]


@CONTROLLERS.register
class PID(Controller):
    """u = Kp e + Ki z + Kv e', z' = e; beyond ``limit`` the command is cut and z is held while e would drive it on.

    Numbers: Kp, Ki, Kv, and the limit where there is one.
    """

    type: Literal["pid"] = Field(description="kind of controller")
    position_gain: float = not_negative("gain", "Kp", "position gain")
    integral_gain: float = not_negative("gain/s", "Ki", "integral gain")
    velocity_gain: float = not_negative("gain*s", "Kv", "velocity gain")
    limit: float | None = positive("command", "u_max", "largest command; none: without a limit", default=None)

    def numbers(self) -> tuple[float, ...]:
        """The gains, and the limit."""
        gains = self.position_gain, self.integral_gain, self.velocity_gain
        return gains if self.limit is None else (*gains, self.limit)

    def initial(self) -> tuple[float, ...]:
        """The integral of the error is zero at first."""
        return (0.0,)

    @property
    def states(self) -> tuple[OwnState, ...]:
        """The integral."""
        return (OwnState("integral", "rad*s|m*s"),)

    def _unlimited(self, p: Any, m: Measured, x: list[Any]) -> Any:
        return p[0] * (m.wanted - m.position) + p[1] * x[0] + p[2] * (m.wanted_rate - m.velocity)

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """The command of all three terms, cut at the limit."""
        command = self._unlimited(p, m, x)
        return command if self.limit is None else f.fmax(f.fmin(command, p[3]), -p[3])

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The error; zero while it would drive a cut command further."""
        error = m.wanted - m.position
        if self.limit is None:
            return [error]
        command = self._unlimited(p, m, x)
        return [f.if_else(f.fabs(command) > p[3], f.if_else(command * error > 0, 0.0, error), error)]

    def local_gains(self) -> tuple[float, float]:
        """Kp, Kv."""
        return self.position_gain, self.velocity_gain

    @property
    def structure(self) -> str:
        """The limit is part of the code."""
        return f"{super().structure}{' limited' * (self.limit is not None)}"
