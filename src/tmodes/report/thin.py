"""Fewer samples for a picture, honestly: a chart keeps every peak, the robot's pose is shown often enough."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

__all__ = ["MOST_FRAMES", "MOST_POINTS", "scene_frames", "thinned"]

MOST_POINTS = 6000
"""Points of a chart's abscissa beyond which it is thinned."""

MOST_FRAMES = 3000
"""Instants at which the robot is kept, at most."""

_RATE = 50.0
"""Instants at which the robot is kept in a simulated second."""

_FEW = 400
"""Instants of a short run, so that its vibration can be seen slowed down."""

_MOST_NUMBERS = 900_000
"""Numbers of one of the robot's arrays over all instants, at most."""

_FEWEST_BINS = 50

Indices = NDArray[np.intp]


def thinned(curves: NDArray[np.float64], most: int = MOST_POINTS) -> Indices:
    """Which of n samples a picture of ``curves``, shape (n, k), needs: in each of equal bins every curve's extremes.

    At most about ``most`` of them (more where there are very many curves); all where there are no more. The first and
    the last are always among them.
    """
    count, width = curves.shape
    if count <= most:
        return np.arange(count)
    bins = min(max(_FEWEST_BINS, most // (2 * max(width, 1))), count)
    edges = np.linspace(0, count, bins + 1).astype(np.intp)
    chosen = [np.array([0, count - 1], dtype=np.intp)]
    for start, end in pairwise(edges):
        part = curves[start:end]
        chosen += [start + part.argmin(axis=0), start + part.argmax(axis=0)]
    return np.unique(np.concatenate(chosen))


def scene_frames(times: NDArray[np.float64], numbers: int = 0) -> Indices:
    """The samples at which the robot is shown: evenly in time, 50 in a second or 400, at most :data:`MOST_FRAMES`.

    ``times`` (n,) [s], rising; ``numbers``: how many each instant takes of one array, which bounds the instants too.
    The first and the last sample are among them.
    """
    if len(times) < 2:
        return np.arange(len(times))
    room = max(2, min(MOST_FRAMES, _MOST_NUMBERS // max(numbers, 1)))
    wanted = max(_FEW, int(np.ceil((times[-1] - times[0]) * _RATE)) + 1)
    even = np.linspace(times[0], times[-1], min(wanted, room))
    after = np.clip(np.searchsorted(times, even), 1, len(times) - 1)
    nearer = even - times[after - 1] < times[after] - even
    return np.unique(np.where(nearer, after - 1, after))
