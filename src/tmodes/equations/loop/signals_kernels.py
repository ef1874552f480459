"""Kernels of given motions: a signal and its two derivatives from the row of a schedule, and the base that it moves."""

from __future__ import annotations

from math import factorial
from typing import Any

import casadi as ca

from tmodes.equations.recursion.hinge import PLACEMENT, POSE
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = [
    "BASE_NUMBERS",
    "SIGNAL",
    "base_kernel",
    "base_motion",
    "load_kernel",
    "power_kernel",
    "replacing_kernel",
    "signal_kernel",
]

SIGNAL = 3
"""What is known of a signal at an instant: value, rate, acceleration."""

BASE_NUMBERS = 15
"""Numbers of a moving base: rotation (9) and position (3) of its placement, gravity (3) in the world."""


def signal_kernel(degree: int, orders: int = SIGNAL) -> Kernel:
    """(time, start of the piece, coefficients) -> (value, rate, acceleration, ...) of the piece's polynomial."""

    def build(time: Any, start: Any, coefficients: Any) -> list[list[Any]]:
        tau = time[0] - start[0]
        found = [coefficients[degree], *([0.0] * (orders - 1))]
        for k in reversed(range(degree)):
            for order in reversed(range(1, orders)):
                found[order] = found[order] * tau + found[order - 1]
            found[0] = found[0] * tau + coefficients[k]
        return [[factorial(order) * value if order > 1 else value for order, value in enumerate(found)]]

    return Kernel(f"signal {degree} {orders}", (1, 1, degree + 1), (orders,), build)


def replacing_kernel(size: int, places: tuple[int, ...]) -> Kernel:
    """(q, v, a signal for each place) -> (q, v) whose coordinates at the places move as their signals."""

    def build(q: Any, rates: Any, *signals: Any) -> list[list[Any]]:
        kept = dict(zip(places, signals, strict=True))
        return [
            [kept[i][0] if i in kept else q[i] for i in range(size)],
            [kept[i][1] if i in kept else rates[i] for i in range(size)],
        ]

    return Kernel(f"replacing {size} {places}", (size, size, *(SIGNAL,) * len(places)), (size, size), build)


@kernel("moving base", (BASE_NUMBERS, *(SIGNAL,) * 6), (FORCE + 3 + POSE,))
def base_kernel(numbers: Any, *signals: Any) -> list[list[Any]]:
    """(numbers, six signals) -> the base's row: acceleration less gravity (6), rate (3), pose (15).

    The signals are the travels x, y, z [m] and the angles roll, pitch, yaw [rad] about fixed axes (R = Rz Ry Rx), all
    in the axes of the base's placement.
    """
    placed, place, gravity = v.tri(numbers), v.vec(numbers, 9), v.vec(numbers, 12)
    travel = [[signal[k] for signal in signals[:3]] for k in range(SIGNAL)]
    angle, rates, more = ([signal[k] for signal in signals[3:]] for k in range(SIGNAL))
    turned, rate = _turned(angle), _rate(angle, rates)
    angles, speeds = ca.SX.sym("angles", 3), ca.SX.sym("speeds", 3)
    info = ca.vertcat(*_rate([angles[i] for i in range(3)], [speeds[i] for i in range(3)]))
    change = ca.jtimes(info, ca.vertcat(angles, speeds), ca.vertcat(speeds, ca.SX(ca.vertcat(*more))))
    change = ca.substitute(change, ca.vertcat(angles, speeds), ca.vertcat(*angle, *rates))
    world = v.matmul(placed, turned)
    linear = v.sub(v.matvec(placed, travel[2]), gravity)
    return [v.flat(
        v.vec(change), v.matvec(v.transpose(world), linear), rate,
        world, v.add(place, v.matvec(placed, travel[0])), v.matvec(placed, travel[1]),
    )]  # fmt: skip


def base_motion(rate: Any, pose: Any) -> list[Any]:
    """Rate and velocity (6) of the base in its own axes, from its rate in them and its pose."""
    return [*v.vec(rate), *v.matvec(v.transpose(v.tri(pose)), v.vec(pose, 12))]


def _turned(angle: v.Vector) -> v.Matrix:
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    (cr, cp, cy), (sr, sp, sy) = (ca.cos(a) for a in angle), (ca.sin(a) for a in angle)
    return [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]


def _rate(angle: v.Vector, speed: v.Vector) -> v.Vector:
    """Angular velocity in the axes that turn."""
    (roll, pitch, _), (p, q, r) = angle, speed
    cr, sr, cp, sp = ca.cos(roll), ca.sin(roll), ca.cos(pitch), ca.sin(pitch)
    return [p - r * sp, q * cr + r * sr * cp, r * cr * cp - q * sr]


def load_kernel(*, follower: bool) -> Kernel:
    """(pose of the frame, offset, force and moment, signal, sum of wrenches) -> sum with the load, in world axes.

    The force and moment of a follower are in the point's own axes.
    """

    def build(pose: Any, offset: Any, load: Any, signal: Any, sum_: Any) -> list[list[Any]]:
        force, moment = v.vec(load), v.vec(load, 3)
        if follower:
            world = v.matmul(v.tri(pose), v.tri(offset))
            force, moment = v.matvec(world, force), v.matvec(world, moment)
        both = [*force, *moment]
        return [[sum_[i] + signal[0] * both[i] for i in range(FORCE)]]

    return Kernel(f"load{' follower' * follower}", (POSE, PLACEMENT, FORCE, 3, FORCE), (FORCE,), build)


@kernel("power", (FORCE, POSE, 3), (1,))
def power_kernel(wrench: Any, pose: Any, rate: Any) -> list[list[Any]]:
    """(wrench, pose and rate of its point, all in world axes) -> power [W]."""
    return [[v.dot(v.vec(wrench), v.vec(pose, 12)) + v.dot(v.vec(wrench, 3), v.vec(rate))]]
