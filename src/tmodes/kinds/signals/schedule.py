"""A motion in time as pieces of polynomials: exact, and every jump of it is known to the integrators."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Schedule"]


@dataclass(frozen=True)
class Schedule:
    """Piecewise polynomials of time.

    ``knots`` [s], shape (pieces + 1,), rising; ``coefficients``, shape (pieces, degree + 1), of powers of
    ``t - knots[k]``. Integrators end their steps exactly on the knots, so nothing is smeared over a jump.
    """

    knots: NDArray[np.float64]
    coefficients: NDArray[np.float64]

    @property
    def duration(self) -> float:
        """Length of the schedule [s]."""
        return float(self.knots[-1] - self.knots[0])

    @property
    def degree(self) -> int:
        """Degree of the polynomials."""
        return self.coefficients.shape[1] - 1

    def at(self, time: ArrayLike, derivative: int = 0) -> NDArray[np.float64]:
        """The value, or its ``derivative``-th derivative, at each time [s]; at a jump, the later piece counts."""
        time = np.asarray(time, dtype=float)
        piece = self._piece(time)
        tau = time - self.knots[piece]
        powers = np.polynomial.polynomial.polyder(self.coefficients, derivative, axis=1)
        value = np.zeros_like(tau)
        for column in powers.T[::-1]:
            value = value * tau + column[piece]
        return value

    def rows_at(self, time: ArrayLike) -> NDArray[np.float64]:
        """Start and coefficients of the piece at each time [s], shape (n, degree + 2): what compiled code reads."""
        piece = self._piece(np.asarray(time, dtype=float))
        return np.column_stack([self.knots[piece], self.coefficients[piece]])

    def _piece(self, time: NDArray[np.float64]) -> NDArray[np.intp]:
        return np.clip(np.searchsorted(self.knots, time, side="right") - 1, 0, len(self.coefficients) - 1)

    def until(self, end: float) -> Schedule:
        """The same motion from its start to ``end`` [s]: cut short, or held in its last position."""
        kept = self.knots[:-1] < end
        knots, pieces = self.knots[:-1][kept], self.coefficients[kept]
        if end > self.knots[-1]:
            rest = np.zeros((1, self.degree + 1))
            rest[0, 0] = self.at(self.knots[-1])
            knots, pieces = np.append(knots, self.knots[-1]), np.vstack([pieces, rest])
        return Schedule(np.append(knots, end), pieces)
