"""Rates at which friction changes within narrow bands about zero, which the steps of implicit methods must not skip."""

from __future__ import annotations

from typing import Any

from tmodes.equations.loop.contact_kernels import Touch
from tmodes.equations.recursion.hinge import POSE
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, Slot

__all__ = ["narrow_rates"]


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
