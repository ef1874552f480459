"""Local optima by gradients, from one or several starts, as an optimum that is reported."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.gradients.quantities import Functional
from tmodes.study.optimize.goals import Goals
from tmodes.study.optimize.gradient import Descent, Differences, descend
from tmodes.study.optimize.leaves import cheap
from tmodes.study.optimize.result import Optimum
from tmodes.study.optimize.summary import found
from tmodes.study.optimize.trials import Trials

__all__ = ["by_gradient"]

Array = NDArray[np.float64]

STARTS = 3


def by_gradient(
    trials: Trials, functionals: Mapping[str, Functional], count: int, seed: int, units: dict[str, str],
    progress: Callable[[str, float], None],
) -> Optimum:  # fmt: skip
    """The best of the local optima."""
    if functionals or not cheap(trials.study):
        return _adjoint(trials, functionals, units, progress)
    probes = Trials(trials.study, trials.space, trials.goals, trials.scenarios, None, progress, {})
    slopes = Differences(trials, probes)
    ends = [descend(slopes, start, lambda steps: progress("steps", 0.0)) for start in _starts(trials, count, seed)]
    best = min(ends, key=lambda end: (end.terms.excess.max(initial=0.0) > 0, end.terms.objective))
    return found(trials, "gradient", units, prices=_prices(trials.goals, best))


def _adjoint(trials: Trials, functionals: Mapping[str, Functional], units: dict[str, str], progress: Any) -> Optimum:
    from tmodes.study.optimize.adjoint import Adjoint

    slopes = Adjoint(trials, functionals)
    end = descend(slopes, slopes.start, lambda steps: progress("runs with gradients", 0.0))
    return found(trials, "gradient", units, gradients=slopes.runs, prices=_prices(trials.goals, end))


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
