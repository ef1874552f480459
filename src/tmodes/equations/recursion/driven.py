"""The coordinates of a chain in a schedule, and what drives them: efforts, elastic gears, motors with a given motion.

Both makers of equations share it, the recursion and Lagrange's equations: a drive turns into an effort on its joint
and an inertia of its own, and the motor behind an elastic gear follows from the joint's acceleration.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from tmodes.equations.recursion.drive_kernels import SIDES, mixing_kernel, sides_kernel
from tmodes.equations.recursion.parts import AxisPart, LinkPart, Parts
from tmodes.kinds.kernel.schedule import Divisible, Kernel, Schedule, Slot
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Coordinates", "Driven", "Drives", "packing_kernel"]


class Coordinates:
    """Blocks of all coordinates ``q`` and rates ``v``, parts of them, and what acts on the chain.

    ``wrenches``: number of a point -> force and moment on it, in world axes. ``braked``: index of a joint's coordinate
    -> the numbers of its drive with what its brake adds.
    """

    def __init__(self, parts: Parts, schedule: Schedule, q: Slot, v: Slot) -> None:
        self.parts, self.schedule, self.q, self.v = parts, schedule, q, v
        self.none = parts.none
        self.wrenches: dict[int, Slot] = {}
        self.braked: dict[int, Slot] = {}

    def take_wrenches(self, *, loaded: bool) -> None:
        """The input of forces on the points (6 each, in world axes), where there is one."""
        if loaded:
            block = self.schedule.input("wrenches", FORCE * len(self.parts.points))
            self.wrenches = {k: block.part(FORCE * k, FORCE) for k in range(len(self.parts.points))}

    def drive_numbers(self, axis: AxisPart) -> Any:
        """The numbers of the drive of an axis, its brake's among them."""
        return self.braked.get(axis.angle, axis.drive_numbers)

    def angle(self, axis: AxisPart) -> tuple[Slot, Slot]:
        """A coordinate of a joint and its rate."""
        return self._pair(axis.angle)

    def motor(self, axis: AxisPart) -> tuple[Slot, Slot]:
        """Angle and rate of a motor."""
        return self._pair(axis.motor)

    def _pair(self, index: int, size: int = 1) -> tuple[Slot, Slot]:
        return (self.none[1], self.none[1]) if index < 0 else (self.q.part(index, size), self.v.part(index, size))

    def sides(self, axis: AxisPart, slips: Mapping[int, Slot] | None = None) -> Slot:
        """Sides of the motor and of the joint of an axis (see :class:`Drives`)."""
        places = (axis.motor, axis.angle)
        if axis.drive is None or not any(axis.drive.set_sides):
            return self.none[SIDES]
        if slips is None:
            rates = self.schedule.call(packing_kernel((1, 1)), self.motor(axis)[1], self.angle(axis)[1])[0]
            return self.schedule.call(sides_kernel(), rates)[0]
        free = self.none[2]
        return self.schedule.call(packing_kernel((2, 2)), *(slips.get(place, free) for place in places))[0]

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


class Drives(NamedTuple):
    """What drives a chain: ``effort`` of each drive, accelerations that are ``given``, length of an implicit ``step``.

    ``start``: coordinates and rates from which springs, dampers and friction start; those of the outward pass place all
    else. ``feedback`` (2 per effort): see :meth:`DriveKernels.forward`. ``sides``: index of a coordinate with dry
    friction that is a set at rest -> its direction of slip and the inertia that holds it; without them the rates say.
    """

    effort: Slot
    given: Slot
    step: Slot
    start: tuple[Divisible, Slot]
    feedback: Slot | None = None
    sides: Mapping[int, Slot] | None = None


class Driven:
    """Efforts on the joints and own inertias of their drives, and the accelerations of the motors."""

    way: Any

    def __init__(self, way: Coordinates, drives: Drives) -> None:
        self.way = way
        self.effort, self.given, self.step, self.start, self.feedback, self.slips = drives
        self.followed: dict[int, Slot] = {}  # index of a motor that keeps a given motion -> its acceleration
        self.schedule, self.parts = way.schedule, way.parts
        self.motor_terms: dict[int, Slot] = {}
        self.accelerations: list[Slot] = []
        self.contact: Slot | None = None
        self.coupled = way.coupled_inputs()
        self.torques: dict[int, Slot] = {}
        self.coupled_loads: dict[int, Slot] = {}

    def packed(self) -> Slot:
        """The accelerations in one block, after the run."""
        sizes = tuple(block.size for block in self.accelerations)
        return self.schedule.call(packing_kernel(sizes), *self.accelerations)[0]

    def given_acceleration(self, axis: AxisPart) -> Slot:
        """The acceleration of a prescribed coordinate, zero of any other."""
        return self.given.part(axis.given, 1) if axis.given >= 0 else self.way.none[1]

    def _start(self, index: int) -> tuple[Slot, Slot]:
        """Where a coordinate and its rate start from; zero without one."""
        none = self.way.none[1]
        return (none, none) if index < 0 else (self.start[0].part(index, 1), self.start[1].part(index, 1))

    def sides(self, axis: AxisPart) -> Slot:
        """Sides of motor and joint; zeros where no dry friction is a set."""
        return self.way.sides(axis, self.slips)

    def drive(self, axis: AxisPart) -> tuple[Slot, Slot]:
        """Effort on a coordinate of a joint (of a prescribed one its acceleration), and inertia that its drive adds."""
        none = self.way.none[1]
        if axis.given >= 0 or axis.drive is None or axis.drive_numbers is None:
            return self.given_acceleration(axis), none
        if axis.drive.bare and not self.feedback:
            return self.effort.part(axis.effort, 1), none
        numbers = self.way.drive_numbers(axis)
        if axis.motor in self.coupled:
            blocks = (numbers, *self.coupled[axis.motor], *self.way.angle(axis), self.sides(axis))
            effort, self.torques[axis.motor] = self.schedule.call(axis.drive.coupled(), *blocks)
            return effort, none
        if axis.motor in self.followed:
            angles = (*self._start(axis.motor), *self._start(axis.angle))
            blocks = (numbers, *angles, self.step, self.sides(axis))
            effort, own = self.schedule.call(axis.drive.followed(), *blocks)
            return effort, own
        effort = self.effort.part(axis.effort, 1) if axis.effort >= 0 else none
        feedback = self.feedback.part(2 * axis.effort, 2) if self.feedback and axis.effort >= 0 else self.way.none[2]
        angles = (*self._start(axis.motor), *self._start(axis.angle))
        blocks = (numbers, *angles, effort, feedback, self.step, self.sides(axis))
        effort, own, self.motor_terms[axis.angle] = self.schedule.call(axis.drive.forward(), *blocks)
        return effort, own

    def couple_motors(self) -> None:
        """Rows of the motors whose gears are coupled."""
        self.coupled_loads = loads = self.way.coupled_loads(self.torques)
        for axis in self.parts.axes:
            if axis.motor in loads and axis.drive and axis.drive_numbers:
                effort = self.effort.part(axis.effort, 1)
                speed, numbers = self.way.motor(axis)[1], self.way.drive_numbers(axis)
                blocks = (numbers, speed, effort, loads[axis.motor], self.sides(axis))
                self.motor_terms[axis.angle] = self.schedule.call(axis.drive.coupled_motor(), *blocks)[0]

    def motor_accelerations(self, joints: dict[int, Slot]) -> dict[int, Slot]:
        """Accelerations of all motors by index, from those of the joints by index."""
        motors: dict[int, Slot] = dict(self.followed)
        for axis in self.parts.axes:
            if axis.motor >= 0 and axis.motor not in self.followed and axis.drive:
                blocks = (self.motor_terms[axis.angle], joints[axis.angle])
                (motors[axis.motor],) = self.schedule.call(axis.drive.motor(), *blocks)
        return motors
