"""Coordinates q + h v, from which the springs of an implicit step of h start: those that are asked for, in groups."""

from __future__ import annotations

from typing import Any

from tmodes.equations.recursion.passes import Passes
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Slot

__all__ = ["Ahead", "ahead_kernel"]

_GROUP = 8
"""Motors or joints that go in one call; so the code is no longer for a longer arm."""


class Ahead:
    """Stands for the block of all coordinates; a call is added where a coordinate of its group is first asked for.

    A group is some motors, some joints, or all coordinates of one link.
    """

    def __init__(self, way: Passes, step: Slot) -> None:
        self.way, self.step = way, step
        self.found: dict[int, Slot] = {}
        motors, joints = way.parts.motors, way.parts.joints
        firsts = [*motors[::_GROUP], *joints[::_GROUP], *(part.link.first for part in way.parts.nodes if part.link)]
        self.firsts = sorted({*firsts, way.parts.size})

    def part(self, start: int, size: int) -> Slot:
        """A block of them, within one group."""
        first = max(first for first in self.firsts if first <= start)
        if first not in self.found:
            count = min(other for other in self.firsts if other > first) - first
            blocks = self.way.q.part(first, count), self.way.v.part(first, count), self.step
            (self.found[first],) = self.way.schedule.call(ahead_kernel(count), *blocks)
        return self.found[first].part(start - first, size)


def ahead_kernel(size: int) -> Kernel:
    """(q, v, h) -> q + h v."""

    def build(q: Any, v: Any, step: Any) -> list[list[Any]]:
        return [[q[i] + step[0] * v[i] for i in range(size)]]

    return Kernel(f"ahead {size}", (size, size, 1), (size,), build, plain=True)
