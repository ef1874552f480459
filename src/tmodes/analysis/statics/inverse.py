"""Inverse kinematics of the robot as it bends: joint and motor angles that hold a point where it is wanted, at rest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.inverse import coordinate_rates
from tmodes.analysis.quasistatic import gear_inputs, gross_motion, sprung
from tmodes.analysis.statics.at_rest import first_commands
from tmodes.analysis.statics.equilibrium import free_coordinates, held_coordinates, starting_pose
from tmodes.analysis.statics.loads import Load, acts_of, coordinate_numbers, sheet_loads, surface_act
from tmodes.analysis.statics.stability import stability_of
from tmodes.analysis.statics.system import StaticSystem, newton
from tmodes.analysis.statics.target import Target
from tmodes.analysis.statics.tip_solver import Found, TipProblem, batched
from tmodes.errors import InputError
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["Branch", "Branches", "Target", "TipProblem", "branch_of", "held_poses", "tip_problem"]

Array = NDArray[np.float64]

SAME = 1e-5
"""Difference of coordinates [rad, m] below which two starts ended in one branch."""

NOT_MET = 1e-9
"""Distance [m] and angle [rad] of the point from where it is wanted beyond which a branch is none."""

SINGULAR = 1e-4
"""Ratio of singular values below which a branch is where two meet."""

_LOST, _TRIAL, _TRIED, _MOST_TURNED = 1e-3, 0.05, 4, 3
"""Ratio of singular values below which a motion may leave the point; how far it is tried; ends that are brought on;
joints of a family that may be whole turns on."""


@dataclass(frozen=True, eq=False)
class Branch:
    """One way to hold the point: the pose ``q`` (nq,), motors, joints and links, by the model's coordinates.

    ``off``: distance of the point from where it is wanted [m], and angle [rad]; ``rigid``: the pose of the same motors
    were nothing elastic; ``torque`` by input: what the motors hold [N*m, N]; ``stable``, ``lowest_frequency_Hz`` with
    the motors held; ``velocity_map`` (6, inputs): velocity of the point [m/s, rad/s] per rate of each input at rest;
    ``outside``: what of the robot's limits it passes; ``starts``: how many ended here; ``singular``: where the point
    can not be moved in one of the directions in which it can elsewhere; ``ways``: motions of the joints [rad, m] along
    which the branch continues as a family that holds the point, the null space of the Jacobian, largest part 1.
    """

    model: Model = field(repr=False)
    q: Array
    off: tuple[float, float]
    rigid: Array
    torque: Mapping[str, float]
    deflection: Array
    stable: bool
    lowest_frequency_Hz: float
    velocity_map: Array
    outside: tuple[str, ...]
    starts: int
    singular: bool
    residual: float
    ways: tuple[Mapping[str, float], ...] = ()

    @property
    def named(self) -> dict[str, float]:
        """Coordinates by name [rad, m]."""
        return dict(zip(self.model.coordinates, self.q.tolist(), strict=True))

    @property
    def motors(self) -> dict[str, float]:
        """What holds it: motors, and joints driven directly, by coordinate [rad, m]."""
        return {name: self.named[name] for name in self.torque}

    @property
    def twists(self) -> dict[str, float]:
        """Gear output less gear input, by ``joint.gear`` or ``joint.spring`` [rad, m]."""
        axes = [axis for axis in self.model.parts.axes if axis.axis.element]
        found = self.q[sprung(self.model)] - gear_inputs(self.model, self.q[None], rest=True)[0]
        return {axis.axis.element: float(one) for axis, one in zip(axes, found, strict=True)}

    def input_rates(self, velocity: Array) -> dict[str, float]:
        """Rates of the inputs [rad/s, m/s], of least norm, that move the point at ``velocity`` (3,) [m/s] or (6,).

        Slowly, so that what is elastic stays at rest: Eq. (43) with the static deflection.
        """
        given = np.asarray(velocity, dtype=float)
        rates = coordinate_rates(self.velocity_map[: len(given)], given)
        return dict(zip(self.torque, rates.tolist(), strict=True))


@dataclass(frozen=True, eq=False)
class Branches:
    """All ``branches`` that ``starts`` starts found; ``redundant``: motions of the joints that leave the point.

    Where there is none, ``nearest`` is the pose whose point is nearest; None: not even that was found. ``held``: how
    many numbers of place and turn hold at once; ``placed``: whether the place alone can be held.
    """

    branches: tuple[Branch, ...]
    starts: int
    ended: int
    redundant: int
    nearest: Branch | None
    held: int
    placed: bool = False


def tip_problem(
    robot: Robot,
    point: int = 0,
    loads: Sequence[Load] = (),
    *,
    model: Model | None = None,
    near: Mapping[str, float] | None = None,
) -> tuple[TipProblem, Array]:
    """The problem of a robot under its weight, its loads and ``loads``, in its contact, and the pose it starts from.

    ``near``: coordinates of that pose [rad, m]; others at their first commands. Raises
    :class:`tmodes.errors.InputError` for a robot of which no joint has a drive.
    """
    model = model or Model(robot.chain())
    acts = acts_of(model, [*sheet_loads(robot), *loads])
    acts += [surface_act(model, robot.contact)] if robot.contact else []
    known = {name: value for name, value in robot.initial.coordinates.items() if name in model.coordinates}
    given = held_coordinates(model, coordinate_numbers(model, near))
    pose = starting_pose(model, first_commands(robot, model) | given, known)
    system = StaticSystem(model, acts, free_coordinates(model, {}, ()))
    problem = TipProblem(system, point, 1.0)
    if not len(problem.inputs):
        raise InputError("joints", "no joint that a motor holds", "a motor or a drive at a joint", "give a joint one")
    units = model.chain.units([model.coordinates[k] for k in problem.outer])
    turning = [k for k, unit in zip(problem.outer, units.values(), strict=True) if unit != "m"]
    poses = np.tile(pose, (64, 1))
    poses[:, turning] = np.random.default_rng(0).uniform(-np.pi, np.pi, (64, len(turning)))
    places = model.pose(poses)[0][:, point]
    size = float(np.linalg.norm(places - places.mean(axis=0), axis=1).max(initial=0.0))
    return TipProblem(system, point, size if size > 0 else 1.0), pose


def starting_poses(robot: Robot, problem: TipProblem, pose: Array, starts: int) -> Array:
    """Poses (starts, nq) spread evenly within the limits of the joints: ``pose``, then Halton's points."""
    from scipy.stats.qmc import Halton

    low, high = limits_of(robot, problem)
    span = np.where(problem.unit == 1.0, np.pi, problem.size)
    low, high = np.where(np.isfinite(low), low, -span), np.where(np.isfinite(high), high, span)
    poses = np.tile(pose, (starts, 1))
    spread = Halton(len(low), scramble=False).random(starts)[1:]  # the first one is a corner
    poses[1:, problem.outer] = low + (high - low) * spread
    return poses


def limits_of(robot: Robot, problem: TipProblem) -> tuple[Array, Array]:
    """Least and largest value (o,) of each joint coordinate that motors set [rad, m]; infinite: none."""
    joints = {name: joint for joint in robot.joints for name in joint.coordinates}
    low, high = np.full(len(problem.outer), -np.inf), np.full(len(problem.outer), np.inf)
    for k, index in enumerate(problem.outer):
        joint = joints.get(problem.system.model.coordinates[index])
        limits = joint.limits if joint else None
        if limits is not None:
            low[k] = -np.inf if limits.lower is None else limits.lower
            high[k] = np.inf if limits.upper is None else limits.upper
    return low, high


def held_poses(robot: Robot, problem: TipProblem, pose: Array, target: Target, starts: int) -> Branches:
    """All branches that the starts find; where motions leave the point, those of least motion from a pose.

    First with rigid links, from each start; then, from each of the different ends, with all that bends.
    """
    begun = starting_poses(robot, problem, pose, starts)
    rigid = problem.solve(begun, target, rigid=True)
    kept, count = _different(problem, rigid, rigid.reached | ~rigid.reached.any())
    found = problem.solve(rigid.q[kept], target)
    if (
        not found.reached.any() and rigid.reached.any() and len(kept) < starts
    ):  # bent it may be reached from where it is not when rigid
        kept, count, found = np.arange(starts), np.ones(starts, dtype=int), problem.solve(rigid.q, target)
    slopes = problem.step(begun, target, problem.inner[:0]).jacobian
    rank, place = _rank(slopes), int(target.rows[:3].sum())
    still = np.abs(slopes[:, :place]).max(axis=(0, 2), initial=0.0) < SAME  # nothing moves it, as out of a plane
    held = rank + int((still & (np.abs(found.error[:, :place]).max(axis=0) < SAME)).sum())
    redundant = len(problem.outer) - rank
    if not found.reached.any():
        near = _nearest(robot, problem, found, target)
        alone = target.turns and target.rows[:3].any() and problem.solve(found.q, Target(target.position)).reached.any()
        return Branches((), starts, 0, redundant, near, held, bool(alone))
    q = found.q[found.reached]
    if redundant:
        q = problem.least_motion(q, target, pose[problem.outer])
        found = problem.solve(q, target)
        weights = np.ones(len(q), dtype=int)
    else:
        weights = count[found.reached]
        found = Found(_wrapped(robot, problem, q), *(part[found.reached] for part in found[1:]))
    singular, q = _singular(found.jacobian, rank), found.q.copy()
    for k in np.flatnonzero(singular):
        family = len(_ways(problem, q[k], target)) > 0
        q[k] = _drawn(problem, q[k], target, pose) if family else _folded(problem, q[k], target)
    kept, counts = _different(problem, found._replace(q=q), np.ones(len(q), dtype=bool), weights)
    if not redundant:
        nearest = np.argsort(np.linalg.norm((q[kept] - pose)[:, problem.outer] / problem.unit, axis=1))
        kept, counts = _joined(problem, q, kept[nearest], counts[nearest], target)
    branches = [
        branch_of(robot, problem, q[k], target, int(n), singular=bool(singular[k]), on=bool(redundant or singular[k]))
        for k, n in zip(kept, counts, strict=True)
    ]
    met = [one for one in branches if max(one.off) <= NOT_MET]
    motion = {id(one): float(np.linalg.norm((one.q - pose)[problem.outer] / problem.unit)) for one in met}
    met.sort(key=lambda one: (bool(one.outside), not one.stable, motion[id(one)]))
    return Branches(tuple(met), starts, int(sum(one.starts for one in met)), redundant, None, held)


def _rank(jacobian: Array) -> int:
    values = np.linalg.svd(jacobian, compute_uv=False)
    return int((values > SINGULAR * values.max(axis=1, keepdims=True, initial=1e-300)).sum(axis=1).max(initial=0))


def _singular(jacobian: Array, rank: int) -> NDArray[np.bool_]:
    values = np.linalg.svd(jacobian, compute_uv=False)
    return np.asarray(values[:, rank - 1] < 1e-3 * values[:, 0]) if rank else np.zeros(len(jacobian), dtype=bool)


def _nearest(robot: Robot, problem: TipProblem, found: Found, target: Target) -> Branch | None:
    """The pose at which the point is nearest, in least squares of lengths over the size of the robot and of turns."""
    order = np.argsort(np.linalg.norm(found.error, axis=1))[:_TRIED]
    found = problem.solve(np.stack([problem.descended(q, target) for q in found.q[order]]), target)
    size = np.where(found.nearest, np.linalg.norm(found.error, axis=1), np.inf)
    return (
        branch_of(robot, problem, found.q[size.argmin()], target, 0, singular=True) if np.isfinite(size).any() else None
    )


def _ways(problem: TipProblem, q: Array, target: Target) -> Array:
    """Motions (k, o) of the joints, largest part 1, along which a pose (nq,) continues while it holds the point.

    Where the Jacobian only turns singular, as where two branches meet, what is moved along its null space comes back.
    """
    jacobian = problem.step(q[None], target).jacobian[0]
    _, values, right = np.linalg.svd(jacobian)
    ways = right[int((values > _LOST * values.max(initial=0.0)).sum()) :]
    if not len(ways):
        return ways
    moved = np.tile(q, (len(ways), 1))
    moved[:, problem.outer] += _TRIAL * ways * problem.unit
    ends = problem.solve(moved, target)
    gone = (ends.q - q)[ends.reached][:, problem.outer] / problem.unit / _TRIAL @ ways.T
    _, values, turned = np.linalg.svd(gone)
    found = (turned @ ways)[: int((values > 0.5).sum())]
    return found / np.take_along_axis(found, np.abs(found).round(6).argmax(axis=1)[:, None], axis=1)


def _joined(
    problem: TipProblem, q: Array, kept: NDArray[np.intp], counts: Array, target: Target
) -> tuple[NDArray[np.intp], Array]:
    """The same without poses that lie in the family of one before, perhaps whole turns on."""
    turning, own = problem.unit == 1.0, q[:, problem.outer]
    order: list[int] = kept.tolist()
    left = dict(zip(order, counts.tolist(), strict=True))
    for first in order:
        ways = _ways(problem, q[first], target) if first in left else np.zeros((0, len(turning)))
        moved = turning & (np.abs(ways).max(axis=0, initial=0.0) > SAME)
        if not len(ways) or moved.sum() > _MOST_TURNED:
            continue
        turns = 2 * np.pi * np.array(list(product(*([-1, 0, 1] if at else [0] for at in moved))))
        for other in [k for k in left if order.index(k) > order.index(first)]:
            wanted = own[other] + turns
            ends = problem.least_motion(np.tile(q[first], (len(turns), 1)), target, wanted)[:, problem.outer]
            apart = np.abs(ends[:, None] - wanted).max(axis=2)
            if apart.min(initial=np.inf) < 10 * SAME:
                left[first] += left.pop(other)
    return np.array([*left], dtype=np.intp), np.array([*left.values()], dtype=int)


def _drawn(problem: TipProblem, q: Array, target: Target, pose: Array) -> Array:
    """Of the family of a pose (nq,), the member that is nearest to ``pose``, as near as is found."""
    found = problem.least_motion(q[None], target, pose[problem.outer])
    return found[0] if len(found) else q


def _different(
    problem: TipProblem, found: Found, wanted: NDArray[np.bool_], weights: Array | None = None
) -> tuple[NDArray[np.intp], Array]:
    """Indices of different ends among the ``wanted``, and how many starts ended in each."""
    own = found.q[:, problem.outer] / problem.unit
    turns, rest = problem.unit == 1.0, found.q[:, problem.inner]
    kept: list[int] = []
    count: list[int] = []
    for k in np.flatnonzero(wanted):
        apart = np.abs(own[kept] - own[k])
        apart = np.where(turns, np.abs((apart + np.pi) % (2 * np.pi) - np.pi), apart).max(axis=1, initial=0.0)
        apart = np.maximum(apart, np.abs(rest[kept] - rest[k]).max(axis=1, initial=0.0))
        same = np.flatnonzero(apart <= 10 * SAME)
        one = 1 if weights is None else int(weights[k])
        if len(same):
            count[same[0]] += one
        else:
            kept.append(int(k))
            count.append(one)
    return np.array(kept, dtype=np.intp), np.array(count, dtype=int)


def _wrapped(robot: Robot, problem: TipProblem, q: Array) -> Array:
    """The same poses with turning joints within their limits, by whole turns, else in (-pi, pi]."""
    (low, high), q = limits_of(robot, problem), q.copy()
    turning = problem.unit == 1.0
    bounded = np.isfinite(low) & np.isfinite(high)
    middle = (np.where(bounded, low, 0.0) + np.where(bounded, high, 0.0)) / 2
    own = q[:, problem.outer]
    shifted = own - 2 * np.pi * np.ceil((own - middle) / (2 * np.pi) - 0.5)
    q[:, problem.outer] = np.where(turning, shifted, own)
    return q


def _folded(problem: TipProblem, q: Array, target: Target) -> Array:
    """Where two branches meet near a pose, if the point is there, too; Newton's method alone finds it to 1e-8 only.

    The slope of the error along the direction in which the point does not move is zero there; by a secant.
    """
    now = problem.solve(q[None].copy(), target)
    left, _, right = np.linalg.svd(now.jacobian[0])
    k = min(len(left), len(right)) - 1
    values = np.linalg.svd(now.jacobian[0], compute_uv=False)
    k = int((values > 1e-12 * values[0]).sum()) - 1 if values[k] <= 1e-14 * values[0] else k
    way, moved = right[k], q.copy()

    def at(share: float) -> tuple[Array, float]:
        moved = q.copy()
        moved[problem.outer] += share * way * problem.unit
        step = problem.step(moved[None], target)
        moved[problem.inner] -= step.left[0]
        return moved, float(left[:, k] @ step.jacobian[0] @ way)

    near, far = at(0.0)[1], at(1e-4)[1]
    if far != near:
        moved = at(-1e-4 * near / (far - near))[0]
    size = [float(np.linalg.norm(problem.error(one[None], target)[0])) for one in (q, moved)]
    return moved if size[1] <= max(size[0], 1e-12) else q


def branch_of(
    robot: Robot, problem: TipProblem, q: Array, target: Target, starts: int, *, singular: bool, on: bool = False
) -> Branch:
    """All that is to be known of a pose (nq,) whose joints and links are found: its motors, and what holds it.

    ``on``: it may be one of a family.
    """
    system, model = problem.system, problem.system.model
    q = problem.motors(q[None])[0]
    root = newton(system, q, 1.0)
    q = q if root is None or np.abs(root.q - q).max() > SAME else root.q
    forces, jacobian = problem.forces(q[None])[0], model.jacobian(q)[problem.point]
    stiffness = system.stiffness(q, 1.0)
    found = stability_of(system.mass(q)[system.block], stiffness[system.block], system.reach(q))
    given = stiffness[system.free][:, problem.inputs]
    bent = batched(stiffness[system.block][None], given[None])[0]
    rigid = gross_motion(model, q[None])
    rigid[:, sprung(model)] = gear_inputs(model, q[None], rest=True)
    (before, after), turns = model.pose(np.concatenate([rigid, q[None]]))
    off = after[problem.point] - target.position
    turned = target.turn(turns[1:, problem.point])[0] if target.turns else np.zeros(0)
    ways = _ways(problem, q, target) * problem.unit if on else np.zeros((0, len(problem.outer)))
    named = [dict(zip([model.coordinates[k] for k in problem.outer], one.tolist(), strict=True))
             for one in np.where(np.abs(ways) < SAME, 0.0, ways)]  # fmt: skip
    names = [model.coordinates[k] for k in problem.inputs]
    torque = dict(zip(names, forces[problem.inputs].tolist(), strict=True))
    return Branch(
        model=model, q=q, off=(float(np.linalg.norm(off[np.isfinite(off)])), float(np.linalg.norm(turned))),
        rigid=rigid[0], torque=torque, deflection=after[problem.point] - before[problem.point], stable=found.stable,
        lowest_frequency_Hz=found.lowest_frequency_Hz,
        velocity_map=jacobian[:, problem.inputs] - jacobian[:, system.free] @ bent,
        outside=_outside(robot, problem, q, forces), starts=starts, singular=singular,
        residual=float(np.abs(forces[system.free]).max(initial=0.0)), ways=tuple(named),
    )  # fmt: skip


def _outside(robot: Robot, problem: TipProblem, q: Array, forces: Array) -> tuple[str, ...]:
    """The limits of position and effort that a pose passes."""
    (low, high), names = limits_of(robot, problem), problem.system.model.coordinates
    joints = {name: joint for joint in robot.joints for name in joint.coordinates}
    found = []
    for k, (index, motor) in enumerate(zip(problem.outer, problem.inputs, strict=True)):
        value, joint = q[index], joints.get(names[index])
        if not low[k] <= value <= high[k]:
            found.append(f"{names[index]} {value:.4g} outside {low[k]:.4g} ... {high[k]:.4g}")
        most = joint.limits.effort if joint and joint.limits else None
        if most is not None and abs(forces[motor]) > most:
            found.append(f"{names[index]} holds {abs(forces[motor]):.4g}, at most {most:.4g}")
    return tuple(found)
