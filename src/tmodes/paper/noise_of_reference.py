"""Noise on a commanded motion: what a controller receives in addition to the reference."""

from __future__ import annotations

import numpy as np

from tmodes.kinds.schema.quantity import DataSheet, not_negative, positive
from tmodes.kinds.signals.merge import merge
from tmodes.kinds.signals.noise import Noise
from tmodes.kinds.signals.schedule import Schedule

__all__ = ["CommandNoise"]


class CommandNoise(DataSheet):
    """Noise on the reference as the controller receives it, like the signal ``noise``; none by default.

    To the controller, an error of the sensor is the same with the other sign.
    """

    deviation: float = not_negative("rad|m", "sigma", "standard deviation of the values", default=0.0, at_most=1e3)
    frequency: float = positive("Hz", "f", "highest frequency", default=100.0, plausible=(1e-3, 1e4))
    seed: int = not_negative("-", "seed", "same seed, same noise", default=0, at_most=2**53)

    def on(self, motion: Schedule, until: float) -> Schedule:
        """The motion with the noise on it, up to ``until`` [s]; without a deviation the motion itself.

        Raises :class:`tmodes.errors.InputError` where it needs too many pieces.
        """
        if not self.deviation:
            return motion
        signal = Noise(type="noise", deviation=self.deviation, frequency=self.frequency, seed=self.seed)
        both = merge([motion.until(until), signal.schedule(until)])
        return Schedule(both.knots, np.ascontiguousarray(both.coefficients.sum(axis=1)))
