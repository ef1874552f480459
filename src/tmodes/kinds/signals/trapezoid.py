"""From rest to rest with constant acceleration, constant speed and constant deceleration."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, delayed, signal_time, signal_value
from tmodes.kinds.signals.schedule import Schedule

__all__ = ["Trapezoid"]


@SIGNALS.register
class Trapezoid(Signal):
    """From rest to rest with constant acceleration, constant speed and constant deceleration."""

    type: Literal["trapezoid"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value at the start", at_least=-1e3, at_most=1e3)
    end: float = signal_value("u_1", "value at the end", at_least=-1e3, at_most=1e3)
    duration: float = positive("s", "T", "duration of the move", at_most=1e5, smallest=1e-6)
    ramp_fraction: float = positive(
        "-", "ramp", "share of the duration that each ramp takes", at_most=0.5, smallest=1e-6
    )
    delay: float = signal_time("t_0", "time at which it starts", default=0.0)

    def schedule(self, until: float) -> Schedule:
        """The delay, the three pieces of the move, and the last value, up to ``until`` [s]."""
        return delayed(self._move(), self.delay, until)

    def _move(self) -> Schedule:
        """Three pieces of second degree; two pieces when the ramps meet."""
        ramp = self.ramp_fraction * self.duration
        cruise = self.duration - 2 * ramp
        speed = (self.end - self.start) / (self.duration - ramp)
        rate = speed / ramp
        half = speed * ramp / 2
        pieces = [
            (0.0, (self.start, 0.0, rate / 2)),
            (ramp, (self.start + half, speed, 0.0)),
            (ramp + cruise, (self.end - half, speed, -rate / 2)),
        ]
        if cruise <= 1e-12 * self.duration:
            del pieces[1]
        return Schedule(
            np.array([start for start, _ in pieces] + [self.duration]),
            np.array([coefficients for _, coefficients in pieces]),
        )

    def move_ends(self, reach: float = 1.0) -> float:
        """Delay and duration."""
        return self.delay + reach * self.duration
