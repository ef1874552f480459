"""Smooth functions of one variable that are no powers of it: interpolants by Chebyshev polynomials, to rounding.

The dimensions of a section enter a robot's numbers so: the stiffness of a tube is a polynomial of its thickness, its
shear coefficient (Cowper, J. Appl. Mech. 33, 1966) a ratio of two. See Trefethen, Approximation Theory and
Approximation Practice, 2013.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

__all__ = ["Curve", "Samples", "Span", "places_of"]

Array = NDArray[np.float64]

_DEGREES = 8, 16, 32
"""Degrees that are tried; the points of each are among those of the next."""

_TAIL = 1e-13
"""Size of the last coefficients of a share that has converged."""


class Span(NamedTuple):
    """From ``low`` to ``high``; by ratios where both are positive: the inverse of a stiffness is then as smooth.

    ``even``: by differences nevertheless, which suits polynomials.
    """

    low: float
    high: float
    even: bool = False

    @property
    def _by_ratios(self) -> bool:
        return self.low > 0 and not self.even

    def place(self, values: Array | float) -> Array:
        """Where values are, -1 at the low end to 1 at the high one."""
        if self._by_ratios:
            return np.asarray(2 * np.log(np.asarray(values) / self.low) / np.log(self.high / self.low) - 1)
        return np.asarray((2 * np.asarray(values) - self.low - self.high) / (self.high - self.low))

    def value(self, places: Array) -> Array:
        """The values there."""
        if self._by_ratios:
            return np.asarray(self.low * (self.high / self.low) ** ((places + 1) / 2))
        return np.asarray((self.low + self.high + (self.high - self.low) * places) / 2)


def places_of(degree: int) -> Array:
    """The places (degree + 1,) of Chebyshev's points, from 1 to -1."""
    return np.asarray(np.cos(np.pi * np.arange(degree + 1) / max(degree, 1)), dtype=float)


@dataclass(frozen=True, eq=False)
class Curve:
    """A share: 0 where its variable starts, 1 at its far end; ``coefficients`` of Chebyshev polynomials over a span."""

    span: Span
    coefficients: Array

    def at(self, values: Array | float) -> Array:
        """The share at some values of the variable."""
        return np.asarray(chebyshev.chebval(self.span.place(values), self.coefficients), dtype=np.float64)


class Samples:
    """Vectors along one variable from ``low`` to ``high``, more of them when they are asked for."""

    def __init__(self, evaluate: Callable[[float], Array], low: float, high: float) -> None:
        self._evaluate, self._span = evaluate, Span(low, high)
        self._known: dict[int, Array] = {}
        self.degree = 0

    def refined(self) -> bool:
        """Take more points; False where there are enough of them."""
        more = next((degree for degree in _DEGREES if degree > self.degree), 0)
        self.degree = more or self.degree
        return more > 0

    @property
    def points(self) -> Array:
        """Where they are, from the high end to the low one, (degree + 1,)."""
        return self._span.value(places_of(self.degree))

    @property
    def vectors(self) -> Array:
        """The vectors there, (degree + 1, n); each is evaluated once."""
        places = [k * (_DEGREES[-1] // self.degree) for k in range(self.degree + 1)]
        for place, value in zip(places, self.points.tolist(), strict=True):
            if place not in self._known:
                self._known[place] = self._evaluate(min(max(value, self._span.low), self._span.high))
        return np.array([self._known[place] for place in places])

    def curve(self, shares: Array) -> Curve | None:
        """The curve through shares (degree + 1,) at the points; None where it has not converged."""
        angles = np.pi * np.arange(self.degree + 1) / self.degree
        basis = np.cos(np.outer(angles, np.arange(self.degree + 1)))
        coefficients = np.linalg.solve(basis, shares).astype(np.float64)
        converged = bool(np.abs(coefficients[-2:]).max() <= _TAIL * max(1.0, np.abs(shares).max()))
        return Curve(self._span, coefficients) if converged else None
