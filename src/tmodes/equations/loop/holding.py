"""Kernels of a contact that sticks and slips: the force that keeps its point, and when that ends.

A point that sticks has no acceleration along the surface; what it needs for that is found by two trial forces. It
begins to slip where that is beyond the static friction, against the force that held it. The rest of a slip that
integration leaves decays.
"""

from __future__ import annotations

from typing import Any

from tmodes.equations.loop.contact_kernels import MODE, SLIP
from tmodes.equations.loop.of_touch import OfTouch
from tmodes.equations.recursion.hinge import POSE
from tmodes.kinds.contacts.contract import SURFACE
from tmodes.kinds.contacts.registry import Meeting
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Holding"]

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
