"""Proportional-integral-derivative control of a drive's own position: filtered rate, limit, anti-windup, sampled."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured, OwnState
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.schema.quantity import Issue, not_negative, positive

__all__ = ["PID", "AntiWindup", "SampledPID"]


_BAND = 1e-2
"""Share of the limit over which conditional integration stops the integral, in continuous time."""


class AntiWindup(StrEnum):
    """What the integral does while the command is cut (K. J. Astrom, T. Hagglund, PID Controllers, 1995, 3.5)."""

    CLAMP = "clamp"
    """It is held while the error would drive the command further on (conditional integration)."""
    BACK_CALCULATION = "back_calculation"
    """What is cut off flows back into it, with ``tracking_time``."""
    NONE = "none"
    """It goes on."""


class _PID(Controller):
    """u = Kp e + Ki z + Kv e', z' = e. Numbers: Kp, Ki, Kv, then what there is of limit, tracking and filter time."""

    needs_joint: ClassVar[bool] = True

    position_gain: float = not_negative("gain", "Kp", "position gain")
    integral_gain: float = not_negative("gain/s", "Ki", "integral gain")
    velocity_gain: float = not_negative("gain*s", "Kv", "velocity gain")
    limit: float | None = positive("command", "u_max", "largest command; none: that of the drive", default=None)
    anti_windup: AntiWindup = Field(default=AntiWindup.CLAMP, strict=False, description="what a limit does to z")
    tracking_time: float | None = positive("s", "Tt", "time of back-calculation", default=None)
    filter_time: float | None = positive(
        "s", "Tf", "time constant of the rate, which is then that of the measured position; none: the rate itself",
        default=None,
    )  # fmt: skip

    def _issues(self) -> Iterator[Issue]:
        back = self.anti_windup is AntiWindup.BACK_CALCULATION
        if back and self.tracking_time is None:
            hint = "add `tracking_time: 0.1`"
            yield Issue("tracking_time", "nothing", "a time, because `anti_windup` is back_calculation", hint)
        if back and not self.integral_gain:
            yield Issue("anti_windup", "back_calculation", "left out without an integral gain", "remove it")
        if self.tracking_time is not None and not back:
            yield Issue("tracking_time", f"{self.tracking_time:g} s", "left out without back_calculation", "remove it")

    @property
    def _more(self) -> dict[str, float]:
        given = {name: getattr(self, name) for name in ("limit", "tracking_time", "filter_time")}
        return {name: value for name, value in given.items() if value is not None}

    @property
    def limits_at(self) -> tuple[int, ...]:  # pyright: ignore[reportIncompatibleVariableOverride]
        """The largest command, where it has one."""
        return (3,) if self.limit is not None else ()

    def numbers(self) -> tuple[float, ...]:
        """The gains, and what else there is."""
        return (self.position_gain, self.integral_gain, self.velocity_gain, *self._more.values())

    def _number(self, p: Any, name: str) -> Any:
        return p[3 + list(self._more).index(name)] if name in self._more else None

    def _unlimited(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """The command of all three terms."""
        falling = self._rate(p, m, x)
        return p[0] * (m.wanted - self._position(m)) + p[1] * x[0] + p[2] * (m.wanted_rate - falling)

    def _position(self, m: Measured) -> Any:
        """The position that is fed back."""
        return m.position

    def _rate(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """The rate that is fed back."""
        raise NotImplementedError

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """The command of all three terms, cut at the limit."""
        command, limit = self._unlimited(p, m, x), self._number(p, "limit")
        return command if limit is None else f.fmax(f.fmin(command, limit), -limit)

    def _integrated(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """The rate of the integral: the error; less what a limit cuts off."""
        error, limit = m.wanted - self._position(m), self._number(p, "limit")
        limit = m.limit if limit is None else limit
        if limit is None or self.anti_windup is AntiWindup.NONE:
            return error
        command = self._unlimited(p, m, x)
        if self.anti_windup is AntiWindup.BACK_CALCULATION:
            cut = f.fmax(f.fmin(command, limit), -limit) - command
            return error + cut / (p[1] * self._number(p, "tracking_time"))
        return f.if_else(command * error > 0, (1 - self._held(command, limit)) * error, error)

    def _held(self, command: Any, limit: Any) -> Any:
        """The share of the error that the integral leaves out."""
        return f.if_else(f.fabs(command) > limit, 1.0, 0.0)

    @property
    def structure(self) -> str:
        """What it has is part of the code."""
        return f"{super().structure} {' '.join(self._more)} {self.anti_windup}"


@CONTROLLERS.register
class PID(_PID):
    """u = Kp e + Ki z + Kv e', z' = e, in continuous time; with ``filter_time`` of a filtered rate y' = (th - y)/Tf."""

    type: Literal["pid"] = Field(description="kind of controller")

    def initial(self) -> tuple[float, ...]:
        """The integral of the error is zero at first, and the filtered position."""
        return (0.0,) * (1 + (self.filter_time is not None))

    @property
    def states(self) -> tuple[OwnState, ...]:
        """The integral, and the filtered position."""
        return (OwnState("integral", "rad*s|m*s"), OwnState("filtered", "rad|m"))[: len(self.initial())]

    def _rate(self, p: Any, m: Measured, x: list[Any]) -> Any:
        return m.velocity if self.filter_time is None else (m.position - x[1]) / self._number(p, "filter_time")

    def _held(self, command: Any, limit: Any) -> Any:
        """All of it just beyond the limit: a jump there would have no solution where it leads the command back."""
        return f.fmin(f.fmax((f.fabs(command) - limit) / (_BAND * limit), 0.0), 1.0)

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """That of the integral, and of the filtered position."""
        return [self._integrated(p, m, x), *([self._rate(p, m, x)] if self.filter_time is not None else [])]

    def local_gains(self) -> tuple[float, float]:
        """Kp, Kv."""
        return self.position_gain, self.velocity_gain


@CONTROLLERS.register
class SampledPID(_PID):
    """u_k = Kp e_k + Ki z_k + Kv e'_k at t = k T, held until the next sample; z_k+1 = z_k + T e_k.

    With ``filter_time`` the rate is that of the measured position: r_k = (Tf r_k-1 + th_k - th_k-1)/(Tf + T).
    """

    type: Literal["sampled_pid"] = Field(description="kind of controller")
    filter_time: float | None = not_negative(
        "s", "Tf", "time constant of the rate, which is then that of the measured position (0: its last difference); "
        "none: the rate itself", default=None,
    )  # fmt: skip
    integral_gain: float = not_negative("gain/s", "Ki", "integral gain", default=0.0)
    sample_time: float = positive("s", "T", "time between samples", plausible=(1e-5, 1.0))
    measured: str | None = Field(
        default=None, min_length=1, max_length=200, description="sensor that it reads; none: the position itself"
    )

    def _issues(self) -> Iterator[Issue]:
        yield from super()._issues()
        if self.measured is not None and self.filter_time is None:
            hint = "write `filter_time: 0` for its last difference"
            yield Issue("filter_time", "nothing", "a time, because a sensor that is `measured` gives no rate", hint)

    @property
    def reads(self) -> tuple[str, ...]:
        """The sensor."""
        return () if self.measured is None else (self.measured,)

    def _position(self, m: Measured) -> Any:
        return m.position if self.measured is None else m.signals[self.measured]

    @property
    def period(self) -> float:
        """T [s]."""
        return self.sample_time

    def numbers(self) -> tuple[float, ...]:
        """Those of a PID, and the time between samples."""
        return (*super().numbers(), self.sample_time)

    def initial(self) -> tuple[float, ...]:
        """The sum of the errors is zero at first; no position was measured yet."""
        return (0.0,) if self.filter_time is None else (0.0,) * 4

    @property
    def states(self) -> tuple[OwnState, ...]:
        """The sum of the errors, times T; of a filtered rate that, the last position, and whether there is one."""
        more = OwnState("rate", "rad/s|m/s"), OwnState("last", "rad|m"), OwnState("begun", "1")
        return (OwnState("integral", "rad*s|m*s"), *more)[: len(self.initial())]

    def _rate(self, p: Any, m: Measured, x: list[Any]) -> Any:
        if self.filter_time is None:
            return m.velocity
        time, last = self._number(p, "filter_time"), f.if_else(x[3] > 0, x[2], self._position(m))
        return (time * x[1] + self._position(m) - last) / (time + p[len(self.numbers()) - 1])

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The error times T is added."""
        integral = x[0] + p[len(self.numbers()) - 1] * self._integrated(p, m, x)
        return [integral, *([self._rate(p, m, x), self._position(m), 1.0] if self.filter_time is not None else [])]

    @property
    def structure(self) -> str:
        """Whether it reads a sensor is part of the code."""
        return f"{super().structure} {self.measured or ''}".rstrip()
