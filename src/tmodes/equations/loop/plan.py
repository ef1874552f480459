"""What happens to a chain in a run, in plain terms: which signal moves what, what loads it, what it touches.

The numbers of the signals themselves are in the rows of a schedule; here is only which is which.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.chain.chain import Chain, Motor
from tmodes.equations.loop.contact_kernels import Touch
from tmodes.equations.loop.control_kernels import Servo, View, Winding
from tmodes.equations.loop.laws import Law
from tmodes.equations.loop.layout import StateLayout
from tmodes.equations.loop.signals_kernels import SIGNAL
from tmodes.equations.mechanics import Mechanics, mechanics
from tmodes.equations.recursion.drive_kernels import DriveKernels, drive_kernels, drive_numbers
from tmodes.equations.recursion.parts import AxisPart, Parts
from tmodes.equations.recursion.passes import resting_base
from tmodes.errors import InputError
from tmodes.kinds.controllers.registry import OwnState, Port
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.kernel.schedule import Numbers, Slot
from tmodes.kinds.noted.functions import number

__all__ = [
    "BlockPlan", "DrivePlan", "Driver", "LoadPlan", "LoopParts", "LoopPlan", "TouchPlan", "winding_of",
]  # fmt: skip

Array = NDArray[np.float64]


@dataclass(frozen=True)
class DrivePlan:
    """What moves one joint: a servo, or nothing but its signal, which it then follows exactly (``servo`` None).

    ``numbers``: R, CE, CM, L, limits, then those of the controller; ``noise``: the signal of the error with which the
    controller sees its wanted value, -1 for none; ``clock``: the signal with the time since its last sample, ``late``:
    since its last delayed output. ``command``: the signal of a block that is its command; empty for its own.
    ``motion``: the signal of what its joint shall do, -1 where that is its setpoint; ``feed``: of the effort that is
    added to its command, -1 for none; ``brake``: of the largest torque of its brake, -1 for none.
    """

    joint: str
    signal: int
    servo: Servo | None
    winding: Winding
    numbers: tuple[float, ...]
    noise: int = -1
    clock: int = -1
    late: int = -1
    command: str = ""
    motion: int = -1
    feed: int = -1
    brake: int = -1

    @property
    def wanted(self) -> int:
        """The signal of what its joint shall do."""
        return self.signal if self.motion < 0 else self.motion

    @property
    def has_current(self) -> bool:
        """Whether the motor's current is a state."""
        return self.servo is not None and self.servo.has_current


@dataclass(frozen=True)
class BlockPlan:
    """A block of its own: a sensor, a filter, an observer, a controller of several drives.

    ``joint``: the drive of its own that it sees; empty for none. ``ports``: the signals that it gives; ``commands``:
    the joints that they command. ``clock``, ``late``: as those of a drive.
    """

    name: str
    law: Law
    ports: tuple[Port, ...]
    numbers: tuple[float, ...]
    joint: str = ""
    clock: int = -1
    late: int = -1
    commands: tuple[str, ...] = ()

    @property
    def signals(self) -> tuple[str, ...]:
        """Names of the signals that it gives."""
        return tuple(f"{self.name}.{port.name}" if port.name else self.name for port in self.ports)

    @property
    def named_states(self) -> tuple[OwnState, ...]:
        """Names and units of its states; of the held outputs those of the ports."""
        names = tuple(port.name or "value" for port in self.ports)
        return self.law.named_states(tuple(port.unit for port in self.ports), names)


@dataclass(frozen=True)
class LoadPlan:
    """A force and moment (6,) on a point, times a signal (-1: constant); of a follower in the point's axes."""

    point: int
    follower: bool
    wrench: tuple[float, ...]
    signal: int = -1


@dataclass(frozen=True)
class TouchPlan:
    """A point on a surface; ``numbers`` as the kernels want them."""

    point: int
    touch: Touch
    numbers: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class LoopPlan:
    """A chain in a run. ``base``: the six signals that move it, or none. Signals are polynomials of ``degree``.

    ``jolts``: signals whose rates jump -> the signals of these jumps, see :class:`tmodes.kinds.signals.registry.Jolts`.
    ``blocks``: in the order in which each comes after those that it reads; ``sources``: what else blocks read, by name:
    the number of a signal (of ``order`` 1: its rate), or an output, ``late`` where it follows from the commands of its
    instant. ``at_rest``: see :attr:`settles`.
    """

    chain: Chain
    drives: tuple[DrivePlan, ...]
    signals: int
    degree: int
    loads: tuple[LoadPlan, ...] = ()
    touch: TouchPlan | None = None
    base: tuple[int, ...] = ()
    jolts: tuple[tuple[int, int], ...] = ()
    blocks: tuple[BlockPlan, ...] = ()
    sources: Mapping[str, Any] = field(default_factory=dict)
    at_rest: bool = False

    @property
    def row_size(self) -> int:
        """Numbers of a row: start of the piece, coefficients of each signal."""
        return 1 + self.signals * (self.degree + 1)

    @property
    def currents(self) -> tuple[str, ...]:
        """Joints whose motor current is a state."""
        return tuple(drive.joint for drive in self.drives if drive.has_current)

    @property
    def further_states(self) -> tuple[str, ...]:
        """Names of the states between the rates and the works."""
        return (*(f"{name}.current" for name in self.currents), *self.control_names, *self.surface_names)

    @property
    def surface_names(self) -> tuple[str, ...]:
        """Names of the own states of a surface with mass that only pushes."""
        return ("contact.surface", "contact.surface_rate") if self.touch and self.touch.touch.lands else ()

    @property
    def _laws(self) -> Iterator[tuple[str, bool, Any]]:
        """Name of each law's states, whether its joint slides, and the servo or block; in the order of the state."""
        sliding = self.chain.sliding
        for drive in self.drives:
            if drive.servo:
                yield f"{drive.joint}.controller", drive.joint in sliding, drive.servo
        for block in self.blocks:
            yield block.name, block.joint in sliding, block

    @property
    def control_names(self) -> tuple[str, ...]:
        """Names of the own states of controllers and other blocks, such as `hub.controller.integral`."""
        return tuple(f"{name}.{state.name}" for name, _, law in self._laws for state in law.named_states)

    @property
    def control_units(self) -> tuple[str, ...]:
        """Units of these states."""
        return tuple(state.unit_of(slides=slides) for _, slides, law in self._laws for state in law.named_states)

    @property
    def clocks(self) -> tuple[tuple[int, int], ...]:
        """The signals with the time since the last sample, and since the last delayed output, of what is sampled."""
        return tuple((one.clock, one.late) for one in (*self.drives, *self.blocks) if one.clock >= 0)

    @property
    def aside(self) -> set[int]:
        """Signals that move nothing by themselves: noise on what controllers see, their clocks, and jumps of rates."""
        read = {k for k in self.sources.values() if isinstance(k, int)} - {
            k for drive in self.drives for k in (drive.signal, drive.feed)
        }
        noise = {drive.noise for drive in self.drives} | read
        return noise | {place for pair in self.clocks for place in (*pair, -1)} | {k for _, k in self.jolts}

    @property
    def is_sampled(self) -> bool:
        """Whether any controller or other block is."""
        return any(drive.servo.is_sampled for drive in self.drives if drive.servo) or any(
            block.law.is_sampled for block in self.blocks
        )

    @property
    def most_kept(self) -> int:
        """How many samples pass at most from one to the last of its delayed outputs, through all blocks in a row."""
        laws = [drive.servo.delay.kept for drive in self.drives if drive.servo and drive.servo.is_sampled]
        return sum(block.law.delay.kept for block in self.blocks if block.law.is_sampled) + max(laws, default=0)

    @property
    def first_samples(self) -> int:
        """After how many samples of one instant all held outputs are those of it.

        Outputs that follow from commands of their instant see the command of the sample before.
        """
        late = any(getattr(source, "late", False) for source in self.sources.values())
        return self.most_kept + 1 + late if self.is_sampled else 0

    @property
    def held_controls(self) -> tuple[bool, ...]:
        """Of each own state whether it is an output that is held, which follows from a sample."""
        laws = [drive.servo for drive in self.drives if drive.servo] + [block.law for block in self.blocks]
        return tuple(k < law.held for law in laws for k in range(law.states))

    @property
    def unstuck(self) -> LoopPlan:
        """The same where nothing sticks, and a surface has no mass; its numbers stand where those of this plan do."""
        nodes = tuple(replace(node, joint=node.joint.without_sticking()) for node in self.chain.nodes)
        touch = self.touch
        if touch and touch.touch.modes:
            still = Touch(touch.touch.sheet.resting())
            touch = replace(touch, touch=still, numbers=still.numbers(self.chain.gravity))
        return replace(self, chain=replace(self.chain, nodes=nodes), touch=touch, jolts=())

    @property
    def settles(self) -> LoopPlan:
        """The same for states at rest: nothing sticks, no surface has a mass, and samples are changes of their states.

        Its numbers stand where those of this plan do.
        """
        drives = []
        for drive in self.drives:
            servo = replace(drive.servo, settles=True) if drive.servo and drive.servo.is_sampled else drive.servo
            drives.append(replace(drive, servo=servo))
        blocks = tuple(replace(one, law=replace(one.law, settles=True)) for one in self.blocks)
        return replace(self.unstuck, drives=tuple(drives), blocks=blocks, at_rest=True)

    @cached_property
    def controls(self) -> tuple[float, ...]:
        """The own states of all controllers at time 0, in the order of the drives, then those of other blocks."""
        laws = [drive.servo for drive in self.drives if drive.servo] + [block.law for block in self.blocks]
        return tuple(number(value) for law in laws for value in law.start)


def winding_of(motor: Motor | None) -> tuple[Winding, tuple[float, ...]]:
    """Electric side of a motor, and R, CE, CM, L."""
    if motor is None or motor.resistance is None:
        return Winding.NONE, (1.0, 0.0, 1.0, 0.0)
    kind = Winding.INDUCTANCE if motor.inductance else Winding.RESISTANCE
    return kind, (motor.resistance, motor.back_emf, motor.torque_constant, motor.inductance)


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


@dataclass(frozen=True)
class Placed:
    """A block of the plan with its numbers, where its states begin among all, and the drive of its own."""

    plan: BlockPlan
    numbers: Slot
    controls: int
    driver: Driver | None


class _Again(Numbers):
    """Blocks of others' numbers, which are appended once, and found again in the same order."""

    def __init__(self, numbers: Numbers, known: list[Slot]) -> None:
        super().__init__()
        self._numbers, self._known, self._next = numbers, known, 0

    def block(self, values: ArrayLike) -> Slot:
        """The next block; appended where it is not known yet."""
        if self._next == len(self._known):
            self._known.append(self._numbers.block(values))
        self._next += 1
        return self._known[self._next - 1]


@dataclass(eq=False)
class LoopParts:
    """What the schedules of a plan have in common: kernels, and the numbers that all of them read."""

    plan: LoopPlan
    mechanics: Mechanics = field(init=False)
    parts: Parts = field(init=False)
    drivers: tuple[Driver, ...] = field(init=False)
    blocks: tuple[Placed, ...] = field(init=False)
    further: dict[str, list[Slot]] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        plan, chain = self.plan, self.plan.chain
        self.mechanics = mechanics(chain)
        self.parts = self.mechanics.parts
        if plan.base and not self.mechanics.base_moves:
            got, expected = "a moving base", f"a base that stands still with the equations `{chain.equations}`"
            raise InputError("base_motion", got, expected, "remove `base_motion`, or take `equations: recursion`")
        far = plan.touch and (plan.touch.touch.has_mass or self.mechanics.on_links) and not self.mechanics.base_moves
        if plan.touch and far and plan.touch.touch.modes:
            got, expected = "what sticks or is met", f"a smooth law with the equations `{chain.equations}`"
            hint = "add `friction_velocity: 0.001`; a surface that only pushes, or is rough, has no mass here"
            raise InputError("contact", got, expected, hint)
        if plan.jolts and plan.touch and not self.mechanics.base_moves:
            got, expected = "a rate that jumps", f"a rate without jumps, in contact, with `{chain.equations}`"
            raise InputError("drives", got, expected, "smooth the motion, or take `equations: recursion`")
        numbers = self.parts.numbers
        begin = [sum(d.servo.states for d in plan.drives[:k] if d.servo) for k in range(len(plan.drives))]
        self.drivers = tuple(self._driver(drive, first) for drive, first in zip(plan.drives, begin, strict=True))
        self.blocks = tuple(self._placed(sum(d.servo.states for d in plan.drives if d.servo)))
        self.loads = [numbers.block(load.wrench) for load in plan.loads]
        self.always = numbers.block([1.0, 0.0, 0.0])
        self.touch = numbers.block(plan.touch.numbers) if plan.touch else None
        placed = chain.base
        moved = [*placed.rotation.ravel(), *placed.position, *chain.gravity]
        self.base = numbers.block(moved if plan.base else resting_base(chain))

    def numbers_of(self, source: str) -> Numbers:
        """Where an output that blocks read puts numbers of its own: the same blocks each time that it is asked for."""
        return _Again(self.parts.numbers, self.further.setdefault(source, []))

    def _driver(self, plan: DrivePlan, controls: int) -> Driver:
        part = next(axis for axis in self.parts.axes if axis.axis.name == plan.joint)
        kind, slot = part.drive, part.drive_numbers
        if part.given >= 0 or kind is None or slot is None:
            joint, free = part.node.joint, drive_kind("effort")
            kind, slot = drive_kernels(joint, free), self.parts.numbers.block(drive_numbers(joint, free))
        currents = self.plan.currents
        current = currents.index(plan.joint) if plan.joint in currents else -1
        if plan.servo:
            orders = plan.servo.controller.setpoint_orders if plan.servo.controller else SIGNAL
            plan = replace(plan, servo=plan.servo.seeing(self._view(part.input, orders, (plan.joint,))))
        return Driver(plan, part, part.index, self.parts.numbers.block(plan.numbers), kind, slot, current, controls)

    def _view(self, own: int, orders: int, commands: tuple[str, ...]) -> View:
        """What a block sees that sees all."""
        names = tuple(drive.joint for drive in self.plan.drives)
        return View(tuple(self.parts.names), names, len(self.plan.currents), own, orders, commands)

    def _placed(self, first: int) -> Iterator[Placed]:
        """The blocks of the plan; their states begin at ``first`` among those of all laws."""
        for block in self.plan.blocks:
            driver = next((one for one in self.drivers if one.plan.joint == block.joint), None)
            if block.law.block.sees_all:
                own, orders = driver.coordinate if driver else -1, block.law.block.setpoint_orders
                view = self._view(own, orders, block.commands)
                block = replace(block, law=replace(block.law, view=view))  # noqa: PLW2901
            yield Placed(block, self.parts.numbers.block(block.numbers), first, driver)
            first += block.law.states

    @cached_property
    def held_commands(self) -> tuple[tuple[int, tuple[int, ...]], ...]:
        """Where the state holds sampled commands: of each drive what it moves, and the places, the one in force first.

        Behind it what the block remembers of it, and those of blocks before, whose command it takes over; of a drive
        without sampled ones nothing.
        """
        found, first = [], self.layout.controls.start
        for driver in self.drivers:
            servo, joint, places = driver.plan.servo, driver.plan.joint, list[int]()
            if servo and servo.held:
                places += range(first + driver.controls, first + driver.controls + servo.held)
            for one in sorted(self.blocks, key=lambda one: driver.plan.command not in one.plan.signals):
                own = one.plan.commands or ((one.plan.joint,) if len(one.plan.ports) == 1 else ())
                if joint in own and one.plan.law.held:
                    law, past = one.plan.law, getattr(one.plan.law.block, "remembered", 0)
                    kept = [*range(law.held), *range(law.states - past, law.states)]
                    places += [first + one.controls + k for k in kept[own.index(joint) :: law.outputs]]
            if places:
                found.append((driver.coordinate, tuple(places)))
        return tuple(found)

    @cached_property
    def slipping(self) -> dict[int, tuple[AxisPart, int]]:
        """Coordinates whose dry friction is a set at rest: the axis of each, and whether it is its motor's (0) or not.

        A motor that follows its signal exactly needs none: its friction is part of what it takes.
        """
        exact = {driver.part.motor for driver in self.drivers if driver.plan.servo is None}
        found = {}
        for axis in self.parts.axes:
            sticks = axis.drive.set_sides if axis.drive else (False, False)
            if sticks[0] and axis.motor not in exact:
                found[axis.motor] = (axis, 0)
            if sticks[1]:
                found[axis.angle] = (axis, 1)
        return dict(sorted(found.items()))

    @property
    def modes(self) -> int:
        """How many numbers say what sticks and what slips: of coordinates, then of the point that touches.

        Where rates jump, one more: 1 plus the time [s] of the last jump.
        """
        touch = self.plan.touch.touch.modes if self.plan.touch else 0
        return len(self.slipping) + touch + bool(self.plan.jolts)

    @cached_property
    def layout(self) -> StateLayout:
        """Where the state holds what."""
        sizes = len(self.plan.currents), len(self.plan.controls), len(self.plan.surface_names), self.modes
        return StateLayout.of(self.parts.size, *sizes)
