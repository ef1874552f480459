"""Kernels of a contact that sticks, slips, is met and left: constraint forces, impact, friction bands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from tmodes.equations.loop.contact_kernels import CONTACT_OUTPUTS, MODE, SLIP, TOUCHES, Touch
from tmodes.equations.recursion.hinge import POSE
from tmodes.kinds.contacts.contract import SURFACE
from tmodes.kinds.contacts.registry import Meeting
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, Slot, kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["OWN", "Holding", "Landing", "OfTouch", "Rubbing", "against_kernel", "jump_kernel", "narrow_rates"]


@dataclass(frozen=True)
class OfTouch:
    """Kernels of one contact."""

    touch: Touch

    @property
    def key(self) -> str:
        """The structure in words."""
        return self.touch.key

    @property
    def size(self) -> int:
        """How many numbers the contact has."""
        return self.touch.size


_REST = 1e-7
"""A slip [m/s] up to this is rest."""

_DECAY = 10.0
"""Rate [1/s] at which what is left of a slip decays while the point sticks; taken at the end of an implicit step."""

_LEAST = 1e-14
"""Share of the mobility that is added along each tangent: no quotient by zero."""

_DEPENDENT = 1e-9
"""The smaller principal mobility along the surface over the larger one up to which the point moves along a line only.

A slider moves so, and what is left across is rounding in whatever direction the robot is turned.
"""

_ROUNDING = 1e-12
"""Share of the point's acceleration up to which what a trial force changes of it is rounding.

Where that is all, joints that stick hold the point already: of what they bear the contact takes nothing.
"""


class Holding(OfTouch):
    """The kernels of one contact."""

    def _met(self, pose: Any, p: Any, mode: Any) -> tuple[Meeting, v.Vector, Any]:
        """Meeting, slip, and normal force."""
        velocity = v.vec(pose, 12)
        met = self.touch.meeting(p, v.vec(pose, 9), velocity)
        return met, self.touch.slip(p, met, velocity)[1], self.touch.normal(p, met, mode)[0]

    @kernel("hold trials {0.key}", (POSE, "size", FORCE, MODE), (FORCE, FORCE))
    def trials(self, pose: Any, p: Any, sum_: Any, mode: Any) -> list[list[Any]]:
        """(pose of the point, numbers, sum of wrenches, mode) -> the sums with a trial force along each tangent."""
        met, _, normal = self._met(pose, p, mode)
        pushes = (v.scale(1 + f.fabs(normal), along) for along in _tangents(met.direction))
        return [[*(sum_[i] + push[i] for i in range(3)), *(sum_[3 + i] for i in range(3))] for push in pushes]

    @kernel("hold share {0.key}", (POSE, FORCE, FORCE, FORCE, "size", MODE, 1), (2, 3))
    def share(self, pose: Any, before: Any, one: Any, two: Any, p: Any, mode: Any, step: Any) -> list[list[Any]]:
        """Shares of both trials that act, and the force on the point that they are: zeros where it does not stick.

        Of (pose of the point, acceleration less gravity without and with each trial, numbers, mode, h). The mobility
        along the surface (2, 2) is inverted; where it is of rank one by its determinant, which is the same whatever the
        tangents, by its pseudo-inverse, of such a matrix its transpose over the sum of its squares.
        """
        met, slip, normal = self._met(pose, p, mode)
        along = _tangents(met.direction)
        motion = v.add(v.vec(before), v.vec(p, SURFACE + 1))
        decay = _DECAY / (1 + _DECAY * step[0])
        wanted = [-decay * v.dot(t, slip) - v.dot(t, motion) for t in along]
        (a, b), (c, d) = ([v.dot(t, v.sub(v.vec(after), v.vec(before))) for after in (one, two)] for t in along)
        noise = _ROUNDING * v.total([_size(v.vec(each)) for each in (before, one, two)])
        whole, line = f.fabs(a) + f.fabs(d), a * a + b * b + c * c + d * d + 1e-200
        is_line = f.fabs(a * d - b * c) <= whole * f.fmax(_DEPENDENT * whole, noise)
        sticks = (_slips(mode) < 0.5) * (f.fabs(normal) > 0) * (whole > noise)
        along_line = [(a * wanted[0] + c * wanted[1]) / line, (b * wanted[0] + d * wanted[1]) / line]
        least = _LEAST * whole + 1e-100
        a, d = a + least, d + least
        scale = 1 / (a * d - b * c)
        anywhere = [scale * (d * wanted[0] - b * wanted[1]), scale * (a * wanted[1] - c * wanted[0])]
        shares = [sticks * f.if_else(is_line, *pair) for pair in zip(along_line, anywhere, strict=True)]
        held = v.add(*(v.scale(share * (1 + f.fabs(normal)), t) for share, t in zip(shares, along, strict=True)))
        return [shares, held]

    @kernel("hold end {0.key}", (POSE, "size", MODE, 3), (1,))
    def function(self, pose: Any, p: Any, mode: Any, held: Any) -> list[list[Any]]:
        """(pose of the point, numbers, mode, force that holds) -> positive while the mode lasts, as without a force."""
        _, slip, normal = self._met(pose, p, mode)
        rest = self._limit(p, normal) - _size(v.vec(held))
        rest = f.if_else(_size(slip) < 10 * _REST, rest, -1.0)
        lasts = f.if_else(_slips(mode) < 0.5, rest, v.dot(slip, v.vec(mode)))
        return [[f.if_else(f.fabs(normal) > 0, lasts, 1.0)]]

    def _limit(self, p: Any, normal: Any) -> Any:
        return self.touch.sheet.static_limit(self.touch.law(p), normal)

    @kernel("hold switched {0.key}", (POSE, FORCE, "size", MODE, 3), (SLIP,))
    def switched(self, pose: Any, motion: Any, p: Any, mode: Any, held: Any) -> list[list[Any]]:
        """(pose of the point, acceleration less gravity, numbers, mode, force that holds) -> slip after the switch.

        A slip that has turned by a right angle continues in its new direction, or sticks where it has come to rest and
        does not accelerate along its mode.
        """
        _, slip, normal = self._met(pose, p, mode)
        push, side = v.vec(held), v.vec(mode)
        change = v.dot(v.add(v.vec(motion), v.vec(p, SURFACE + 1)), side)
        moves = _size(slip) > _REST
        fresh = v.scale(1 / (_size(slip) + 1e-300), slip)
        begins = _size(push) > self._limit(p, normal)
        against = v.scale(-1 / (_size(push) + 1e-300), push)
        stuck = [f.if_else(moves, x, begins * y) for x, y in zip(fresh, against, strict=True)]
        turned = v.dot(slip, side) <= 0
        moving = [f.if_else(turned, x, y) for x, y in zip(fresh, side, strict=True)]
        slowed = [(change > 0) * y for y in side]
        slipping = [f.if_else(moves, x, y) for x, y in zip(moving, slowed, strict=True)]
        touching = f.fabs(normal) > 0
        chosen = zip(stuck, slipping, strict=True)
        return [[touching * f.if_else(_slips(mode) < 0.5, x, y) for x, y in chosen]]


def _slips(mode: Any) -> Any:
    """About 1 where it slips, 0 where it sticks."""
    return v.dot(v.vec(mode), v.vec(mode))


def _size(a: v.Vector) -> Any:
    return f.sqrt(v.dot(a, a))


def _tangents(normal: v.Vector) -> tuple[v.Vector, v.Vector]:
    """Two directions across a unit vector and each other."""
    x, y, z = normal
    steep = f.fabs(x) < 0.6
    first = [f.if_else(steep, 0.0, -z), f.if_else(steep, z, 0.0), f.if_else(steep, -y, x)]
    one = v.scale(1 / _size(first), first)
    return one, v.cross(normal, one)


class Rubbing(OfTouch):
    """The kernels of one contact."""

    @kernel("rub trial {0.key}", (POSE, FORCE, "size", 1, FORCE), (2, FORCE))
    def trial(self, pose: Any, motion: Any, p: Any, step: Any, sum_: Any) -> list[list[Any]]:
        """(pose of the point, its acceleration less gravity, numbers, h, sum of wrenches) -> (normal forces (2), sum).

        Normal force without friction, and a trial force; the sum with the trial's friction. The trial is a normal force
        of the same sign, of whose friction the accelerations are found next.
        """
        met, velocity, change = self.touch.change(pose, motion, p)
        normal = self.touch.force(p, met, velocity)[0] + self.touch.mass(p, met, step) * change
        trial = ca.if_else(normal >= 0, 1.0, -1.0) * (ca.fabs(normal) + 1.0)
        rub = self.touch.rub(p, trial, met, velocity)
        return [[normal, trial], [*(sum_[i] - rub[i] for i in range(3)), *(sum_[3 + i] for i in range(3))]]

    @kernel("rub share {0.key}", (POSE, FORCE, FORCE, "size", 1, 2), (1, 1))
    def share(self, pose: Any, before: Any, after: Any, p: Any, step: Any, trial: Any) -> list[list[Any]]:
        """(pose, acceleration without and with the trial's friction, numbers, h, normal forces (2)) -> (share, fold).

        ``share``: how much of the trial's friction acts: the normal force with a share s of the trial N1 is
        N0 - s (N0 - N(1)), and shall be s N1. ``fold`` is 1 plus the mass times the point's mobility along the normal
        under friction: where it is not positive, the contact jams.
        """
        met, _, change = self.touch.change(pose, before, p)
        slower = self.touch.mass(p, met, step) * (change - self.touch.change(pose, after, p)[2])
        return [[trial[0] / (trial[1] + slower)], [1 + slower / trial[1]]]

    @kernel("rub unit {0.key}", (POSE, "size", FORCE), (FORCE,))
    def unit_push(self, pose: Any, p: Any, sum_: Any) -> list[list[Any]]:
        """(pose of the point, numbers, sum of wrenches) -> sum with 1 N more along the normal, on the surface."""
        met = self.touch.meeting(p, v.vec(pose, 9), v.vec(pose, 12))
        return [[*(sum_[i] - met.direction[i] for i in range(3)), *(sum_[3 + i] for i in range(3))]]

    @kernel("rub fold {0.key}", (POSE, FORCE, FORCE, "size", 1), (1,))
    def fold(self, pose: Any, before: Any, after: Any, p: Any, rubbing: Any) -> list[list[Any]]:
        """(pose of the point, its acceleration without and with 1 N more, numbers, fold of friction) -> fold of all.

        1 plus the mass times the mobility, of the robot without that mass, along the push of normal force and friction.
        """
        slower = p[SURFACE] * (self.touch.change(pose, before, p)[2] - self.touch.change(pose, after, p)[2])
        return [[rubbing[0] / (1 - slower)]]


OWN = 2
"""Displacement [m] of the surface along the direction into it, and its rate [m/s]."""

_CLEAR = 1e-14
"""Distance [m] between point and surface after a joint motion, above the rounding of their places."""

_SLOWEST = 1e-9
"""Speed [m/s] up to which point and surface do not meet, but press or part by their accelerations."""

_BOUNCE = 3e-7
"""Speed [m/s] up to which a point does not bounce any more."""


class Landing(OfTouch):
    """The kernels of one contact."""

    def _free(self, p: Any, own: Any) -> Any:
        """Acceleration of the surface by itself."""
        return -self.touch.sheet.normal_force(self.touch.law(p), own[0], own[1]) / p[SURFACE]

    @kernel("land own {0.key}", (POSE, FORCE, "size", MODE, OWN), (OWN,))
    def own(self, pose: Any, motion: Any, p: Any, mode: Any, own: Any) -> list[list[Any]]:
        """(pose, acceleration less gravity, numbers, mode, own state) -> rate of the own state."""
        met, _, change = self.touch.change(pose, motion, p)
        moved = ((met.rate, own[1]), (change, self._free(p, own)))
        return [[f.if_else(mode[TOUCHES] > 0.5, *pair) for pair in moved]]

    @kernel("land kept {0.key}", (POSE, "size", OWN, 1), (OWN,))
    def kept(self, pose: Any, p: Any, own: Any, touches: Any) -> list[list[Any]]:
        """(pose, numbers, own state, whether they touched) -> own state, exactly at the point where they touched."""
        depth = self.touch.meeting(p, v.vec(pose, 9), v.vec(pose, 12)).depth
        return [[f.if_else(touches[0] > 0.5, depth, own[0]), own[1]]]

    @kernel("land end {0.key}", (POSE, FORCE, "size", MODE, OWN), (1,))
    def function(self, pose: Any, motion: Any, p: Any, mode: Any, own: Any) -> list[list[Any]]:
        """(pose, acceleration less gravity, numbers, mode, own state) -> force while they touch, else the gap."""
        met, _, change = self.touch.change(pose, motion, p)
        return [[f.if_else(mode[TOUCHES] > 0.5, self.touch.whole(p, met, change, mode), own[0] - met.depth)]]

    @kernel("land switched {0.key}", (POSE, FORCE, FORCE, "size", MODE, OWN), (1, 1, OWN, 1))
    def switched(self, pose: Any, before: Any, pushed: Any, p: Any, mode: Any, own: Any) -> list[list[Any]]:
        """(pose, acceleration without and with 1 N that pushes the point out, numbers, mode, own state) -> the switch.

        Impulse [N*s] that pushes the point out, whether they touch, own state, and the work [J] taken from the robot.
        """
        met, _, change = self.touch.change(pose, before, p)
        mobility = change - self.touch.change(pose, pushed, p)[2]
        touches, gap, speed = mode[TOUCHES] > 0.5, own[0] - met.depth, met.rate - own[1]
        meets = (1 - touches) * (gap <= 0)
        hits = meets * (speed > _SLOWEST)
        back = self.touch.sheet.restitution_of(self.touch.law(p))
        bounces = hits * (speed > _BOUNCE) * (back * 1.0 > 0)
        impulse = hits * (1 + bounces * back) * speed / (mobility + 1 / p[SURFACE])
        after, moved = met.rate - mobility * impulse, own[1] + impulse / p[SURFACE]
        even = meets * (f.fabs(speed) <= _SLOWEST)
        presses = even * (change > self._free(p, [met.depth, own[1]]))
        stays = touches * (self.touch.whole(p, met, change, mode) >= 0)
        holds = f.fmin(stays + presses + hits * (1 - bounces), 1)
        parts = f.fmin(touches + even, 1) * (1 - holds)
        place = f.if_else(parts > 0.5, met.depth + _CLEAR, own[0])
        rate = f.if_else(touches * (1 - stays) > 0.5, met.rate, moved)
        new = [f.if_else(holds > 0.5, met.depth, place), f.if_else(holds > 0.5, after, rate)]
        return [[impulse], [holds], new, [impulse * (met.rate + after) / 2]]


@kernel("land info", (CONTACT_OUTPUTS, MODE, OWN), (CONTACT_OUTPUTS,))
def against_kernel(info: Any, mode: Any, own: Any) -> list[list[Any]]:
    """(what is known of a contact, mode, own state) -> the same, the penetration against where the surface is."""
    apart = (f.if_else(mode[TOUCHES] > 0.5, 0.0, info[4 + k] - own[k]) for k in range(OWN))
    return [[*(info[k] for k in range(4)), *apart]]


def jump_kernel(size: int) -> Kernel:
    """(rates, accelerations without and with a force of 1 N, impulse) -> rates after it."""

    def build(rates: Any, before: Any, after: Any, impulse: Any) -> list[list[Any]]:
        return [[rates[k] + impulse[0] * (after[k] - before[k]) for k in range(size)]]

    return Kernel(f"jump {size}", (size, size, size, 1), (size,), build)


def narrow_rates(instant: Any) -> Slot | None:
    """Rates of all such friction, then the widths of their bands; None where there is none."""
    rates: list[Slot] = []
    widths: list[Slot] = []
    for axis in instant.parts.axes:
        if axis.drive is None:
            continue
        motor = axis.motor if axis.motor >= 0 else axis.angle
        sides = ((motor, axis.drive.dry_motor), (axis.angle, axis.drive.dry_joint))
        for side, (place, dry) in enumerate(sides):
            if dry.is_narrow:
                rates.append(instant.way.v.part(place, 1))
                widths.append(instant.call(axis.drive.widths(), axis.drive_numbers)[0].part(side, 1))
    plan = instant.plan.touch
    if plan and plan.touch.sheet.friction_width([0.0] * len(plan.touch.sheet.numbers())) is not None:
        pose = instant.solution.point(plan.point)[0]
        slip, width = instant.call(_slip(plan.touch), pose, instant.loop.touch)
        rates.append(slip)
        widths.append(width)
    return instant.pack(*rates, *widths) if rates else None


def _slip(touch: Touch) -> Kernel:
    """(pose of the point, numbers of the contact) -> (slip, the width of its band for each component)."""

    def build(pose: Any, p: Any) -> list[list[Any]]:
        velocity = v.vec(pose, 12)
        met = touch.meeting(p, v.vec(pose, 9), velocity)
        return [[*touch.slip(p, met, velocity)[1]], [touch.sheet.friction_width(touch.law(p))] * 3]

    return Kernel(f"narrow slip {touch.key}", (POSE, touch.size), (3, 3), build)
