"""Rotations as CasADi matrices: about an axis, by a rotation vector (smooth at zero), and back to a vector."""

from __future__ import annotations

from math import factorial
from typing import Any

import casadi as ca
import numpy as np

__all__ = ["about", "exponential", "skew", "vee"]

TERMS = 13
"""Terms of the series of the exponential: 1e-16 up to a rotation of 2 rad."""


def skew(u: Any) -> Any:
    """The matrix (3, 3) of the cross product by u (3,)."""
    return ca.skew(ca.vertcat(u[0], u[1], u[2]))


def vee(matrix: Any) -> Any:
    """The vector (3,) of the skew part of a matrix (3, 3)."""
    return ca.vertcat(matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]) / 2


def about(axis: Any, angle: Any) -> Any:
    """Rotation (3, 3) about the unit vector ``axis`` by ``angle`` [rad]."""
    across = skew(axis)
    return ca.DM.eye(3) + ca.sin(angle) * across + (1 - ca.cos(angle)) * (across @ across)


def exponential(vector: Any) -> Any:
    """Rotation (3, 3) by the rotation vector (3,) [rad], as a power series: it has derivatives at zero."""
    square, across = ca.dot(vector, vector), skew(vector)
    sine = sum((-square) ** k / factorial(2 * k + 1) for k in range(TERMS))
    versine = sum((-square) ** k / factorial(2 * k + 2) for k in range(TERMS))
    return np.eye(3) + sine * across + versine * (across @ across)
