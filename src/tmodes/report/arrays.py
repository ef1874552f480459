"""Arrays for a picture: fewer samples that keep every peak, the digits that are seen, rotations as quaternions."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.report.pack import Coarse, TwoParts

__all__ = [
    "MOST_FRAMES", "MOST_POINTS", "colour", "displaced", "kept", "quaternions", "scene_frames", "stations_shown",
    "steady", "thinned",
]  # fmt: skip


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


Array = NDArray[np.float64]

_FINE = 30_000
"""Numbers up to which an array keeps the digits of single precision."""

_MOST_PLACES = 400_000
"""Places (frames, links, stations) beyond which fewer stations along each link are shown."""


def kept(values: Array) -> NDArray[np.float32] | Coarse:
    """An array as a picture needs it: in single precision, or, where it is large, in 65,000 steps."""
    return values.astype(np.float32) if values.size <= _FINE else Coarse(values)


def displaced(values: Array, rigid: Array, base: NDArray[np.float32] | Coarse) -> NDArray[np.float32] | TwoParts:
    """Places that differ little from ``rigid``, which is kept as ``base``.

    The difference keeps its own digits, because it is shown enlarged.
    """
    if values.size <= _FINE:
        return values.astype(np.float32)
    return TwoParts(base, kept(values - rigid))


def colour(name: str, label: str, unit: str, values: Array) -> dict[str, Any]:
    """What may colour the links; ``values`` (m, L, S)."""
    return {"id": name, "label": label, "unit": unit, "values": kept(values)}


def quaternions(rotation: Array) -> NDArray[np.float32]:
    """Quaternions x, y, z, w (m, L, 4) of rotations (m, L, 3, 3), along time without jumps of sign."""
    from scipy.spatial.transform import Rotation

    shape = rotation.shape[:-2]
    found = Rotation.from_matrix(rotation.reshape(-1, 3, 3)).as_quat().reshape(*shape, 4)
    return steady(found).astype(np.float32)


def steady(found: Array) -> Array:
    """The same rotations, each quaternion (m, L, 4) on the side of the one before it."""
    turns = np.where((found[1:] * found[:-1]).sum(axis=-1) < 0, -1.0, 1.0)
    signs = np.concatenate([np.ones((1, *turns.shape[1:])), np.cumprod(turns, axis=0)])
    return found * signs[..., None]


def stations_shown(count: int, frames: int, links: int) -> NDArray[np.intp]:
    """Indices of the stations along each link that are shown, root and tip among them."""
    most = max(5, _MOST_PLACES // max(frames * links, 1))
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(np.intp))
