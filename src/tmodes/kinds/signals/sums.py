"""Sums of schedules: on all their knots, in whatever order those come."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from tmodes.kinds.noted.functions import array, maximum, minimum, number
from tmodes.kinds.signals.schedule import SAME, SignalPieces, merge, shifted

__all__ = ["summed"]

_MOST = 100
"""Inner knots of noted schedules that may come in any order; of more their order is a guard."""


def summed(parts: Sequence[SignalPieces]) -> SignalPieces:
    """The sum of schedules that begin and end together, on all their knots.

    Where knots are noted they are sorted without a branch, so that one program holds for all orders of them: it has a
    piece for each knot, of length 0 where two coincide.
    """
    ends = [(number(one.knots[0]), number(one.knots[-1])) for one in parts]
    inner = [knot for one in parts for knot in one.knots[1:-1]]
    if not any(one.is_noted for one in parts) or len(inner) > _MOST:
        both = merge(parts)
        return SignalPieces(both.knots, np.ascontiguousarray(both.coefficients.sum(axis=1)))
    (first, last), degree = ends[0], max(one.degree for one in parts)
    knots = [first, *_rising(inner), last]
    rows = []
    for start, end in pairwise(knots):
        powers: Any = np.zeros(degree + 1)
        for one in parts:
            powers = powers + _about(one, start, (start + end) / 2, SAME * (last - first), degree)
        rows.append(powers)
    return SignalPieces(array(knots), array(rows))


def _about(one: SignalPieces, start: Any, time: Any, near: float, degree: int) -> Any:
    """Coefficients (degree + 1,) about ``start`` of the piece at ``time``, chosen without a branch."""
    after = [1.0, *(_after(time - knot, near) for knot in one.knots[1:-1]), 0.0]
    chosen = [late - next_one for late, next_one in pairwise(after)]
    begin = sum(share * knot for share, knot in zip(chosen, one.knots, strict=False))
    powers = sum(share * row for share, row in zip(chosen, one.coefficients, strict=True))
    moved = shifted(array(powers)[None], array([start - begin]))[0]
    return array([*moved, *[0.0] * (degree - one.degree)])


def _after(since: Any, near: float) -> Any:
    """1 from a knot on, 0 before it [s since it]; exactly so, but within ``near`` of it."""
    later = since + _BETWEEN * near
    return 0.5 + 0.5 * later / abs(later)


_BETWEEN = 0.7310585786300049
"""A share at which no two knots are apart by intention."""


def _rising(values: Sequence[Any]) -> list[Any]:
    """The values in rising order, by pairs that are compared in an order of their own: Batcher's odd-even mergesort.

    K. E. Batcher, Sorting networks and their applications, AFIPS Spring Joint Computer Conference (1968), 307-314.
    """
    found = list(values)
    for low, high in _pairs(len(found)):
        a, b = found[low], found[high]
        found[low], found[high] = minimum(a, b), maximum(a, b)
    return found


def _pairs(count: int) -> Iterator[tuple[int, int]]:
    """The pairs of D. E. Knuth, The Art of Computer Programming 3, algorithm 5.2.2M."""
    top = 1 << max(count - 1, 0).bit_length() - 1 if count > 1 else 0
    p = top
    while p:
        q, r, d = top, 0, p
        while d:
            yield from ((i, i + d) for i in range(count - d) if i & p == r)
            d, q, r = q - p, q >> 1, p
        p >>= 1
