"""Axes in numbers: rotation matrices of angles, quaternions and axes, and the line of a beam that is bent at rest."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.noted.functions import array, norm, number, sin

__all__ = [
    "bent_line", "cross_matrix", "matrix_quaternion", "quaternion_matrix", "rotation_about", "rpy_matrix", "unit",
]  # fmt: skip

Array = NDArray[np.float64]


def unit(vector: ArrayLike) -> Array:
    """The vector of length 1 in the same direction; the vector must not be zero."""
    values = array(vector)
    if values.dtype == float:
        values = values / np.abs(values).max()  # first by the largest entry, so that no square overflows or vanishes
    return values / norm(values)


def cross_matrix(vector: ArrayLike) -> Array:
    """The matrix (3, 3) that multiplies as ``vector x``."""
    x, y, z = array(vector)
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def rotation_about(axis: ArrayLike, angle: float) -> Array:
    """Rotation (3, 3) by an angle [rad] about a unit vector (Rodrigues)."""
    cross = cross_matrix(axis)
    return np.eye(3) + sin(angle) * cross + 2 * sin(angle / 2) ** 2 * cross @ cross


def rpy_matrix(roll: float, pitch: float, yaw: float) -> Array:
    """Rotation (3, 3) by roll about x, then pitch about y, then yaw about z, axes that stay, as in URDF [rad]."""
    x, y, z = (rotation_about(axis, angle) for axis, angle in zip(np.eye(3), (roll, pitch, yaw), strict=True))
    return z @ y @ x


def quaternion_matrix(quaternion: ArrayLike) -> Array:
    """Rotation (3, 3) of a quaternion (x, y, z, w), which is made of unit length first."""
    x, y, z, w = unit(quaternion)
    cross = cross_matrix((x, y, z))
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def matrix_quaternion(matrix: ArrayLike) -> Array:
    """Quaternions (..., 4) as x, y, z, w of unit length, of rotations (..., 3, 3).

    By the largest of its parts (Shepperd, Journal of Guidance and Control 1, 1978).
    """
    m = np.asarray(matrix, dtype=float)
    own, trace = np.diagonal(m, axis1=-2, axis2=-1), np.trace(m, axis1=-2, axis2=-1)
    squares = np.concatenate([1 + 2 * own - trace[..., None], 1 + trace[..., None]], axis=-1)
    products = squares[..., None] * np.eye(4)  # four times each part times each
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        products[..., i, j] = products[..., j, i] = m[..., i, j] + m[..., j, i]
        products[..., k, 3] = products[..., 3, k] = m[..., j, i] - m[..., i, j]
    largest = squares.argmax(axis=-1)[..., None, None]
    found = np.take_along_axis(products, largest, axis=-2)[..., 0, :]
    return found / np.linalg.norm(found, axis=-1, keepdims=True)


def bent_line(curvature: ArrayLike, length: float) -> tuple[Array, Array]:
    """Rotation (3, 3) and position (3,) [m] of the end of a line of constant ``curvature`` (twist, y, z) [1/m].

    The line starts at the origin along x; its frame obeys R' = R [curvature x], its position p' = R e_x: a helix.
    """
    bent = array(curvature) * length
    angle = number(norm(bent))
    if angle == 0.0:
        return np.eye(3), np.array([length, 0.0, 0.0])
    cross = cross_matrix(bent)
    first, second = _half_versine(angle), _sine_defect(angle)
    mean = np.eye(3) + first * cross + second * cross @ cross
    return rotation_about(bent / angle, angle), length * mean[:, 0]


def _half_versine(angle: float) -> float:
    """(1 - cos a)/a^2."""
    return number(2 * (sin(angle / 2) / angle) ** 2)


def _sine_defect(angle: float) -> float:
    """(a - sin a)/a^3; by its series where the difference would cancel."""
    if angle < 0.1:
        square = angle**2
        return 1 / 6 - square / 120 + square**2 / 5040 - square**3 / 362880
    return number((angle - sin(angle)) / angle**3)
