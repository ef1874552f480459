"""Kernels of a surface with mass that only pushes: it is met, moves with the point, is left, and moves by itself.

At a touch an impulse makes both normal speeds equal, or turns their difference around by the restitution; momentum is
kept. They move as one while the force between them pushes. A point that would leave a surface again at once rests on
it: so infinitely many bounces end.
"""

from __future__ import annotations

from typing import Any

from tmodes.equations.loop.contact_kernels import CONTACT_OUTPUTS, MODE, TOUCHES
from tmodes.equations.loop.of_touch import OfTouch
from tmodes.equations.recursion.hinge import POSE
from tmodes.kinds.contacts.contract import SURFACE
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["OWN", "Landing", "against_kernel", "jump_kernel"]

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
