"""Arrays of a scene: the digits a picture keeps, turning as quaternions, fewer stations where there are too many."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.report.pack import Coarse, TwoParts

__all__ = ["colour", "displaced", "kept", "quaternions", "stations_shown", "steady"]

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
