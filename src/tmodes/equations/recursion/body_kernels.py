"""Kernels of rigid bodies, of forces on points, and of the motion of points."""

from __future__ import annotations

from typing import Any

from tmodes.equations.recursion.hinge import PLACEMENT, POSE
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, kernel
from tmodes.kinds.kernel.spatial import FORCE, INERTIA, Force, Inertia, body_bias, body_inertia

__all__ = [
    "BODY", "body_inertia_kernel", "body_kernel", "body_moment_kernel", "point_kernel", "push_kernel", "sum_kernel",
    "times_kernel",
]  # fmt: skip

BODY = 10
"""Numbers of a rigid body: mass, first moment m c (3), inertia about the frame's origin (xx, yy, zz, xy, xz, yz)."""


def body_kernel(*, on_section: bool) -> Kernel:
    """(body, rotation of its frame, rate) -> its inertia and bias force about that frame's origin, in link axes."""

    def build(body: Any, rotation: Any, rate: Any) -> list[list[Any]]:
        moment, inertia = v.vec(body, 1), v.symmetric(body, 4)
        if on_section:
            turned = v.tri(rotation)
            moment, inertia = v.matvec(turned, moment), v.turn(turned, inertia, is_symmetric=True)
        bias = body_bias(moment, inertia, v.vec(rate))
        return [body_inertia(body[0], moment, inertia).packed(), bias.packed()]

    return Kernel(f"body{' on section' * on_section}", (BODY, 9, 3), (INERTIA, FORCE), build, plain=True)


@kernel("body inertia", (BODY,), (INERTIA,), plain=True)
def body_inertia_kernel(body: Any) -> list[list[Any]]:
    """Body -> its inertia about its frame's origin."""
    return [body_inertia(body[0], v.vec(body, 1), v.symmetric(body, 4)).packed()]


def push_kernel(*, on_section: bool) -> Kernel:
    """(pose of the link's axes, rotation of a frame, arm in it, wrench in the world, bias force) -> less the wrench."""

    def build(pose: Any, rotation: Any, arm: Any, wrench: Any, bias: Any) -> list[list[Any]]:
        back = v.transpose(v.tri(pose))
        lever = v.matvec(v.tri(rotation), v.vec(arm)) if on_section else v.vec(arm)
        push = Force(v.matvec(back, v.vec(wrench, 3)), v.matvec(back, v.vec(wrench))).force_at(lever)
        return [(Force.of(bias) - push).packed()]

    return Kernel(f"push{' on section' * on_section}", (POSE, 9, 3, 6, FORCE), (FORCE,), build)


def point_kernel(*, on_section: bool) -> Kernel:
    """Motion of a point in world axes: (pose of its frame, rotation of that in the link, rate, acceleration, offset).

    -> (pose, rate, [linear; angular] acceleration). Rate and acceleration of the frame are in the link's axes.
    """

    def build(pose: Any, rotation: Any, rate: Any, motion: Any, offset: Any) -> list[list[Any]]:
        world, w, arm, move = v.tri(pose), v.vec(rate), v.vec(offset, 9), Force.of(motion)
        if on_section:
            back = v.transpose(v.tri(rotation))
            w, move = v.matvec(back, w), move.turned(back)
        place = v.add(v.vec(pose, 9), v.matvec(world, arm))
        velocity = v.add(v.vec(pose, 12), v.matvec(world, v.cross(w, arm)))
        linear = v.add(move.motion_at(arm).linear, v.cross(w, v.cross(w, arm)))
        return [
            v.flat(v.matmul(world, v.tri(offset)), place, velocity), v.matvec(world, w),
            [*v.matvec(world, linear), *v.matvec(world, move.angular)],
        ]  # fmt: skip

    return Kernel(f"point{' on section' * on_section}", (POSE, 9, 3, FORCE, PLACEMENT), (POSE, 3, 6), build)


@kernel("times", (INERTIA, FORCE, FORCE), (FORCE,))
def times_kernel(inertia: Any, motion: Any, bias: Any) -> list[list[Any]]:
    """(inertia, acceleration, bias force) -> force."""
    return [(Inertia.of(inertia).times(Force.of(motion)) + Force.of(bias)).packed()]


@kernel("body moment", (BODY, POSE, 3), (3,))
def body_moment_kernel(body: Any, pose: Any, sum_: Any) -> list[list[Any]]:
    """(body, pose of its frame, sum) -> sum of mass times position, in the world."""
    return [v.add(v.vec(sum_), v.scale(body[0], v.vec(pose, 9)), v.matvec(v.tri(pose), v.vec(body, 1)))]


@kernel("sum", (INERTIA, FORCE, INERTIA, FORCE), (INERTIA, FORCE))
def sum_kernel(inertia: Any, bias: Any, more: Any, push: Any) -> list[list[Any]]:
    """(inertia, bias force, inertia, bias force) -> the two together."""
    return [[inertia[i] + more[i] for i in range(INERTIA)], [bias[i] + push[i] for i in range(FORCE)]]
