"""Local optima, by gradients from one or several starts, or without, as an optimum that is reported."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.gradients.quantities import Functional
from tmodes.study.optimize.adjoint import Adjoint
from tmodes.study.optimize.goals import Goals, Judged
from tmodes.study.optimize.gradient import MOST_STEPS, Descent, descend, descend_worst, ended
from tmodes.study.optimize.leaves import cheap
from tmodes.study.optimize.result import Optimum
from tmodes.study.optimize.summary import found
from tmodes.study.optimize.trials import Trials

__all__ = ["by_gradient", "without_gradient"]

Array = NDArray[np.float64]

STARTS = 3


def by_gradient(
    trials: Trials, functionals: Mapping[str, Functional], count: int, seed: int, units: dict[str, str],
    progress: Callable[[str, float], None],
) -> Optimum:  # fmt: skip
    """The best of the local optima."""
    slopes, simulated = Adjoint(trials, functionals), bool(functionals) or not cheap(trials.study)
    starts = [trials.start] if simulated else _starts(trials, count, seed)
    stage = "runs with gradients" if simulated else "steps"
    ends = [_end(slopes, start, lambda steps: progress(stage, steps / MOST_STEPS)) for start in starts]
    best = min(ends, key=lambda end: (end.terms.excess.max(initial=0.0) > 0, end.terms.objective))
    trials.complete()
    return found(trials, "gradient", units, gradients=slopes.runs, prices=_prices(trials.goals, best))


def _end(slopes: Adjoint, start: Array, tell: Callable[[int], None]) -> Descent:
    """Where a search from a start ends; of one case, or a percentile of all, along the slope of what decides."""
    if len(slopes.trials.scenarios) == 1 or slopes.trials.goals.percentile < _ALL:
        return descend(slopes.at, start, tell)
    precision = _COARSE if slopes.simulated else _FINE
    shares = descend_worst(slopes.in_all_cases, slopes.of_case, start, tell, precision=precision)
    return ended(shares, slopes.at(shares))


_ALL, _COARSE, _FINE = 100.0, 3e-4, 1e-10
"""Percentile; precision of an optimum of runs, and of numbers at rest."""


def without_gradient(
    trials: Trials, count: int, units: dict[str, str], progress: Callable[[str, float], None]
) -> Optimum:
    """A local optimum from the sheet's own design in at most ``count`` trials, by quadratic models of what they give.

    COBYQA (T. M. Ragonneau, Z. Zhang, arXiv:2311.16812), with limits; what fails counts as ten times the start.
    """
    from scipy.optimize import Bounds, NonlinearConstraint, minimize

    space, sign = trials.space, trials.goals.signs[0]
    first = trials.judged(trials.at(space.at(trials.start[None])))
    scale = abs(float(first.objectives[0, 0])) if np.isfinite(first.objectives[0, 0]) else 1.0

    def judged(x: Array) -> Judged:
        progress("designs", min(1.0, len(trials) / count))
        return trials.judged(trials.at(space.at(np.clip(x, 0.0, 1.0)[None])))

    def objective(x: Array) -> float:
        value = sign * float(judged(x).objectives[0, 0]) / (scale or 1.0)
        return value if np.isfinite(value) else _FAILED

    def excess(x: Array) -> Array:
        return np.nan_to_num(judged(x).excess[0], nan=_FAILED, posinf=_FAILED)

    limits = [NonlinearConstraint(excess, -np.inf, 0.0)] if trials.goals.limits else []
    options = {"maxfev": count, "initial_tr_radius": 0.1, "final_tr_radius": 1e-4}
    minimize(objective, trials.start, method="COBYQA", bounds=Bounds(0.0, 1.0), constraints=limits, options=options)
    return found(trials, "cobyqa", units)


_FAILED = 10.0


def _starts(trials: Trials, count: int, seed: int) -> list[Array]:
    """The best of evenly spread points of the unit cube."""
    from scipy.stats import qmc

    space = trials.space
    points = qmc.Sobol(len(space.names), scramble=True, rng=np.random.default_rng(seed))
    shares = points.random_base2(max(2, int(np.ceil(np.log2(count)))))
    judged = trials.judged(trials.at(space.at(shares)))
    signed = judged.objectives[:, 0] * trials.goals.signs[0]
    order = np.lexsort((signed, np.where(np.isnan(signed), np.inf, judged.violation)))
    return [shares[k] for k in order[:STARTS]]


def _prices(goals: Goals, end: Descent) -> dict[str, float]:
    """By how much the objective changes with the bound of each limit that is active."""
    return {
        limit.text: -float(goals.signs[0]) * limit.sign * float(multiplier) / limit.scale
        for limit, multiplier in zip(goals.limits, end.multipliers, strict=True)
        if multiplier
    }
