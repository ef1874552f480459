"""Many schedules on common knots: what compiled loops read, one row of coefficients for each piece and signal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.signals.schedule import Schedule

__all__ = ["MergedSchedule", "merge"]

SAME = 1e-12
"""Knots nearer than this share of the whole time are one knot [-]."""


@dataclass(frozen=True)
class MergedSchedule:
    """Several signals as polynomials of time on common pieces.

    ``knots`` [s], shape (pieces + 1,), rising; ``coefficients``, shape (pieces, signals, degree + 1), of powers of
    ``t - knots[k]``.
    """

    knots: NDArray[np.float64]
    coefficients: NDArray[np.float64]

    @property
    def degree(self) -> int:
        """Degree of the polynomials."""
        return self.coefficients.shape[2] - 1

    def at(self, time: ArrayLike, derivative: int = 0) -> NDArray[np.float64]:
        """Values, or ``derivative``-th derivatives, shape (*times, signals); at a jump, the later piece counts."""
        time = np.asarray(time, dtype=float)
        piece = np.clip(np.searchsorted(self.knots, time, side="right") - 1, 0, len(self.coefficients) - 1)
        tau = (time - self.knots[piece])[..., None]
        powers = np.polynomial.polynomial.polyder(self.coefficients, derivative, axis=2)
        value = np.zeros((*time.shape, self.coefficients.shape[1]))
        for column in np.moveaxis(powers, 2, 0)[::-1]:
            value = value * tau + column[piece]
        return value


def merge(schedules: Sequence[Schedule]) -> MergedSchedule:
    """The schedules on all their knots, each held in its last value up to the end of the longest.

    Nothing is smeared: every knot of every schedule is a knot, and each polynomial is shifted to its new start.
    """
    if not schedules:
        return MergedSchedule(np.array([0.0, 1.0]), np.zeros((1, 0, 1)))
    end = max(float(schedule.knots[-1]) for schedule in schedules)
    whole = [schedule.until(end) if schedule.knots[-1] < end else schedule for schedule in schedules]
    knots = _common_knots(np.concatenate([schedule.knots for schedule in whole]))
    degree = max(schedule.degree for schedule in whole)
    parts = [_on_knots(schedule, knots, degree) for schedule in whole]
    return MergedSchedule(knots, np.stack(parts, axis=1))


def _common_knots(knots: NDArray[np.float64]) -> NDArray[np.float64]:
    knots = np.unique(knots)
    far = np.diff(knots) > SAME * (knots[-1] - knots[0])
    kept = knots[np.concatenate([[True], far])]
    kept[-1] = knots[-1]
    return kept


def _on_knots(schedule: Schedule, knots: NDArray[np.float64], degree: int) -> NDArray[np.float64]:
    """Coefficients (pieces, degree + 1) of the schedule about the starts of new pieces."""
    from math import comb

    rows = schedule.rows_at((knots[:-1] + knots[1:]) / 2)
    shift, old = knots[:-1] - rows[:, 0], rows[:, 1:]
    shift = np.where(np.abs(shift) <= SAME * (knots[-1] - knots[0]), 0.0, shift)
    new = np.zeros((len(old), degree + 1))
    for power in range(old.shape[1]):
        for lower in range(power + 1):
            new[:, lower] += comb(power, lower) * old[:, power] * shift ** (power - lower)
    return new
