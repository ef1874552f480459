"""Local optima by gradients: sequential quadratic programming."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["STEP", "Descent", "Terms", "descend", "neighbours", "slopes"]

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
    terms = terms_at(shares)
    return Descent(shares, terms, _multipliers(shares, terms))


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
