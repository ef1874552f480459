"""Extrapolated linearly implicit Euler steps as tables: places, their times, and what a step and its samples sum up.

Places are the states of a step: 0 its start, then row by row those after each Euler step of h over the row's number.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.loops.extrapolation_loop import ROWS
from tmodes.compile.loops.runge_kutta import SamplePlaces
from tmodes.compile.loops.tableau import difference_weights, steady_weights

__all__ = ["Extrapolated"]

Array = NDArray[np.float64]
Counts = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Extrapolated:
    """The tableau of ``ROWS`` rows, as :mod:`tmodes.compile.loops.extrapolation_loop` takes them."""

    memory = ROWS
    """How many evaluations are kept at once: those of one row."""

    stages = 1 + ROWS * (ROWS + 1) // 2
    """Places of a step."""

    inputs = ("step", "start")
    """What the evaluation takes besides time, state and row."""

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
        """Shares of the places in the end of a step, (stages,)."""
        table = np.zeros(self.stages)
        for row, weight in steady_weights().items():
            table[_place(row, row)] = weight
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
        """Places of each step: all."""
        return np.full(len(evaluations), self.stages)

    def weighted(self, used: Counts, places: SamplePlaces) -> tuple[Counts, Array]:
        """Places of each step, and weights (n, stages) of them in samples; the start counts once more than listed."""
        weights = _dense(places.share - 1.0) @ _terms(self.b)
        weights[:, 0] -= 1.0
        return used, weights


def _place(row: int, step: int) -> int:
    """Of the state after ``step`` steps of a row; of none it is the start."""
    return row * (row - 1) // 2 + step if step else 0


def _dense(back: Array) -> Array:
    """Shares of start, end and derivatives (1 to ROWS - 1) in samples, ``back`` shares of a step before its end."""
    last = (-back) ** ROWS
    orders = np.arange(1, ROWS)
    powers = back[:, None] ** orders - last[:, None] * (-1.0) ** orders
    return np.column_stack([last, 1.0 - last, powers])


def _terms(end: Array) -> Array:
    """Start, end and derivatives at the end of a step, as sums of its places."""
    terms = np.zeros((ROWS + 1, len(end)))
    terms[0, 0], terms[1] = 1.0, end
    for order in range(1, ROWS):
        for (row, step), weight in difference_weights(ROWS, order).items():
            terms[order + 1, _place(row, step)] += weight
    return terms
