"""What the error of a run's states makes of its headline figures: each is computed again from disturbed states."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Figure", "at_worst", "disturbed_rows", "even_samples", "figure_errors", "rows_each"]

Array = NDArray[np.float64]

Variables = Mapping[str, tuple[tuple[str, ...], Array, str, str]]
"""Dimensions, values, unit and long name of each series."""

_PATTERNS = 8
"""Patterns of signs with which the sizes of errors are added."""


class Figure(NamedTuple):
    """A headline figure: its path in the summary, the samples it comes from, and how it follows from all series.

    ``value`` gives (rows,) or (rows, components), whose distance counts.
    """

    name: str
    samples: tuple[int, ...]
    value: Callable[[Variables], Array]


def at_worst(name: str, series: str, values: Array, *place: int) -> Figure:
    """The largest size of one series (n, ...) at a place of it, at the sample where it is reached."""
    worst = int(np.argmax(np.abs(values[(slice(None), *place)])))
    return Figure(name, (worst,), lambda found: found[series][1][(slice(None), *place)])


def rows_each(estimates: Sequence[Any]) -> int:
    """Rows of a sample: as it is, and disturbed once by what is signed, or by eight patterns of signs.

    ``estimates``: each a :class:`tmodes.simulation.parts.ErrorEstimate`.
    """
    return 2 if all(estimate.signed for estimate in estimates) else 1 + _PATTERNS


def even_samples(count: int, rows: int) -> tuple[int, ...]:
    """Samples from the first to the last: eleven, or 101 where each takes few rows."""
    parts = 10 if rows > 2 else 100
    return tuple(sorted({round(part * (count - 1) / parts) for part in range(parts + 1)}))


def disturbed_rows(states: Array, estimate: Any, samples: Sequence[int], rows: int, turn: int) -> Array:
    """For each sample its state, then disturbed ones: ``rows`` of it, (samples rows, size).

    What is signed is added as it is; sizes are added with patterns of signs (Walsh functions of the components, begun
    at ``turn``), of which the worst will count.
    """
    kept = np.asarray(samples, dtype=int)
    info = np.repeat(states[kept], rows, axis=0).reshape(len(kept), rows, -1)
    signs = np.ones((1, 1)) if estimate.signed else _signs(states.shape[1], turn)
    info[:, 1:] += signs * estimate.values[kept][:, None]
    return info.reshape(len(kept) * rows, -1)


def _signs(size: int, turn: int) -> Array:
    patterns = range(1, _PATTERNS + 1)
    return np.array([[1.0 - 2 * ((row & (k + turn)).bit_count() % 2) for k in range(size)] for row in patterns])


def figure_errors(
    figures: Sequence[Figure], samples: Sequence[int], rows: int, variables: Variables
) -> dict[str, float]:
    """The error of each figure by its name, where it is a number.

    ``variables`` of the rows of :func:`disturbed_rows` at these samples.
    """
    info = {}
    for figure in figures:
        values = figure.value(variables).reshape(len(samples), rows, -1)
        apart = np.linalg.norm(values[:, 1:] - values[:, :1], axis=2).max(axis=1)
        info[figure.name] = float(max(apart[samples.index(k)] for k in figure.samples))
    return {name: error for name, error in info.items() if math.isfinite(error)}
