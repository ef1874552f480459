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

__all__ = ["CONTACT_OUTPUTS", "LawAt", "Touch", "contact_law"]

CONTACT_OUTPUTS = 6
"""What is known of a contact: force by the point on the surface (3), its normal part, penetration and its rate."""

_LEAST = 1e-30
"""Least depth [m] that the law of a surface sees that only pushes: laws may take roots of it."""


@dataclass(frozen=True)
class Touch:
    """The kernels of a contact.

    Its numbers: those of the surface (4), the moving mass, gravity (3), and those of the law.
    """

    sheet: Contact

    @property
    def key(self) -> str:
        """The structure in words."""
        law = self.sheet
        return f"{law.shape.shape} {law.structure}{' unilateral' * law.unilateral}"

    @property
    def size(self) -> int:
        """How many numbers it has."""
        return SURFACE + 4 + len(self.sheet.numbers())

    def numbers(self, gravity: Any) -> tuple[float, ...]:
        """The numbers, for ``gravity`` (3,) [m/s^2]."""
        law = self.sheet
        return (*map(float, law.shape.numbers()), float(law.moving_mass), *map(float, gravity), *law.numbers())

    @property
    def has_mass(self) -> bool:
        """Whether a mass moves with the point."""
        return self.sheet.moving_mass > 0

    @property
    def rubs_with_mass(self) -> bool:
        """Whether friction asks for the accelerations, so that both are found together."""
        return self.sheet.rubs_with_mass and self.sheet.is_rough

    def _meeting(self, p: Any, place: v.Vector, velocity: v.Vector) -> Meeting:
        return self.sheet.shape.meet(p, place, velocity)

    def _law(self, p: Any) -> list[Any]:
        return [p[SURFACE + 4 + k] for k in range(len(self.sheet.numbers()))]

    def _push(self, p: Any, met: Meeting) -> Any:
        """Force of the law, before a surface that only pushes limits it."""
        depth = ca.if_else(met.depth > _LEAST, met.depth, _LEAST) if self.sheet.unilateral else met.depth
        return self.sheet.normal_force(self._law(p), depth, met.rate)

    def _acts(self, met: Meeting, push: Any) -> Any:
        return (met.depth > 0) * (push > 0) if self.sheet.unilateral else 1.0

    def slopes(self, p: Any, met: Meeting) -> tuple[Any, Any]:
        """Derivatives of the law's force by penetration [N/m] and by its rate [N*s/m]; zero where none acts."""
        depth, rate = ca.SX.sym("depth"), ca.SX.sym("rate")
        push = ca.SX(self._push(p, Meeting(met.direction, depth, rate, 0.0)))
        slopes = ca.jacobian(push, ca.vertcat(depth, rate))
        here = ca.substitute(slopes, ca.vertcat(depth, rate), ca.vertcat(met.depth, met.rate))
        acts = self._acts(met, self._push(p, met))
        return acts * here[0], acts * here[1]

    def _rub(self, p: Any, normal: Any, met: Meeting, velocity: v.Vector) -> v.Vector:
        slip = v.sub(velocity, v.scale(met.rate, met.direction))
        return self.sheet.friction_force(self._law(p), normal, slip, velocity)

    def normal(self, p: Any, met: Meeting) -> tuple[Any, Any]:
        """Normal force of the law, and the same before a surface that only pushes limits it."""
        push = self._push(p, met)
        return self._acts(met, push) * push, push

    def _force(self, p: Any, met: Meeting, velocity: v.Vector) -> tuple[Any, v.Vector]:
        """Normal force of the law, and the force by the point on the surface, but for what waits for the mass."""
        normal, _ = self.normal(p, met)
        force = v.scale(normal, met.direction)
        if self.sheet.is_rough and not self.rubs_with_mass:
            force = v.add(force, self._rub(p, normal, met, velocity))
        return normal, force

    @kernel("touch {0.key}", (POSE, POSE, 3, PLACEMENT, "size", FORCE), (FORCE, 2))
    def wrench(self, pose: Any, axes: Any, rate: Any, offset: Any, p: Any, sum_: Any) -> list[list[Any]]:
        """(pose of the frame, pose of the link's axes, rate in them, offset, numbers, sum of wrenches) -> (sum, gate).

        The sum includes the surface's push; the gate is the penetration, and the push without its limits.
        """
        place, velocity, *_ = _point(pose, axes, rate, offset)
        met = self._meeting(p, place, velocity)
        force = self._force(p, met, velocity)[1]
        pushed = [*(sum_[i] - force[i] for i in range(3)), *(sum_[3 + i] for i in range(3))]
        return [pushed, [met.depth, self._push(p, met)]]

    def _mass(self, p: Any, met: Meeting, step: Any) -> Any:
        """Moving mass, and h be + h^2 ka of a spring and a damper that are taken at the end of a step h."""
        stiffness, damping = self.slopes(p, met)
        return p[SURFACE] + step[0] * (damping + step[0] * stiffness)

    @kernel("touch mass {0.key}", (POSE, POSE, 3, PLACEMENT, "size", 1), (INERTIA, FORCE))
    def inertia(self, pose: Any, axes: Any, rate: Any, offset: Any, p: Any, step: Any) -> list[list[Any]]:
        """(pose of the frame, pose of the link's axes, rate in them, offset, numbers, step h) -> (inertia, bias force).

        Of the surface's mass, and of h be + h^2 ka while it pushes: what a spring and a damper that are taken at the
        end of a step add to it. About the frame's origin in the link's axes. The recursion's accelerations have
        gravity in them, which does not act on the surface.
        """
        place, velocity, arm, spin = _point(pose, axes, rate, offset)
        met, back = self._meeting(p, place, velocity), v.transpose(v.tri(axes))
        mass = self._mass(p, met, step)
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
        met = self._meeting(p, v.vec(pose, 9), velocity)
        normal, _ = self.normal(p, met)
        curving = met.curving + v.dot(met.direction, v.vec(p, SURFACE + 1))
        rubs, fixed = [v.zero(), v.zero()], v.zero()
        if self.rubs_with_mass:
            rubs = [v.scale(side, self._rub(p, side, met, velocity)) for side in (1.0, -1.0)]
        elif self.sheet.is_rough:
            fixed = self._rub(p, normal, met, velocity)
        mass = self._mass(p, met, step)
        return [met.direction, [mass, normal, curving], fixed, [*rubs[0], *rubs[1]]]

    @kernel("touch trial {0.key}", (POSE, FORCE, "size", 1, FORCE), (2, FORCE))
    def trial(self, pose: Any, motion: Any, p: Any, step: Any, sum_: Any) -> list[list[Any]]:
        """(pose of the point, its acceleration less gravity, numbers, h, sum of wrenches) -> (normal forces (2), sum).

        Normal force without friction, and a trial force; the sum with the trial's friction. The trial is a normal force
        of the same sign, of whose friction the accelerations are found next.
        """
        met, velocity, change = self._change(pose, motion, p)
        normal = self._force(p, met, velocity)[0] + self._mass(p, met, step) * change
        trial = ca.if_else(normal >= 0, 1.0, -1.0) * (ca.fabs(normal) + 1.0)
        rub = self._rub(p, trial, met, velocity)
        return [[normal, trial], [*(sum_[i] - rub[i] for i in range(3)), *(sum_[3 + i] for i in range(3))]]

    @kernel("touch share {0.key}", (POSE, FORCE, FORCE, "size", 1, 2), (1, 1))
    def share(self, pose: Any, before: Any, after: Any, p: Any, step: Any, trial: Any) -> list[list[Any]]:
        """(pose, acceleration without and with the trial's friction, numbers, h, normal forces (2)) -> (share, fold).

        ``share``: how much of the trial's friction acts: the normal force with a share s of the trial N1 is
        N0 - s (N0 - N(1)), and shall be s N1. ``fold`` is 1 plus the mass times the point's mobility along the normal
        under friction: where it is not positive, the contact jams.
        """
        met, _, change = self._change(pose, before, p)
        slower = self._mass(p, met, step) * (change - self._change(pose, after, p)[2])
        return [[trial[0] / (trial[1] + slower)], [1 + slower / trial[1]]]

    @kernel("touch unit {0.key}", (POSE, "size", FORCE), (FORCE,))
    def unit_push(self, pose: Any, p: Any, sum_: Any) -> list[list[Any]]:
        """(pose of the point, numbers, sum of wrenches) -> sum with 1 N more along the normal, on the surface."""
        met = self._meeting(p, v.vec(pose, 9), v.vec(pose, 12))
        return [[*(sum_[i] - met.direction[i] for i in range(3)), *(sum_[3 + i] for i in range(3))]]

    @kernel("touch fold {0.key}", (POSE, FORCE, FORCE, "size", 1), (1,))
    def fold(self, pose: Any, before: Any, after: Any, p: Any, rubbing: Any) -> list[list[Any]]:
        """(pose of the point, its acceleration without and with 1 N more, numbers, fold of friction) -> fold of all.

        1 plus the mass times the mobility, of the robot without that mass, along the push of normal force and friction.
        """
        slower = p[SURFACE] * (self._change(pose, before, p)[2] - self._change(pose, after, p)[2])
        return [[rubbing[0] / (1 - slower)]]

    def _change(self, pose: Any, motion: Any, p: Any) -> tuple[Meeting, v.Vector, Any]:
        """Meeting, velocity, and second derivative of the penetration."""
        velocity = v.vec(pose, 12)
        met = self._meeting(p, v.vec(pose, 9), velocity)
        return met, velocity, met.curving + v.dot(met.direction, v.add(v.vec(motion), v.vec(p, SURFACE + 1)))

    @kernel("touch {0.key}", (POSE, FORCE, "size"), (CONTACT_OUTPUTS, 1))
    def info(self, pose: Any, motion: Any, p: Any) -> list[list[Any]]:
        """(pose of the point, its acceleration less gravity, numbers) -> (CONTACT_OUTPUTS numbers, power taken [W])."""
        met, velocity, change = self._change(pose, motion, p)
        normal, force = self._force(p, met, velocity)
        inertial = p[SURFACE] * change
        force = v.add(force, v.scale(inertial, met.direction))
        if self.rubs_with_mass:
            force = v.add(force, self._rub(p, normal + inertial, met, velocity))
        return [[*force, normal + inertial, met.depth, met.rate], [v.dot(force, velocity)]]


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
