"""Motions in time as pieces of polynomials: exact, and every jump is known to the integrators.

One signal is a :class:`SignalPieces`; compiled loops read many on common knots, one row of coefficients for each piece.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError
from tmodes.kinds.noted.functions import array, by_size, highest, maximum, number, place, polynomial_derivative, zeros
from tmodes.kinds.noted.number import Lost, is_noted, plain_value

__all__ = [
    "SAME", "Clock", "Jolts", "MergedSchedule", "SignalPieces", "merge", "merge_cases", "on_knots", "shifted",
]  # fmt: skip


@dataclass(frozen=True)
class SignalPieces:
    """Piecewise polynomials of time.

    ``knots`` [s], shape (pieces + 1,), rising; ``coefficients``, shape (pieces, degree + 1), of powers of
    ``t - knots[k]``. Integrators end their steps exactly on the knots, so nothing is smeared over a jump.
    """

    knots: NDArray[np.float64]
    coefficients: NDArray[np.float64]

    @property
    def duration(self) -> float:
        """Length of the schedule [s]."""
        return number(self.knots[-1] - self.knots[0])

    @property
    def degree(self) -> int:
        """Degree of the polynomials."""
        return self.coefficients.shape[1] - 1

    def at(self, time: ArrayLike, derivative: int = 0) -> NDArray[np.float64]:
        """The value, or its ``derivative``-th derivative, at each time [s]; at a jump, the later piece counts."""
        time = array(time)
        piece = self._piece(time)
        tau = time - self.knots[piece]
        powers = polynomial_derivative(self.coefficients, derivative, axis=1)
        value = zeros(time.shape, tau, self.coefficients)
        for column in powers.T[::-1]:
            value = value * tau + column[piece]
        return value

    def rows_at(self, time: ArrayLike) -> NDArray[np.float64]:
        """Start and coefficients of the piece at each time [s], shape (n, degree + 2): what compiled code reads."""
        piece = self._piece(array(time))
        return np.column_stack([self.knots[piece], self.coefficients[piece]])

    def _piece(self, time: NDArray[np.float64]) -> NDArray[np.intp]:
        return np.clip(place(self.knots, time, "right") - 1, 0, len(self.coefficients) - 1)

    @property
    def is_noted(self) -> bool:
        """Whether any number is noted."""
        return is_noted(self.knots) or is_noted(self.coefficients)

    def plain(self) -> SignalPieces:
        """The same with the values of noted numbers; itself where none is."""
        if not self.is_noted:
            return self
        return SignalPieces(*(np.vectorize(plain_value, [float])(part) for part in (self.knots, self.coefficients)))

    def jumps(self) -> NDArray[np.float64]:
        """The times at which its value jumps [s], between its ends."""
        return self.knots[1:-1][MergedSchedule(self.knots, self.coefficients[:, None, :]).gaps()[1][:, 0]]

    def until(self, end: float) -> SignalPieces:
        """The same motion from its start to ``end`` [s]: cut short, or held in its last position."""
        kept = self.knots[:-1] < end
        knots, pieces = self.knots[:-1][kept], self.coefficients[kept]
        if end > self.knots[-1]:
            rest = zeros((1, self.degree + 1), self.coefficients, self.knots)
            rest[0, 0] = number(self.at(self.knots[-1]))
            knots, pieces = np.append(knots, self.knots[-1]), np.vstack([pieces, rest])
        return SignalPieces(np.append(knots, end), pieces)

    def slope(self, knots: NDArray[np.float64], coefficients: NDArray[np.float64], end: float) -> SignalPieces:
        """The derivative of the motion up to ``end`` [s] by a number, at fixed times, from those of its own numbers.

        It is a signal too; where a knot moves at which this one jumps, it lacks the impulse.
        """
        moved, rates = coefficients.copy(), polynomial_derivative(self.coefficients, 1, axis=1)
        moved[:, : self.degree] -= knots[:-1, None] * rates[:, : self.degree]
        found = SignalPieces(self.knots, moved).until(end)
        if end > self.knots[-1]:  # where the motion stays
            found.coefficients[-1, 0] += self.at(self.knots[-1], 1) * knots[-1]
        return found

    def since(self, begin: float) -> SignalPieces:
        """The same motion from ``begin`` [s] on, which becomes its time 0."""
        later = self.knots[self.knots > begin + SAME * self.duration]
        knots = np.concatenate([[begin], later if len(later) else [begin + self.duration]])
        return SignalPieces(knots - begin, on_knots(self, knots, self.degree))


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
        piece = np.clip(place(self.knots, time, "right") - 1, 0, len(self.coefficients) - 1)
        tau = (time - self.knots[piece])[..., None]
        powers = polynomial_derivative(self.coefficients, derivative, axis=2)
        value = zeros((*time.shape, self.coefficients.shape[1]), self.coefficients, tau)
        for column in np.moveaxis(powers, 2, 0)[::-1]:
            value = value * tau + column[piece]
        return value

    def gaps(self, derivative: int = 0) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        """By how much each value, or derivative, jumps at inner knots (knots, signals), and where that is no rounding.

        What counts is measured by the largest position, or rate, within the pieces: at its ends a move may be at rest.
        """
        lengths = np.diff(self.knots)
        orders = [polynomial_derivative(self.coefficients, order, axis=2) for order in range(derivative + 1)]
        sizes = zeros(self.coefficients.shape[1], self.coefficients)
        for powers in orders:
            sizes = maximum(_largest(powers, lengths), sizes * _SLOW / (self.knots[-1] - self.knots[0]))
        gaps = orders[-1][1:, :, 0] - _values(orders[-1], lengths)[:-1]
        return gaps, np.abs(gaps) > _SAME_VALUE * sizes

    def halved(self) -> MergedSchedule:
        """The same signals with a knot in the middle of each piece too."""
        lengths = np.diff(self.knots)
        later = shifted(self.coefficients, np.broadcast_to(lengths[:, None] / 2, self.coefficients.shape[:2]))
        knots = np.append(np.column_stack([self.knots[:-1], self.knots[:-1] + lengths / 2]).ravel(), self.knots[-1])
        pieces = np.stack([self.coefficients, later], axis=1)
        return MergedSchedule(knots, pieces.reshape(2 * len(lengths), *self.coefficients.shape[1:]))

    @property
    def schedule(self) -> SignalPieces:
        """All in one row for each piece, as compiled code reads them."""
        return SignalPieces(self.knots, self.coefficients.reshape(len(self.coefficients), -1))


_SAME_VALUE = 1e-6
"""A jump smaller than this share of the largest value is rounding of a fitted signal."""

_SLOW = 1e-3
"""Largest rate times the time of the run, over the largest position, below which a rate may be nothing but rounding:
a formula is fitted to 1e-12 of its value by at least 16 pieces of degree 7, its rate so to about 1e-9."""


def _largest(powers: NDArray[np.float64], lengths: NDArray[np.float64]) -> NDArray[np.float64]:
    """Magnitudes (signals,) of polynomials within their pieces; 0 only where all of them vanish."""
    shares = np.linspace(0.0, 1.0, powers.shape[2] + 1)
    return highest(np.array([highest(np.abs(_values(powers, share * lengths)), 0) for share in shares]), 0)


def _values(powers: NDArray[np.float64], times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Polynomials (pieces, signals, degree + 1) at a time [s] (pieces,) after the start of each piece."""
    values = zeros(powers.shape[:2], powers, times)
    for k in reversed(range(powers.shape[2])):
        values = values * times[:, None] + powers[:, :, k]
    return values


def merge(schedules: Sequence[SignalPieces]) -> MergedSchedule:
    """The schedules on all their knots, each held in its last value up to the end of the longest.

    Nothing is smeared: every knot of every schedule is a knot, and each polynomial is shifted to its new start.
    """
    if not schedules:
        return MergedSchedule(np.array([0.0, 1.0]), np.zeros((1, 0, 1)))
    end = max(number(schedule.knots[-1]) for schedule in schedules)
    whole = [schedule.until(end) if schedule.knots[-1] < end else schedule for schedule in schedules]
    knots = _common_knots(np.concatenate([schedule.knots for schedule in whole]))
    degree = max(schedule.degree for schedule in whole)
    parts = [on_knots(schedule, knots, degree) for schedule in whole]
    return MergedSchedule(knots, np.stack(parts, axis=1))


def merge_cases(parts: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]]) -> list[SignalPieces]:
    """The rows of :func:`merge` of n cases at once, bitwise; of each signal its knots (n, k) and pieces (n, k - 1, m).

    Cases whose knots come in the same order, and coincide alike, are merged together.
    """
    knots = np.concatenate([own for own, _ in parts], axis=1)
    order = np.argsort(knots, axis=1, kind="stable")
    rising = np.take_along_axis(knots, order, axis=1)
    apart = np.diff(rising, axis=1) > SAME * (rising[:, -1:] - rising[:, :1])
    _, first, groups = np.unique(np.column_stack([order, apart]), axis=0, return_index=True, return_inverse=True)
    found: list[SignalPieces] = [SignalPieces(knots[0], knots[:0])] * len(knots)
    for group in range(len(first)):
        which = np.flatnonzero(groups.ravel() == group)
        if len(which) == 1 or any((own[which, -1] != rising[which, -1]).any() for own, _ in parts):
            for k in which.tolist():
                found[k] = merge([SignalPieces(own[k], pieces[k]) for own, pieces in parts]).schedule
            continue
        common = rising[which][:, np.append(True, apart[which[0]])]
        common[:, -1] = rising[which, -1]
        for k, own, rows in zip(which.tolist(), common, _merged_alike(parts, which, common), strict=True):
            found[k] = SignalPieces(own, rows)
    return found


def _merged_alike(
    parts: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]],
    which: NDArray[np.intp],
    knots: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Rows (m, k - 1, numbers) on common ``knots`` (m, k) of cases of one order of knots."""
    degree = max(pieces.shape[2] for _, pieces in parts) - 1
    middle, size = (knots[:, :-1] + knots[:, 1:]) / 2, np.ptp(knots, axis=1)[:, None]
    rows = []
    for own, pieces in parts:
        starts = own[which]
        piece = np.clip((starts[:, None, :] <= middle[:, :, None]).sum(axis=2) - 1, 0, pieces.shape[1] - 1)
        shift = knots[:, :-1] - np.take_along_axis(starts, piece, axis=1)
        powers = np.take_along_axis(pieces[which], piece[:, :, None], axis=1)
        moved = shifted(powers, np.where(np.abs(shift) <= SAME * size, 0.0, shift))
        rows.append(np.pad(moved, [(0, 0), (0, 0), (0, degree + 1 - moved.shape[2])]))
    return np.stack(rows, axis=2).reshape(len(which), knots.shape[1] - 1, -1)


def _common_knots(knots: NDArray[np.float64]) -> NDArray[np.float64]:
    knots = np.unique(knots)
    far = np.diff(knots) > SAME * (knots[-1] - knots[0])
    kept = knots[np.concatenate([[True], far])]
    kept[-1] = knots[-1]
    return kept


def on_knots(schedule: SignalPieces, knots: NDArray[np.float64], degree: int) -> NDArray[np.float64]:
    """Coefficients (pieces, degree + 1) of the schedule about the starts of new pieces, whose ends are ``knots``."""
    rows = schedule.rows_at((knots[:-1] + knots[1:]) / 2)
    shift = knots[:-1] - rows[:, 0]
    new = zeros((len(rows), degree + 1), rows, knots)
    new[:, : rows.shape[1] - 1] = shifted(rows[:, 1:], np.where(np.abs(shift) <= SAME * np.ptp(knots), 0.0, shift))
    return new


def shifted(powers: NDArray[np.float64], shift: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coefficients (..., degree + 1) about times later by ``shift`` (...) [s]."""
    new = zeros(powers.shape, powers, shift)
    for power in range(powers.shape[-1]):
        for lower in range(power + 1):
            new[..., lower] += comb(power, lower) * powers[..., power] * shift ** (power - lower)
    return new


MOST_SAMPLES = 1_000_000

_SAME = 1e-9
"""A sample nearer to a time of the output than this share of the output step is taken at that time."""


@dataclass(frozen=True)
class Clock:
    """A saw tooth that is exactly 0 at each sample and rises by 1 s/s; ``output_step`` [s] of the run.

    ``after``: of instants that come so much later than each sample [s]; before the first it is positive.
    """

    period: float
    output_step: float
    after: float = 0.0
    is_clock: ClassVar[bool] = True

    def schedule(self, until: float) -> SignalPieces:
        """A piece from each sample to the next, up to ``until`` [s].

        Raises :class:`tmodes.errors.InputError` for more than a million samples.
        """
        starts = self.samples(until)
        pieces = np.tile([0.0, 1.0], (len(starts), 1))
        if self.after > 0:
            starts, pieces = np.append(0.0, starts), np.vstack([[1.0, 0.0], pieces])
        return SignalPieces(np.append(starts, until), pieces)

    def samples(self, until: float) -> NDArray[np.float64]:
        """The instants before ``until`` [s]; raises as :meth:`schedule`."""
        if is_noted(self.period):
            raise Lost("samples on the instants of the output are structure", self.period)
        count = int(np.ceil(until / self.period * (1 - 1e-12)))
        if count > MOST_SAMPLES:
            got, most = f"{self.period:g} s, {count} samples in {until:g} s", f"at most {MOST_SAMPLES} samples"
            raise InputError("sample_time", got, most, "sample less often, or shorten the run")
        times = self.period * np.arange(count) + self.after
        times = times[times < until]
        shown = np.round(times / self.output_step) * self.output_step
        return np.where(np.abs(times - shown) < _SAME * self.output_step, shown, times)

    def move_ends(self, reach: float = 1.0) -> float | None:
        """Never."""
        del reach


_BEGIN = 1.0
"""How long from its start a motion is looked at [s], whatever the run's time."""


@dataclass(frozen=True)
class Jolts:
    """The jumps of a signal's rate, as a signal of their own.

    From each jump to the next it is a line that is exactly 0 at the jump and whose slope is by how much the rate jumps.
    ``from_rest``: what the signal moves stands still before time 0, so that its first rate is a jump too.
    """

    signal: Any
    from_rest: bool

    def schedule(self, until: float) -> SignalPieces:
        """A piece from each jump to the next, up to ``until`` [s]."""
        moved = self.signal.schedule(until).until(until)
        gaps, counts = MergedSchedule(moved.knots, moved.coefficients[:, None, :]).gaps(1)
        kept = counts[:, 0]
        times, slopes = moved.knots[1:-1][kept], np.concatenate([[self._first(moved)], gaps[kept, 0]])
        return SignalPieces(np.concatenate([[0.0], times, [until]]), np.column_stack([0 * slopes, slopes]))

    def _first(self, moved: SignalPieces) -> float:
        """By how much the rate jumps at time 0; zero where it is rounding."""
        if not self.from_rest:
            return 0.0
        try:
            begin = self.signal.schedule(_BEGIN)
        except InputError:  # it has no value at its end
            begin = moved
        rates = polynomial_derivative(begin.coefficients[:, None, :], 1, axis=2)
        first, largest = number(moved.at(0.0, 1)), number(_largest(rates, np.diff(begin.knots))[0])
        return first if abs(first) > _SAME_VALUE * largest else 0.0

    def jump(self, until: float) -> bool:
        """Whether any is there."""
        return any(by_size(self.schedule(until).coefficients))

    def move_ends(self, reach: float = 1.0) -> float | None:
        """Never."""
        del reach
