"""Joint references of a path: the rigid robot's inverse kinematics along it, joined by polynomials to a known error.

Rates and accelerations are exact at the rows: J q' = x' and J q'' = x'' - J' q', of the compiled model. A redundant
robot moves with the least rates, q' = J^T l with J J^T l = x', integrated along the path.
Source: B. Siciliano, L. Sciavicco, L. Villani, G. Oriolo, Robotics: Modelling, Planning and Control (2009), 3.5, 3.7.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import straight
from tmodes.analysis.statics.at_rest import first_commands
from tmodes.errors import InputError
from tmodes.frame import rotation_vector
from tmodes.kinds.paths.registry import Course, Path, Place
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["Followed", "Leg", "followed"]

Array = NDArray[np.float64]

_CLOSE, _ROUNDS, _FARTHEST = 1e-12, 60, 0.5
"""Newton's method: what is left [m, rad], steps, and the longest step [rad, m]."""

_REACHED = 1e-9
"""What may be left of a place that counts as reached [m, rad]."""

_SINGULAR = 1e-9
"""Smallest over largest singular value of the Jacobian below which joints do not follow the tip."""

_CHECKS = (0.15, 0.35, 0.5, 0.65, 0.85)
"""Shares of an interval at which the tip is compared with the path."""

_STRIDE = 1e-5
"""Motion of a joint for differences of the Jacobian [rad, m]."""

MOST_ROWS = 5000
_FIRST = 8
"""Rows of a leg to begin with."""


class Leg(NamedTuple):
    """One path of several: its course, when it begins [s], and its way over time."""

    course: Course
    begin: float
    signal: Any
    place: Place

    @property
    def end(self) -> float:
        """When its way is at its end, from its beginning [s]; not a number for none."""
        end = self.signal.move_ends()
        return float("nan") if end is None else float(end)

    @property
    def pieces(self) -> SignalPieces:
        """Its way over time from its beginning."""
        found: SignalPieces = self.signal.schedule(self.end)
        return found

    def target(self, way: float) -> tuple[Array, Array | None]:
        """Place (3,) and turn (3, 3) of the tip there."""
        course = self.course
        if course.turn is None:
            return course.at(way).value, None
        return course.at(way).value, _turned(course.turn * (way / course.length)) @ self.place.rotation


@dataclass(frozen=True, eq=False)
class Followed:
    """Rows of the references of all driven joints, ``joints`` by name.

    ``times`` (n,) [s]; ``values``, ``rates``, ``accelerations`` (n, joints) [rad, m]; ``error`` [m] and ``turned``
    [rad]: the largest distance of the undeformed robot's tip from the path, between the rows; ``legs``: the paths.
    """

    joints: tuple[str, ...]
    times: Array
    values: Array
    rates: Array
    accelerations: Array
    error: float
    turned: float
    legs: tuple[Leg, ...]

    def exact(self, times: Array) -> Iterator[tuple[Array | None, Array | None, Array | None]]:
        """Of each time [s] the tip's place (3,), its turn (3, 3), and the joints (n,); None: left open by the path."""
        begins, pieces = np.array([leg.begin for leg in self.legs]), [leg.pieces for leg in self.legs]
        for time in np.clip(times, 0.0, self.times[-1]).tolist():
            k = max(int(np.searchsorted(begins, time, "right")) - 1, 0)
            leg = self.legs[k]
            way = float(np.clip(pieces[k].at(time - leg.begin), 0.0, leg.course.length))
            if leg.course.of_joints:
                yield None, None, leg.course.at(way).value
            else:
                yield *leg.target(way), None

    def signals(self, factor: float = 1.0) -> list[dict[str, Any]]:
        """The references, times a factor, as signals, in the order of the joints, as plain data."""
        columns = ("positions", self.values), ("velocities", self.rates), ("accelerations", self.accelerations)
        return [
            {
                "type": "trajectory",
                "times": self.times.tolist(),
                **{name: (factor * rows[:, k]).tolist() for name, rows in columns},
            }
            for k in range(len(self.joints))
        ]


class Arm:
    """The undeformed robot by the values of its driven joints."""

    def __init__(self, robot: Robot) -> None:
        self.model = Model(robot.undriven.chain())
        self.start = first_commands(robot, self.model)
        if not self.start:
            hint = "give its drives the command `position` or `prescribed`"
            raise InputError("drives", "no joint whose position is commanded", "joints that follow the path", hint)
        points = [point.name for point in self.model.chain.points]
        self.tip = points.index("tip")
        known = {name: value for name, value in robot.initial.coordinates.items() if name in self.model.coordinates}
        rest = np.zeros((1, self.model.nq))
        for name, value in known.items():
            rest[0, self.model.coordinates.index(name)] = value
        units = np.repeat(rest, 1 + len(self.start), axis=0)
        for k, name in enumerate(self.start):
            place = self.model.coordinates.index(name)
            units[:, place] = 0.0
            units[1 + k, place] = 1.0
        whole = straight(self.model, units)
        self.offset, self.basis = whole[0], (whole[1:] - whole[0]).T
        ways = [self.jacobian(values) for values in np.random.default_rng(0).uniform(-2.0, 2.0, (3, len(self.start)))]
        self.ranks = {
            rows: max(int(np.linalg.matrix_rank(one[:rows], tol=_SINGULAR * np.abs(one).max())) for one in ways)
            for rows in (3, 6)
        }
        """Directions in which the joints move the tip's place, and place and turn, of all poses."""

    def whole(self, joints: Array) -> Array:
        """All coordinates."""
        return self.offset + joints @ self.basis.T

    def pose(self, joints: Array) -> tuple[Array, Array]:
        """Positions (n, 3) and rotations (n, 3, 3) of the tip."""
        position, rotation = self.model.pose(np.atleast_2d(self.whole(joints)))
        return position[:, self.tip], rotation[:, self.tip]

    def jacobian(self, joints: Array) -> Array:
        """(6, joints): velocity and rate of the tip."""
        return self.model.jacobian(self.whole(joints))[self.tip] @ self.basis

    def efforts(self, joints: Array, rates: Array, accelerations: Array) -> Array:
        """Efforts (joints,) that a motion of the rigid robot takes, its rotors among what is moved."""
        moved = [self.basis @ each for each in (rates, accelerations)]
        forces = self.model.inverse_dynamics(self.whole(joints), *moved) + self.model.rotor_inertias * moved[1]
        return forces @ self.basis

    def bend(self, joints: Array, rates: Array) -> Array:
        """Acceleration and angular acceleration (6,) of the tip at steady rates of the joints."""
        motion = self.model.points(self.whole(joints), self.basis @ rates, 0.0)
        return np.concatenate([motion.acceleration[self.tip], motion.angular_acceleration[self.tip]])


def followed(
    robot: Robot, paths: Sequence[Path], profile: Callable[[float], Any], tolerance: float,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Followed:  # fmt: skip
    """References along paths one after the other, each from rest to rest with the ``profile`` (a signal) of its length.

    From where the first commands put the undeformed robot; ``tolerance`` [m, rad] of the tip between the rows.

    Raises :class:`tmodes.errors.InputError` for a place that the robot does not reach or passes in a singular pose.
    """
    arm = Arm(robot)
    joints = np.array([*arm.start.values()])
    rows: list[tuple[float, Array, Array, Array]] = []
    errors, legs, begin = [(0.0, 0.0)], [], 0.0
    for number, path in enumerate(paths):
        progress("path", number / len(paths))
        position, rotation = arm.pose(joints)
        place = Place(position[0], rotation[0], joints)
        try:
            course = path.course(place)
        except InputError as error:
            raise InputError(f"path {number + 1}: {error.which}", error.got, error.expected, error.hint) from error
        leg = Leg(course, begin, profile(course.length), place)
        found, error = _Following(arm, leg, f"path {number + 1}").rows(tolerance)
        rows += found
        errors.append(error)
        legs.append(leg)
        joints, begin = found[-1][1], found[-1][0]
    times, values, rates, accelerations = (np.array(column) for column in zip(*_kept(rows), strict=True))
    worst = np.max(errors, axis=0)
    names = tuple(name.removesuffix(".motor") for name in arm.start)
    worst_place, worst_turn = worst.tolist()
    return Followed(names, times, values, rates, accelerations, worst_place, worst_turn, tuple(legs))


def _kept(rows: list[tuple[float, Array, Array, Array]]) -> Iterator[tuple[float, Array, Array, Array]]:
    """Without rows that say the same as the one before."""
    size = max(float(np.abs(row[3]).max()) for row in rows)
    for k, row in enumerate(rows):
        if not k or row[0] > rows[k - 1][0] or np.abs(row[3] - rows[k - 1][3]).max() > 1e-9 * size:
            yield row


class _Following:
    """One leg, from its start to its end."""

    def __init__(self, arm: Arm, leg: Leg, which: str) -> None:
        self.arm, self.leg, self.which = arm, leg, which
        if not leg.end > 0:
            raise InputError(
                "task.profile", "a motion without an end", "a move with an end", "take s_curve, or quintic"
            )
        self.pieces, self.end = leg.pieces, leg.end
        self.counts = 6 if leg.course.turn is not None else 3
        self.rank = arm.ranks[self.counts]
        self.redundant = len(arm.start) > self.rank

    def rows(self, tolerance: float) -> tuple[list[tuple[float, Array, Array, Array]], tuple[float, float]]:
        """Rows (time, values, rates, accelerations), halved until the tip is on the path; errors in place and angle."""
        starts, begin = self._knots(), self.leg.begin
        found, worst, guess = [], np.zeros(2), self.leg.place.joints
        for low, high in pairwise(starts):
            first = self._row(low, guess, low, late=True)
            found.append((begin + low, *first))
            stack = [high]
            while stack:
                last = self._row(stack[-1], first[0], low, late=False)
                error = self._error(low, stack[-1], first, last)
                middle = (low + stack[-1]) / 2
                if error.max() > tolerance and stack[-1] - low > 1e-9 * self.end:
                    stack.append(middle)
                    if len(found) + len(stack) > MOST_ROWS:
                        hint = "raise `fit`, or keep away from singular poses"
                        raise InputError(self.which, f"more than {MOST_ROWS} rows", "a path that can be fitted", hint)
                    continue
                worst = np.maximum(worst, error)
                low, first = stack.pop(), last  # noqa: PLW2901 - the next interval begins where this one ends
                found.append((begin + low, *first))
            guess = first[0]
        return found, (float(worst[0]), float(worst[1]))

    def _knots(self) -> list[float]:
        """Times at which a derivative may jump, and a few in between."""
        knots = {0.0, self.end, *self.pieces.knots.tolist()}
        knots |= {time for way in self.leg.course.knots for time in self._passes(way)}
        knots |= set(np.linspace(0.0, self.end, _FIRST + 1).tolist())
        kept = [0.0]
        for time in sorted(knots):
            if time - kept[-1] > 1e-9 * self.end and self.end - time > 1e-9 * self.end:
                kept.append(time)
        return [*kept, self.end]

    def _passes(self, way: float) -> Iterator[float]:
        from scipy.optimize import brentq

        times = np.linspace(0.0, self.end, 2001)
        values = self.pieces.at(times) - way
        for k in np.flatnonzero((values[:-1] < 0) != (values[1:] < 0)).tolist():
            found: Any = brentq(lambda time: float(self.pieces.at(time)) - way, times[k], times[k + 1], xtol=1e-15)
            yield float(found)

    def _row(self, time: float, guess: Array, before: float, *, late: bool) -> tuple[Array, Array, Array]:
        """Values, rates and accelerations at a time; at a knot those ``late`` of it, or before it.

        ``guess``: the joints at the time ``before``.
        """
        at = time if late else np.nextafter(time, 0.0)
        way, speed, gain = (float(self.pieces.at(at, order)) for order in range(3))
        course, length = self.leg.course, self.leg.course.length
        there = min(max(way, 0.0), length) + (1e-13 if late else -1e-13) * length
        place = course.at(there)
        if course.of_joints:
            return place.value, place.slope * speed, place.slope * gain + place.bend * speed**2
        if self.redundant:
            guess = self._carried(guess, float(np.clip(self.pieces.at(before), 0.0, length)), there)
        joints = self._reached(min(max(way, 0.0), length), guess)
        inverse, by_way = self._ways(joints, there)
        jacobian = self.arm.jacobian(joints)[: self.counts]
        bend = np.concatenate([place.bend, np.zeros(3)])[: self.counts]
        left = inverse @ (bend - self.arm.bend(joints, by_way)[: self.counts])
        if self.redundant:  # the part that leaves the tip in place: that of J'^T l
            step = _STRIDE / max(float(np.abs(by_way).max()), 1e-300)
            ends = [self.arm.jacobian(joints + sign * step * by_way)[: self.counts] for sign in (1.0, -1.0)]
            free = (ends[0] - ends[1]).T @ (inverse.T @ by_way) / (2 * step)
            left += free - inverse @ (jacobian @ free)
        return joints, by_way * speed, by_way * gain + left * speed**2

    def _ways(self, joints: Array, way: float) -> tuple[Array, Array]:
        """The inverse of the Jacobian (joints, directions), and the least rates of the joints per way."""
        course = self.leg.course
        jacobian = self.arm.jacobian(joints)[: self.counts]
        sizes = np.linalg.svd(jacobian, compute_uv=False)
        if sizes[self.rank - 1] <= _SINGULAR * sizes[0]:
            pose = ", ".join(f"{value:.4g}" for value in joints)
            hint = "move the path, or start in another pose"
            raise InputError(self.which, f"a singular pose at {pose}", "joints that follow the tip", hint)
        turn = np.zeros(3) if course.turn is None else course.turn / course.length
        inverse = np.asarray(np.linalg.pinv(jacobian, rcond=_SINGULAR), dtype=np.float64)
        return inverse, inverse @ np.concatenate([course.at(way).slope, turn])[: self.counts]

    def _carried(self, joints: Array, start: float, way: float) -> Array:
        """The joints of a redundant robot, brought from one way to another by the least rates."""
        from scipy.integrate import solve_ivp

        if abs(way - start) < _CLOSE:
            return joints
        found: Any = solve_ivp(
            lambda at, now: self._ways(now, at)[1], (start, way), joints, method="DOP853", rtol=1e-10, atol=1e-12
        )
        return np.asarray(found.y[:, -1])

    def _reached(self, way: float, guess: Array) -> Array:
        """The joints whose tip is there, by Newton's method from a guess."""
        wanted, turned = self.leg.target(way)
        joints, left = guess, np.inf
        for _ in range(_ROUNDS):
            off = _off(self.arm.pose(joints), wanted, turned)
            left = float(np.abs(off).max())
            if left < _CLOSE:
                break
            step = np.linalg.lstsq(self.arm.jacobian(joints)[: self.counts], off, rcond=1e-12)[0]
            size = float(np.abs(step).max())
            joints = joints + step * min(1.0, _FARTHEST / max(size, 1e-300))
            if size < 1e-15:
                break
        if not left < _REACHED:
            there = ", ".join(f"{value:.4g}" for value in wanted)
            got, expected = (
                f"the place ({there}) m, which the tip misses by {left:.3g}",
                "places that the robot reaches",
            )
            raise InputError(self.which, got, expected, "shorten the path, start in another pose, or leave `rpy` out")
        return joints

    def _error(self, low: float, high: float, first: Any, last: Any) -> Array:
        """Distance [m] and angle [rad] of the tip from the path between two rows."""
        from scipy.interpolate import BPoly

        if high - low <= 0:
            return np.zeros(2)
        ends = [[*row] for row in (first, last)]
        times = low + (high - low) * np.array(_CHECKS)
        joints = BPoly.from_derivatives([low, high], ends)(times)
        ways = np.clip(self.pieces.at(times), 0.0, self.leg.course.length)
        if self.leg.course.of_joints:
            exact = np.array([self.leg.course.at(way).value for way in ways.tolist()])
            return np.array([0.0, np.abs(joints - exact).max()])
        positions, rotations = self.arm.pose(joints)
        found = np.zeros(2)
        for way, position, rotation in zip(ways.tolist(), positions, rotations, strict=True):
            off = _off((position[None], rotation[None]), *self.leg.target(way))
            found = np.maximum(found, [np.linalg.norm(off[:3]), np.linalg.norm(off[3:])])
        return found


def _off(pose: tuple[Array, Array], wanted: Array, turned: Array | None) -> Array:
    """What is missing to a place (3,), or to a place and an orientation (6,)."""
    position, rotation = pose[0][0], pose[1][0]
    away = wanted - position
    return away if turned is None else np.concatenate([away, rotation_vector(turned @ rotation.T)])


def _turned(vector: Array) -> Array:
    """The rotation matrix of a rotation vector."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_rotvec(vector).as_matrix()
