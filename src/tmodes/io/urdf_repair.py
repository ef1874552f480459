"""Impossible inertias of a URDF's links made possible, and by how much that may lower a natural frequency.

The moments about the axes of the joints that turn a link are kept (:func:`tmodes.kinds.links.body.raised_inertia`), the
others raised. A mass matrix that grows from M - D to M lowers no frequency of any springs by more than the factor
sqrt(1 - l), l the largest eigenvalue of D x = l M x (Rayleigh's quotient); it is taken in random poses.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.links.body import entries, raised_inertia
from tmodes.kinds.schema.axes import cross_matrix, rotation_about, rpy_matrix

__all__ = ["Mover", "inertia_of"]

Array = NDArray[np.float64]

POSES = 20
MOST_JOINTS = 60
"""Moving joints beyond which the change of frequencies is not computed."""

FADES = 1e-3
"""Weight of the axis of a joint over that of the next one towards the link."""


def inertia_of(body: Mapping[str, Any]) -> Array:
    """The inertia (3, 3) of a body of the sheet about its center, in its link's axes."""
    pairs = body.get("inertia") or dict.fromkeys(("xx", "yy", "zz", "xy", "xz", "yz"), 0.0)
    xx, yy, zz, xy, xz, yz = (pairs[pair] for pair in ("xx", "yy", "zz", "xy", "xz", "yz"))
    turn = rpy_matrix(*body.get("rpy", (0.0, 0.0, 0.0)))
    return turn @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ turn.T


@dataclass(frozen=True, eq=False)
class Mover:
    """The rigid tree of a URDF: its ``joints`` as of the sheet, parents first."""

    joints: Sequence[Mapping[str, Any]]

    def repaired(self, link: str, body: Mapping[str, Any]) -> dict[str, Any]:
        """A body with the inertia of a real one, in its link's axes."""
        return {**body, "rpy": [0.0, 0.0, 0.0], "inertia": entries(raised_inertia(inertia_of(body), self._uses(link)))}

    def _uses(self, link: str) -> Array:
        """Axes (k, 3) of the joints that turn a link in its own axes at the zero pose, the nearer the longer."""
        carriers = {joint["child"]: joint for joint in self.joints}
        uses, turn, weight = [], np.eye(3), 1.0
        while link in carriers:
            joint = carriers[link]
            if joint["type"] == "revolute":
                uses.append(weight * turn.T @ _unit(joint["axis"]))
                weight *= FADES
            turn, link = rpy_matrix(*joint["origin"]["rpy"]) @ turn, joint["parent"]
        return np.array(uses).reshape(-1, 3)

    def largest_fall(self, bodies: Mapping[str, Mapping[str, Any]], link: str, added: Array) -> float | None:
        """The share by which an ``added`` inertia (3, 3) of a link lowers a natural frequency at most; None: unknown.

        ``bodies``: of all links, that one's repaired.
        """
        count = sum(joint["type"] != "fixed" for joint in self.joints)
        if not 0 < count <= MOST_JOINTS:
            return None
        rng, largest = np.random.default_rng(0), 0.0
        for _ in range(POSES):
            mass, turning = np.zeros((count, count)), np.zeros((3, count))
            for name, (turn, angular, linear) in self._moved(rng.uniform(-1, 1, count), count).items():
                body = bodies.get(name)
                if body is None:
                    continue
                own = turn.T @ angular
                center = linear - cross_matrix(turn @ np.array(body["center"])) @ angular
                mass += body["mass"] * center.T @ center + own.T @ inertia_of(body) @ own
                turning = own if name == link else turning
            try:
                from scipy.linalg import eigh

                share = eigh(turning.T @ added @ turning, mass, eigvals_only=True)[-1]
            except np.linalg.LinAlgError:
                return None
            largest = max(largest, float(share))
        return 1.0 - float(np.sqrt(max(0.0, 1.0 - largest)))

    def _moved(self, position: Array, count: int) -> dict[str, tuple[Array, Array, Array]]:
        """Of each link its rotation, and the jacobians (3, count) of its turn and of its origin."""
        still = np.eye(3), np.zeros((3, count)), np.zeros((3, count))
        found: dict[str, tuple[Array, Array, Array]] = {}
        k = 0
        for joint in self.joints:
            turn, angular, linear = found.get(joint["parent"], still)
            arm = turn @ np.array(joint["origin"]["position"])
            linear = linear - cross_matrix(arm) @ angular
            turn, angular = turn @ rpy_matrix(*joint["origin"]["rpy"]), angular.copy()
            if joint["type"] != "fixed":
                axis = turn @ _unit(joint["axis"])
                if joint["type"] == "revolute":
                    angular[:, k] = axis
                    turn = turn @ rotation_about(_unit(joint["axis"]), np.pi * position[k])
                else:
                    linear = linear - cross_matrix(axis * position[k]) @ angular
                    linear[:, k] = axis
                k += 1
            found[joint["child"]] = turn, angular, linear
        return found


def _unit(axis: Sequence[float]) -> Array:
    return np.array(axis) / np.linalg.norm(axis)
