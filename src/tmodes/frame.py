"""Where a frame is, and which way it looks."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Placement", "along", "rotation_vector"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Placement:
    """Where a frame is and which way it looks: ``rotation`` (3, 3), columns = its axes; ``position`` (3,) [m]."""

    rotation: Array = field(default_factory=lambda: np.eye(3))
    position: Array = field(default_factory=lambda: np.zeros(3))

    def __matmul__(self, other: Placement) -> Placement:
        """The placement of a frame that is given in this one."""
        return Placement(self.rotation @ other.rotation, self.rotation @ other.position + self.position)

    def inverse(self) -> Placement:
        """The frame that this one is given in, as seen from this one."""
        return Placement(self.rotation.T, -self.rotation.T @ self.position)


def along(parts: ArrayLike) -> Array:
    """Components (..., k) of parts (..., k, 3) along their sum, which add up to its length; 0 where it is zero."""
    parts = np.asarray(parts, dtype=float)
    total = parts.sum(axis=-2)
    size = np.linalg.norm(total, axis=-1, keepdims=True)
    unit = np.divide(total, size, out=np.zeros_like(total), where=size > 0)
    return np.einsum("...ki,...i->...k", parts, unit)


SMALL = 1e-3
"""Angle [rad] below which the length of a rotation vector is taken from a series, exact to rounding."""


def rotation_vector(rotation: ArrayLike) -> Array:
    """The rotation vector (3,) [rad] of a rotation matrix (3, 3): its axis times its angle, at most pi long.

    By the quaternion, from its largest component (Shepperd, Quaternion from Rotation Matrix, J. Guid. Control 1, 1978).
    """
    matrix = np.asarray(rotation, dtype=float)
    trace = np.trace(matrix)
    candidates = [*np.diag(matrix), trace]
    largest = int(np.argmax(candidates))
    if largest == 3:
        quaternion = np.array([*_skew(matrix), 1 + trace])
    else:
        i, j, k = largest, (largest + 1) % 3, (largest + 2) % 3
        quaternion = np.empty(4)
        quaternion[i] = 1 - trace + 2 * matrix[i, i]
        quaternion[j] = matrix[j, i] + matrix[i, j]
        quaternion[k] = matrix[k, i] + matrix[i, k]
        quaternion[3] = matrix[k, j] - matrix[j, k]
    quaternion /= np.linalg.norm(quaternion)
    if quaternion[3] < 0:
        quaternion = -quaternion
    vector, real = quaternion[:3], quaternion[3]
    angle = 2 * np.arctan2(np.linalg.norm(vector), real)
    small = angle <= SMALL
    return vector * (2 + angle**2 / 12 + 7 * angle**4 / 2880 if small else angle / np.sin(angle / 2))


def _skew(matrix: Array) -> list[float]:
    """Twice the axis times the sine of the angle."""
    return [matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]
