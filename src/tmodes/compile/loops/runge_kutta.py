"""Explicit Runge-Kutta methods as tableaus: stages, steps, and states between steps as combinations of the stages."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate import dop853_table as dop853
from tmodes.integrate.method import Tableau

__all__ = ["RungeKutta", "SamplePlaces", "dop853_table", "replayed"]

Array = NDArray[np.float64]
Counts = NDArray[np.int64]


class SamplePlaces(NamedTuple):
    """Of each sample the step that it lies in, at which share of it, and how long that step is [s]."""

    step: Counts
    share: Array
    length: Array


@dataclass(frozen=True, eq=False)
class RungeKutta:
    """``a`` (stages, stages), ``b`` and ``c`` (stages,); ``dense`` (n,) shares of a step -> weights (n, stages).

    A state at a share of a step of h is that at its start, and h times the weighted stages. The first ``own`` stages
    make the step; those after it serve the states between.
    """

    a: Array
    b: Array
    c: Array
    own: int
    dense: Callable[[Array], Array]
    inputs = ()
    """What the evaluation takes besides time, state and row: nothing."""

    @property
    def stages(self) -> int:
        """How many there are."""
        return len(self.b)

    @property
    def memory(self) -> int:
        """How many evaluations are kept at once: those of all stages."""
        return len(self.b)

    def used(self, evaluations: Array) -> Counts:
        """Stages of each step; those between its ends are not known yet."""
        return np.full(len(evaluations), self.own, dtype=np.int64)

    def weighted(self, used: Counts, places: SamplePlaces) -> tuple[Counts, Array]:
        """Stages of each step with those that its samples need, and their weights in the samples, (n, stages)."""
        step, length = places.step, places.length[:, None]
        weights = length * self.dense(places.share)
        weights[np.abs(weights) <= 1e-15 * length] = 0.0
        used[step[1:][(weights[1:, self.own :] != 0).any(axis=1)]] = self.stages
        return used, weights


def _square(rows: tuple[tuple[float, ...], ...]) -> Array:
    matrix = np.zeros((len(rows), len(rows)))
    for k, row in enumerate(rows):
        matrix[k, : len(row)] = row
    return matrix


def replayed(tableau: Tableau) -> RungeKutta:
    """A method by its tableau; the stage after those of the step is the slope at its end, which samples may need."""
    a, b = _square(tableau.a), np.zeros(tableau.stages)
    b[: len(tableau.a[-1])] = tableau.a[-1]

    def hermite(share: Array) -> Array:
        rest = 1 - share
        weights = (share**2 * (1 + 2 * rest))[:, None] * b
        weights[:, 0] += share * rest**2
        weights[:, -1] -= rest * share**2
        if tableau.error is None:
            weights[share >= 1 - 1e-9] = b  # there the loop takes the step's end itself
        return weights

    def dense(share: Array) -> Array:
        powers = np.array(tableau.dense)
        return np.stack([share ** (k + 1) for k in range(powers.shape[1])], axis=1) @ powers.T

    return RungeKutta(a, b, np.array(tableau.c), tableau.own, hermite if tableau.dense is None else dense)


def dop853_table() -> RungeKutta:
    """The last four stages, the slope at the step's end the first of them, are those of the dense output."""
    count = len(dop853.A)
    a, b = _spread(dop853.A, count), _spread([dop853.A[dop853.STAGES]], count)[0]
    rows = _spread(dop853.DENSE, count)
    ends = np.eye(count)[[0, dop853.STAGES]]

    def dense(share: Array) -> Array:
        rest = 1 - share
        powers = np.cumprod([share, rest, share, rest, share, rest, share], axis=0)
        change = powers[0] - powers[1] + 2 * powers[2]
        slopes = np.outer(powers[1] - powers[2], ends[0]) - np.outer(powers[2], ends[1])
        return np.outer(change, b) + slopes + powers[3:].T @ rows

    return RungeKutta(a, b, np.array(dop853.C), dop853.STAGES, dense)


def _spread(rows: Sequence[Mapping[int, float]], count: int) -> Array:
    """Rows that leave out zeros, whole."""
    matrix = np.zeros((len(rows), count))
    for k, row in enumerate(rows):
        matrix[k, [*row]] = [*row.values()]
    return matrix
