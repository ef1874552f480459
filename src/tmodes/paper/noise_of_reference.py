"""Noise on the wanted motion: what a controller hears beside what is meant."""

from __future__ import annotations

import numpy as np

from tmodes.kinds.schema.quantity import DataSheet, not_negative, positive
from tmodes.kinds.signals.merge import merge
from tmodes.kinds.signals.noise import Noise
from tmodes.kinds.signals.schedule import Schedule

__all__ = ["ReferenceNoise"]


class ReferenceNoise(DataSheet):
    """Noise on the wanted angle as the controller hears it, as of the signal ``noise`` of arms.

    To the controller an error of the sensor is the same with the other sign. None by default.
    """

    deviation: float = not_negative("rad", "sigma", "standard deviation of the values", default=0.0, at_most=1e3)
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
