"""The robot of the benchmark, in plain numbers that every engine is given: a serial chain of rigid links in general.

Revolute joints about x, y and z in turn, on frames turned by Rz(0.3) Rx(0.2) and shifted at random; all links alike.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, Joint, Node
from tmodes.frame import Placement
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.registry import RigidLink

__all__ = ["CENTER", "GRAVITY", "INERTIA", "MASS", "TURNED", "RigidChain"]

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
