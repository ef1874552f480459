"""Zeros, responses over frequency and time, and stability margins of linear systems."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Margins", "frequencies", "loop_margins", "points", "response", "step_duration", "step_values",
    "transmission_zeros",
]  # fmt: skip

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


_FAR = 1e6
"""A zero beyond so many times the fastest pole is one of the rounding of the matrices, at infinity."""

_REAL = 1e-6
"""Share of a response that may be imaginary where it crosses the real axis."""

_RINGS, _AROUND = 0.1, np.linspace(-1.45, 1.45, 16)
"""Damping ratio below which a pole is a peak, and halves of its phase [rad] at which the response is looked at."""

_FINE = 3200
"""Frequencies at which crossings are looked for, besides those where the loop rings."""

_REFINED, _POOR = 2, 1e-10
"""Steps by which a response is refined, and the share of it by which the last one may still change it."""

_NULL = 1e-6
"""Rate [1/s] of a motion that neither grows nor decays."""


class Margins(NamedTuple):
    """Of a loop that is closed by negative feedback: factors on the gain, phase [rad], delay [s], and disk margin.

    ``stable``: whether the closed loop is so at all; of one that is not the others say how far it is from becoming so.
    ``gain`` and ``phase`` with their frequencies [Hz]; ``disk``: distance of the loop from -1 as a symmetric disk
    margin (P. Seiler, A. Packard, P. Gahinet, An introduction to disk margins, IEEE Control Systems 40, 2020).
    """

    gain: float
    gain_frequency: float
    phase: float
    phase_frequency: float
    delay: float
    disk: float
    stable: bool

    @property
    def words(self) -> str:
        """Those that are finite, with their frequencies."""
        if not self.stable:
            return "unstable"
        shown = []
        if np.isfinite(self.gain):
            shown.append(f"gain {20 * np.log10(self.gain):.3g} dB at {self.gain_frequency:.3g} Hz")
        if np.isfinite(self.phase):
            shown.append(f"phase {np.degrees(self.phase):.3g}° at {self.phase_frequency:.3g} Hz")
        if np.isfinite(self.delay):
            shown.append(f"delay {1e3 * self.delay:.3g} ms")
        return ", ".join([*shown, f"disk {self.disk:.2g}"])


def response(A: Array, B: Array, C: Array, D: Array) -> Callable[[Complex], Complex]:
    """C (p - A)^-1 B + D at points (n,): (n, outputs, inputs).

    By one Schur form for all points, which mixes states of unlike sizes, so refined in the states as they are (N. J.
    Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., chapter 12); by elimination where that ends poorly.
    """
    from scipy.linalg import schur

    both: Any = schur(A, output="complex") if len(A) else (np.zeros((0, 0)),) * 2
    form, basis = both
    n = len(A)
    least = np.finfo(float).eps * (np.abs(np.diag(form)).max(initial=0.0) or 1.0)

    def apart(points: Complex, pole: Any) -> Any:
        return np.where(points == pole, least, points - pole)[:, None]

    def solved(points: Complex, push: Complex) -> Complex:
        into = np.tensordot(basis.conj().T, push, 1)
        states = np.zeros_like(into)
        for k in reversed(range(n)):
            states[k] = (into[k] + np.tensordot(form[k, k + 1 :], states[k + 1 :], 1)) / apart(points, form[k, k])
        return np.tensordot(basis, states, 1)

    def at(points: Complex) -> Complex:
        push = np.repeat(B[:, None].astype(np.complex128), len(points), axis=1)
        states = step = solved(points, push)
        for _ in range(_REFINED):
            step = solved(points, push - points[:, None] * states + np.tensordot(A, states, 1))
            states = states + step
        found, last = (np.moveaxis(np.tensordot(C, one, 1), 1, 0) for one in (states, step))
        for k in np.nonzero((np.abs(last) > _POOR * np.abs(found)).any(axis=(1, 2)))[0]:
            with suppress(np.linalg.LinAlgError):  # right on a pole
                found[k] = C @ np.linalg.solve(points[k] * np.eye(n) - A, B)
        return np.asarray(found + D, dtype=np.complex128)

    return at


def transmission_zeros(A: Array, B: Array, C: Array, D: Array) -> Complex:
    """Finite zeros [1/s] from all inputs to as many outputs, the smallest first: of the Rosenbrock pencil."""
    from scipy.linalg import eigvals

    n, m = B.shape
    scale = max(np.abs(np.linalg.eigvals(A)).max(initial=0.0), 1e-12)
    size = [np.abs(one).max(initial=0.0) or 1.0 for one in (B, C)]
    left = np.block([[A / scale, B / size[0]], [C / size[1], D / (size[0] * size[1]) * scale]])
    right = np.zeros((n + m, n + m))
    right[:n, :n] = np.eye(n)
    values: Any = eigvals(left, right, homogeneous_eigvals=True)
    kept = np.abs(values[1]) > np.abs(values[0]) / _FAR
    found = scale * values[0][kept] / values[1][kept]
    return found[np.argsort(np.abs(found), kind="stable")]


def step_duration(poles: Complex, period: float | None) -> float:
    """Until the slowest motion that decays is down to 1 %, or one that grows is 20 times as large [s]."""
    rates = np.log(poles[poles != 0]) / period if period else poles
    if len(growing := rates.real[rates.real > _NULL]):
        return float(np.log(20) / growing.max())
    decays = np.maximum(-rates.real, 0.1 * np.abs(rates))  # what rings on for long is seen to ring
    return float(np.log(100) / decays[decays > _NULL].min(initial=np.inf)) or 1.0


def step_values(A: Array, B: Array, C: Array, D: Array, count: int, step: float, period: float | None) -> Array:
    """Outputs (count, outputs, inputs) every ``step`` [s] after steps of 1 of the inputs, exact there."""
    from scipy.linalg import expm

    n, m = B.shape
    whole = np.block([[A, B], [np.zeros((m, n + m))]])
    if period:
        whole[n:, n:] = np.eye(m)
    on = np.linalg.matrix_power(whole, round(step / period)) if period else expm(whole * step)
    state, values = np.vstack([np.zeros((n, m)), np.eye(m)]), np.zeros((count, len(C), m))
    for k in range(count):
        values[k] = C @ state[:n] + D
        state = on @ state
    return values


def frequencies(poles: Complex, period: float | None, count: int = 400) -> Array:
    """Frequencies [Hz] (n,) of a response: from below the slowest pole to above the fastest, close where it rings."""
    with np.errstate(divide="ignore", invalid="ignore"):  # a pole at 0 of a delay
        rates = np.log(poles) / period if period else poles
    rates = rates[(np.abs(rates) > _NULL) & np.isfinite(rates)]
    sizes = np.abs(rates) / (2 * np.pi)
    low, high = (sizes.min() / 10, sizes.max() * 10) if len(sizes) else (0.01, 100.0)
    high = min(high, 0.5 / period) if period else high
    rings = (rates.imag > 0) & (np.abs(rates.real) < _RINGS * np.abs(rates))
    around = sizes[rings][:, None] + np.abs(rates[rings].real)[:, None] / (2 * np.pi) * np.tan(_AROUND)
    sizes = np.append(sizes, around)
    return np.unique(np.append(np.geomspace(min(low, high / 10), high, count), sizes[(sizes > low) & (sizes < high)]))


def points(at: Array, period: float | None) -> Complex:
    """Frequencies [Hz] on the imaginary axis, or on the unit circle of a sampled system."""
    turns = 2j * np.pi * at
    return np.asarray(np.exp(turns * period) if period else turns, dtype=np.complex128)


def loop_margins(A: Array, B: Array, C: Array, D: Array, period: float | None) -> Margins:
    """Of a loop of one input and output that negative feedback closes; infinite where there is none.

    Crossings are found on a fine grid of frequencies and sharpened by bisection.
    """
    poles = np.linalg.eigvals(A - B @ C / (1 + D[0, 0]))
    stable = bool((np.abs(poles) < 1).all() if period else (poles.real < 0).all())
    grid, at = frequencies(np.linalg.eigvals(A).astype(complex), period, _FINE), response(A, B, C, D)
    return _margins(lambda f: at(points(np.atleast_1d(f), period))[:, 0, 0], grid, stable)


def _margins(loop: Callable[[Any], Complex], fine: Array, stable: bool) -> Margins:
    from scipy.optimize import minimize_scalar

    values = loop(fine)
    real = _crossings(lambda f: loop(f).imag, fine, values.imag)
    unit = _crossings(lambda f: np.abs(loop(f)) - 1, fine, np.abs(values) - 1)
    crossed = [
        *zip(loop(real).tolist(), real.tolist(), strict=True)
    ]  # at a pole without damping the sign changes at infinity
    gains = [(1 / abs(one), f) for one, f in crossed if one.real < 0 and abs(one.imag) < _REAL * abs(one) < 1]
    phases = [*zip(np.angle(-loop(unit)).tolist(), unit.tolist(), strict=True)]
    gain = min(gains, key=lambda one: abs(np.log(one[0])), default=(np.inf, np.nan))
    phase = min(phases, key=lambda one: abs(one[0]), default=(np.inf, np.nan))
    delays = [(angle % (2 * np.pi)) / (2 * np.pi * f) for angle, f in phases if f]

    # Largest alpha of the disk of gains and phases (skew 0): 1/|S - 1/2| at its least, with S = 1/(1 + L).
    def far(log: float) -> float:
        return float(1 / np.abs(1 / (1 + loop(np.exp(log))[0]) - 0.5))

    least = int(np.argmin(1 / np.abs(1 / (1 + values) - 0.5)))
    around = np.log(fine[[max(least - 1, 0), min(least + 1, len(fine) - 1)]])
    found: Any = minimize_scalar(far, bounds=tuple(around), method="bounded")
    disk = min(far(np.log(fine[least])), float(found.fun))
    sizes = [float(one) for one in (*gain, *phase, min(delays, default=np.inf), disk)]
    return Margins._make([*sizes, stable])


def _crossings(of: Callable[[Any], Any], grid: Array, values: Array) -> Array:
    """Where a function changes its sign between points of a grid."""
    from scipy.optimize.elementwise import find_root

    signs = np.flatnonzero(values[:-1] * values[1:] < 0)
    found = np.asarray(find_root(of, (grid[signs], grid[signs + 1])).x) if len(signs) else np.zeros(0)
    return found[np.isfinite(found)]  # a pole without damping changes the sign, too
