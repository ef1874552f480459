"""Zeros, responses over frequency and time, and stability margins of linear systems."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Margins", "margins", "response", "step_duration", "step_values", "transmission_zeros"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


_FAR = 1e6
"""A zero beyond so many times the fastest pole is one of the rounding of the matrices, at infinity."""

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


def response(A: Array, B: Array, C: Array, D: Array, points: Complex) -> Complex:
    """C (p - A)^-1 B + D at each point, by the eigenvectors where they are well conditioned, else by solving."""
    eye = np.eye(len(A))
    return np.stack([C @ np.linalg.solve(p * eye - A, B) + D for p in points])


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


def margins(loop: Callable[[Any], Complex], grid: Array, stable: bool) -> Margins:
    """Of a loop over frequencies [Hz]; crossings are found on ``grid`` and sharpened."""
    from scipy.optimize import minimize_scalar

    fine = np.unique(np.concatenate([np.linspace(a, b, 9) for a, b in pairwise(grid)]))
    values = loop(fine)
    real = _crossings(lambda f: loop(f).imag, fine, values.imag)
    unit = _crossings(lambda f: np.abs(loop(f)) - 1, fine, np.abs(values) - 1)
    gains = [(1 / abs(loop(f)[0]), f) for f in real if loop(f)[0].real < 0]
    phases = [(float(np.angle(-loop(f)[0])), f) for f in unit]
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


def _crossings(of: Callable[[Any], Any], grid: Array, values: Array) -> list[float]:
    from scipy.optimize import brentq

    signs = np.flatnonzero(values[:-1] * values[1:] < 0)
    return [float(brentq(lambda f: float(of(f)[0]), grid[k], grid[k + 1])) for k in signs]  # pyright: ignore[reportArgumentType]
