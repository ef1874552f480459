"""Kernels of loads and of contact: forces on a point, and the mass of a surface that moves with it.

Contact force along the direction d into the surface, by the point on it, with the penetration x: Fc = me x'' + be x'
+ ka x + F0 (Filipovic & Djuric 2010, Eq. (36), with the signs of the 2010 robot's environment). The acceleration's part
is an inertia me d d^T on the point: exact, and nothing is differentiated. Friction acts along the surface and is mu
times the force of spring, damper and preload.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import casadi as ca

from tmodes.equations.recursion.hinge import PLACEMENT, POSE
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.spatial import FORCE, INERTIA, Force, Inertia

__all__ = ["CONTACT_TOLD", "TOUCH", "Surface", "Touch", "load_kernel", "power_kernel"]

TOUCH = 13
"""Numbers of a contact: direction or center (3), distance or radius, me, be, ka, F0, mu, veps, gravity (3)."""

CONTACT_TOLD = 6
"""What is told of a contact: force by the point on the surface (3), its normal part, penetration and its rate."""


class Surface(StrEnum):
    """The shape of a surface; a wall is a plane."""

    PLANE = "plane"
    BALL = "ball"  # the arm is outside
    BOWL = "bowl"  # the arm is inside of a ball, and presses outwards


@dataclass(frozen=True)
class _Meeting:
    """A point and a surface: direction into it, penetration, its rate, and its acceleration but for the point's own."""

    direction: v.Vector
    depth: Any
    rate: Any
    curving: Any


@dataclass(frozen=True)
class Touch:
    """Structure of a contact."""

    surface: Surface
    unilateral: bool = False
    rough: bool = False

    @property
    def key(self) -> str:
        """The structure in words."""
        return f"{self.surface}{' unilateral' * self.unilateral}{' rough' * self.rough}"

    def _meeting(self, p: Any, place: v.Vector, velocity: v.Vector) -> _Meeting:
        if self.surface is Surface.PLANE:
            direction = v.vec(p)
            return _Meeting(direction, v.dot(direction, place) - p[3], v.dot(direction, velocity), 0.0)
        arm = v.sub(place, v.vec(p))
        distance = ca.sqrt(v.dot(arm, arm))
        side = 1.0 if self.surface is Surface.BOWL else -1.0
        direction = v.scale(side / distance, arm)
        rate = v.dot(direction, velocity)
        curving = side * (v.dot(velocity, velocity) - rate * rate) / distance
        return _Meeting(direction, side * (distance - p[3]), rate, curving)

    def _push(self, p: Any, met: _Meeting) -> Any:
        """Force of spring, damper and preload."""
        return p[5] * met.rate + p[6] * met.depth + p[7]

    def _force(self, p: Any, met: _Meeting, velocity: v.Vector) -> tuple[Any, v.Vector]:
        """Normal force of spring, damper and preload, and the force by the point on the surface."""
        normal = self._push(p, met)
        if self.unilateral:
            normal = (met.depth > 0) * (normal > 0) * normal
        force = v.scale(normal, met.direction)
        if self.rough:
            slip = v.sub(velocity, v.scale(met.rate, met.direction))
            speed = ca.sqrt(v.dot(slip, slip) + p[9] * p[9])
            force = v.add(force, v.scale(p[8] * ca.fabs(normal) / speed, slip))
        return normal, force

    def wrench(self) -> Kernel:
        """(pose of the frame, pose of the link's axes, rate in them, offset, numbers, sum of wrenches) -> (sum, gate).

        The sum has the surface's push in it then; the gate is the penetration, and the push without its limits.
        """

        def build(pose: Any, axes: Any, rate: Any, offset: Any, p: Any, sum_: Any) -> list[list[Any]]:
            place, velocity, *_ = _point(pose, axes, rate, offset)
            met = self._meeting(p, place, velocity)
            force = self._force(p, met, velocity)[1]
            pushed = [*(sum_[i] - force[i] for i in range(3)), *(sum_[3 + i] for i in range(3))]
            return [pushed, [met.depth, self._push(p, met)]]

        return Kernel(f"touch {self.key}", (POSE, POSE, 3, PLACEMENT, TOUCH, FORCE), (FORCE, 2), build)

    def inertia(self) -> Kernel:
        """(pose of the frame, pose of the link's axes, rate in them, offset, numbers, step h) -> (inertia, bias force).

        Of the surface's mass, and of h be + h^2 ka while it pushes: what a spring and a damper that are taken at the
        end of a step add to it. About the frame's origin in the link's axes. The recursion's accelerations have
        gravity in them, which does not act on the surface.
        """

        def build(pose: Any, axes: Any, rate: Any, offset: Any, p: Any, step: Any) -> list[list[Any]]:
            place, velocity, arm, spin = _point(pose, axes, rate, offset)
            met, back = self._meeting(p, place, velocity), v.transpose(v.tri(axes))
            added = step[0] * (p[5] + step[0] * p[6])
            if self.unilateral:
                added = (met.depth > 0) * (self._push(p, met) > 0) * added
            mass = p[4] + added
            direction, lever = v.matvec(back, met.direction), v.matvec(back, arm)
            none = [[0.0] * 3 for _ in range(3)]
            inertia = Inertia(none, none, v.outer(v.scale(mass, direction), direction)).at(lever)
            drift = v.add(v.cross(spin, v.cross(spin, arm)), v.vec(p, 10))
            push = mass * (met.curving + v.dot(met.direction, drift))
            return [inertia.packed(), Force(v.zero(), v.scale(push, direction)).force_at(lever).packed()]

        return Kernel(f"touch mass {self.key}", (POSE, POSE, 3, PLACEMENT, TOUCH, 1), (INERTIA, FORCE), build)

    def info(self) -> Kernel:
        """(pose of the point, its [linear; angular] acceleration less gravity, numbers) -> (told (6), power taken)."""

        def build(pose: Any, motion: Any, p: Any) -> list[list[Any]]:
            place, velocity = v.vec(pose, 9), v.vec(pose, 12)
            met = self._meeting(p, place, velocity)
            normal, force = self._force(p, met, velocity)
            change = met.curving + v.dot(met.direction, v.add(v.vec(motion), v.vec(p, 10)))
            inertial = p[4] * change
            force = v.add(force, v.scale(inertial, met.direction))
            return [[*force, normal + inertial, met.depth, met.rate], [v.dot(force, velocity)]]

        return Kernel(f"touch told {self.key}", (POSE, FORCE, TOUCH), (CONTACT_TOLD, 1), build)


def _point(pose: Any, axes: Any, rate: Any, offset: Any) -> tuple[v.Vector, v.Vector, v.Vector, v.Vector]:
    """Position and velocity of a point of a frame, its arm, and the frame's rate, all in world axes."""
    arm, spin = v.matvec(v.tri(pose), v.vec(offset, 9)), v.matvec(v.tri(axes), v.vec(rate))
    return v.add(v.vec(pose, 9), arm), v.add(v.vec(pose, 12), v.cross(spin, arm)), arm, spin


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


def power_kernel() -> Kernel:
    """(wrench, pose and rate of its point, all in world axes) -> power [W]."""

    def build(wrench: Any, pose: Any, rate: Any) -> list[list[Any]]:
        return [[v.dot(v.vec(wrench), v.vec(pose, 12)) + v.dot(v.vec(wrench, 3), v.vec(rate))]]

    return Kernel("power", (FORCE, POSE, 3), (1,), build)
