"""Functions of time of which the torque of a drive is made, so that few of them act on every mode that rings.

Smooth polynomials move the robot; harmonics at its natural frequencies, in the same window, act on one mode each, so
that the response to the functions is well conditioned. All are clamped cubic splines through rows of a table, as the
signal ``table`` has them: what is found is what a sheet can say. They and their rates vanish at both ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["TorqueFunctions", "torque_functions"]

Array = NDArray[np.float64]

POLYNOMIALS = 10
"""How many polynomials, of degree 4 on."""

_LEAST_ROWS, _MOST_ROWS, _PER_RADIAN = 100, 400, 1.0
"""Pieces of the table: at least, at most, and per radian of the fastest harmonic."""

_ALIKE = 1e-3
"""A combination of functions of less than this share of the largest one is left out: others are alike."""


@dataclass(frozen=True, eq=False)
class TorqueFunctions:
    """``knots`` (k,) [s], ``values`` (k, n) of n orthogonal functions there, with a mean square of 1.

    ``pieces`` (n, k - 1, 4): powers of the time since each knot; ``fine`` (4 k - 3, n): values at the knots and at the
    quarters between them; ``bending`` (k - 2, n): second differences, in units of a half wave over a tenth of the time.
    """

    knots: Array
    values: Array
    pieces: Array
    fine: Array
    bending: Array


def torque_functions(duration: float, frequencies: Sequence[float], polynomials: int = POLYNOMIALS) -> TorqueFunctions:
    """Functions over ``duration`` [s]; ``frequencies`` [rad/s]: of the modes that have a pair of their own.

    >>> torque_functions(1.0, [40.0]).values.shape
    (61, 12)
    """
    from scipy.interpolate import CubicSpline

    count = int(np.clip(np.ceil(_PER_RADIAN * duration * max(frequencies, default=0.0)), _LEAST_ROWS, _MOST_ROWS))
    x = np.linspace(0.0, 1.0, count + 1)
    window = (4 * x * (1 - x)) ** 2
    shapes = [np.polynomial.Legendre.basis(k)(2 * x - 1) for k in range(polynomials)]
    for phase in (frequency * duration * (x - 0.5) for frequency in frequencies):
        shapes += [np.cos(phase), np.sin(phase)]
    modes, sizes, _ = np.linalg.svd(window[:, None] * np.array(shapes).T, full_matrices=False)
    values = modes[:, sizes > _ALIKE * sizes[0]] * np.sqrt(count)
    values[[0, -1]] = 0.0
    spline = CubicSpline(x * duration, values, bc_type="clamped")
    bending = np.diff(values, 2, axis=0) * (count / POLYNOMIALS / 2) ** 2 / np.sqrt(count)
    fine = spline(np.linspace(0.0, duration, 4 * count + 1))
    return TorqueFunctions(x * duration, values, spline.c[::-1].transpose(2, 1, 0), fine, bending)
