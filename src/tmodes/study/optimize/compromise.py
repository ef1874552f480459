"""Compromises between two objectives along gradients: the least of the larger of both, weighed in even steps.

Weighted largest distances from the best of each objective (R. E. Steuer, E.-U. Choo, Math. Programming 26, 1983) reach
every part of a curve, also where it is not convex, which weighted sums leave out.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tmodes.study.optimize.adjoint import Adjoint
from tmodes.study.optimize.goals import Goals, Limit
from tmodes.study.optimize.gradient import Terms, descend_worst
from tmodes.study.optimize.result import Optimum
from tmodes.study.optimize.summary import found
from tmodes.study.optimize.trials import Trials

__all__ = ["COMPROMISES", "compromises"]

Array = NDArray[np.float64]

COMPROMISES = "compromises"
"""The stage that is reported."""

_PRECISION = 1e-3
"""Of a distance at its start, the gain with which a search ends."""


def compromises(trials: Trials, count: int, units: dict[str, str], progress: Callable[[str, float], None]) -> Optimum:
    """Designs of which none is better in both objectives: the best of each, and ``count`` - 2 between them.

    Limits choose among all that were tried; the searches do not follow them.
    """
    one, other = trials.goals.aims
    goals = Goals((one,), (Limit(other.term.text, other.term, other.sign, 0.0, "-"),))  # whose excess is its value
    alone = Trials(trials.study, trials.space, goals, trials.scenarios, None, lambda *_: None, {})
    slopes = Adjoint(alone, {})
    best, widths = np.zeros(2), np.ones(2)

    def searched(start: Array, shares: Array) -> Array:
        """Where the larger of the distances over ``shares`` (2,) is least; infinite: that objective does not count."""

        def in_all(x: Array) -> Array:
            return ((slopes.in_all_cases(x) - best[:, None]) / (widths * shares)[:, None]).reshape(1, -1)

        def of(x: Array, case: int) -> Terms:
            row, scenario = divmod(case, len(trials.scenarios))
            terms, scale = slopes.of_case(x, scenario), widths[row] * shares[row]
            value, slope = (terms.excess[0], terms.slopes[0]) if row else (terms.objective, terms.slope)
            return Terms(float(value - best[row]) / scale, slope / scale, np.zeros(0), np.zeros((0, len(x))))

        return descend_worst(in_all, of, start, precision=_PRECISION)

    ends = []
    for k, shares in enumerate((np.array([1.0, np.inf]), np.array([np.inf, 1.0]))):
        progress(COMPROMISES, k / count)
        ends.append(searched(trials.start, shares))
    values = np.array([slopes.in_all_cases(end).max(axis=1) for end in ends])
    best, widths = np.diag(values).copy(), np.maximum(values.max(axis=0) - np.diag(values), np.finfo(float).tiny)
    x = ends[0]
    for k in range(1, count - 1):
        progress(COMPROMISES, (k + 1) / count)
        x = searched(x, np.array([k, count - 1 - k]) / (count - 1))
    progress(COMPROMISES, 1.0)
    trials.at(alone.designs)
    return found(trials, "compromise", units, gradients=slopes.runs)
