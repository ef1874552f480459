"""What is rounding in a vector of numbers, and where a form of it is wrong by more than that."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.model.forms import Form

__all__ = ["mistaken", "rounding"]

Array = NDArray[np.float64]

_VERIFIED = 1e-12
_ROUNDING = 4e-15
"""Size of a number over that of its neighbours in the vector (of the same matrix, the same signal) that is rounding."""

_NEAR = 20


def rounding(values: Array) -> Array:
    """Size of what is rounding in a vector, by the largest of each number and its neighbours."""
    padded = np.pad(np.abs(np.where(np.isfinite(values), values, 0.0)), _NEAR)
    return _ROUNDING * np.lib.stride_tricks.sliding_window_view(padded, 2 * _NEAR + 1).max(axis=1, initial=0.0)


def mistaken(form: Form, values: Mapping[int, float], true: Array) -> NDArray[np.bool_]:
    """Which numbers of a form are not the ``true`` ones (n,) at a point, but for rounding."""
    noise = rounding(true)
    allowed = np.maximum(_VERIFIED * np.maximum(np.abs(true), _reach(form, true)), noise)
    return ~(np.abs(form.at(values) - true) <= allowed)


def _reach(form: Form, true: Array) -> Array:
    """Size of what is added up in a number: rounding is of that size."""
    size = np.zeros_like(true)
    for entry, terms in form.sums.items():
        size[entry] = max(abs(form.base[entry]), *(abs(coefficient) for coefficient, _ in terms))
    return size
