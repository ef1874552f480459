"""The methods whose steps can be repeated and differentiated, as tables, with their native loops."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.loops.extrapolation_loop import FEW, ROWS
from tmodes.compile.loops.extrapolation_rows import difference_weights, steady_weights
from tmodes.compile.native import Library
from tmodes.compile.replay.replay_extrapolated import extrapolated_loops
from tmodes.compile.replay.replay_loop import replay_loops
from tmodes.integrate import dop853
from tmodes.integrate.method import Integrator, Tableau
from tmodes.integrate.registry import integrator, integrators

__all__ = ["ExtrapolationTableau", "RungeKutta", "SamplePlaces", "Table", "loops_of", "replay_methods", "table_of"]

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


def _places(rows: int) -> int:
    """Places of a step of so many rows."""
    return 1 + rows * (rows + 1) // 2


@dataclass(frozen=True, eq=False)
class ExtrapolationTableau:
    """The tableaus of ``ROWS`` and ``FEW`` rows, as :mod:`tmodes.compile.loops.extrapolation_loop` takes them."""

    memory = ROWS
    """How many evaluations are kept at once: those of one row."""

    stages = _places(ROWS)
    """Places of a step."""

    inputs = ("step", "start")
    """What the evaluation takes besides time, state and row."""

    @cached_property
    def a(self) -> Array:
        """Of each place its row and the place before it, (2, stages)."""
        table = np.zeros((2, self.stages))
        for row in range(1, ROWS + 1):
            first = _places(row - 1)
            table[0, first : first + row] = row
            table[1, first + 1 : first + row] = np.arange(first, first + row - 1)
        return table

    @cached_property
    def b(self) -> Array:
        """Shares of the places in the end of a step, of all rows and of few, (2, stages)."""
        table = np.zeros((2, self.stages))
        for line, rows in enumerate((ROWS, FEW)):
            for row, weight in steady_weights(rows).items():
                table[line, _place(row, row)] = weight
        return table

    @cached_property
    def c(self) -> Array:
        """Time of each place as a share of the step, (stages,)."""
        times = np.zeros(self.stages)
        for row in range(1, ROWS + 1):
            first = _places(row - 1)
            times[first : first + row] = np.arange(1, row + 1) / row
        return times

    def used(self, evaluations: Array) -> Counts:
        """Places of each step."""
        return np.where(evaluations < _places(ROWS) - 1, _places(FEW), self.stages)

    def weighted(self, used: Counts, places: SamplePlaces) -> tuple[Counts, Array]:
        """Places of each step, and weights (n, stages) of them in samples; the start counts once more than listed."""
        weights, few = np.zeros((len(places.step), self.stages)), used[places.step] < self.stages
        for rows, end, own in zip((ROWS, FEW), self.b, (~few, few), strict=True):
            weights[own] = _dense(places.share[own] - 1.0, rows) @ _terms(end, rows)
        weights[:, 0] -= 1.0
        return used, weights


def _place(row: int, step: int) -> int:
    """Of the state after ``step`` steps of a row; of none it is the start."""
    return row * (row - 1) // 2 + step if step else 0


def _dense(back: Array, rows: int) -> Array:
    """Shares of start, end and derivatives (1 to rows - 1) in samples, ``back`` shares of a step before its end."""
    last = (-back) ** rows
    orders = np.arange(1, rows)
    powers = back[:, None] ** orders - last[:, None] * (-1.0) ** orders
    return np.column_stack([last, 1.0 - last, powers])


def _terms(end: Array, rows: int) -> Array:
    """Start, end and derivatives at the end of a step, as sums of its places."""
    terms = np.zeros((rows + 1, len(end)))
    terms[0, 0], terms[1] = 1.0, end
    for order in range(1, rows):
        for (row, step), weight in difference_weights(rows, order).items():
            terms[order + 1, _place(row, step)] += weight
    return terms


Table = RungeKutta | ExtrapolationTableau


def replay_methods() -> list[str]:
    """The names of the methods that have a table."""
    return [name for name, one in integrators().items() if one.replayed]


@cache
def table_of(one: Integrator) -> Table:
    """The table of a method; KeyError for one without."""
    if one.tableau is not None:
        return replayed(one.tableau)
    return {"dop853": dop853_table, "extrapolation": ExtrapolationTableau}[one.name]()


def loops_of(method: str) -> Library:
    """The native loops ``again``, ``along`` and ``back`` over recorded steps of a method."""
    return replay_loops() if integrator(method).is_explicit else extrapolated_loops()
