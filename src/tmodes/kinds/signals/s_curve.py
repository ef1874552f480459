"""From rest to rest in least time with bounded speed, acceleration and jerk."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.noted.functions import array, number, sqrt
from tmodes.kinds.noted.number import plain_value
from tmodes.kinds.schema.quantity import positive
from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_value
from tmodes.kinds.signals.schedule import SAME, SignalPieces

__all__ = ["SCurve"]


_NONE = 1e-200
"""A way that is none: its third power is zero in double precision."""


@SIGNALS.register
class SCurve(Signal):
    """From rest to rest in the least time that its speed, acceleration and jerk allow; the jerk has three values."""

    type: Literal["s_curve"] = Field(description="kind of signal")
    start: float = signal_value("u_0", "value at the start")
    end: float = signal_value("u_1", "value at the end")
    speed: float = positive("signal", "v", "largest speed [per s]")
    acceleration: float = positive("signal", "a", "largest acceleration and deceleration [per s^2]")
    jerk: float = positive("signal", "j", "largest jerk [per s^3]")

    def durations(self) -> tuple[Any, Any, Any]:
        """How long each phase of jerk, of steady acceleration and of steady speed takes [s].

        Where the way is too short for the speed the last is 0; where it is for the acceleration, too, the second is.
        Source: L. Biagiotti, C. Melchiorri, Trajectory Planning for Automatic Machines and Robots (2008), 3.4.
        """
        way, v, a, j = number(abs(self.end - self.start)), self.speed, self.acceleration, self.jerk
        jerking, steady = (a / j, v / a - a / j) if v * j >= a * a else (sqrt(v / j), 0.0)
        cruise = way / v - 2 * jerking - steady
        if cruise >= 0:
            return jerking, steady, cruise
        if way * j * j >= 2 * a**3:
            jerking = a / j
            return jerking, sqrt(jerking * jerking / 4 + way / a) - 3 * jerking / 2, 0.0
        return (_cubic_root(way / (2 * j)) if way > _NONE else 0.0), 0.0, 0.0

    def pieces(self, until: float) -> SignalPieces:
        """Up to seven pieces of third degree."""
        if not self.length() > 0:
            return SignalPieces(np.array([0.0, until]), np.array([[self.start]]))
        found, whole = [*self._phases()], self.length()
        kept = [(time, row) for time, length, row in found if length > SAME * whole]
        knots = [0.0, *(time for time, _ in kept[1:]), whole]
        return SignalPieces(array(knots), array([row for _, row in kept]))

    def _phases(self) -> Iterator[tuple[Any, Any, tuple[Any, ...]]]:
        """Time at which each phase begins, its length [s], and its coefficients."""
        jerking, steady, cruise = self.durations()
        way = self.end - self.start
        rate = self.jerk * way / abs(way)
        time, x, v, a = 0.0, self.start, 0.0, 0.0
        lengths = (jerking, steady, jerking, cruise, jerking, steady, jerking)
        for jerk, t in zip((rate, 0.0, -rate, 0.0, -rate, 0.0, rate), lengths, strict=True):
            yield time, t, (x, v, a / 2, jerk / 6)
            x = x + t * (v + t * (a / 2 + t * (jerk / 6)))
            v = v + t * (a + t * (jerk / 2))
            a, time = a + t * jerk, time + t

    def length(self, reach: float = 1.0) -> Any:
        """Its duration."""
        jerking, steady, cruise = self.durations()
        return reach * (4 * jerking + 2 * steady + cruise)


def _cubic_root(x: Any) -> Any:
    """By Halley's method from the root of the value: six steps are enough for a number a hundred times as large."""
    found: Any = np.cbrt(plain_value(x))
    for _ in range(6):
        cube = found * found * found
        found = found * (cube + 2 * x) / (2 * cube + x)
    return found
