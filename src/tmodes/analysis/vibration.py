"""A motion that comes to rest: its slow part, the vibrations about it by mode, and when it stays within a band.

Samples are taken as a sum of decaying exponentials, whose rates follow from a matrix pencil (Hua & Sarkar, IEEE
Transactions on Acoustics, Speech, and Signal Processing 38, 1990) of all axes together: what rings is vibration, what
does not is the slowly moving mean. Single exponentials of a vibration that is not quite linear cancel, their sum does
not: its size is that of the sum, and those of about the same frequency are one mode.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "AT_REST",
    "FEWEST",
    "RINGS",
    "STANDS",
    "Oscillation",
    "Residual",
    "are_coarse",
    "farthest",
    "fitted",
    "residual_vibration",
    "settled_after",
]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

AT_REST, STANDS = "at rest", 1e-9
"""Said of a point that does not move; travel over its distance from the origin up to which that is so."""

FEWEST = 24
"""Samples without which no vibration is separated."""

_MOST_SAMPLES, _MOST_TERMS = 600, 40

_RANKS = 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8
"""Singular values over the largest below which there is no further exponential: as few of them as are right."""

RINGS = 0.4
"""Damping ratio from which on a motion creeps rather than rings."""

_WRONG, _NOTHING = (1e-3, 0.01), 1e-4
"""Error of the sum (rms), over the vibration, that is wanted and that is taken; over the whole motion, negligible."""

_WINDOWS = 1, 2, 4, 8
"""Parts of the samples that are looked at, until one is such a sum: frequencies drift with the size."""

_NEAR = 0.05
"""Difference of two frequencies over the larger one up to which they are one mode."""

_WEIGHTY = 0.3
"""Envelope over its largest value up to which a vibration counts where modes are weighed against each other."""

_DRIFTS = 0.01
"""Change of a frequency over itself from which on it is said."""

_PERIODIC = 0.5
"""Share of a spectrum about its peak from which on a motion that is no sum of exponentials has a period."""

_BETWEEN, _SMALL, _PLACES = 1e-3, 0.1, 65
"""Error between samples over the distance from rest, from which on finer ones are taken; least such distance over the
band; places between two samples at which a largest distance is looked for."""

_STRONG = 1e-3
"""Amplitude over the largest above which a frequency must be sampled well."""


class Oscillation(NamedTuple):
    """A vibration of about one frequency.

    ``amplitude``: its largest envelope, the distance from the mean within a turn; ``share`` of the energies
    (squares of distances) of all modes and of what they leave unexplained together;
    ``drift``: frequency [Hz] in its first and its last turn, where these differ; ``poles`` [1/s] that it is made of.
    """

    frequency_Hz: float
    damping_ratio: float
    amplitude: float
    share: float = 1.0
    drift: tuple[float, float] | None = None
    poles: tuple[complex, ...] = ()


class Residual(NamedTuple):
    """A vibration, about the slowly moving mean.

    ``amplitude``: the largest value of its envelope, never more than the range of the motion; None, with a ``reason``,
    where it is not known. ``largest``: the largest distance from the mean that is seen, at ``time``, and ``along`` (k,)
    the axes. ``unexplained``: share that the modes do not have. ``slow``: poles [1/s] of the mean, ``span`` [s]: time
    after the start in which this is so.
    """

    amplitude: float | None
    modes: tuple[Oscillation, ...] = ()
    reason: str = ""
    largest: float = 0.0
    time: float = 0.0
    along: tuple[float, ...] = ()
    unexplained: float = 0.0
    slow: tuple[complex, ...] = ()
    span: float = 0.0


def settled_after(
    times: Array, values: Array, rest: ArrayLike, limit: float, since: float, rates: Array | None = None
) -> float | None:
    """Time [s] after ``since`` from which on ``values`` (n, k) stay within ``limit`` of ``rest``; None: not seen.

    Between samples the motion is the cubic of both values and their ``rates`` (n, k), whose last exit is found exactly;
    where no rates are given they are those of the samples themselves.
    """
    pieces, bounds = _cubics(times, values - np.asarray(rest), rates)
    if np.linalg.norm(values[-1] - np.asarray(rest)) > limit:
        return None
    for k in np.flatnonzero((bounds > limit) & (times[1:] > since * (1 + 1e-12)))[::-1]:
        far = np.sum([np.convolve(one, one) for one in pieces[::-1, k].T], axis=0)
        far[-1] -= limit**2
        roots = np.roots(far)
        crossed = roots.real[(np.abs(roots.imag) < 1e-9) & (roots.real <= 1 + 1e-9)].max(initial=-1.0)
        when = float(times[k] + crossed * (times[k + 1] - times[k]) - since)
        if crossed >= -1e-9 and when > 0:
            return when
    return 0.0


def farthest(times: Array, values: Array, rates: Array | None, rest: Array) -> float:
    """The largest distance of such a motion from ``rest``, between samples too."""
    most = float(np.linalg.norm(values - rest, axis=1).max())
    pieces, bounds = _cubics(times, values - rest, rates)
    between = np.linspace(0.0, 1.0, _PLACES)[:, None] ** np.arange(4)
    return float(np.linalg.norm(np.tensordot(between, pieces[:, bounds > most], axes=1), axis=2).max(initial=most))


def _cubics(times: Array, values: Array, rates: Array | None) -> tuple[Array, Array]:
    """Powers (4, n - 1, k) of the share of each interval, and the most that their polynomials can be away from zero."""
    first, last = values[:-1], values[1:]
    slopes: Array = np.asarray(np.gradient(values, times, axis=0) if rates is None else rates)
    left, right = (np.diff(times)[:, None] * some for some in (slopes[:-1], slopes[1:]))
    powers = np.array([first, left, 3 * (last - first) - 2 * left - right, 2 * (first - last) + left + right])
    control = np.array([first, first + left / 3, last - right / 3, last])  # no cubic leaves the hull of these
    return powers, np.linalg.norm(control, axis=2).max(axis=0, initial=0.0)


def are_coarse(times: Array, values: Array, rates: Array, rest: ArrayLike, limit: float) -> bool:
    """Whether the motion between samples is not known to a thousandth of its distance from ``rest``.

    Of distances below a tenth of ``limit``, to that of a tenth. By the error of the cubics that leave out every other
    sample: that of all is a sixteenth of it.
    """
    steps = np.diff(times)
    even = np.abs(steps[1:] - steps[:-1]) < 1e-6 * steps[1:]
    middle = (values[2:] + values[:-2]) / 2 + steps[1:, None] * (rates[:-2] - rates[2:]) / 4
    wrong, far = (np.linalg.norm(one, axis=1)[even] for one in (middle - values[1:-1], values[1:-1] - np.asarray(rest)))
    return bool((wrong / 16 > _BETWEEN * np.maximum(far, _SMALL * limit)).any())


def residual_vibration(times: Array, values: Array, since: float | None = None) -> Residual:
    """The vibration in evenly spaced samples ``values`` (n, k) of a motion that nothing drives, from ``since`` [s] on.

    Of one decaying vibration the amplitude is its envelope at ``since``.
    """
    if len(times) < FEWEST:
        return Residual(None, (), "the run ends with the move")
    start = float(times[0]) if since is None else since
    if np.ptp(values, axis=0).max() <= STANDS * np.abs(values).max():
        return Residual(0.0, (), AT_REST)
    for part in _WINDOWS:
        count = len(times) // part
        if count >= FEWEST and (found := _of_window(times[:count] - start, values[:count])):
            return found
    return _by_period(times - start, values)


def _of_window(times: Array, values: Array) -> Residual | None:
    """The vibration in some samples; None where they are no sum of decaying exponentials."""
    kept = slice(0, None, _stride(times, values))
    t, y = times[kept][:_MOST_SAMPLES], values[kept][:_MOST_SAMPLES]
    y = y - y.mean(axis=0)
    windows = _shapes(y)
    known = [poles for rank in _RANKS if (poles := _poles(*windows, float(t[1] - t[0]), rank)) is not None]
    inside = times <= t[-1]
    whole = times[inside], values[inside] - values[kept][:_MOST_SAMPLES].mean(axis=0)
    sums = (_checked(t, y, poles, wrong, *whole) for wrong in _WRONG for poles in known)
    return next(filter(None, sums), None)


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


def fitted(times: Array, values: Array, poles: Complex) -> Complex:
    """Coefficients (terms, k) of exponentials of these ``poles``, conjugates among them, that make up values (n, k)."""
    basis: Any = np.exp(np.outer(times, poles))
    return np.linalg.lstsq(basis, values.astype(complex), rcond=None)[0]


def _checked(t: Array, y: Array, poles: Complex, limit: float, times: Array, values: Array) -> Residual | None:
    """The vibration by these rates; None where their sum is not the motion ``y`` (n, k), to a share ``limit`` of it.

    ``values``: the same motion at all ``times``.
    """
    length, size = float(t[-1] - t[0]), float(np.abs(y).max())
    poles = (np.minimum(poles.real, 1.0 / length) + 1j * poles.imag).astype(complex)
    parts, basis = fitted(t, y, poles), np.exp(np.outer(t, poles))
    wrong = float(np.sqrt(np.mean(np.sum(np.abs(basis @ parts - y) ** 2, axis=1))))
    rings = (poles.imag != 0) & (-poles.real < RINGS * np.abs(poles))
    fast = rings & (np.abs(poles.imag) * length >= 2 * np.pi)
    apart = y - (basis[:, ~fast] @ parts[~fast]).real
    vibration = float(np.linalg.norm((basis[:, fast] @ parts[fast]).real, axis=1).max(initial=0.0))
    if wrong > max(limit * vibration, _NOTHING * size) or vibration > (width := _diameter(y)):
        return None
    one = np.flatnonzero(fast & (poles.imag > 0))
    signals = _Exponentials(np.append(0.0, t), poles[one], 2 * parts[one])
    amplitude = float(signals.envelope(np.arange(len(one))).max(initial=0.0))
    sizes = 2 * np.linalg.norm(parts, axis=1) * (poles.imag > 0)
    if sizes[rings & ~fast].max(initial=0.0) > max(amplitude, wrong, _NOTHING * size):
        return Residual(None, (), "less than one period of a vibration is seen until it is at rest, or the run ends")
    modes = [
        mode._replace(amplitude=min(mode.amplitude, width))
        for mode in _modes(signals, apart, length, max(wrong, 1e-9 * size))
    ]
    if not modes:
        return Residual(0.0, (), _calm(poles[sizes > _NOTHING * size]), span=length)
    slowly: Any = np.exp(np.outer(times, poles[~fast]))
    seen = values - (slowly @ parts[~fast]).real
    far = np.linalg.norm(seen, axis=1)
    return Residual(
        min(amplitude, width), tuple(modes), "", float(far.max()), float(times[far.argmax()]),
        tuple(map(float, np.abs(seen).max(axis=0))), max(1.0 - sum(mode.share for mode in modes), 0.0),
        tuple(poles[~fast].tolist()), length,
    )  # fmt: skip


def _calm(turning: Complex) -> str:
    """Why nothing rings, in words; ``turning``: poles [1/s] of what turns at all."""
    ratio = float((-turning.real / np.abs(turning)).min(initial=np.inf))
    strongly = f"it is damped too strongly to ring: damping ratio {ratio:.2g}, {RINGS:g} or more"
    return strongly if RINGS <= ratio < 1 else "nothing oscillates about the slowly moving mean"


class _Exponentials(NamedTuple):
    """Turning exponentials: ``poles`` (m,) and ``parts`` (m, k), whose real part is the motion, at ``times`` (n,)."""

    times: Array
    poles: Complex
    parts: Complex

    def of(self, group: NDArray[np.intp], order: int = 0) -> Complex:
        """The sum of some, or its derivative, (n, k)."""
        basis: Any = np.exp(np.outer(self.times, self.poles[group]))
        return basis @ (self.parts[group] * self.poles[group, None] ** order)

    def envelope(self, group: NDArray[np.intp]) -> Array:
        """The largest distance within a turn, without its decay (n,): the end of a turning vector draws an ellipse."""
        turning = self.of(group)
        squares = np.sum(np.abs(turning) ** 2, axis=1) + np.abs(np.sum(turning**2, axis=1))
        return np.sqrt(squares / 2)


def _modes(signals: _Exponentials, apart: Array, length: float, least: float) -> list[Oscillation]:
    """The modes of a vibration whose distances from its mean are ``apart`` (n, k), larger than ``least``."""
    whole = signals.envelope(np.arange(len(signals.poles)))[1:]
    weighty = np.flatnonzero(whole >= _WEIGHTY * whole.max(initial=0.0))
    seen = slice(int(weighty[-1]) + 1 if len(weighty) else len(whole))
    found, left = [], apart[seen].copy()
    for group in _groups(signals.poles, length):
        turning, envelope = signals.of(group), signals.envelope(group)
        if envelope.max() > least:
            weight = np.sum(np.abs(turning) ** 2)
            pole = complex(np.sum(turning.conj() * signals.of(group, 1)) / weight)
            own = turning.real[1:][seen]
            left -= own
            drift = _drift(signals, group, envelope, pole.imag) if len(group) > 1 else None
            poles = tuple(signals.poles[group].tolist())
            found.append(
                Oscillation(
                    pole.imag / (2 * np.pi), -pole.real / abs(pole), float(envelope.max()), np.sum(own**2), drift, poles
                )
            )
    whole = sum(mode.share for mode in found) + np.sum(left**2)
    return sorted((one._replace(share=float(one.share / whole)) for one in found), key=lambda mode: -mode.amplitude)


def _groups(poles: Complex, length: float) -> list[NDArray[np.intp]]:
    """Poles that are one mode: of about one frequency, by its share, by their decay, or by the time that is seen."""
    order = np.argsort(poles.imag)
    sorted_poles = poles[order]
    decay = np.abs(sorted_poles.real[1:]) / 2 + np.abs(sorted_poles.real[:-1]) / 2
    near = np.maximum(np.maximum(_NEAR * sorted_poles.imag[1:], 2 * np.pi / length), decay)
    splits = np.flatnonzero(np.diff(sorted_poles.imag) > near) + 1
    return np.split(order, splits) if len(order) else []


def _drift(signals: _Exponentials, group: NDArray[np.intp], envelope: Array, rate: float) -> tuple[float, float] | None:
    """Frequency [Hz] in the first and the last turn in which a vibration counts; None where both are the same."""
    turning, turn = signals.of(group), 2 * np.pi / rate
    strong = signals.times[envelope >= _WEIGHTY * envelope.max()]
    slope, ends = signals.of(group, 1), []
    for begin in (0.0, max(float(strong[-1]) - turn, 0.0)):
        here = (signals.times >= begin) & (signals.times <= begin + turn)
        weight = np.sum(np.abs(turning[here]) ** 2)
        ends.append(float(np.sum(turning[here].conj() * slope[here]).imag / weight / (2 * np.pi)))
    return (ends[0], ends[1]) if abs(ends[1] - ends[0]) > _DRIFTS * abs(ends[0]) else None


def _diameter(y: Array) -> float:
    """The largest distance of two samples (n, k)."""
    squares = np.sum(y**2, axis=1)
    return float(np.sqrt(max(np.max(squares[:, None] + squares - 2 * y @ y.T), 0.0)))


def _by_period(times: Array, values: Array) -> Residual:
    """The distance from a mean over one period, of a motion that has one; without its modes."""
    none = Residual(None, (), "the motion after the move is not a sum of decaying vibrations")
    window = np.hanning(len(times))[:, None]
    power = np.sum(np.abs(np.fft.rfft((values - values.mean(axis=0)) * window, axis=0)) ** 2, axis=1)
    peak = int(power.argmax())
    if peak < 2 or power[peak // 2 : 2 * peak].sum() < _PERIODIC * power.sum() or peak > len(times) // 8:
        return none
    count = round(len(times) / peak)
    mean = np.stack([np.convolve(column, np.full(count, 1.0 / count), "valid") for column in values.T], axis=1)
    first = (count - 1) // 2
    apart = values[first : first + len(mean)] - mean
    far = np.linalg.norm(apart, axis=1)
    return Residual(
        float(far.max()), (), f"{none.reason}: its distance from a mean over one period", float(far.max()),
        float(times[first + far.argmax()]),
        tuple(map(float, np.abs(apart).max(axis=0))), 1.0,
    )  # fmt: skip
