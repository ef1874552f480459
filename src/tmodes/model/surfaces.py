"""Smooth functions of a few variables that act together: interpolants by products of Chebyshev polynomials.

The outer diameter and the wall of a tube enter a robot's numbers so: neither does by itself what it does next to
another value of the other one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from tmodes.model.curves import Span, places_of

__all__ = ["Grid", "SmoothSurface"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SmoothSurface:
    """A share of some variables together, by their index: 0 where all start, 1 where all are at their far ends.

    ``coefficients`` (m, n, ...) of products of Chebyshev polynomials, an axis for each variable, over its span.
    """

    variables: tuple[int, ...]
    spans: tuple[Span, ...]
    coefficients: Array

    def at(self, values: Sequence[Array | float]) -> Array:
        """The share at values of each of its variables, all of one shape or single numbers."""
        each = [span.place(own) for span, own in zip(self.spans, values, strict=True)]
        first, *others = np.broadcast_arrays(*each)
        found = chebyshev.chebval(first, self.coefficients)
        for place in others:
            found = chebyshev.chebval(place, found, tensor=False)
        return np.asarray(found, dtype=np.float64)


@dataclass(frozen=True)
class Grid:
    """Points over spans, one more along each than its degree."""

    spans: tuple[Span, ...]
    degrees: tuple[int, ...]

    @property
    def size(self) -> int:
        """Number of points."""
        return int(np.prod([degree + 1 for degree in self.degrees]))

    def sampled(self, evaluate: Callable[[tuple[float, ...]], Array]) -> Array:
        """The vectors at all points, (m, n, ..., numbers)."""
        lines = [
            np.clip(span.value(places_of(degree)), span.low, span.high).tolist()
            for span, degree in zip(self.spans, self.degrees, strict=True)
        ]
        found = [evaluate(point) for point in product(*lines)]
        return np.array(found).reshape(*(degree + 1 for degree in self.degrees), -1)

    def coefficients(self, samples: Array) -> Array:
        """Of the polynomials through samples (m, n, ..., numbers), of the same shape."""
        found = samples
        for axis, degree in enumerate(self.degrees):
            basis, moved = chebyshev.chebvander(places_of(degree), degree), np.moveaxis(found, axis, 0)
            solved = np.linalg.solve(basis, moved.reshape(degree + 1, -1)).astype(np.float64)
            found = np.moveaxis(solved.reshape(moved.shape), 0, axis)
        return found

    def rough(self, samples: Array, tail: float) -> list[bool]:
        """Whether the last coefficients along each axis are larger than a share ``tail`` of a number."""
        found = np.abs(self.coefficients(samples))
        size = np.max(np.abs(samples), axis=tuple(range(len(self.degrees))))
        last = [np.moveaxis(found, axis, 0)[-2:] for axis in range(len(self.degrees))]
        return [bool((one > tail * size).any()) for one in last]
