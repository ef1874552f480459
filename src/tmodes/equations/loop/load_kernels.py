"""Kernels of loads on a point, and of their power."""

from __future__ import annotations

from typing import Any

from tmodes.equations.recursion.hinge import PLACEMENT, POSE
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["load_kernel", "power_kernel"]


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
