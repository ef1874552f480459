"""Local optima by gradients: sequential quadratic programming."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["STEP", "Descent", "Terms", "descend", "descend_worst", "ended", "neighbours", "slopes"]

Array = NDArray[np.float64]

STEP = 1e-4
"""Of a parameter's range."""


def neighbours(shares: Array, step: float = STEP) -> Array:
    """A point (k,) and two neighbours along each parameter, (2 k + 1, k): on both sides, at an end both inwards."""
    one, two = (np.diag(side) for side in _sides(shares, step).T)
    return shares + np.concatenate([np.zeros((1, len(shares))), one, two])


def slopes(values: Array, shares: Array, step: float = STEP) -> Array:
    """Derivatives (..., k) of the parabola through the values (2 k + 1, ...) at the neighbours of a point (k,)."""
    k = len(shares)
    sides = _sides(shares, step).reshape(k, 2, *[1] * (values.ndim - 1))
    one, two = sides[:, 0], sides[:, 1]
    here = (values[1 : k + 1] - values[0]) / one * two - (values[k + 1 :] - values[0]) / two * one
    return np.moveaxis(here / (two - one), 0, -1)


def _sides(shares: Array, step: float) -> Array:
    """Steps to both neighbours of each parameter, (k, 2)."""
    inner = (shares >= step) & (shares <= 1 - step)
    inwards = np.where(shares < step, 1.0, -1.0)
    return step * np.where(inner[:, None], [1.0, -1.0], inwards[:, None] * [1.0, 2.0])


MOST_STEPS = 200
_PRECISION = 1e-12
_WITHIN = 2e-10
"""Share of a limit by which the search stays within it, so that rounding does not lead outside."""
_ACTIVE = 1e-6


class Terms(NamedTuple):
    """At one point of the unit cube: the signed ``objective`` and its slope (k,), ``excess`` (l,) and slopes (l, k)."""

    objective: float
    slope: Array
    excess: Array
    slopes: Array


class Descent(NamedTuple):
    """Where a search ended; ``multipliers`` (l,): decrease of the objective by the excess that a limit would allow."""

    shares: Array
    terms: Terms
    multipliers: Array


def descend(
    terms_at: Callable[[Array], Terms], start: Array, tell: Callable[[int], None] = lambda steps: None
) -> Descent:
    """A local optimum from a start (k,) in the unit cube: SLSQP (D. Kraft, 1988), L-BFGS-B where there is no limit."""
    from scipy.optimize import Bounds, minimize

    first = terms_at(start)
    if not np.isfinite(first.objective):
        return Descent(start, first, np.zeros(len(first.excess)))
    scale = abs(first.objective) or 1.0
    steps = [0]

    def at(x: Array) -> Terms:
        return _passable(terms_at(np.clip(x, 0.0, 1.0)), first)

    def count(_: Array) -> None:
        steps[0] += 1
        tell(steps[0])

    def objective(x: Array) -> tuple[float, Array]:
        terms = at(x)
        return terms.objective / scale, terms.slope / scale

    options = {"maxiter": MOST_STEPS, "ftol": _PRECISION}
    bounds = Bounds(0.0, 1.0)
    if not first.excess.size:
        options |= {"gtol": 1e-9}
        end = minimize(objective, start, jac=True, method="L-BFGS-B", bounds=bounds, callback=count, options=options)
    else:
        limits = {
            "type": "ineq",
            "fun": lambda x: -at(x).excess - _WITHIN,
            "jac": lambda x: -at(x).slopes,
        }
        end = minimize(
            objective, start, jac=True, method="SLSQP", bounds=bounds, constraints=limits, callback=count,
            options=options,
        )  # fmt: skip
    shares = np.clip(end.x, 0.0, 1.0)
    return ended(shares, terms_at(shares))


def ended(shares: Array, terms: Terms) -> Descent:
    """A search that ended there."""
    return Descent(shares, terms, _multipliers(shares, terms))


_MOST_WORST = 60
_FIRST_RADIUS, _LARGEST_RADIUS, _LEAST_RADIUS = 0.1, 0.3, 1e-6
"""Steps; of the unit cube, how far one leads."""

_PENALTY, _ENOUGH, _GOOD, _NONE = 10.0, 0.1, 0.7, 1e-9
"""Of a limit's excess; shares of the foreseen gain for a step, and for a longer next one; of a slope, what is none."""


class _Cases:
    """Objective and limits of all cases at points of the unit cube; an objective that explodes grows as a line."""

    def __init__(self, in_all_cases: Callable[[Array], Array], of_case: Callable[[Array, int], Terms], start: Array):
        self._in_all, self._of_case = in_all_cases, of_case
        self.scale = abs(in_all_cases(start)[0].max()) or 1.0
        self.bad: list[tuple[int, int]] = []
        self._reach: dict[tuple[int, int], float] = {}

    def at(self, x: Array) -> Array:
        """Objective and excess of the limits (1 + l, s)."""
        found = self._in_all(x).copy()
        found[0] = np.arcsinh(found[0] / self.scale)
        return np.where(np.isfinite(found), found, np.inf)

    def merit(self, values: Array) -> float:
        """The worst objective and what limits are exceeded by."""
        return float(values[0].max() + _PENALTY * np.maximum(values[1:], 0.0).max(initial=0.0))

    def seen(self, values: Array) -> bool:
        """Take in which cases decide; whether all of them were known."""
        new = [(row, int(case)) for row, case in enumerate(values.argmax(axis=1)) if (row, int(case)) not in self.bad]
        self.bad += new
        return not new

    def step(self, x: Array, values: Array, radius: float) -> tuple[Array, float]:
        """The best step (k,) within a radius by the slopes of the cases that may decide, and the gain it foresees."""
        from scipy.optimize import linprog

        worst, rows, ends = values.max(axis=1), [], []
        for row, case in self.bad:
            own = values[row, case]
            if own + 2 * radius * self._reach.get((row, case), np.inf) < (worst[0] if row == 0 else 0.0):
                continue
            terms = self._of_case(x, case)
            slope = terms.slope / np.hypot(self.scale, terms.objective) if row == 0 else terms.slopes[row - 1]
            self._reach[row, case] = float(np.abs(slope).sum())
            rows.append([*slope, *((-1.0, 0.0) if row == 0 else (0.0, -1.0))])
            ends.append(-own - (_WITHIN if row else 0.0))
        acting = np.abs(rows)[:, :-2].max(axis=0) > _NONE * np.abs(rows)[:, :-2].max()
        near = (acting * np.clip([-x, 1.0 - x], -radius, radius)).T
        goal = [*np.zeros(len(x)), 1.0, _PENALTY]
        found = linprog(goal, rows, ends, bounds=[*near, (None, None), (0.0, None)])
        return found.x[: len(x)], self.merit(values) - found.fun


def descend_worst(
    in_all_cases: Callable[[Array], Array], of_case: Callable[[Array, int], Terms], start: Array,
    tell: Callable[[int], None] = lambda steps: None, *, precision: float,
) -> Array:  # fmt: skip
    """A local optimum (k,) of the worst of all cases: linear programs of those that have decided, within a radius.

    K. Madsen, An algorithm for minimax solution of overdetermined systems of non-linear equations, IMA J. Appl. Math.
    16, 1975. ``in_all_cases``: objective and excess of the limits (1 + l, s); ``of_case``: the terms of one case;
    ``precision``: of the objective at the start, the gain with which it ends. The worst of smooth functions has edges,
    at which a descent along the slope of the worst one alone stops.
    """
    x, radius = start, _FIRST_RADIUS
    cases = _Cases(in_all_cases, of_case, start)
    values = cases.at(x)
    if not np.isfinite(values).all():
        return start
    cases.seen(values)
    for steps in range(_MOST_WORST):
        tell(steps)
        move, foreseen = cases.step(x, values, radius)
        enough = _PRECISION if (values[1:] > 0).any() else precision
        if foreseen < enough * min(1.0, radius / _FIRST_RADIUS) or radius < max(_LEAST_RADIUS, precision):
            break
        there = np.clip(x + move, 0.0, 1.0)
        after = cases.at(there)
        known = cases.seen(after)
        share = (cases.merit(values) - cases.merit(after)) / foreseen
        if share > _ENOUGH:
            x, values = there, after
            radius = min(_LARGEST_RADIUS, 2 * radius) if share > _GOOD else radius
        elif known:
            radius /= 3
    return x


def _passable(terms: Terms, first: Terms) -> Terms:
    """Terms of a design that failed are bad, so that the search turns back."""
    if all(np.isfinite(one).all() for one in terms):
        return terms
    worse = first.objective + 10 * (abs(first.objective) or 1.0)
    return Terms(worse, np.zeros_like(first.slope), np.ones_like(first.excess), np.zeros_like(first.slopes))


def _multipliers(shares: Array, terms: Terms) -> Array:
    """Of the limits, from -slope = sum of multipliers times slopes of all that is active, bounds too; none negative."""
    from scipy.optimize import nnls

    active = np.abs(terms.excess) < _ACTIVE
    own = np.eye(len(shares))
    columns = np.vstack([terms.slopes[active], own[shares > 1 - _ACTIVE], -own[shares < _ACTIVE]])
    found = np.zeros(len(terms.excess))
    if active.any():
        found[active] = nnls(columns.T, -terms.slope)[0][: active.sum()]
    return found
