"""Motions in time as pieces of polynomials: exact, and every jump is known to the integrators.

One signal is a :class:`Schedule`; compiled loops read many on common knots, one row of coefficients for each piece.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError

__all__ = ["Clock", "MergedSchedule", "Schedule", "merge"]


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

    def halved(self) -> MergedSchedule:
        """The same signals with a knot in the middle of each piece too."""
        lengths = np.diff(self.knots)
        later = _shifted(self.coefficients, np.broadcast_to(lengths[:, None] / 2, self.coefficients.shape[:2]))
        knots = np.append(np.column_stack([self.knots[:-1], self.knots[:-1] + lengths / 2]).ravel(), self.knots[-1])
        pieces = np.stack([self.coefficients, later], axis=1)
        return MergedSchedule(knots, pieces.reshape(2 * len(lengths), *self.coefficients.shape[1:]))

    @property
    def schedule(self) -> Schedule:
        """All in one row for each piece, as compiled code reads them."""
        return Schedule(self.knots, self.coefficients.reshape(len(self.coefficients), -1))


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
    rows = schedule.rows_at((knots[:-1] + knots[1:]) / 2)
    shift = knots[:-1] - rows[:, 0]
    new = np.zeros((len(rows), degree + 1))
    new[:, : rows.shape[1] - 1] = _shifted(rows[:, 1:], np.where(np.abs(shift) <= SAME * np.ptp(knots), 0.0, shift))
    return new


def _shifted(powers: NDArray[np.float64], shift: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coefficients (..., degree + 1) about times later by ``shift`` (...) [s]."""
    new = np.zeros_like(powers)
    for power in range(powers.shape[-1]):
        for lower in range(power + 1):
            new[..., lower] += comb(power, lower) * powers[..., power] * shift ** (power - lower)
    return new


MOST_SAMPLES = 1_000_000

_SAME = 1e-9
"""A sample nearer to a time of the output than this share of the output step is taken at that time."""


@dataclass(frozen=True)
class Clock:
    """A saw tooth that is exactly 0 at each sample and rises by 1 s/s; ``output_step`` [s] of the run."""

    period: float
    output_step: float

    def schedule(self, until: float) -> Schedule:
        """A piece from each sample to the next, up to ``until`` [s].

        Raises :class:`tmodes.errors.InputError` for more than a million samples.
        """
        count = int(np.ceil(until / self.period * (1 - 1e-12)))
        if count > MOST_SAMPLES:
            got, most = f"{self.period:g} s, {count} samples in {until:g} s", f"at most {MOST_SAMPLES} samples"
            raise InputError("sample_time", got, most, "sample less often, or shorten the run")
        times = self.period * np.arange(count)
        shown = np.round(times / self.output_step) * self.output_step
        starts = np.where(np.abs(times - shown) < _SAME * self.output_step, shown, times)
        return Schedule(np.append(starts, until), np.tile([0.0, 1.0], (count, 1)))

    def move_ends(self, reach: float = 1.0) -> float | None:
        """Never."""
        del reach
