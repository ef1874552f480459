"""What all schedules of a closed loop have in common: the drives at their nodes, and the numbers of all."""

from __future__ import annotations

from dataclasses import dataclass, field

from tmodes.equations.loop.plan import DrivePlan, LoopPlan, StateLayout
from tmodes.equations.mechanics import Mechanics, mechanics
from tmodes.equations.recursion.drive_kernels import DriveKernels, drive_kernels, drive_numbers
from tmodes.equations.recursion.parts import AxisPart, Parts
from tmodes.equations.recursion.passes import resting_base
from tmodes.errors import InputError
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.kernel.schedule import Slot

__all__ = ["Driver", "LoopParts"]


@dataclass(frozen=True)
class Driver:
    """A drive of the plan at its node: the numbers and kernels that its motion needs."""

    plan: DrivePlan
    part: AxisPart
    index: int
    numbers: Slot
    kind: DriveKernels
    kind_numbers: Slot
    current: int
    controls: int
    """Where its controller's own states begin among those of all."""

    @property
    def coordinate(self) -> int:
        """Index of the coordinate that its motor turns."""
        return self.part.input


@dataclass(eq=False)
class LoopParts:
    """What the schedules of a plan have in common: kernels, and the numbers that all of them read."""

    plan: LoopPlan
    mechanics: Mechanics = field(init=False)
    parts: Parts = field(init=False)
    drivers: tuple[Driver, ...] = field(init=False)

    def __post_init__(self) -> None:
        plan, chain = self.plan, self.plan.chain
        self.mechanics = mechanics(chain)
        self.parts = self.mechanics.parts
        if plan.base and not self.mechanics.base_moves:
            got, expected = "a moving base", f"a base that stands still with the equations `{chain.equations}`"
            raise InputError("base_motion", got, expected, "remove `base_motion`, or take `equations: recursion`")
        numbers = self.parts.numbers
        begin = [sum(d.servo.states for d in plan.drives[:k] if d.servo) for k in range(len(plan.drives))]
        self.drivers = tuple(self._driver(drive, first) for drive, first in zip(plan.drives, begin, strict=True))
        self.loads = [numbers.block(load.wrench) for load in plan.loads]
        self.always = numbers.block([1.0, 0.0, 0.0])
        self.touch = numbers.block(plan.touch.numbers) if plan.touch else None
        placed = chain.base
        moved = [*placed.rotation.ravel(), *placed.position, *chain.gravity]
        self.base = numbers.block(moved if plan.base else resting_base(chain))

    def _driver(self, plan: DrivePlan, controls: int) -> Driver:
        part = next(axis for axis in self.parts.axes if axis.axis.name == plan.joint)
        kind, slot = part.drive, part.drive_numbers
        if kind is None or slot is None:
            joint, free = part.node.joint, drive_kind("effort")
            kind, slot = drive_kernels(joint, free), self.parts.numbers.block(drive_numbers(joint, free))
        currents = self.plan.currents
        current = currents.index(plan.joint) if plan.joint in currents else -1
        return Driver(plan, part, part.index, self.parts.numbers.block(plan.numbers), kind, slot, current, controls)

    @property
    def layout(self) -> StateLayout:
        """Where the state holds what."""
        return StateLayout.of(self.parts.size, len(self.plan.currents), len(self.plan.controls))
