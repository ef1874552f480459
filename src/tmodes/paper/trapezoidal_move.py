"""The trapezoidal velocity profile of the paper's example."""

from __future__ import annotations

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import DataSheet, any_sign, positive
from tmodes.kinds.signals.schedule import Schedule
from tmodes.paper.noise_of_reference import CommandNoise

__all__ = ["TrapezoidalMove"]

TURN = 6.3
"""A full turn [rad], a little rounded up."""


class TrapezoidalMove(DataSheet):
    """Rest to rest with constant acceleration, constant speed and constant deceleration."""

    start: float = any_sign(
        "rad", "theta_o(0)", "motor angle at the start", at_least=-1e3, at_most=1e3, plausible=(-TURN, TURN)
    )
    end: float = any_sign(
        "rad", "theta_o(T)", "motor angle at the end", at_least=-1e3, at_most=1e3, plausible=(-TURN, TURN)
    )
    duration: float = positive("s", "T", "duration of the move", at_most=1e5, smallest=1e-6)
    ramp_fraction: float = positive(
        "-", "ramp", "share of the duration that each ramp takes", at_most=0.5, smallest=1e-6
    )
    noise: CommandNoise = Field(default_factory=CommandNoise)

    def schedule(self) -> Schedule:
        """The move as three pieces of second degree; two pieces when the ramps meet."""
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
