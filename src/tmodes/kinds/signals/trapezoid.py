"""From rest to rest with constant acceleration, constant speed and constant deceleration."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import numpy as np
from pydantic import ConfigDict, Field

from tmodes.kinds.noted.functions import number, sqrt
from tmodes.kinds.schema.quantity import Issue, positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_value
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Trapezoid"]


@SIGNALS.register
class Trapezoid(Signal):
    """From rest to rest with constant acceleration, speed and deceleration: by its duration, or by both of them."""

    model_config = ConfigDict(json_schema_extra={"examples": [{"duration": 1.0, "ramp_fraction": 0.2}]})
    """What a form begins with: one of the two ways to give it."""

    type: Literal["trapezoid"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value at the start", at_least=-1e3, at_most=1e3)
    end: float = signal_value("u_1", "value at the end", at_least=-1e3, at_most=1e3)
    duration: float | None = positive("s", "T", "duration of the move", default=None, at_most=1e5, smallest=1e-6)
    ramp_fraction: float | None = positive(
        "-", "ramp", "share of the duration that each ramp takes", default=None, at_most=0.5, smallest=1e-6
    )
    speed: float | None = positive("signal", "v", "speed, with `acceleration` instead of a duration", default=None)
    acceleration: float | None = positive("signal", "a", "acceleration and deceleration", default=None)

    def _issues(self) -> Iterator[Issue]:
        by_time, by_rate = ("duration", "ramp_fraction"), ("speed", "acceleration")
        given = [name for name in (*by_time, *by_rate) if getattr(self, name) is not None]
        wanted = by_rate if given and given[0] in by_rate else by_time
        expected = "`duration` and `ramp_fraction`, or `speed` and `acceleration`"
        for name in wanted:
            if name not in given:
                yield Issue(name, "nothing", expected, f"add the line `{name}: ...`")
        for name in given:
            if name not in wanted:
                yield Issue(name, f"{getattr(self, name):g}", expected, f"remove `{name}`, or the other two")

    @property
    def _times(self) -> tuple[float, float]:
        """Duration of the move and of each ramp [s]; where it is too short for the speed, the ramps meet below it."""
        if self.speed is None or self.acceleration is None:
            return number(self.duration or 0.0), number(self.duration or 0.0) * number(self.ramp_fraction or 0.0)
        way = abs(self.end - self.start)
        ramp = min(self.speed / self.acceleration, sqrt(way / self.acceleration))
        return (way / (ramp * self.acceleration) + ramp if ramp else 0.0), ramp

    def pieces(self, until: float) -> SignalPieces:
        """The three pieces of the move."""
        if self._times[0] == 0:
            return SignalPieces(np.array([0.0, until]), np.array([[self.start]]))
        return self._move()

    def _move(self) -> SignalPieces:
        """Three pieces of second degree; two pieces when the ramps meet."""
        duration, ramp = self._times
        cruise = duration - 2 * ramp
        speed = (self.end - self.start) / (duration - ramp)
        rate = speed / ramp
        half = speed * ramp / 2
        pieces = [
            (0.0, (self.start, 0.0, rate / 2)),
            (ramp, (self.start + half, speed, 0.0)),
            (ramp + cruise, (self.end - half, speed, -rate / 2)),
        ]
        if cruise <= 1e-12 * duration:
            del pieces[1]
        return SignalPieces(
            np.array([start for start, _ in pieces] + [duration]),
            np.array([coefficients for _, coefficients in pieces]),
        )

    def length(self, reach: float = 1.0) -> float:
        """Its duration."""
        return reach * self._times[0]
