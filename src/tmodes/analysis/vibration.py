"""A motion that comes to rest: its slow part, the vibrations about it by mode, and when it stays within a band.

Samples are taken as a sum of decaying exponentials, whose rates follow from a matrix pencil (Hua & Sarkar, IEEE
Transactions on Acoustics, Speech, and Signal Processing 38, 1990) of all axes together: what rings is vibration, what
does not is the slowly moving mean.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["FEWEST", "Mode", "Residual", "residual_vibration", "settled_after"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

FEWEST = 24
"""Samples without which no vibration is separated."""

_MOST_SAMPLES, _MOST_TERMS = 600, 40

_RANKS = 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8
"""Singular values over the largest below which there is no further exponential: as few of them as are right."""

_RINGS = 0.4
"""Damping ratio from which on a motion creeps rather than rings."""

_WRONG, _NOTHING = 0.01, 1e-4
"""Error of the sum (rms), over the vibration, and over the whole motion, from which on it is not trusted."""

_CANCELS = 3.0
"""Sum of the modes' amplitudes over the largest vibration: above it they cancel, and none is real."""

_STRONG = 1e-3
"""Amplitude over the largest above which a frequency must be sampled well."""


class Mode(NamedTuple):
    """``amplitude`` at the start: the largest distance from the mean during a turn, without its decay."""

    frequency_Hz: float
    damping_ratio: float
    amplitude: float


class Residual(NamedTuple):
    """``amplitude`` of the vibration at the start, that of its modes together; None, with a ``reason``, if unknown."""

    amplitude: float | None
    modes: tuple[Mode, ...] = ()
    reason: str = ""


def settled_after(times: Array, values: Array, rest: ArrayLike, limit: float, since: float) -> float | None:
    """Time [s] after ``since`` from which on ``values`` (n, k) stay within ``limit`` of ``rest``; None: not seen.

    Between samples the distance is taken as a straight line.
    """
    far = np.linalg.norm(values - np.asarray(rest), axis=1)
    outside = np.flatnonzero((far > limit) & (times >= since * (1 - 1e-12)))
    if not len(outside):
        return 0.0
    last = int(outside[-1])
    if last == len(times) - 1:
        return None
    share = (far[last] - limit) / (far[last] - far[last + 1])
    return float(times[last] + share * (times[last + 1] - times[last]) - since)


def residual_vibration(times: Array, values: Array, since: float | None = None) -> Residual:
    """The vibration in evenly spaced samples ``values`` (n, k) of a motion that nothing drives; at ``since`` [s]."""
    if len(times) < FEWEST:
        return Residual(None, (), "the run ends with the move")
    start = float(times[0]) if since is None else since
    kept = slice(0, None, _stride(times, values))
    t, y = times[kept][:_MOST_SAMPLES] - start, values[kept][:_MOST_SAMPLES]
    y = y - y.mean(axis=0)
    size = float(np.abs(y).max())
    if size <= 1e-12:
        return Residual(0.0)
    windows = _shapes(y)
    for rank in _RANKS:
        poles = _poles(*windows, float(t[1] - t[0]), rank)
        if poles is not None and (found := _checked(t, y, size, poles)):
            return found
    return Residual(None, (), "the motion after the move is not a sum of decaying vibrations")


def _stride(times: Array, values: Array) -> int:
    """Which samples are enough: a fourth of their rate is above all that vibrates."""
    count, step = len(times), float(times[1] - times[0])
    if count <= _MOST_SAMPLES:
        return 1
    window = np.hanning(count)[:, None]
    amplitude = np.abs(np.fft.rfft((values - values.mean(axis=0)) * window, axis=0)).max(axis=1)
    highest = np.fft.rfftfreq(count, step)[amplitude > _STRONG * amplitude.max()].max(initial=1.0 / (count * step))
    return max(1, min(-(-count // _MOST_SAMPLES), int(1.0 / (4.0 * highest * step))))


def _shapes(values: Array) -> tuple[Array, Array, int]:
    """Singular values and vectors of all windows of samples (n, k), and the length of a window."""
    width = len(values) // 3
    windows = np.lib.stride_tricks.sliding_window_view(values, width, axis=0)  # (n - width + 1, k, width)
    _, sizes, shapes = np.linalg.svd(windows.reshape(len(windows), -1), full_matrices=False)
    return sizes, shapes, width


def _poles(sizes: Array, shapes: Array, width: int, step: float, rank: float) -> Complex | None:
    """The rates [1/s] of the exponentials; None where there are too many for the samples."""
    terms = int((sizes > rank * sizes[0]).sum())
    if not 0 < terms <= min(_MOST_TERMS, width - 1):
        return None
    held = shapes[:terms].T.reshape(-1, width, terms)
    before, after = (part.reshape(-1, terms) for part in (held[:, :-1], held[:, 1:]))
    factors: Any = np.linalg.eigvals(np.linalg.lstsq(before, after, rcond=None)[0]).astype(complex)
    factors = factors[np.abs(factors) > 1e-12]
    return np.log(factors) / step if len(factors) else None


def _checked(t: Array, y: Array, size: float, poles: Complex) -> Residual | None:
    """The vibration by these rates; None where their sum is not the motion."""
    length = float(t[-1] - t[0])
    poles = (np.minimum(poles.real, 1.0 / length) + 1j * poles.imag).astype(complex)
    basis = np.exp(np.outer(t, poles))
    parts: Any = np.linalg.lstsq(basis, y.astype(complex), rcond=None)[0]  # (terms, k)
    wrong = float(np.sqrt(np.mean(np.sum(np.abs(basis @ parts - y) ** 2, axis=1))))
    turns = np.abs(poles.imag) * length / (2 * np.pi)
    rings = (turns > 0) & (-poles.real < _RINGS * np.abs(poles))
    slow = rings & (turns < 1.0)
    vibration = float(np.linalg.norm((basis[:, rings & ~slow] @ parts[rings & ~slow]).real, axis=1).max(initial=0.0))
    if wrong > max(_WRONG * vibration, _NOTHING * size):
        return None
    creeping = [_mode(poles[k], parts[k]).amplitude for k in np.flatnonzero(slow & (poles.imag > 0))]
    modes = tuple(sorted((_mode(poles[k], parts[k]) for k in np.flatnonzero(rings & ~slow & (poles.imag > 0))),
                         key=lambda mode: -mode.amplitude))  # fmt: skip
    modes = tuple(mode for mode in modes if mode.amplitude > max(wrong, 1e-9 * size))
    total = sum(mode.amplitude for mode in modes)
    if total > _CANCELS * max(vibration, wrong):
        return None
    if max(creeping, default=0.0) > max(total, wrong, _NOTHING * size):
        return Residual(None, (), "less than one period of the vibration is seen after the move: simulate longer")
    return Residual(total, modes)


def _mode(pole: complex, part: Complex) -> Mode:
    """Of one of a pair; its place is twice the real part of ``part`` turning, an ellipse."""
    largest = np.sqrt(2 * (np.vdot(part, part).real + abs(np.sum(part * part))))
    return Mode(float(pole.imag / (2 * np.pi)), float(-pole.real / abs(pole)), float(largest))
