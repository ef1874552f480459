"""Where a series is largest, by a rule that rounding does not decide."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

__all__ = ["worst_place"]

_SAME = 1e-9
"""Share of the largest size within which another one is as large."""


def worst_place(values: ArrayLike) -> tuple[int, ...]:
    """The first place, in the order of the axes, whose size is that of the largest value to nine digits.

    So of a robot that stands still it is the first instant, on every computer and in the page; no number is no value.
    """
    sizes = np.abs(np.asarray(values))
    first = int((sizes >= np.fmax.reduce(sizes, axis=None) * (1 - _SAME)).argmax())
    return tuple(map(int, np.unravel_index(first, sizes.shape)))
