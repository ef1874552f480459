"""Poses in which a robot at rest holds a point where it is wanted, from many starts at once.

The equations of rest r(o, i, m) = 0 of joints that motors turn (o), of all else that gives way (i: links, springs) and
of the motors (m), with the pose e(o, i) = 0 of the point. The rest of i is eliminated from each step, so that the step
is in o alone, by Levenberg's and Marquardt's method; the motors follow from their gears at the end:

    di = -K_ii^-1 (r_i + K_io do),   (J_o - J_i K_ii^-1 K_io) do = -e + J_i K_ii^-1 r_i

K is the exact stiffness, J the exact Jacobian. K. Levenberg, Quart. Appl. Math. 2 (1944) 164; the elimination: M. J. D.
Powell's for equality constraints, as in J. Nocedal, S. Wright, Numerical Optimization (2006), section 18.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.quasistatic import gear_inputs
from tmodes.analysis.statics.equilibrium import driven
from tmodes.analysis.statics.loads import Pose
from tmodes.analysis.statics.system import StaticSystem
from tmodes.analysis.statics.target import Target
from tmodes.model.passes import derivatives

__all__ = ["Found", "TipProblem", "batched"]

Array = NDArray[np.float64]

REACHED = 1e-12
"""Error of the pose over the size of the robot [rad, and of the length] at which it is reached."""

_SETTLED = 1e-9
"""Change of coordinates, and slope of the error over the error, that is rounding."""

_MOST_STEPS = 120
_LONGEST = 0.6
"""Longest change in one step [rad]."""

_ROWS = 20_000


class Found(NamedTuple):
    """Where n starts ended: poses ``q`` (n, nq), ``error`` (n, m) of the point over the size, ``jacobian`` (n, m, o).

    ``left`` (n,): change of the inner coordinates that rest still wants.
    """

    q: Array
    error: Array
    jacobian: Array
    left: Array

    @property
    def reached(self) -> NDArray[np.bool_]:
        """Whether the point is where it is wanted, and the robot at rest."""
        return (np.linalg.norm(self.error, axis=1) <= REACHED) & (self.left <= _SETTLED)

    @property
    def nearest(self) -> NDArray[np.bool_]:
        """Whether no small change brings the point nearer."""
        slope = np.linalg.norm(np.einsum("nmo,nm->no", self.jacobian, self.error), axis=1)
        return (slope <= 1e-5 * np.linalg.norm(self.error, axis=1)) & (self.left <= _SETTLED)


class _Step(NamedTuple):
    error: Array
    jacobian: Array
    left: Array
    by_outer: Array
    shift: Array
    """Change of the error (n, m) as the inner coordinates come to rest."""

    @property
    def merit(self) -> Array:
        return np.asarray((self.error**2).sum(axis=1) + (self.left**2).sum(axis=1))


def batched(matrices: Array, right: Array) -> Array:
    """Solutions (n, a, b) of n systems; by the pseudo-inverse where one is singular."""
    try:
        return np.asarray(np.linalg.solve(matrices, right), dtype=float)
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.pinv(np.nan_to_num(matrices)) @ right, dtype=float)


@dataclass(frozen=True, eq=False)
class TipProblem:
    """A robot with what acts on it, and the point that is to be somewhere; ``size``: of the robot [m]."""

    system: StaticSystem
    point: int
    size: float

    @cached_property
    def inputs(self) -> NDArray[np.intp]:
        """Coordinates that motors set: motors before elastic gears, joints driven directly."""
        return np.array(driven(self.system.model), dtype=np.intp)

    @cached_property
    def outer(self) -> NDArray[np.intp]:
        """The joint coordinate behind each input."""
        axes = {axis.input: axis.angle for axis in self.system.model.parts.axes}
        return np.array([axes[k] for k in self.inputs], dtype=np.intp)

    @cached_property
    def geared(self) -> NDArray[np.bool_]:
        """Which of the inputs stand before an elastic gear."""
        return self.inputs != self.outer

    @cached_property
    def inner(self) -> NDArray[np.intp]:
        """Coordinates that give way: of links and of joints without a motor."""
        return np.setdiff1d(self.system.free, self.outer)

    @cached_property
    def unit(self) -> Array:
        """What a change of 1 of each outer coordinate is: rad, or the size of the robot along a slide."""
        units = self.system.model.chain.units([self.system.model.coordinates[k] for k in self.outer])
        return np.array([self.size if unit == "m" else 1.0 for unit in units.values()])

    def error(self, q: Array, target: Target) -> Array:
        """Of poses (n, nq): how far the point is off, lengths over the size of the robot, turns in rad (n, m)."""
        positions, rotations = self.system.model.pose(q)
        off = (positions[:, self.point] - target.position) / self.size
        turned = target.turn(rotations[:, self.point])[0] if target.turns else np.zeros_like(off)
        return np.concatenate([off, turned], axis=1)[:, target.rows]

    def acting(self, q: Array) -> tuple[Array | None, Array]:
        """Wrenches (n, points, 6) and what acts add to the stiffness (n, nq, nq)."""
        system, count = self.system, len(q)
        added = np.zeros((count, q.shape[1], q.shape[1]))
        if not system.acts:
            return None, added
        (positions, rotations), jacobians = system.model.pose(q), system.model.jacobian(q)
        jacobians = jacobians.reshape(count, *jacobians.shape[-3:])
        total = np.zeros((count, len(system.model.parts.points), 6))
        for act in system.acts:
            for row in range(count):
                there = (one[row, act.point] for one in (positions, rotations, jacobians))
                pose = Pose(*there)
                total[row, act.point] += act.wrench(pose)
                own = act.stiffness(pose)
                added[row] += 0.0 if own is None else own
        return total, added

    def forces(self, q: Array) -> Array:
        """Forces (n, nq) that are to be applied in poses (n, nq) at rest [N*m, N]."""
        still = np.zeros_like(q)
        return self.system.model.inverse_dynamics(q, still, still, wrenches=self.acting(q)[0])

    def stiffness(self, q: Array, along: NDArray[np.intp]) -> Array:
        """Columns (n, nq, along) of the stiffness."""
        passes, count, n = self.system.model.passes, len(q), len(along)
        wrenches, added = self.acting(q)
        found = added[:, :, along]
        units = np.zeros((count * n, q.shape[1]))
        units[np.arange(count * n), np.tile(along, count)] = 1.0
        blocks = {"q": np.repeat(q, n, axis=0), "v": np.zeros_like(units), "a": np.zeros_like(units)}
        blocks["base"] = np.tile(self.system.base(1.0), (count * n, 1))
        if wrenches is not None:
            blocks["wrenches"] = np.repeat(wrenches.reshape(count, -1), n, axis=0)
        for name in ("inertia", "elastic"):
            schedule = passes.schedule(name, loaded=wrenches is not None and name == "inertia")
            given = {label: blocks[label] for label in schedule.inputs}
            columns = derivatives(passes.parameters, schedule, given, {"q": units}, count * n)["forces"]
            found = found + columns.reshape(count, n, -1).transpose(0, 2, 1)
        return found

    def step(self, q: Array, target: Target, inner: NDArray[np.intp] | None = None) -> _Step:
        """Error, Jacobian by the outer coordinates with what gives way, and what rest wants of the inner ones."""
        error, count = self.error(q, target), len(q)
        inner = self.inner if inner is None else inner
        jacobian = self.system.model.jacobian(q)[:, self.point]
        jacobian[:, :3] /= self.size
        if target.turns and target.rotation is None:
            jacobian[:, 3:] = target.turn(self.system.model.pose(q)[1][:, self.point])[1] @ jacobian[:, 3:]
        jacobian = jacobian[:, target.rows]
        outer = jacobian[:, :, self.outer] * self.unit
        if not len(inner):
            none = np.zeros((count, 0))
            return _Step(error, outer, none, np.zeros((count, 0, len(self.outer))), np.zeros_like(error))
        columns = np.concatenate([inner, self.outer])
        stiffness = self.stiffness(q, columns)[:, inner]
        right = np.concatenate([self.forces(q)[:, inner, None], stiffness[:, :, len(inner) :] * self.unit], axis=2)
        answer = batched(stiffness[:, :, : len(inner)], right)
        left, by_outer, given = answer[:, :, 0], -answer[:, :, 1:], jacobian[:, :, inner]
        return _Step(error, outer + given @ by_outer, left, by_outer, -_times(given, left))

    def solve(self, q: Array, target: Target, *, rigid: bool = False) -> Found:
        """From starts (n, nq); ``rigid``: the inner coordinates stay."""
        pieces = range(0, len(q), _ROWS)
        found = [self._solve(q[k : k + _ROWS].copy(), target, rigid=rigid) for k in pieces]
        return Found(*(np.concatenate(parts) for parts in zip(*found, strict=True)))

    def _solve(self, q: Array, target: Target, *, rigid: bool) -> Found:
        inner = self.inner[:0] if rigid else self.inner
        now, damping = self.step(q, target, inner), np.full(len(q), 1e-3)
        rows = np.arange(len(q))
        for _ in range(_MOST_STEPS):
            here = _Step(*(part[rows] for part in now))
            do, di = _move(here, damping[rows])
            moved = q[rows].copy()
            moved[:, self.outer] += do * self.unit
            moved[:, inner] += di
            there = self.step(moved, target, inner)
            merit = np.where(np.isfinite(there.merit), there.merit, np.inf)
            better = merit <= here.merit * (1 + 1e-12)
            own = rows[better]
            q[own] = moved[better]
            for part, new in zip(now, there, strict=True):
                part[own] = new[better]
            damping[rows] = np.clip(damping[rows] * np.where(better, 0.1, 8.0), 1e-14, 1e8)
            size = np.abs(np.concatenate([do, di], axis=1)).max(axis=1)
            small = size <= 1e-13
            still = np.abs(there.left).max(axis=1, initial=0.0) <= 0.1 * _SETTLED
            slow = better & still & (merit >= here.merit * (1 - 1e-9)) & (size <= 1e-7)
            exact = better & (merit <= (0.01 * REACHED) ** 2)
            rows = rows[~(small | slow | exact)]
            if not len(rows):
                break
        return Found(q, now.error, now.jacobian, np.abs(now.left).max(axis=1, initial=0.0))

    def descended(self, q: Array, target: Target) -> Array:
        """A pose (nq,) from which no small change brings the point nearer: where much is left over (BFGS, SciPy)."""
        from scipy.optimize import minimize

        def off(outer: Array) -> tuple[float, Array]:
            q[self.outer] = outer * self.unit
            now = self.step(q[None], target)
            for _ in range(_MOST_STEPS):
                q[self.inner] -= now.left[0]
                if np.abs(now.left).max(initial=0.0) <= 0.1 * _SETTLED:
                    break
                now = self.step(q[None], target)
            return float(now.error[0] @ now.error[0]) / 2, now.jacobian[0].T @ now.error[0]

        q = q.copy()
        off(minimize(off, q[self.outer] / self.unit, jac=True, method="BFGS", options={"gtol": 1e-9}).x)
        return q

    def least_motion(self, q: Array, target: Target, wanted: Array, steps: int = 200) -> Array:
        """Of poses (n, nq) that hold the point those (k, nq), as near as can be to ``wanted`` (o,), that it finds.

        By projected steps in the outer coordinates that leave the point; each also brings it back.
        """
        q, size = q.copy(), np.full(len(q), np.inf)
        for _ in range(steps):
            now = self.step(q, target)
            inverse = np.asarray(np.linalg.pinv(now.jacobian, rcond=1e-8), dtype=float)
            back = (wanted - q[:, self.outer]) / self.unit
            free = back - _times(inverse, _times(now.jacobian, back))
            size = np.abs(free).max(axis=1, initial=0.0)
            free *= np.minimum(0.7, 0.3 / np.maximum(size, 1e-300))[:, None]
            do = free - _times(inverse, now.error + now.shift)
            q[:, self.outer] += do * self.unit
            q[:, self.inner] += _times(now.by_outer, do) - now.left
            if (size < _SETTLED).all():
                break
        return q[size < 1e-7]

    def motors(self, q: Array) -> Array:
        """The poses (n, nq) with motors where their gears hold what the joints carry."""
        motors, joints = self.inputs[self.geared], self.outer[self.geared]
        if not len(motors):
            return q
        q = q.copy()
        q[:, motors] = self._relaxed(q, joints)
        axes = {axis.motor: axis.axis.joint.gear for axis in self.system.model.parts.axes}
        plays = [gear.backlash if gear else 0.0 for gear in map(axes.get, motors)]
        q[:, motors] += 2 * np.array(plays) * np.sign(self.forces(q)[:, joints])
        for _ in range(60):
            slope = self.stiffness(q, motors)[:, joints]
            change = batched(slope, self.forces(q)[:, joints, None])[:, :, 0]
            q[:, motors] -= np.clip(change, -1.0, 1.0)
            if (np.abs(change) <= 1e-15 * (1 + np.abs(q[:, motors]))).all():
                break
        return q

    def _relaxed(self, q: Array, joints: NDArray[np.intp]) -> Array:
        """Motor angles (n, motors) at which the gears carry nothing."""
        model = self.system.model
        units = np.zeros((len(model.motors), model.nq))
        units[np.arange(len(model.motors)), model.motors] = 1.0
        own = [k for k, axis in enumerate(a for a in model.parts.axes if a.axis.element) if axis.motor >= 0]
        turned = gear_inputs(model, units)[:, own].T
        order = [[axis.angle for axis in model.parts.axes if axis.motor >= 0].index(k) for k in joints]
        places = [list(model.motors).index(k) for k in self.inputs[self.geared]]
        return np.asarray(np.linalg.solve(turned[np.ix_(order, places)], q[:, joints].T).T, dtype=float)


def _times(matrices: Array, vectors: Array) -> Array:
    return (matrices @ vectors[..., None])[..., 0]


def _move(now: _Step, damping: Array) -> tuple[Array, Array]:
    """Changes of the outer and the inner coordinates."""
    turned = now.jacobian.transpose(0, 2, 1)
    square = turned @ now.jacobian
    n = square.shape[1]
    ridge = damping[:, None] * np.maximum(np.trace(square, axis1=1, axis2=2)[:, None] / max(n, 1), 1e-300)
    square[:, np.arange(n), np.arange(n)] += ridge
    do = -batched(square, _times(turned, now.error + now.shift)[..., None])[..., 0]
    do *= np.minimum(1.0, _LONGEST / np.maximum(np.abs(do).max(axis=1, initial=0.0), 1e-300))[:, None]
    di = _times(now.by_outer, do) - now.left
    return do, di * np.minimum(1.0, _LONGEST / np.maximum(np.abs(di).max(axis=1, initial=0.0), 1e-300))[:, None]
