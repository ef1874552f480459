"""What holds a robot at rest and what does not: decided in a way that does not depend on how the world is turned.

Turning the world leaves rounding where a stiffness or a force was exactly zero. So each coordinate is measured by its
own stiffness, or by the largest one that weight, loads and surfaces could bring it in any attitude (``reach``).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["NOTHING", "beyond_rounding", "is_positive", "is_rounding", "leading", "scale_of", "solved", "unheld"]

Array = NDArray[np.float64]

NOTHING = 1e-14
"""Share of the largest stiffness or squared frequency, per coordinate, below which another is zero to rounding."""


ALIKE = 1e-6
"""Difference of two coordinates' shares in a motion that is rounding: the first of them is named."""


def scale_of(stiffness: Array, reach: Array) -> Array:
    """Roots (n,) of the stiffness by which each coordinate is measured, of K (n, n) and ``reach`` (n,)."""
    own = np.where(_without(stiffness, reach), reach, np.abs(np.diagonal(stiffness)))
    return np.sqrt(np.where(own > 0, own, 1.0))


def unheld(stiffness: Array, reach: Array) -> Array:
    """What nothing holds: unit vectors (n, k) of coordinates times their scales, along which no force is answered."""
    if not (stiffness.size and np.isfinite(stiffness).all() and np.isfinite(reach).all()):
        return np.zeros((len(stiffness), 0))
    scale = scale_of(stiffness, reach)
    alike = stiffness / np.outer(scale, scale)
    held = _held(np.linalg.svd(alike, compute_uv=False))
    return np.zeros((len(held), 0)) if held.all() else np.asarray(np.linalg.svd(alike)[0][:, ~held], dtype=float)


def leading(motions: Array) -> tuple[int, ...]:
    """Of motions (n, k), independent of each other, the k coordinates that take the largest part in them."""
    found, left = [], motions
    for _ in range(motions.shape[1]):
        shares = np.linalg.norm(left, axis=1)
        found.append(int((shares >= shares.max() * (1 - ALIKE)).argmax()))
        along = left[found[-1]] / shares[found[-1]]
        left = left - np.outer(left @ along, along)
    return tuple(sorted(found))


def solved(matrix: Array, right: Array, reach: Array) -> Array | None:
    """The solution, the shortest one along what nothing holds; None for numbers that are not finite."""
    if not (np.isfinite(matrix).all() and np.isfinite(right).all()):
        return None
    if not len(matrix):
        return np.zeros(0)
    scale = scale_of(matrix, reach)
    alike = matrix / np.outer(scale, scale)
    if _held(np.linalg.svd(alike, compute_uv=False)).all():
        return np.asarray(np.linalg.solve(alike, right / scale), dtype=float) / scale
    left, values, shapes = np.linalg.svd(alike)
    held = _held(values)
    return np.asarray(shapes[held].T @ (left[:, held].T @ (right / scale) / values[held]) / scale, dtype=float)


def is_positive(stiffness: Array, reach: Array) -> bool:
    """Whether no motion is pushed on by a symmetric K (n, n), beyond rounding."""
    scale = scale_of(stiffness, reach)
    return bool(np.linalg.eigvalsh(stiffness / np.outer(scale, scale))[0] > -NOTHING * len(scale))


def beyond_rounding(force: Array, stiffness: Array, reach: Array) -> Array:
    """Forces (n,), of which those of coordinates without stiffness are zero where they are rounding."""
    return np.where(_without(stiffness, reach) & is_rounding(force, reach), 0.0, force)


def is_rounding(values: Array, reach: Array) -> NDArray[np.bool_]:
    """Which forces, or stiffnesses, (n,) are rounding of what could act."""
    return np.abs(values) <= NOTHING * len(reach) * reach


def _without(stiffness: Array, reach: Array) -> NDArray[np.bool_]:
    return is_rounding(np.diagonal(stiffness), reach)


def _held(values: NDArray[Any]) -> NDArray[np.bool_]:
    """Of singular values of a stiffness that is scaled to 1, the largest first."""
    return values > NOTHING * len(values) * max(1.0, float(values[0]))
