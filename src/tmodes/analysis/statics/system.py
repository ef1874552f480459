"""The equations of rest of an arm: forces that must vanish along its free coordinates, and their exact slope.

    r(q, f) = elastic(q) + f (gravity(q) - J(q)^T wrenches(q))

The factor f scales everything that loads the arm, its weight included, so that f = 0 is the unloaded arm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.loads import Act, Pose
from tmodes.model.model import Model

__all__ = ["Forces", "StaticSystem"]

Array = NDArray[np.float64]


class Forces(NamedTuple):
    """Along the free coordinates: what is left over, and the part of it that one unit of the load factor brings."""

    rest: Array
    by_factor: Array
    elastic: Array


@dataclass(frozen=True, eq=False)
class StaticSystem:
    """The equations of one arm, its acts, and the indices of the coordinates that are free to move."""

    model: Model
    acts: Sequence[Act]
    free: NDArray[np.intp]

    def wrenches(self, q: Array, factor: float = 1.0) -> Array | None:
        """Wrenches on all points, shape (points, 6), None where nothing acts."""
        if not self.acts:
            return None
        total = np.zeros((len(self.model.parts.points), 6))
        for act, pose in self._posed(q, turning=False):
            total[act.point] += act.wrench(pose)
        return factor * total

    def forces(self, q: Array, factor: float) -> Forces:
        """Forces along the free coordinates at a pose (nq,)."""
        still = np.zeros_like(q)
        loaded = self.model.inverse_dynamics(q, still, still, wrenches=self.wrenches(q), base=self.model.at_rest())
        elastic = self.model.elastic_forces(q, still)
        by_factor = loaded - elastic
        return Forces(*(part[self.free] for part in (elastic + factor * by_factor, by_factor, elastic)))

    def mass(self, q: Array) -> Array:
        """M (nq, nq) in a pose, with what surfaces add."""
        mass = self.model.mass_matrix(q)
        for act, pose in self._posed(q, turning=True):
            carried = act.carried(pose)
            mass = mass + carried[0] if carried else mass
        return mass

    def stiffness(self, q: Array, factor: float) -> Array:
        """K (nq, nq) about a pose, with what following loads and surfaces add."""
        base = self.model.at_rest(gravity=factor)
        stiffness = self.model.stiffness(q, wrenches=self.wrenches(q, factor), base=base)
        for act, pose in self._posed(q, turning=True):
            added = act.stiffness(pose)
            stiffness = stiffness if added is None else stiffness + factor * added
        return stiffness

    def matrices(self, q: Array, factor: float) -> tuple[Array, Array, Array]:
        """M, D, K (nq, nq) about a pose, with what loads and surfaces add to them; Newton's method needs only K."""
        base = self.model.at_rest(gravity=factor)
        _, damping, _ = self.model.linearised(q, wrenches=self.wrenches(q, factor), base=base)
        for act, pose in self._posed(q, turning=True):
            carried = act.carried(pose)
            damping = damping + carried[1] if carried else damping
        return self.mass(q), damping, self.stiffness(q, factor)

    def reduced(self, q: Array, factor: float) -> tuple[Array, Array]:
        """M and K in the free coordinates."""
        return self.mass(q)[self.block], self.stiffness(q, factor)[self.block]

    @property
    def block(self) -> tuple[NDArray[np.intp], ...]:
        """Where the free coordinates stand in a matrix (nq, nq)."""
        return np.ix_(self.free, self.free)

    def _posed(self, q: Array, *, turning: bool) -> list[tuple[Act, Pose]]:
        """Acts with the poses of their points; jacobians only where the slope is wanted."""
        if not self.acts:
            return []
        positions, rotations = self.model.pose(q)
        none = np.zeros((len(positions), 6, 0))
        jacobians = self.model.jacobian(q) if turning else none
        return [(act, Pose(positions[act.point], rotations[act.point], jacobians[act.point])) for act in self.acts]
