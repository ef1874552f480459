"""Any smooth function of time as pieces of polynomials of degree 7, to 12 digits: interpolation at Chebyshev points."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, partial
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.kinds.noted.functions import ceil, highest, isfinite, maximum, number, sin
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.kinds.signals.switches import Switch

__all__ = ["DEGREE", "MOST_PIECES", "fitted", "fitted_sine"]

Array = NDArray[np.float64]

DEGREE = 7
MOST_PIECES = 100_000
TOLERANCE = 1e-12
"""Largest error over the largest magnitude of the function [-]."""

SMALLEST_SHARE = 2.0**-40
"""Share of the whole time below which a piece is not halved any more: what it still hides is a kink or a jump."""

JUMP = 1e-6
"""Change over such a piece, over the largest magnitude, from which it is a jump [-]."""

ROUND_OFF = 16 * np.finfo(float).eps


def fitted(
    function: Callable[[Array], Array], until: float, which: str = "expression", switches: Sequence[Switch] = ()
) -> SignalPieces:
    """The function from 0 to ``until`` [s]: pieces are halved until each holds 12 digits (of the largest value).

    It has knots on ``switches``, where it may jump. Raises :class:`tmodes.errors.InputError` where it has no finite
    value, where it jumps elsewhere, and where it needs more than :data:`MOST_PIECES` pieces.
    """
    looked = np.append(np.linspace(0.0, until, 1001), [time for each in switches for time in (each.before, each.after)])
    scale = maximum(number(highest(np.abs(_finite(function, looked, which)))), 1e-300)
    inner = [each for each in switches if SMALLEST_SHARE < each.time / until < 1 - SMALLEST_SHARE]
    edges = [0.0, *(each.time for each in inner), until]
    first = max([each.after for each in switches if each.time <= SMALLEST_SHARE * until], default=0.0)
    last = min([each.before for each in switches if each.time >= (1 - SMALLEST_SHARE) * until], default=until)
    ends = zip([first, *(each.after for each in inner)], [*(each.before for each in inner), last], strict=True)
    done: list[tuple[Array, Array]] = []
    for (start, end), (low, high) in zip(pairwise(edges), ends, strict=True):
        within = partial(_clipped, function, low, high)
        done += _pieces(within, np.array([start, end]), scale, which, until, sum(len(part) for part, _ in done))
    knots = np.concatenate([part for part, _ in done])
    order = np.argsort(knots)
    return SignalPieces(np.append(knots[order], until), np.concatenate([part for _, part in done])[order])


def _clipped(function: Callable[[Array], Array], low: float, high: float, times: Array) -> Array:
    """A function between two switches, whose rounding does not count."""
    return function(np.clip(times, low, high))


def _pieces(
    function: Callable[[Array], Array], ends: Array, scale: float, which: str, until: float, count: int
) -> list[tuple[Array, Array]]:
    """Starts and coefficients of the pieces between two switches; there are ``count`` before."""
    edges = np.linspace(ends[0], ends[1], int(np.ceil(16 * (ends[1] - ends[0]) / until)) + 1)
    starts, widths = edges[:-1], np.diff(edges)
    done: list[tuple[Array, Array]] = []
    while len(starts):
        coefficients, errors, allowed = _tried(function, starts, widths, scale, which)
        tiny = widths <= SMALLEST_SHARE * until
        _refuse_jumps(function, starts[tiny], widths[tiny], scale, which)
        good = (errors <= allowed) | tiny
        done.append((starts[good], coefficients[good]))
        count += int(good.sum())
        if count + 2 * int((~good).sum()) > MOST_PIECES:
            raise _too_many(which, until)
        half = widths[~good] / 2
        starts, widths = np.concatenate([starts[~good], starts[~good] + half]), np.concatenate([half, half])
    return done


def fitted_sine(amplitude: float, frequency: float, phase: float, offset: float, until: float) -> SignalPieces:
    """The wave offset + amplitude sin(2 pi frequency t + phase), frequency [Hz], from 0 to ``until`` [s].

    A piece is 0.4 rad long: the interpolation's error is (0.4 rad)^8/(8! 2^15) = 5e-13.
    """
    omega = 2 * np.pi * frequency
    count = max(1, ceil(omega * until / 0.4))
    if count > MOST_PIECES:
        raise _too_many("sine", until)
    knots = np.linspace(0.0, until, count + 1)
    widths = np.diff(knots)
    times = omega * (knots[:-1, None] + widths[:, None] * _points()) + phase
    coefficients = amplitude * _powers(sin(times))
    coefficients = np.column_stack([coefficients[:, :1] + offset, coefficients[:, 1:]])
    return SignalPieces(knots, coefficients / widths[:, None] ** np.arange(DEGREE + 1))


@cache
def _points() -> Array:
    """Chebyshev points on 0..1."""
    return (1 - np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))) / 2


@cache
def _tables() -> tuple[Array, Array]:
    """Matrices from values at the points to coefficients of Chebyshev polynomials on 0..1, and from these to powers."""
    from numpy.polynomial import Chebyshev, Polynomial

    waves = [Chebyshev.basis(k, domain=(0, 1)) for k in range(DEGREE + 1)]
    weights = np.full((DEGREE + 1, 1), 2 / (DEGREE + 1))
    weights[0] /= 2
    columns = [wave.convert(kind=Polynomial).coef for wave in waves]
    powers = np.array([np.pad(column, (0, DEGREE + 1 - len(column))) for column in columns], dtype=float).T
    return weights * np.array([wave(_points()) for wave in waves]), powers


def _powers(values: Array) -> Array:
    """Coefficients of powers on 0..1 from values at the points, shape (pieces, degree + 1).

    In two steps: the product of both matrices has large entries, which would cost four digits.
    """
    to_waves, to_powers = _tables()
    return (values @ to_waves.T) @ to_powers.T


def _tried(
    function: Callable[[Array], Array], starts: Array, widths: Array, scale: float, which: str
) -> tuple[Array, Array, Array]:
    """Coefficients of each piece, its error between the points, and the error that is allowed."""
    values = _finite(function, starts[:, None] + widths[:, None] * _points(), which)
    unit = _powers(values)
    between = np.array([0.0, *(_points()[:-1] + _points()[1:]) / 2, 1.0])
    exact = _finite(function, starts[:, None] + widths[:, None] * between, which)
    error = highest(np.abs(unit @ between[None, :] ** np.arange(DEGREE + 1)[:, None] - exact), axis=1)
    slope = highest(np.abs(np.diff(values, axis=1) / np.diff(_points())), axis=1) / widths
    allowed = TOLERANCE * scale + ROUND_OFF * slope * (starts + widths)
    return unit / widths[:, None] ** np.arange(DEGREE + 1), error, allowed


def _refuse_jumps(function: Callable[[Array], Array], starts: Array, widths: Array, scale: float, which: str) -> None:
    """A kink is continuous: over a piece this small it changes nothing. A jump does."""
    if not len(starts):
        return
    change = np.abs(_finite(function, starts + widths, which) - _finite(function, starts, which))
    if (change > JUMP * scale).any():
        where = starts[int(np.argmax(change))]
        hint = "write a step, or a table with the same time twice"
        raise InputError(which, f"a jump at t = {where:.9g} s", "a continuous function of time", hint)


def _finite(function: Callable[[Array], Array], times: Array, which: str) -> Array:
    values = function(times)
    wrong = ~isfinite(values)
    if wrong.any():
        got = f"no finite value at t = {float(times[wrong][0]):.9g} s"
        raise InputError(which, got, "a finite number at every time of the run", "change the formula, or the duration")
    return values


def _too_many(which: str, until: float) -> InputError:
    got = f"a function that needs more than {MOST_PIECES} pieces in {until:g} s"
    return InputError(which, got, f"at most {MOST_PIECES} pieces", "lower its frequency, or shorten the run")
