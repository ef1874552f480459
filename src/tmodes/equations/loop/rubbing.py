"""Kernels of a contact whose friction is of the whole normal force, that of the moving mass included.

That force has the point's acceleration in it: a trial force gives the relation of both.
"""

from __future__ import annotations

from typing import Any

import casadi as ca

from tmodes.equations.loop.of_touch import OfTouch
from tmodes.equations.recursion.hinge import POSE
from tmodes.kinds.contacts.contract import SURFACE
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Rubbing"]


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
