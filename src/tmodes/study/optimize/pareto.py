"""Designs of which none is better in all objectives."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["pareto_front"]


def pareto_front(values: NDArray[np.float64]) -> NDArray[np.intp]:
    """Indices of the rows (m, o), all objectives to be small, that no other row dominates, by the first objective.

    A row dominates another where it is nowhere larger and somewhere smaller; of equal rows all are on the front.
    """
    order = np.lexsort(values.T[::-1])
    front: list[int] = []
    for k in order:  # what dominates a row comes before it
        known = values[front]
        if not ((known <= values[k]).all(axis=1) & (known < values[k]).any(axis=1)).any():
            front.append(int(k))
    return np.array(front, dtype=np.intp)
