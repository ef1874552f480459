"""Extrapolated linearly implicit Euler steps as tables: places, their times, and what a step and its samples sum up.

Places are the states of a step: 0 its start, then row by row those after each Euler step of h over the row's number.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import prod

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.extrapolation_dense import difference_weights
from tmodes.compile.extrapolation_loop import ROWS
from tmodes.compile.runge_kutta import SamplePlaces

__all__ = ["Extrapolated"]

Array = NDArray[np.float64]
Counts = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Extrapolated:
    """The tableau of at most ``ROWS`` rows; what differs from step to step is how many of them it takes."""

    memory = ROWS
    """How many evaluations are kept at once: those of one row."""

    stages = 1 + ROWS * (ROWS + 1) // 2
    """Places of a step of all rows."""

    inputs = ("step", "start")
    """What the evaluation takes beside time, state and row."""

    @cached_property
    def a(self) -> Array:
        """Of each place its row and the place before it, (2, stages)."""
        table = np.zeros((2, self.stages))
        for row in range(1, ROWS + 1):
            first = 1 + row * (row - 1) // 2
            table[0, first : first + row] = row
            table[1, first + 1 : first + row] = np.arange(first, first + row - 1)
        return table

    @cached_property
    def b(self) -> Array:
        """Shares of the places in the end of a step of so many rows, (rows, stages): the Aitken-Neville scheme."""
        table = np.zeros((ROWS + 1, self.stages))
        for rows in range(1, ROWS + 1):
            for row in range(1, rows + 1):
                others = (other for other in range(1, rows + 1) if other != row)
                table[rows, row * (row + 1) // 2] = prod(row / (row - other) for other in others)
        return table

    @cached_property
    def c(self) -> Array:
        """Time of each place as a share of the step, (stages,)."""
        times = np.zeros(self.stages)
        for row in range(1, ROWS + 1):
            first = 1 + row * (row - 1) // 2
            times[first : first + row] = np.arange(1, row + 1) / row
        return times

    def used(self, evaluations: Array) -> Counts:
        """Rows of each step, from the evaluations of its last attempt; one more tells whether a contact changed."""
        return ((np.sqrt(8.0 * evaluations + 1.0) - 1.0) / 2.0 + 1e-9).astype(np.int64)

    def weighted(self, used: Counts, places: SamplePlaces) -> tuple[Counts, Array]:
        """Rows of each step, and weights (n, stages) of the places in samples; the start counts once more than told."""
        weights = np.zeros((len(places.step), self.stages))
        for rows in np.unique(used[places.step]).tolist():
            chosen = used[places.step] == rows
            weights[chosen] = _dense(rows, places.share[chosen] - 1.0) @ _terms(rows, self.b[rows])
        weights[:, 0] -= 1.0
        return used, weights


def _dense(rows: int, back: Array) -> Array:
    """Shares of start, end and derivatives (1 to rows - 1) in samples, ``back`` shares of a step before its end."""
    last = (-back) ** rows
    orders = np.arange(1, rows)
    powers = back[:, None] ** orders - last[:, None] * (-1.0) ** orders
    return np.column_stack([last, 1.0 - last, powers])


def _terms(rows: int, end: Array) -> Array:
    """Start, end and derivatives at the end of a step of so many rows, as sums of its places."""
    terms = np.zeros((rows + 1, len(end)))
    terms[0, 0], terms[1] = 1.0, end
    for order in range(1, rows):
        told = difference_weights(rows, order)
        terms[order + 1, : len(told)] = told
    return terms
