"""A whole arm in a run as schedules: signals, controllers, motors, chain, loads, contact, works.

Inputs ``time`` (1), ``state``, ``row``, and ``step`` h (1). The output ``rate`` is the derivative of the state; with
h > 0 its accelerations are those of a linearly implicit Euler step of h.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

from tmodes.equations.loop.friction import contact_fold
from tmodes.equations.loop.instant import Instant
from tmodes.equations.loop.plan import DrivePlan, LoopPlan, StateLayout
from tmodes.equations.loop.powers import Powers
from tmodes.equations.mechanics import Mechanics, mechanics
from tmodes.equations.recursion.drive_kernels import DriveKernels, drive_kernels, drive_numbers
from tmodes.equations.recursion.parts import AxisPart, Parts
from tmodes.equations.recursion.passes import resting_base
from tmodes.errors import InputError
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.kernel.schedule import Schedule, Slot

__all__ = ["ClosedLoop", "Driver"]


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
class ClosedLoop:
    """The schedules of a plan, and its numbers; every schedule reads the same parameters."""

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

    @cached_property
    def rate(self) -> Schedule:
        """(time, state, row, step) -> derivative of the state."""
        return self._rate(Instant(self))

    @cached_property
    def implicit_rate(self) -> Schedule:
        """(time, state, row, step, start) -> derivative of the state, for the steps of implicit methods.

        Springs, dampers and servos start from ``start`` (2 nq), and h D + h^2 K stand beside the masses; all else is
        taken where ``state`` is, at ``time``.
        """
        return self._rate(Instant(self, apart=True))

    @cached_property
    def euler_rate(self) -> Schedule:
        """The same for implicit Euler steps, whose ``state`` is h of its rates ahead of ``start``.

        A surface in contact with a tip is taken at the end of the step as well.
        """
        return self._rate(Instant(self, apart=True, euler=True))

    def _rate(self, instant: Instant) -> Schedule:
        currents = [instant.change[k] for k in sorted(instant.change)]
        controls = [instant.controls[k] for k in sorted(instant.controls)]
        works = Powers(instant).works
        instant.schedule.often = True
        instant.schedule.output("rate", instant.way.v, *instant.accelerations, *currents, *controls, *works)
        return instant.schedule

    @cached_property
    def observe(self) -> Schedule:
        """(time, state, row, step) -> q, v, a, drives (4 each), gear, contact (6), fold, the base's row, powers."""
        instant = Instant(self)
        powers, drives = Powers(instant), range(len(self.drivers))
        shown = {
            "q": [instant.way.q],
            "v": [instant.way.v],
            "a": instant.accelerations,
            "drives": [powers.info[k] for k in drives],
            "gear": [powers.gear[k] for k in drives],
            "contact": [powers.contact],
            "contact_fold": [contact_fold(instant.solution, instant.begin)],
            "base": [instant.way.base],
            "powers": powers.works,
        }
        for name, blocks in shown.items():
            instant.schedule.output(name, *blocks)
        return instant.schedule
