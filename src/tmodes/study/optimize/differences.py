"""Slopes of the terms by differences of second order: for what costs no simulation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.study.optimize.gradient import Terms
from tmodes.study.optimize.stencil import neighbours, slopes
from tmodes.study.optimize.trials import Trials

__all__ = ["Differences"]

Array = NDArray[np.float64]


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
        here = self._values(self.trials, shares[None])
        values = np.concatenate([here, self._values(self.probes, neighbours(shares)[1:])])
        along = slopes(values, shares)
        return Terms(float(values[0, 0]), along[0], values[0, 1:], along[1:])

    def _values(self, trials: Trials, shares: Array) -> Array:
        """Signed objective and excess (m, 1 + l) at points (m, k); not-a-number where a case failed."""
        judged = trials.judged(trials.at(trials.space.at(shares)))
        excess = np.where(np.isfinite(judged.excess), judged.excess, np.nan)
        return np.column_stack([judged.objectives[:, 0] * trials.goals.signs[0], excess])
