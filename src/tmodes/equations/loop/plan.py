"""What happens to a chain in a run, in plain terms: which signal moves what, what loads it, what it touches.

The numbers of the signals themselves are in the rows of a schedule; here is only which is which.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, Motor
from tmodes.equations.loop.contact_kernels import Touch
from tmodes.equations.loop.control_kernels import Servo, Winding
from tmodes.equations.mechanics import Mechanics, mechanics
from tmodes.equations.recursion.drive_kernels import DriveKernels, drive_kernels, drive_numbers
from tmodes.equations.recursion.parts import AxisPart, Parts
from tmodes.equations.recursion.passes import resting_base
from tmodes.errors import InputError
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.kernel.schedule import Slot

__all__ = [
    "WORKS", "DrivePlan", "Driver", "LoadPlan", "LoopParts", "LoopPlan", "StateLayout", "TouchPlan", "winding_of",
]  # fmt: skip

Array = NDArray[np.float64]

WORKS = ("motor", "loads", "base", "friction", "gear_damping", "link_damping", "contact")
"""Works [J] in the state: the first three brought in, the others taken out."""

BROUGHT_IN = 3
"""How many of the works are brought in."""


@dataclass(frozen=True)
class DrivePlan:
    """What moves one joint: a servo, or nothing but its signal, which it then follows exactly (``servo`` None).

    ``numbers``: R, CE, CM, L, then those of the controller; ``noise``: the signal of the error with which the
    controller sees its wanted value, -1 for none; ``clock``: the signal with the time since its last sample.
    """

    joint: str
    signal: int
    servo: Servo | None
    winding: Winding
    numbers: tuple[float, ...]
    noise: int = -1
    clock: int = -1

    @property
    def has_current(self) -> bool:
        """Whether the motor's current is a state."""
        return self.servo is not None and self.servo.has_current


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
    """A chain in a run. ``base``: the six signals that move it, or none. Signals are polynomials of ``degree``."""

    chain: Chain
    drives: tuple[DrivePlan, ...]
    signals: int
    degree: int
    loads: tuple[LoadPlan, ...] = ()
    touch: TouchPlan | None = None
    base: tuple[int, ...] = ()

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
        return (*(f"{name}.current" for name in self.currents), *self.control_names)

    @property
    def control_names(self) -> tuple[str, ...]:
        """Names of the controllers' own states, such as `hub.controller.integral`."""
        own = [(drive.joint, drive.servo.named_states) for drive in self.drives if drive.servo]
        return tuple(f"{joint}.controller.{state.name}" for joint, states in own for state in states)

    @property
    def control_units(self) -> tuple[str, ...]:
        """Units of the controllers' own states."""
        own = [(drive.joint in self.chain.sliding, drive.servo.named_states) for drive in self.drives if drive.servo]
        return tuple(state.unit_of(slides=slides) for slides, states in own for state in states)

    @property
    def aside(self) -> set[int]:
        """Signals that move nothing by themselves: noise on what controllers see, and their clocks."""
        return {place for drive in self.drives for place in (drive.noise, drive.clock)}

    @property
    def is_sampled(self) -> bool:
        """Whether any controller is."""
        return any(drive.servo.is_sampled for drive in self.drives if drive.servo)

    @property
    def controls(self) -> tuple[float, ...]:
        """The own states of all controllers at time 0, in the order of the drives."""
        return tuple(float(value) for drive in self.drives if drive.servo for value in drive.servo.start)


def winding_of(motor: Motor | None) -> tuple[Winding, tuple[float, ...]]:
    """Electric side of a motor, and R, CE, CM, L."""
    if motor is None or motor.resistance is None:
        return Winding.NONE, (1.0, 0.0, 1.0, 0.0)
    kind = Winding.INDUCTANCE if motor.inductance else Winding.RESISTANCE
    return kind, (motor.resistance, motor.back_emf, motor.torque_constant, motor.inductance)


class StateLayout(NamedTuple):
    """Where a state holds what: coordinates, rates, motor currents [A], controllers' own states, works [J]."""

    q: slice
    v: slice
    currents: slice
    controls: slice
    works: slice

    @classmethod
    def of(cls, coordinates: int, currents: int, controls: int) -> StateLayout:
        """Of so many coordinates, currents, and own states of controllers."""
        n, electric = coordinates, 2 * coordinates + currents
        end = electric + controls
        return cls(
            slice(0, n), slice(n, 2 * n), slice(2 * n, electric), slice(electric, end), slice(end, end + len(WORKS))
        )

    @property
    def size(self) -> int:
        """Numbers of a state."""
        return self.works.stop


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
