"""Arrays that one thread has for itself."""

from __future__ import annotations

from math import prod

import numpy as np
from numpy.typing import NDArray

__all__ = ["LINE", "private"]

LINE = 128
"""Bytes that processors fetch together: a line of the cache and its neighbour."""


def private(*shape: int) -> NDArray[np.float64]:
    """Zeros that begin on such a line and have their last one for themselves.

    Vectors across two lines are slow to load, and a line that two threads write wanders between their cores.
    """
    item = np.dtype(np.float64).itemsize
    lines = -(-prod(shape) * item // LINE) + 1
    room = np.zeros(lines * LINE // item)
    start = -(room.ctypes.data // item) % (LINE // item)
    return room[start : start + prod(shape)].reshape(shape)
