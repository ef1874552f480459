"""A disturbance observer: what loads a motor beyond its own inertia and friction is estimated and given to it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured, OwnState
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.noted import functions as noted
from tmodes.kinds.schema.quantity import Issue, not_negative, positive

__all__ = ["DisturbanceObserver"]

_TURN = 6.283185307179586


@CONTROLLERS.register
class DisturbanceObserver(Controller):
    """u = Kp (wanted - th) + Kv (wanted' - th') + the signal ``input`` + d, d = w/(s + w) (u - b th' - J th'').

    w = 2 pi ``bandwidth``; J, b: inertia and viscous friction of the motor as known; u: the effort after a limit of it.
    Where an effort is fed forward, th' and th'' are less those of the setpoint, so that d is what differs from it.
    Only th' is measured: d = z - w J th', z' = w (u - b th' + w J th' - z). Sampled: a = exp(-w T), g = (1 - a) J/T,
    d = z - g th', z+ = a d + (1 - a) (u - b th') + g th', exact where u - b th' and load are constant between samples
    (K. Ohnishi, M. Shibata, T. Murakami, Motion control for advanced mechatronics, IEEE/ASME Trans. Mechatronics 1,
    1996).
    """

    sees_all: ClassVar[bool] = True
    needs_joint: ClassVar[bool] = True
    needs_model: ClassVar[bool] = True
    commands_effort: ClassVar[bool] = True

    type: Literal["disturbance_observer"] = Field(description="kind of controller")
    bandwidth: float = positive("Hz", "w", "cut-off of the low pass, w/(2 pi)", plausible=(1e-2, 1e4))
    position_gain: float = not_negative("gain", "Kp", "position gain", default=0.0)
    velocity_gain: float = not_negative("gain*s", "Kv", "velocity gain", default=0.0)
    input: str = Field(default="", max_length=200, description="law that it adds to: a block; none: its own gains")
    sample_time: float | None = positive("s", "T", "time between samples; none: at every instant", default=None,
                                         plausible=(1e-5, 1.0))  # fmt: skip

    def _issues(self) -> Iterator[Issue]:
        if not (self.input or self.position_gain):
            hint = "write `position_gain` and `velocity_gain`, or `input: NAME` of a block of this joint"
            yield Issue("input", "nothing", "a law that it adds to, its own or that of a block", hint)

    @property
    def reads(self) -> tuple[str, ...]:
        """The law that it adds to."""
        return (self.input,) if self.input else ()

    @property
    def period(self) -> float | None:
        """T [s]."""
        return self.sample_time

    def numbers(self) -> tuple[Any, ...]:
        """Kp, Kv, and w twice; sampled: 1 - a, (1 - a)/T."""
        rate, T = _TURN * self.bandwidth, self.sample_time
        share = rate if T is None else 1 - noted.exp(-rate * T)
        return self.position_gain, self.velocity_gain, share, share / (T or 1.0)

    def initial(self) -> tuple[float, ...]:
        """Nothing is known of the load."""
        return (0.0,)

    @property
    def states(self) -> tuple[OwnState, ...]:
        """z: at rest the load."""
        return (OwnState("load", "N*m|N"),)

    @staticmethod
    def _rate(m: Measured) -> Any:
        """th', of a drive whose effort is fed forward beyond that of its setpoint."""
        return m.velocity - m.wanted_rate if m.fed else m.velocity

    def _estimate(self, p: Any, m: Measured, x: list[Any]) -> tuple[Any, Any]:
        """The load d, and what of z is not of it."""
        moved = p[3] * m.model.inertia[m.drives.index(m.joint)] * self._rate(m)
        return x[0] - moved, moved

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """As above."""
        law = p[0] * (m.wanted - m.position) + p[1] * (m.wanted_rate - m.velocity)
        return law + self._estimate(p, m, x)[0] + (m.signals[self.input] if self.input else 0.0)

    def _excess(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """The command less friction and estimate: u - b th' - d."""
        u, lost = self.command(p, m, x), m.model.viscous[m.drives.index(m.joint)] * self._rate(m)
        u = u if m.limit is None else f.fmax(f.fmin(u, m.limit), -m.limit)
        return u - lost - self._estimate(p, m, x)[0]

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """That of z."""
        return [p[2] * self._excess(p, m, x)]

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """That of the next sample."""
        return [x[0] + p[2] * self._excess(p, m, x)]

    @property
    def structure(self) -> str:
        """What it reads is part of the code."""
        return f"{super().structure} {self.input}"
