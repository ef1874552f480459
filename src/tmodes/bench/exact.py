"""Accelerations of the rigid chain in extended precision, by a way of its own: Jacobians of all links, one solve.

Newton-Euler equations projected onto the joints, M a = -h, with M = sum m Jv^T Jv + Jw^T I Jw (Siciliano et al.,
Robotics, 2009, section 7.1). Slow and simple; no code is shared with the recursion that it judges.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.bench.rigid import CENTER, GRAVITY, INERTIA, MASS, TURNED, RigidChain

__all__ = ["accelerations", "relative_error"]

_WIDE = np.longdouble
"""80 bits where the processor has them (x86); elsewhere errors near rounding are of both sides."""


def accelerations(robot: RigidChain, q: ArrayLike, v: ArrayLike) -> NDArray[np.float64]:
    """Accelerations without efforts [rad/s^2], (n, joints), at n states."""
    pairs = zip(np.asarray(q, dtype=_WIDE), np.asarray(v, dtype=_WIDE), strict=True)
    return np.array([_at(robot, *pair) for pair in pairs], dtype=float)


def relative_error(found: NDArray[np.float64], exact: NDArray[np.float64]) -> float:
    """Largest error of the accelerations of a state over the largest acceleration of that state."""
    return float((np.abs(found - exact).max(axis=1) / np.abs(exact).max(axis=1)).max())


def _at(robot: RigidChain, q: Any, v: Any) -> Any:
    axes, origins, turns = _poses(robot, q)
    n = robot.joints
    centers = origins + turns @ CENTER.astype(_WIDE)
    # Column j of link k: its velocity per rate of joint j, which moves it only where j <= k.
    moved = np.tril(np.ones((n, n), dtype=_WIDE))[:, None, :]
    angular = moved * axes.T[None]
    linear = moved * np.cross(axes[None], centers[:, None] - origins[None]).transpose(0, 2, 1)
    inertias = turns * INERTIA.astype(_WIDE) @ turns.transpose(0, 2, 1)
    rates = angular @ v
    force, torque = _drift(axes, origins, centers, v)
    force = MASS * (force - GRAVITY.astype(_WIDE))
    spin = (inertias @ rates[:, :, None])[:, :, 0]
    torque = (inertias @ torque[:, :, None])[:, :, 0] + np.cross(rates, spin)
    flat_linear, flat_angular = linear.reshape(3 * n, n), angular.reshape(3 * n, n)
    matrix = MASS * flat_linear.T @ flat_linear + flat_angular.T @ (inertias @ angular).reshape(3 * n, n)
    bias = flat_linear.T @ force.ravel() + flat_angular.T @ torque.ravel()
    return _solve(matrix, -bias)


def _poses(robot: RigidChain, q: Any) -> tuple[Any, Any, Any]:
    """Joint axes (n, 3), joint origins (n, 3) [m] and link rotations (n, 3, 3) in the base's axes."""
    turn, origin = np.eye(3, dtype=_WIDE), np.zeros(3, dtype=_WIDE)
    axes, origins, turns = [], [], []
    for angle, axis, place in zip(q, robot.axes, robot.places.astype(_WIDE), strict=True):
        origin = origin + turn @ place
        turn = turn @ TURNED.astype(_WIDE) @ _about(int(axis), angle)
        axes.append(turn[:, axis])
        origins.append(origin)
        turns.append(turn)
    return np.array(axes), np.array(origins), np.array(turns)


def _about(axis: int, angle: Any) -> Any:
    first, second = (axis + 1) % 3, (axis + 2) % 3
    turn = np.eye(3, dtype=_WIDE)
    turn[first, first] = turn[second, second] = np.cos(angle)
    turn[second, first], turn[first, second] = np.sin(angle), -np.sin(angle)
    return turn


def _drift(axes: Any, origins: Any, centers: Any, v: Any) -> tuple[Any, Any]:
    """Linear accelerations of the centers and angular ones of the links, (n, 3), while all joints keep their rates."""
    rate, spin, pull, before = (np.zeros(3, dtype=_WIDE) for _ in range(4))
    linear, angular = [], []
    for axis, origin, center, speed in zip(axes, origins, centers, v, strict=True):
        arm = origin - before
        pull = pull + np.cross(spin, arm) + np.cross(rate, np.cross(rate, arm))
        spin = spin + np.cross(rate, axis * speed)
        rate = rate + axis * speed
        arm = center - origin
        linear.append(pull + np.cross(spin, arm) + np.cross(rate, np.cross(rate, arm)))
        angular.append(spin)
        before = origin
    return np.array(linear), np.array(angular)


def _solve(matrix: Any, right: Any) -> Any:
    """Solution by elimination without pivoting: the matrix is positive definite; LAPACK has no extended precision."""
    a, x = matrix.copy(), right.copy()
    n = len(x)
    for k in range(n):
        factors = a[k + 1 :, k] / a[k, k]
        a[k + 1 :, k:] -= factors[:, None] * a[k, k:]
        x[k + 1 :] -= factors * x[k]
    for k in reversed(range(n)):
        x[k] = (x[k] - a[k, k + 1 :] @ x[k + 1 :]) / a[k, k]
    return x
