"""Kernels of contact: forces on a point, and the mass of a surface that moves with it.

A surface says where the point stands with regard to it, a contact law which force that takes. A moving mass me acts
along the direction d into the surface: an inertia me d d^T on the point, exact, and nothing is differentiated in time.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import casadi as ca

from tmodes.equations.recursion.hinge import PLACEMENT, POSE
from tmodes.kinds.contacts.contract import SURFACE
from tmodes.kinds.contacts.registry import Contact, Meeting
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import kernel
from tmodes.kinds.kernel.spatial import FORCE, INERTIA, Force, Inertia
from tmodes.kinds.noted.functions import number

__all__ = ["CONTACT_OUTPUTS", "MODE", "SLIP", "TOUCHES", "LawAt", "Touch", "contact_law"]

CONTACT_OUTPUTS = 6
"""What is known of a contact: force by the point on the surface (3), its normal part, penetration and its rate.

The penetration is that of the surface where it is: of one with mass that only pushes, at its own displacement."""

SLIP, TOUCHES, MODE = 3, 3, 4
"""Of a contact that sticks and slips the direction of its slip, zeros while it sticks: a unit vector that the slip has
left by less than a right angle. Then whether a surface with mass that only pushes is touched; of others always 1."""

_BELT = SURFACE + 4
_LAW = _BELT + 3
"""Where the numbers of the surface's velocity and of the law begin."""

_SLOWEST = 1e-9
"""What a slip [m/s] has along its mode at least: its direction is known at its onset, whatever rounding says."""

_LEAST = 1e-30
"""Least depth [m] that the law of a surface sees that only pushes: laws may take roots of it."""


@dataclass(frozen=True)
class Touch:
    """The kernels of a contact.

    Its numbers: those of the surface (4), the moving mass, gravity (3), the surface's velocity (3), those of the law.
    """

    sheet: Contact

    @property
    def key(self) -> str:
        """The structure in words."""
        law = self.sheet
        return f"{law.shape.shape} {law.structure}{' unilateral' * law.unilateral}{' lands' * self.lands}"

    @property
    def size(self) -> int:
        """How many numbers it has."""
        return _LAW + len(self.sheet.numbers())

    def numbers(self, gravity: Any) -> tuple[float, ...]:
        """The numbers, for ``gravity`` (3,) [m/s^2]."""
        law = self.sheet
        surface = (*law.shape.numbers(), law.moving_mass, *gravity, *law.velocity)
        return (*map(number, surface), *law.numbers())

    @property
    def has_mass(self) -> bool:
        """Whether a mass moves with the point."""
        return self.sheet.moving_mass > 0

    @property
    def rubs_with_mass(self) -> bool:
        """Whether friction asks for the accelerations, so that both are found together."""
        return self.sheet.rubs_with_mass and self.sheet.is_rough

    @property
    def lands(self) -> bool:
        """Whether its surface has mass and only pushes: it is met, left, and moves by itself."""
        return self.has_mass and self.sheet.unilateral

    @property
    def modes(self) -> int:
        """How many of the numbers of its mode stand in the state: those that switch."""
        return SLIP * self.sheet.sticks + self.lands

    def meeting(self, p: Any, place: v.Vector, velocity: v.Vector) -> Meeting:
        """Where the point stands with regard to the surface."""
        return self.sheet.shape.meet(p, place, velocity)

    def law(self, p: Any) -> list[Any]:
        """The numbers of the law."""
        return [p[_LAW + k] for k in range(len(self.sheet.numbers()))]

    def _push(self, p: Any, met: Meeting) -> Any:
        """Force of the law, before a surface that only pushes limits it; what carries a mass acts on both sides."""
        pushes = self.sheet.unilateral and not self.lands
        depth = ca.if_else(met.depth > _LEAST, met.depth, _LEAST) if pushes else met.depth
        return self.sheet.normal_force(self.law(p), depth, met.rate)

    def _acts(self, met: Meeting, push: Any, mode: Any) -> Any:
        if self.lands and mode is not None:
            return mode[TOUCHES]
        return (met.depth > 0) * (push > 0) if self.sheet.unilateral else 1.0

    def slopes(self, p: Any, met: Meeting, mode: Any = None) -> tuple[Any, Any]:
        """Derivatives of the law's force by penetration [N/m] and by its rate [N*s/m]; zero where none acts."""
        depth, rate = ca.SX.sym("depth"), ca.SX.sym("rate")
        push = ca.SX(self._push(p, Meeting(met.direction, depth, rate, 0.0)))
        slopes = ca.jacobian(push, ca.vertcat(depth, rate))
        here = ca.substitute(slopes, ca.vertcat(depth, rate), ca.vertcat(met.depth, met.rate))
        acts = self._acts(met, self._push(p, met), mode)
        return acts * here[0], acts * here[1]

    def slip(self, p: Any, met: Meeting, velocity: v.Vector) -> tuple[v.Vector, v.Vector]:
        """Velocity against the surface's, and its part along the surface."""
        belt = v.vec(p, _BELT)
        against = v.sub(velocity, v.sub(belt, v.scale(v.dot(belt, met.direction), met.direction)))
        return against, v.sub(against, v.scale(met.rate, met.direction))

    def rub(self, p: Any, normal: Any, met: Meeting, velocity: v.Vector, mode: Any = None) -> v.Vector:
        """Friction by the point on the surface."""
        against, slip = self.slip(p, met, velocity)
        if not self.sheet.sticks:
            return self.sheet.friction_force(self.law(p), normal, slip, against)
        # Along the slip, and along the mode still where the slip has turned back: its end is a simple root.
        side = v.vec(mode)
        slips, ahead = ca.if_else(v.dot(side, side) > 0.5, 1.0, 0.0), v.dot(slip, side)
        turned = v.add(slip, v.scale(ca.fabs(ahead) - ahead + _SLOWEST, side))
        along = v.add(v.scale(slips, turned), v.scale(1 - slips, met.direction))
        unit = v.scale(1 / ca.sqrt(v.dot(along, along)), along)
        return v.scale(slips, self.sheet.friction_force(self.law(p), normal, unit, unit))

    def normal(self, p: Any, met: Meeting, mode: Any = None) -> tuple[Any, Any]:
        """Normal force of the law, and the same before a surface that only pushes limits it."""
        push = self._push(p, met)
        return self._acts(met, push, mode) * push, push

    def whole(self, p: Any, met: Meeting, change: Any, mode: Any) -> Any:
        """Normal force with that of the moving mass; ``change``: second derivative of the penetration."""
        inertial = p[SURFACE] * change
        return self.normal(p, met, mode)[0] + (mode[TOUCHES] * inertial if self.lands else inertial)

    def force(self, p: Any, met: Meeting, velocity: v.Vector, mode: Any = None) -> tuple[Any, v.Vector]:
        """Normal force of the law, and the force by the point on the surface, but for what waits for the mass."""
        normal, _ = self.normal(p, met, mode)
        force = v.scale(normal, met.direction)
        if self.sheet.is_rough and not self.rubs_with_mass:
            force = v.add(force, self.rub(p, normal, met, velocity, mode))
        return normal, force

    @kernel("touch {0.key}", (POSE, POSE, 3, PLACEMENT, "size", FORCE, MODE), (FORCE, 2))
    def wrench(self, pose: Any, axes: Any, rate: Any, offset: Any, p: Any, sum_: Any, mode: Any) -> list[list[Any]]:
        """(pose of the frame, that of the link's axes, rate in them, offset, numbers, wrenches, mode) -> (sum, gate).

        The sum includes the surface's push; the gate is the penetration, and the push without its limits.
        """
        place, velocity, *_ = _point(pose, axes, rate, offset)
        met = self.meeting(p, place, velocity)
        force = self.force(p, met, velocity, mode)[1]
        pushed = [*(sum_[i] - force[i] for i in range(3)), *(sum_[3 + i] for i in range(3))]
        return [pushed, [met.depth, self._push(p, met)]]

    def mass(self, p: Any, met: Meeting, step: Any, mode: Any = None) -> Any:
        """Moving mass, and h be + h^2 ka of a spring and a damper that are taken at the end of a step h."""
        stiffness, damping = self.slopes(p, met, mode)
        moving = p[SURFACE] * mode[TOUCHES] if self.lands else p[SURFACE]
        return moving + step[0] * (damping + step[0] * stiffness)

    @kernel("touch mass {0.key}", (POSE, POSE, 3, PLACEMENT, "size", 1, MODE), (INERTIA, FORCE))
    def inertia(self, pose: Any, axes: Any, rate: Any, offset: Any, p: Any, step: Any, mode: Any) -> list[list[Any]]:
        """(pose of the frame, that of the link's axes, rate in them, offset, numbers, h, mode) -> (inertia, bias).

        Of the surface's mass, and of h be + h^2 ka while it pushes: what a spring and a damper that are taken at the
        end of a step add to it. About the frame's origin in the link's axes. The recursion's accelerations have
        gravity in them, which does not act on the surface.
        """
        place, velocity, arm, spin = _point(pose, axes, rate, offset)
        met, back = self.meeting(p, place, velocity), v.transpose(v.tri(axes))
        mass = self.mass(p, met, step, mode)
        direction, lever = v.matvec(back, met.direction), v.matvec(back, arm)
        none = [[0.0] * 3 for _ in range(3)]
        inertia = Inertia(none, none, v.outer(v.scale(mass, direction), direction)).at(lever)
        drift = v.add(v.cross(spin, v.cross(spin, arm)), v.vec(p, SURFACE + 1))
        push = mass * (met.curving + v.dot(met.direction, drift))
        return [inertia.packed(), Force(v.zero(), v.scale(push, direction)).force_at(lever).packed()]

    @kernel("touch affine {0.key}", (POSE, "size", 1), (3, 3, 3, 6))
    def affine(self, pose: Any, p: Any, step: Any) -> list[list[Any]]:
        """(pose of the point, numbers, step h) -> (direction, [mass, law, curving], friction, two frictions).

        For those who solve for normal force N and accelerations a at once: N = mass (d . a + curving) + law, the force
        on the surface N (d + rub) + friction; rub is the first of two where N is positive, else the second.
        """
        velocity = v.vec(pose, 12)
        met = self.meeting(p, v.vec(pose, 9), velocity)
        normal, _ = self.normal(p, met)
        curving = met.curving + v.dot(met.direction, v.vec(p, SURFACE + 1))
        rubs, fixed = [v.zero(), v.zero()], v.zero()
        if self.rubs_with_mass:
            rubs = [v.scale(side, self.rub(p, side, met, velocity)) for side in (1.0, -1.0)]
        elif self.sheet.is_rough:
            fixed = self.rub(p, normal, met, velocity)
        mass = self.mass(p, met, step)
        return [met.direction, [mass, normal, curving], fixed, [*rubs[0], *rubs[1]]]

    def change(self, pose: Any, motion: Any, p: Any) -> tuple[Meeting, v.Vector, Any]:
        """Meeting, velocity, and second derivative of the penetration."""
        velocity = v.vec(pose, 12)
        met = self.meeting(p, v.vec(pose, 9), velocity)
        return met, velocity, met.curving + v.dot(met.direction, v.add(v.vec(motion), v.vec(p, SURFACE + 1)))

    @kernel("touch taken {0.key}", (POSE, FORCE, FORCE, "size"), (1,))
    def taken(self, pose: Any, before: Any, after: Any, p: Any) -> list[list[Any]]:
        """(pose before an impulse, accelerations without and with it, numbers) -> work [J] on the moving mass."""
        met, _, change = self.change(pose, before, p)
        jump = self.change(pose, after, p)[2] - change
        return [[p[SURFACE] * jump * (met.rate + jump / 2)]]

    @kernel("touch {0.key}", (POSE, FORCE, "size", MODE, 3), (CONTACT_OUTPUTS, 1))
    def info(self, pose: Any, motion: Any, p: Any, mode: Any, held: Any) -> list[list[Any]]:
        """(pose, acceleration less gravity, numbers, mode, force that holds) -> (CONTACT_OUTPUTS, power taken [W])."""
        met, velocity, change = self.change(pose, motion, p)
        normal, force = self.force(p, met, velocity, mode)
        force = v.sub(force, v.vec(held))
        whole = self.whole(p, met, change, mode)
        force = v.add(force, v.scale(whole - normal, met.direction))
        if self.rubs_with_mass:
            force = v.add(force, self.rub(p, whole, met, velocity))
        return [[*force, whole, met.depth, met.rate], [v.dot(force, velocity)]]

    @kernel("sliding {0.key}", (POSE, "size"), (1,))
    def sliding(self, pose: Any, p: Any) -> list[list[Any]]:
        """(pose of the point, numbers) -> speed along the surface, against it."""
        velocity = v.vec(pose, 12)
        slip = self.slip(p, self.meeting(p, v.vec(pose, 9), velocity), velocity)[1]
        return [[ca.sqrt(v.dot(slip, slip))]]


def _point(pose: Any, axes: Any, rate: Any, offset: Any) -> tuple[v.Vector, v.Vector, v.Vector, v.Vector]:
    """Position and velocity of a point of a frame, its arm, and the frame's rate, all in world axes."""
    arm, spin = v.matvec(v.tri(pose), v.vec(offset, 9)), v.matvec(v.tri(axes), v.vec(rate))
    return v.add(v.vec(pose, 9), arm), v.add(v.vec(pose, 12), v.cross(spin, arm)), arm, spin


class LawAt(NamedTuple):
    """Normal force [N], its stiffness [N/m] and its damping [N*s/m] at a penetration; zeros where none acts."""

    force: float
    stiffness: float
    damping: float


def contact_law(sheet: Contact) -> Callable[[float, float], LawAt]:
    """(penetration [m], its rate [m/s]) -> the law there, but for the moving mass and friction."""
    touch, symbols = Touch(sheet), ca.SX.sym("motion", 2)
    numbers = ca.SX(ca.DM(touch.numbers(v.zero())))
    met = Meeting(v.zero(), symbols[0], symbols[1], 0.0)
    normal, _ = touch.normal(numbers, met)
    law = ca.Function("law", [symbols], [ca.vertcat(normal, *touch.slopes(numbers, met))])
    return lambda depth, rate: LawAt(*(float(x) for x in law([depth, rate]).full()[:, 0]))
