"""Frequencies of one uniform beam from its characteristic equation, apart from everything in the package."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq


@dataclass(frozen=True)
class UniformBeam:
    """An Euler-Bernoulli beam: clamped, or on a free hub of inertia ``hub``; mass and inertia at its tip."""

    stiffness: float
    mass_per_length: float
    length: float
    tip_mass: float = 0.0
    tip_inertia: float = 0.0
    hub: float | None = None

    def determinant(self, x):
        """Of the four conditions on y = a sin + b cos + c sinh + d cosh; x: wave number times length; rows scaled."""
        wave = x / self.length
        square = self.stiffness / self.mass_per_length * wave**4
        s, c, sh, ch = np.sin(x), np.cos(x), np.sinh(x), np.cosh(x)
        shape = np.array([s, c, sh, ch])
        slope = wave * np.array([c, -s, ch, sh])
        moment = self.stiffness * wave**2 * np.array([-s, -c, sh, ch])
        shear = self.stiffness * wave**3 * np.array([-c, s, ch, sh])
        root_slope, root_moment = wave * np.array([1, 0, 1, 0]), self.stiffness * wave**2 * np.array([0, -1, 0, 1])
        rows = [
            np.array([0.0, 1.0, 0.0, 1.0]),
            root_slope if self.hub is None else root_moment + self.hub * square * root_slope,
            moment - square * self.tip_inertia * slope,
            shear + square * self.tip_mass * shape,
        ]
        return np.linalg.det(np.array([row / np.abs(row).max() for row in rows]))

    def frequencies(self, count):
        """The first ``count`` [Hz], without the turn as a whole."""
        grid = np.linspace(0.05, 4.0 * (count + 1), 4000 * (count + 1))
        signs = np.sign([self.determinant(x) for x in grid])
        starts = np.flatnonzero(signs[1:] * signs[:-1] < 0)[:count]
        assert len(starts) == count
        waves = np.array([brentq(self.determinant, grid[k], grid[k + 1], xtol=1e-14) for k in starts]) / self.length
        return waves**2 * np.sqrt(self.stiffness / self.mass_per_length) / (2 * np.pi)
