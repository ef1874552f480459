"""The robot of the benchmark: a serial chain of rigid links in general; its accelerations in extended precision."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.chain.chain import Chain, Joint, Node
from tmodes.frame import Placement
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.registry import RigidLink

__all__ = ["CENTER", "GRAVITY", "INERTIA", "MASS", "TURNED", "RigidChain", "accelerations", "relative_error"]


Array = NDArray[np.float64]

MASS = 1.0
"""Mass of a link [kg]."""

CENTER = np.array([0.05, 0.01, 0.02])
"""Center of mass of a link in its frame [m]."""

INERTIA = np.array([0.01, 0.02, 0.02])
"""Moments of inertia of a link about its center of mass, along its axes [kg*m^2]."""

GRAVITY = np.array([0.0, 0.0, -9.81])
"""Gravity in the base's axes [m/s^2]."""

_Z, _X = 0.3, 0.2
TURNED = np.array([[np.cos(_Z), -np.sin(_Z), 0.0], [np.sin(_Z), np.cos(_Z), 0.0], [0.0, 0.0, 1.0]]) @ np.array(
    [[1.0, 0.0, 0.0], [0.0, np.cos(_X), -np.sin(_X)], [0.0, np.sin(_X), np.cos(_X)]]
)
"""Rotation of each joint frame against the link before."""


@dataclass(frozen=True, eq=False)
class RigidChain:
    """``joints`` joints: ``axes`` (joints,) 0, 1 or 2 for x, y, z; ``places`` (joints, 3) [m] in the link before."""

    joints: int

    @property
    def axes(self) -> NDArray[np.intp]:
        """Which axis each joint turns about."""
        return np.arange(self.joints) % 3

    @property
    def places(self) -> Array:
        """Where each joint is in the link before [m]; the first joints are the same for all lengths."""
        return np.random.default_rng(1).uniform(-0.1, 0.1, (self.joints, 3))

    def states(self, count: int) -> tuple[Array, Array]:
        """Coordinates [rad] and rates [rad/s] of ``count`` states at random, each (count, joints)."""
        drawn = np.random.default_rng(0).normal(size=(2, count, self.joints))
        return drawn[0], drawn[1]

    def chain(self) -> Chain:
        """The same robot as a chain of this package."""
        nodes = []
        for k, (axis, place) in enumerate(zip(self.axes, self.places, strict=True)):
            joint = Joint(f"j{k}", joint_kind("revolute"), Placement(TURNED, place), np.eye(3)[axis])
            nodes.append(Node(f"l{k}", k - 1, joint, RigidLink((Body(MASS, CENTER, np.diag(INERTIA)),))))
        return Chain("bench", tuple(nodes), GRAVITY)


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
    centers = origins + turns @ CENTER.astype(_WIDE)
    screws = np.concatenate([axes, np.cross(origins, axes)], axis=1)
    about_centers = turns * INERTIA.astype(_WIDE) @ turns.transpose(0, 2, 1)
    moments = np.einsum("kij,kj->ki", _outward(_spatial(about_centers, centers)), screws)
    lower = np.tril(moments @ screws.T)
    matrix = lower + np.tril(lower, -1).T
    linear, spin = _drift(axes, origins, centers, v)
    rates = np.cumsum(axes * v[:, None], axis=0)
    force = MASS * (linear - GRAVITY.astype(_WIDE))
    angular = np.einsum("kij,kj->ki", about_centers, rates)
    torque = np.einsum("kij,kj->ki", about_centers, spin) + np.cross(rates, angular) + np.cross(centers, force)
    wrenches = _outward(np.concatenate([torque, force], axis=1))
    return _solve(matrix, -np.sum(screws * wrenches, axis=1))


def _spatial(about_centers: Any, centers: Any) -> Any:
    """Spatial inertias (n, 6, 6) of the links at the base's origin, angular part first."""
    zero = np.zeros(len(centers), dtype=_WIDE)
    x, y, z = centers.T
    lever = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    across, unit = MASS * lever, np.broadcast_to(MASS * np.eye(3, dtype=_WIDE), lever.shape)
    return np.block([[about_centers - lever @ across, across], [-across, unit]])


def _outward(values: Any) -> Any:
    """Sums over each link and all links beyond it."""
    return np.cumsum(values[::-1], axis=0)[::-1]


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
        lever = origin - before
        pull = pull + np.cross(spin, lever) + np.cross(rate, np.cross(rate, lever))
        spin = spin + np.cross(rate, axis * speed)
        rate = rate + axis * speed
        lever = center - origin
        linear.append(pull + np.cross(spin, lever) + np.cross(rate, np.cross(rate, lever)))
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
