"""Slopes of the terms by differences of second order: for what costs no simulation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.study.optimize.gradient import Terms
from tmodes.study.optimize.trials import Trials

__all__ = ["Differences"]

Array = NDArray[np.float64]

STEP = 1e-4
"""Of a parameter's range."""


class Differences:
    """Terms at points of the unit cube, each from the cases about it, which are computed together.

    The points themselves are among the ``trials``, their neighbours among the ``probes``.
    """

    def __init__(self, trials: Trials, probes: Trials) -> None:
        self.trials, self.probes = trials, probes
        self._known: dict[bytes, Terms] = {}

    def at(self, shares: Array) -> Terms:
        """The terms at shares (k,)."""
        key = shares.tobytes()
        if key not in self._known:
            self._known[key] = self._computed(shares)
        return self._known[key]

    def _computed(self, shares: Array) -> Terms:
        objective, excess = self._values(self.trials, shares[None])
        sides = _offsets(shares)
        points = shares + np.concatenate([STEP * sides[:, :1] * np.eye(len(shares)), STEP * sides[:, 1:] * np.eye(len(shares))])
        near = np.column_stack(self._values(self.probes, points)).reshape(2, len(shares), -1)
        here = np.concatenate([objective, excess[0]])
        slopes = _slopes(here, near, sides)
        return Terms(float(objective[0]), slopes[0], excess[0], slopes[1:])

    def _values(self, trials: Trials, shares: Array) -> tuple[Array, Array]:
        """Signed objective (m,) and excess (m, l) at points (m, k); not-a-number where a case failed."""
        judged = trials.judged(trials.at(trials.space.at(shares)))
        return judged.objectives[:, 0] * trials.goals.signs[0], np.where(
            np.isfinite(judged.excess), judged.excess, np.nan
        )


def _offsets(shares: Array) -> Array:
    """Steps to two neighbours of each parameter (k, 2): on both sides, or both inwards where it is at its end."""
    inner = (shares >= STEP) & (shares <= 1 - STEP)
    inwards = np.where(shares < STEP, 1.0, -1.0)
    return np.where(inner[:, None], [1.0, -1.0], inwards[:, None] * [1.0, 2.0])


def _slopes(here: Array, near: Array, sides: Array) -> Array:
    """Derivatives (terms, k) of the parabola through the values here (terms,) and near (2, k, terms)."""
    one, two = sides[:, :1], sides[:, 1:]
    rise_one, rise_two = (near[0] - here) / one, (near[1] - here) / two
    return ((rise_one * two - rise_two * one) / (two - one)).T / STEP
