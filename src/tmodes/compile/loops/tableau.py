"""Which row of an extrapolation tableau takes which of its steps in which lane, and the weights of what they give.

Rows depend on nothing but the start, so the lanes of a vector take them side by side: row j, of j steps, in one lane
after the other, the long ones first, each in the lane that is free first. Up to seven rows take as many passes as the
last one has steps. Weights of the Aitken-Neville scheme in the limit of steps of no length: E. Hairer, G. Wanner,
Solving Ordinary Differential Equations II, section IV.9, with n_j = j.
"""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "LANES", "RowStep", "difference_weights", "limit_weights", "passes_of", "schedule_of", "spread_weights",
    "steady_weights",
]  # fmt: skip

LANES = 4
"""Rows side by side: of vectors of eight, which take half as long again, most lanes would idle."""

Array = NDArray[np.float64]


class RowStep(NamedTuple):
    """Step ``step`` (from 0) of row ``row`` (from 1) is taken in pass ``at`` (from 0), in ``lane``."""

    row: int
    step: int
    at: int
    lane: int


@cache
def schedule_of(rows: int) -> tuple[RowStep, ...]:
    """All steps of rows 1 to ``rows``, row by row."""
    free = [0] * LANES
    first: dict[int, tuple[int, int]] = {}
    for row in range(rows, 0, -1):
        lane = free.index(min(free))
        first[row] = free[lane], lane
        free[lane] += row
    places = [(row, step, *first[row]) for row in range(1, rows + 1) for step in range(row)]
    return tuple(RowStep(row, step, begin + step, lane) for row, step, begin, lane in places)


def passes_of(rows: int) -> int:
    """How many passes all steps of so many rows take."""
    return 1 + max((step.at for step in schedule_of(rows)), default=-1)


def limit_weights(rows: int, first: int = 1) -> dict[int, float]:
    """Weights of the ends of rows ``first`` to ``rows`` in the value extrapolated from them."""
    used = range(first, rows + 1)
    return {row: math.prod(row / (row - other) for other in used if other != row) for row in used}


_STEADY = (-22.6, 7.5)


def steady_weights() -> dict[int, float]:
    """Weights of eight rows' ends that let no vibration grow: of order 6, two less than that of the limit.

    The limit itself lets a vibration of frequency w that nothing damps grow by 1.3 % in each step of h w near 3.8, and
    in an arm of many modes one is always there. Shares of the limits of rows 2 to 8 and 3 to 8, found as those for
    which the growth is least, bring it to 0.1 %, at h w near 3.4; beyond, vibrations die.
    """
    whole = limit_weights(8)
    parts = [(share, limit_weights(8, first)) for share, first in zip(_STEADY, (2, 3), strict=True)]
    return {row: value + sum(a * (part.get(row, 0.0) - value) for a, part in parts) for row, value in whole.items()}


def difference_weights(rows: int, order: int) -> dict[tuple[int, int], float]:
    """Weights of the states of ``rows`` rows in the derivative of this order at the end, times h^order / order!.

    Backward differences of each row, extrapolated: E. Hairer, A. Ostermann, Numer. Math. 58 (1990) 419-439. By (row,
    steps done); (0, 0) is the start.
    """
    weights: dict[tuple[int, int], float] = {}
    for row, limit in limit_weights(rows, order).items():
        share = limit * row**order / math.factorial(order)
        for back in range(order + 1):
            place = (row, row - back) if row > back else (0, 0)
            weights[place] = weights.get(place, 0.0) + share * (-1) ** back * math.comb(order, back)
    return weights


def spread_weights(weights: dict[tuple[int, int], float], rows: int) -> Array:
    """Such weights by slots and lanes: slot 0 holds the start, slot p + 1 what pass p of ``rows`` rows gave."""
    spread = np.zeros((passes_of(rows) + 1, LANES))
    spread[0, 0] = weights.get((0, 0), 0.0)
    for row, step, at, lane in schedule_of(rows):
        spread[at + 1, lane] = weights.get((row, step + 1), 0.0)
    return spread
