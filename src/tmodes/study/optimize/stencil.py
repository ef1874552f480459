"""Neighbours of a point in the unit cube, and slopes from the values there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["STEP", "neighbours", "slopes"]

Array = NDArray[np.float64]

STEP = 1e-4
"""Of a parameter's range."""


def neighbours(shares: Array) -> Array:
    """A point (k,) and two neighbours along each parameter, (2 k + 1, k): on both sides, at an end both inwards."""
    one, two = (np.diag(side) for side in _sides(shares).T)
    return shares + np.concatenate([np.zeros((1, len(shares))), one, two])


def slopes(values: Array, shares: Array) -> Array:
    """Derivatives (..., k) of the parabola through the values (2 k + 1, ...) at the neighbours of a point (k,)."""
    k = len(shares)
    sides = _sides(shares).reshape(k, 2, *[1] * (values.ndim - 1))
    one, two = sides[:, 0], sides[:, 1]
    here = (values[1 : k + 1] - values[0]) / one * two - (values[k + 1 :] - values[0]) / two * one
    return np.moveaxis(here / (two - one), 0, -1)


def _sides(shares: Array) -> Array:
    """Steps to both neighbours of each parameter, (k, 2)."""
    inner = (shares >= STEP) & (shares <= 1 - STEP)
    inwards = np.where(shares < STEP, 1.0, -1.0)
    return STEP * np.where(inner[:, None], [1.0, -1.0], inwards[:, None] * [1.0, 2.0])
