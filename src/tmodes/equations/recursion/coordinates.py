"""The coordinates of a chain in a schedule: blocks of motors, joints and links, and how coupled gears mix them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tmodes.equations.recursion.drive_kernels import mixing_kernel
from tmodes.equations.recursion.parts import AxisPart, LinkPart, Parts
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Divisible, Schedule, Slot

__all__ = ["Coordinates", "packing_kernel"]


class Coordinates:
    """Blocks of all coordinates ``q`` and rates ``v``, and parts of them."""

    def __init__(self, parts: Parts, schedule: Schedule, q: Slot, v: Slot) -> None:
        self.parts, self.schedule, self.q, self.v = parts, schedule, q, v
        self.none = parts.none

    def angle(self, axis: AxisPart) -> tuple[Slot, Slot]:
        """A coordinate of a joint and its rate."""
        return self._pair(axis.angle)

    def motor(self, axis: AxisPart) -> tuple[Slot, Slot]:
        """Angle and rate of a motor."""
        return self._pair(axis.motor)

    def _pair(self, index: int, size: int = 1) -> tuple[Slot, Slot]:
        return (self.none[1], self.none[1]) if index < 0 else (self.q.part(index, size), self.v.part(index, size))

    def packed(self, slots: Sequence[Slot]) -> Slot:
        """One number for each coordinate of a joint as one block; zero for a joint that does not move."""
        if len(slots) < 2:
            return slots[0] if slots else self.none[1]
        if all(slot is self.none[1] for slot in slots):
            return self.none[len(slots)]
        return self.schedule.call(packing_kernel((1,) * len(slots)), *slots)[0]

    def bend(self, link: LinkPart, block: Divisible) -> Slot:
        """The link's part of a block of all coordinates."""
        return block.part(link.first, link.kernels.n)

    def coupled_inputs(self) -> dict[int, tuple[Slot, Slot]]:
        """Angle and rate at the input of each coupled gear, by the index of its motor; empty without couplings."""
        matrix, motors = self.parts.couplings, self.parts.motors
        if matrix is None:
            return {}
        mix = mixing_kernel(len(motors), transposed=False)
        angles = self.schedule.call(mix, matrix, *(self.q.part(i, 1) for i in motors))
        rates = self.schedule.call(mix, matrix, *(self.v.part(i, 1) for i in motors))
        return dict(zip(motors, zip(angles, rates, strict=True), strict=True))

    def coupled_loads(self, torques: dict[int, Slot]) -> dict[int, Slot]:
        """Load of all coupled gears on each motor, by the motor's index."""
        matrix, motors = self.parts.couplings, self.parts.motors
        if matrix is None:
            return {}
        mix = mixing_kernel(len(motors), transposed=True)
        return dict(zip(motors, self.schedule.call(mix, matrix, *(torques[i] for i in motors)), strict=True))

    def by_coordinate(self, motors: dict[int, Slot], joints: dict[int, Slot], links: dict[int, Slot]) -> list[Slot]:
        """Blocks of the coordinates in their order: motors, joints, links."""
        none = self.none[1]
        first = [motors.get(i, none) for i in self.parts.motors] + [joints.get(i, none) for i in self.parts.joints]
        return first + [links[part.link.first] for part in self.parts.nodes if part.link]


def packing_kernel(sizes: tuple[int, ...]) -> Kernel:
    """Blocks one after the other in one block."""

    def build(*blocks: Any) -> list[list[Any]]:
        return [[block[i] for block, size in zip(blocks, sizes, strict=True) for i in range(size)]]

    return Kernel(f"packing {sizes}", sizes, (sum(sizes),), build)
