"""Proportional-integral-derivative control at a sample rate: the command is held between samples."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured, OwnState
from tmodes.kinds.schema.quantity import not_negative, positive

__all__ = ["SampledPID"]


@CONTROLLERS.register
class SampledPID(Controller):
    """u_k = Kp e_k + Ki z_k + Kv e'_k at t = k T, held until the next sample; z_k+1 = z_k + T e_k.

    Numbers: Kp, Ki, Kv, T.
    """

    type: Literal["sampled_pid"] = Field(description="kind of controller")
    position_gain: float = not_negative("gain", "Kp", "position gain")
    integral_gain: float = not_negative("gain/s", "Ki", "integral gain", default=0.0)
    velocity_gain: float = not_negative("gain*s", "Kv", "velocity gain")
    sample_time: float = positive("s", "T", "time between samples", plausible=(1e-5, 1.0))

    @property
    def period(self) -> float:
        """T [s]."""
        return self.sample_time

    def numbers(self) -> tuple[float, ...]:
        """The gains, and the time between samples."""
        return self.position_gain, self.integral_gain, self.velocity_gain, self.sample_time

    def initial(self) -> tuple[float, ...]:
        """The sum of the errors is zero at first."""
        return (0.0,)

    @property
    def states(self) -> tuple[OwnState, ...]:
        """The sum of the errors, times T."""
        return (OwnState("integral", "rad*s|m*s"),)

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """As above."""
        return p[0] * (m.wanted - m.position) + p[1] * x[0] + p[2] * (m.wanted_rate - m.velocity)

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The error times T is added."""
        return [x[0] + p[3] * (m.wanted - m.position)]
