"""The tip of the robot as it bends on the path of the rigid one: the equations, and their quasi-static solutions.

The unknowns are all coordinates q. Along those without a motor the equations of motion hold, along the others the tip
is where that of the rigid robot would be, as far as its joints move it, and motors of a redundant robot are where those
of the rigid one would be, as far as that leaves the tip in place (N: the null space of J_rigid):

    [M(q) q'' + h(q, q') + springs]_passive = 0,    J_rigid^T (x(q) - x_path(t)) + N N^T (q_motors - q_rigid(t)) = 0

At rest that compensates what weight and loads bend. With rates and accelerations of the rigid robot in place of its own
(the gross motion, as in :mod:`tmodes.analysis.quasistatic`) it compensates what the inertia of the motion bends, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.follow import Followed
from tmodes.analysis.statics.equilibrium import driven
from tmodes.analysis.statics.inverse import tip_problem
from tmodes.errors import InputError
from tmodes.kinds.contacts.registry import Contact
from tmodes.kinds.signals.registry import Signal
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["Task", "Wanted", "carried", "sagged"]

Array = NDArray[np.float64]

_DEGREE, _REST = 5, 1e-9
"""Of the spline through what is added to the references; rate over the largest one below which a row is at rest."""

_STEPS, _HALVINGS, _SETTLED = 60, 12, 1e-12
"""Newton's method: steps, halvings of one, change over the largest coordinate after which it ends."""

_BETWEEN = 8
"""Rows for each one of the path where accelerations bend the robot."""

_SINGULAR, _STRIDE = 1e-9, 1e-6
"""Share of the largest singular value of a direction that no joint moves; step [m, m/s, m/s^2] of differences."""


def _motors(model: Model, joints: Sequence[str]) -> list[int]:
    """Indices of what moves each joint: its motor, or itself behind a rigid gear."""
    names = list(model.coordinates)
    return [names.index(name if (name := f"{joint}.motor") in names else joint) for joint in joints]


def _rank(ways: Array) -> int:
    """Directions in which the joints move the tip everywhere, of matrices (n, rows, joints)."""
    sizes = np.linalg.svd(ways, compute_uv=False).min(axis=0)
    return int(np.sum(sizes > _SINGULAR * sizes[0]))


class Wanted(NamedTuple):
    """Of the rigid robot at n instants: poses ``q`` (n, nq), places (n, 3) [m] and turns (n, 3, 3) of its tip.

    ``ways``: how the joints move the tip (n, 6, joints).
    """

    q: Array
    places: Array
    turns: Array
    ways: Array


class Pressed:
    """What a surface does to a point that moves, beyond what it does to one at rest: damping, moving mass, friction."""

    def __init__(self, contact: Contact, model: Model) -> None:
        self.contact, self.model = contact, model
        self.point = [point.name for point in model.chain.points].index(contact.point)

    def motion(self, q: Array, v: Array, a: Array) -> Array:
        """Place, velocity and acceleration of the point (3, 3, n)."""
        found = self.model.points(q, v, a)
        return np.stack([part[:, self.point].T for part in (found.position, found.velocity, found.acceleration)])

    def force(self, motion: Array) -> tuple[Array, Array, Array]:
        """Force on the point (3, n) [N], penetration [m] and normal force [N] (n,), from its motion (3, 3, n)."""
        contact, (place, velocity, gain) = self.contact, motion
        met = contact.shape.meet(contact.shape.numbers(), [*place], [*velocity])
        belt = np.array(contact.velocity, dtype=float)[:, None]
        way = np.array(np.broadcast_arrays(*met.direction, met.depth)[:3])
        own = contact.normal_force(contact.numbers(), met.depth, met.rate)
        normal = own + contact.moving_mass * (met.curving + (way * gain).sum(axis=0))
        force = -way * normal
        if contact.is_rough:
            moved = velocity - belt
            slip = moved - way * (way * moved).sum(axis=0)
            rubbed = normal if contact.rubs_with_mass else own
            force = force - np.array(contact.friction_force(contact.numbers(), rubbed, [*slip], [*moved]))
        if contact.unilateral:
            force = np.where((met.depth > 0) & (normal > 0), force, 0.0)
        return force, met.depth, normal

    def beyond_rest(self, q: Array, v: Array, a: Array) -> Array:
        """The force on the point (n, 3) less that in the same pose at rest."""
        motion = self.motion(q, v, a)
        still = np.concatenate([motion[:1], 0 * motion[1:]])
        return (self.force(motion)[0] - self.force(still)[0]).T

    def slopes(self, q: Array, v: Array, a: Array) -> Array:
        """Its derivatives (3, n, 3, 3) by place, velocity and acceleration, by differences."""
        motion, found = self.motion(q, v, a), np.zeros((3, len(q), 3, 3))
        for order in range(3):
            for axis in range(3):
                ends = []
                for sign in (1.0, -1.0):
                    moved = motion.copy()
                    moved[order, axis] += sign * _STRIDE
                    still = np.concatenate([moved[:1], 0 * moved[1:]])
                    ends.append(self.force(moved)[0] - self.force(still)[0])
                found[order, :, :, axis] = (ends[0] - ends[1]).T / (2 * _STRIDE)
        return found


class Task:
    """The equations of a robot that bends and whose tip follows that of the rigid one along ``found``.

    ``rows``: 3 for the tip's place, 6 with its attitude; ``motors``: coordinates that move its joints, ``still``: other
    driven ones, which stay, ``passive``: all others.
    """

    def __init__(self, robot: Robot, found: Followed) -> None:
        self.joints, self.robot, self.found = found.joints, robot, found
        self.duration = float(found.times[-1])
        self.pieces = [Signal.of(signal).schedule(self.duration) for signal in found.signals()]
        self.problem, _ = tip_problem(robot)
        self.model = self.problem.system.model
        self.pressed = Pressed(robot.contact, self.model) if robot.contact else None
        self.motors = _motors(self.model, self.joints)
        self.still = np.array([k for k in driven(self.model) if k not in self.motors], dtype=int)
        self.passive = np.setdiff1d(np.arange(self.model.nq), [*self.motors, *self.still])
        ways, count = self.targets(found.values).ways, len(self.joints)
        placed = all(leg.course.turn is None and not leg.course.of_joints for leg in found.legs)
        self.rows = 3 if placed or _rank(ways[:, :3]) == count else 6
        self.redundant = _rank(ways[:, : self.rows]) < count

    def targets(self, values: Array) -> Wanted:
        """What is wanted with the rigid robot's joints at ``values`` (n, joints)."""
        names, q = list(self.model.coordinates), np.zeros((len(values), self.model.nq))
        for name, value in self.robot.initial.coordinates.items():
            q[:, names.index(name)] = value
        self._move(q, values)
        places, turns = (part[:, self.problem.point] for part in self.model.pose(q))
        jacobian = self.model.jacobian(q)[:, self.problem.point]
        return Wanted(q, places, turns, jacobian[:, :, [names.index(joint) for joint in self.joints]])

    def _move(self, coordinates: Array, values: Array) -> None:
        """Put the values (n, joints) of the joints, or their rates, where these and their motors stand (n, nq)."""
        names = list(self.model.coordinates)
        for joint, column in zip(self.joints, values.T, strict=True):
            for name in (joint, f"{joint}.motor"):
                if name in names:
                    coordinates[:, names.index(name)] = column

    def along(self, times: Array) -> Wanted:
        """The same at times [s] from the beginning of the path; place and turn are exactly those of the path."""
        values = np.stack([one.at(np.clip(times, 0.0, self.duration)) for one in self.pieces], axis=1)
        exact = [*self.found.exact(times)]
        for row, (_, _, joints) in enumerate(exact):
            values[row] = values[row] if joints is None else joints
        found = self.targets(values)
        for row, (place, turn, _) in enumerate(exact):
            found.places[row] = found.places[row] if place is None else place
            found.turns[row] = found.turns[row] if turn is None else turn
        return found

    def residual(self, q: Array, v: Array, a: Array, wanted: Wanted) -> Array:
        """What shall vanish (n, nq)."""
        found = np.zeros_like(q)
        found[:, self.passive] = self.efforts(q, v, a)[:, self.passive]
        found[:, self.motors] = self.off(q, wanted)
        found[:, self.still] = (q - wanted.q)[:, self.still]
        return found

    def slopes(self, q: Array, v: Array, a: Array, wanted: Wanted) -> tuple[Array, Array, Array]:
        """Its derivatives (n, nq, nq) by coordinates, rates and accelerations."""
        wrenches, added = self.problem.acting(q)
        if self.pressed and wrenches is not None:
            wrenches[:, self.pressed.point, :3] += self.pressed.beyond_rest(q, v, a)
        by = self.model.inverse_dynamics_derivatives(q, v, a, wrenches=wrenches)
        parts = [by.q + added, by.v, by.a]
        if self.pressed:  # without what the Jacobian's change adds: the residual is exact
            ways = self.model.jacobian(q)[:, self.pressed.point, :3]
            pressed = self.pressed.slopes(q, v, a)
            parts = [
                part - np.einsum("nki,nkl,nlj->nij", ways, one, ways) for part, one in zip(parts, pressed, strict=True)
            ]
        found = np.zeros((3, *by.q.shape))
        for k, part in enumerate(parts):
            found[k][:, self.passive] = part[:, self.passive]
        found[0][:, self.motors] = self.off_slopes(q, wanted)
        found[0][:, self.still, self.still] = 1.0
        return found[0], found[1], found[2]

    def efforts(self, q: Array, v: Array, a: Array) -> Array:
        """Generalized forces (n, nq) that the motion takes [N*m, N]."""
        wrenches = self.problem.acting(q)[0]
        if self.pressed and wrenches is not None:
            wrenches[:, self.pressed.point, :3] += self.pressed.beyond_rest(q, v, a)
        return self.model.inverse_dynamics(q, v, a, wrenches=wrenches)

    def off(self, q: Array, wanted: Wanted) -> Array:
        """The tip off its path (n, joints), as the joints move it."""
        from scipy.spatial.transform import Rotation

        positions, rotations = (part[:, self.problem.point] for part in self.model.pose(q))
        turned = Rotation.from_matrix(rotations @ wanted.turns.transpose(0, 2, 1)).as_rotvec() * self.problem.size
        off, ways = np.concatenate([positions - wanted.places, turned], axis=1), self._scaled(wanted.ways)
        found = np.einsum("nkj,nk->nj", ways, off[:, : self.rows])
        if self.redundant:
            found += np.einsum("njk,nk->nj", self._free(ways), (q - wanted.q)[:, self.motors])
        return found

    def pushed(self, aside: Array, wanted: Wanted) -> Array:
        """What :meth:`off` is (n, joints) where the tip is ``aside`` (n, rows) [m] of its path, turns as lengths."""
        return np.einsum("nkj,nk->nj", self._scaled(wanted.ways), aside)

    def off_slopes(self, q: Array, wanted: Wanted) -> Array:
        """The slopes (n, joints, nq) of :meth:`off`."""
        ways = self._scaled(wanted.ways)
        slope = ways.transpose(0, 2, 1) @ self._scaled(self.model.jacobian(q)[:, self.problem.point])
        if self.redundant:
            slope[:, :, self.motors] += self._free(ways)
        return slope

    def _scaled(self, ways: Array) -> Array:
        """The rows that count of a Jacobian (n, 6, k), turns as lengths."""
        scaled = ways[:, : self.rows].copy()
        scaled[:, 3:] *= self.problem.size
        return scaled

    def _free(self, ways: Array) -> Array:
        """Motions of the joints (n, joints, joints) that leave the rigid tip in place, of scaled ``ways``."""
        return np.eye(ways.shape[2]) - np.linalg.pinv(ways, rcond=_SINGULAR) @ ways

    def end(self) -> Array:
        """Where the tip rests at the end of the path (3,) [m]: off it by what no joint moves.

        Raises :class:`tmodes.errors.InputError` where Newton's method finds no rest.
        """
        pose = self.at_rest(self.along(np.array([self.duration])))
        return np.asarray(self.model.pose(pose)[0][0, self.problem.point])

    def at_rest(self, wanted: Wanted, rates: Array | None = None, accelerations: Array | None = None) -> Array:
        """Coordinates (n, nq) of the robot at rest with its tip there; or held against what it takes to move so.

        ``rates`` and ``accelerations`` (n, joints): of the rigid robot's joints [rad/s, m/s; rad/s^2, m/s^2].

        Raises :class:`tmodes.errors.InputError` where Newton's method finds none.
        """
        q, open_ = wanted.q.copy(), np.arange(len(wanted.q))
        moving = [np.zeros_like(q), np.zeros_like(q)]
        for motion, given in zip(moving, (rates, accelerations), strict=True):
            if given is not None:
                self._move(motion, given)
        for _ in range(_STEPS):
            here, own = q[open_], Wanted(*(part[open_] for part in wanted))
            v, a = (motion[open_] for motion in moving)
            slopes = self.slopes(here, v, a, own)[0]
            scale = np.abs(slopes).max(axis=2)
            scale[scale == 0] = 1.0
            off = self.residual(here, v, a, own) / scale
            try:
                change = np.linalg.solve(slopes / scale[:, :, None], off[:, :, None])[:, :, 0]
            except np.linalg.LinAlgError:
                break
            size, share, tried = np.abs(change).max(axis=1), np.ones(len(here)), here
            if not np.isfinite(size).all():
                break
            for _ in range(_HALVINGS):
                tried = here - share[:, None] * change
                after = self.residual(tried, v, a, own) / scale
                worse = np.linalg.norm(after, axis=1) > np.linalg.norm(off, axis=1)
                worse &= share * size > np.sqrt(_SETTLED)
                if not worse.any():
                    break
                share[worse] /= 2
            q[open_] = tried
            open_ = open_[size > _SETTLED * (1.0 + np.abs(tried).max(axis=1))]
            if not len(open_):
                return q
        at = wanted.places[open_[0]]
        got = f"no pose at rest that holds the tip at {', '.join(f'{one:.4g}' for one in at)} m"
        hint = "move the path away from singular poses, or take `--reference rigid`"
        raise InputError("task.reference", got, "a path that the robot as it bends reaches", hint)


def sagged(robot: Robot, found: Followed) -> Followed:
    """The references with which the tip of the robot at rest is on the path of the rigid one, at every row.

    Raises :class:`tmodes.errors.InputError` where the robot as it bends does not reach a row.
    """
    task = Task(robot, found)
    held = task.at_rest(task.targets(found.values))
    return _with(found, held[:, task.motors] - found.values)


def carried(robot: Robot, found: Followed) -> Followed:
    """The same against weight, loads and the inertia of the motion, while what bends does not move, at closer rows.

    Raises :class:`tmodes.errors.InputError` where the robot as it bends does not reach a row.
    """
    task, knots = Task(robot, found), np.unique(found.times)
    shares = np.arange(_BETWEEN * (len(knots) - 1) + 1) / _BETWEEN
    times = np.interp(shares, np.arange(len(knots)), knots)
    values, rates, accelerations = (
        np.stack([one.at(times, order) for one in task.pieces], axis=1) for order in range(3)
    )
    held = task.at_rest(task.along(times), rates, accelerations)
    path = replace(found, times=times, values=values, rates=rates, accelerations=accelerations)
    return _with(path, held[:, task.motors] - values)


def _with(found: Followed, added: Array) -> Followed:
    """The references with what is ``added`` (n, joints) to them, smoothly between the rows, at rest where they are."""
    from scipy.interpolate import make_interp_spline

    moves = [np.abs(one).max(axis=1) > _REST * np.abs(one).max() for one in (found.rates, found.accelerations)]
    free, slopes = (moves[0], moves[0] | moves[1]), [np.zeros_like(added), np.zeros_like(added)]
    jumps = 1 + np.flatnonzero(np.diff(found.times) == 0)  # of accelerations: two rows at one time
    for low, high in pairwise([0, *jumps.tolist(), len(added)]):
        times, rows = found.times[low:high], added[low:high]
        loose = make_interp_spline(times, rows, k=min(_DEGREE, high - low - 1))
        ends = [[(order, free[order - 1][row] * loose(found.times[row], order)) for order in (1, 2)]
                for row in (low, high - 1)]  # fmt: skip
        spline = make_interp_spline(times, rows, k=_DEGREE, bc_type=ends)
        for order in (1, 2):
            slopes[order - 1][low:high] = spline(times, order)
    rates, accelerations = slopes
    return replace(
        found, values=found.values + added, rates=found.rates + rates, accelerations=found.accelerations + accelerations
    )
