"""The equations of rest: forces that must vanish along the free coordinates, their exact slope, and their solution.

    r(q, f) = elastic(q) + f (gravity(q) - J(q)^T wrenches(q))

The factor f scales everything that loads the robot, its weight included, so that f = 0 is the unloaded robot. They are
solved by Newton's method, and by a slow but sure descent for robots that nothing holds when unloaded.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.loads import Act, Pose
from tmodes.analysis.statics.rank import is_rounding, scale_of, solved, unheld
from tmodes.model.model import Model

__all__ = ["Forces", "Root", "StaticSystem", "newton", "relative_residual"]

Array = NDArray[np.float64]


class Forces(NamedTuple):
    """Along the free coordinates: what is left over, and the part of it that one unit of the load factor brings."""

    rest: Array
    by_factor: Array
    elastic: Array


@dataclass(frozen=True, eq=False)
class StaticSystem:
    """The equations of one robot, its acts, and the indices of the coordinates that are free to move.

    ``rates`` (nq,): of steady motion, about which it is at rest relative to what turns; None: it stands. ``spin`` (3,):
    rate of its base [rad/s]. ``efforts``: of drives, by coordinate [N*m, N]. Like the loads these and centrifugal
    forces are taken times the factor.
    """

    model: Model
    acts: Sequence[Act]
    free: NDArray[np.intp]
    rates: Array | None = None
    spin: Array | None = None
    efforts: Mapping[str, float] = field(default_factory=dict)

    @cached_property
    def pushed(self) -> Array:
        """The efforts (nq,)."""
        return np.array([self.efforts.get(name, 0.0) for name in self.model.coordinates])

    @property
    def is_touched(self) -> bool:
        """Whether a surface is among the acts."""
        return any(act.is_surface for act in self.acts)

    def base(self, factor: float) -> Array:
        """The row (24) of the base under a factor of its weight."""
        row = self.model.at_rest(gravity=factor)
        row[6:9] = 0.0 if self.spin is None else np.sqrt(factor) * self.spin
        return row

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
        moving = still if self.rates is None else self.rates
        loaded = self.model.inverse_dynamics(q, moving, still, wrenches=self.wrenches(q), base=self.base(1.0))
        elastic = self.model.elastic_forces(q, still)
        by_factor = loaded - elastic
        if self.efforts:
            by_factor = by_factor - self.pushed
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
        acting = {"wrenches": self.wrenches(q, factor), "base": self.base(factor)}
        if self.rates is None:
            stiffness = self.model.stiffness(q, **acting)
        else:
            stiffness = self.model.linearize(q, np.sqrt(factor) * self.rates, **acting)[2]
        for act, pose in self._posed(q, turning=True):
            added = act.stiffness(pose)
            stiffness = stiffness if added is None else stiffness + factor * added
        return stiffness

    def matrices(self, q: Array, factor: float) -> tuple[Array, Array, Array]:
        """M, D, K (nq, nq) about a pose, with what loads and surfaces add to them; Newton's method needs only K."""
        rates = None if self.rates is None else np.sqrt(factor) * self.rates
        _, damping, _ = self.model.linearize(q, rates, wrenches=self.wrenches(q, factor), base=self.base(factor))
        for act, pose in self._posed(q, turning=True):
            carried = act.carried(pose)
            damping = damping + carried[1] if carried else damping
        return self.mass(q), damping, self.stiffness(q, factor)

    def reduced(self, q: Array, factor: float) -> tuple[Array, Array]:
        """M and K in the free coordinates."""
        return self.mass(q)[self.block], self.stiffness(q, factor)[self.block]

    def reach(self, q: Array) -> Array:
        """The largest force that weight, loads and surfaces could bring each free coordinate in any attitude (free,).

        [N, N*m], which is also the scale of the stiffness [per m, rad] that they could bring it.
        """
        rows = np.repeat(self.model.at_rest()[None], 4, axis=0)
        rows[:3, 3:6], rows[3, 3:6] = np.linalg.norm(rows[0, 3:6]) * np.eye(3), 0.0
        poses = np.repeat(q[None], 4, axis=0)
        pulled = self.model.inverse_dynamics(poses, 0 * poses, 0 * poses, base=rows)
        total = np.linalg.norm(pulled[:3] - pulled[3], axis=0) + np.abs(self.pushed)
        for act, pose in self._posed(q, turning=True):
            own = act.stiffness(Pose(pose.position, pose.rotation, np.eye(6)))
            moved = np.linalg.norm(pose.jacobian, axis=0)
            total += np.linalg.norm(act.wrench(pose)) * moved
            total += 0.0 if own is None else np.linalg.norm(own) * moved**2
        return np.asarray(total[self.free], dtype=float)

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


MOST_STEPS = 25
MOST_HALVINGS = 8

SETTLED = 1e-12
"""Newton step over 1 + |q| below which it has settled."""

ROUNDING = 1e-7
"""Newton step below which one that no longer shrinks is rounding."""

GOOD = 1e-9
"""Residual over the level of the loads of what is reported as an equilibrium."""

SMALL_TURN = 1e-6
"""Deflection [rad, m] whose force is the level of a robot that carries next to nothing."""


class Root(NamedTuple):
    """An equilibrium at one load factor: pose (nq,), residual over the level of the forces, stiffness (free, free)."""

    q: Array
    residual: float
    stiffness: Array


def newton(system: StaticSystem, q: Array, factor: float) -> Root | None:
    """The equilibrium near a pose, with the exact slope and a line search; None where it does not settle."""
    before, reach = np.inf, system.reach(q)
    for _ in range(MOST_STEPS):
        stiffness = system.stiffness(q, factor)[system.block]
        forces = system.forces(q, factor)
        solve = partial(solved, stiffness, reach=reach)
        step = solve(forces.rest)
        if step is None:
            return None
        size = float(np.abs(step).max(initial=0.0))
        settled = size <= SETTLED * (1 + np.abs(q).max(initial=0.0))
        residual = relative_residual(forces, stiffness)
        residual = 0.0 if residual > GOOD and is_rounding(forces.rest, reach).all() else residual
        stands = before <= size <= ROUNDING
        if (settled and (stands or _left(forces, stiffness)[0] <= SETTLED)) or (stands and residual <= GOOD):
            return None if _is_pushed(forces, stiffness, reach) else Root(q, residual, stiffness)
        q, before = _searched(system, q, step, solve, factor), size
    return None


def _is_pushed(forces: Forces, stiffness: Array, reach: Array) -> bool:
    """Whether what is left over acts along what nothing holds, beyond rounding of all that could act."""
    loose = unheld(stiffness, reach)
    if not loose.size:
        return False
    scale = scale_of(stiffness, reach)
    level = np.linalg.norm(np.maximum(reach, np.abs(forces.elastic)) / scale)
    return bool(np.linalg.norm(loose.T @ (forces.rest / scale)) > GOOD * level)


def relative_residual(forces: Forces, stiffness: Array) -> float:
    """What is left over against the largest force in play, or that of a tiny deflection where hardly any is in play."""
    share, left = _left(forces, stiffness)
    largest = float(np.sqrt(np.abs(np.diagonal(stiffness)).max(initial=0.0)))
    return min(share, left / (SMALL_TURN * largest)) if largest else share


def _left(forces: Forces, stiffness: Array) -> tuple[float, float]:
    """What is left over, against the largest force in play, and itself; travels and turns made alike by stiffness."""
    scale = np.sqrt(np.abs(np.diagonal(stiffness)))
    scale[scale == 0] = 1.0
    level = max(float(np.abs(part / scale).max(initial=0.0)) for part in (forces.by_factor, forces.elastic))
    left = float(np.abs(forces.rest / scale).max(initial=0.0))
    return left / level if level else 0.0, left


def _searched(
    system: StaticSystem, q: Array, step: Array, solve: Callable[[Array], Array | None], factor: float
) -> Array:
    """The pose after a Newton step, halved until the next step by the same slope is shorter (Deuflhard's test)."""
    share = 1.0
    moved = q
    for _ in range(MOST_HALVINGS):
        moved = q.copy()
        moved[system.free] -= share * step
        following = solve(system.forces(moved, factor).rest)
        if following is not None and np.abs(following).max(initial=0.0) <= (1 - share / 4) * np.abs(step).max():
            return moved
        if np.abs(step).max() <= ROUNDING:
            return moved
        share /= 2
    return moved
