"""One instant of a whole arm in a run as one schedule: signals, controllers, motors, chain, loads, contact, works.

Inputs ``time`` (1), ``state``, ``row``, and ``step`` h (1). The output ``rate`` is the derivative of the state; with
h > 0 its accelerations are those of a linearly implicit Euler step of h.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from tmodes.chain import Drive
from tmodes.equations.arm import vectors as v
from tmodes.equations.arm.body_kernels import point_kernel, times_kernel
from tmodes.equations.arm.closed_loop_plan import WORKS, DrivePlan, LoopPlan, StateLayout
from tmodes.equations.arm.contact_kernels import CONTACT_TOLD, load_kernel, power_kernel
from tmodes.equations.arm.control_kernels import needed_kernel
from tmodes.equations.arm.drive_kernels import DriveKind, drive_kind, drive_numbers
from tmodes.equations.arm.forward import Recursion
from tmodes.equations.arm.kernel import Kernel
from tmodes.equations.arm.parts import NodePart, Parts
from tmodes.equations.arm.passes import Blocks, Passes
from tmodes.equations.arm.schedule import Schedule, Slot
from tmodes.equations.arm.signals_kernels import base_kernel, packing_kernel, replacing_kernel, signal_kernel
from tmodes.equations.arm.spatial import FORCE

__all__ = ["ClosedLoop"]


@dataclass(frozen=True)
class _Driver:
    """A drive of the plan at its node: the numbers and kernels that its motion needs."""

    plan: DrivePlan
    part: NodePart
    index: int
    numbers: Slot
    kind: DriveKind
    kind_numbers: Slot
    current: int

    @property
    def coordinate(self) -> int:
        """Index of the coordinate that its motor turns."""
        return self.part.motor if self.part.motor >= 0 else self.part.angle


@dataclass(eq=False)
class ClosedLoop:
    """The schedules of a plan, and its numbers; every schedule reads the same parameters."""

    plan: LoopPlan
    parts: Parts = field(init=False)
    drivers: tuple[_Driver, ...] = field(init=False)

    def __post_init__(self) -> None:
        plan, chain = self.plan, self.plan.chain
        self.parts = Parts(chain)
        numbers = self.parts.numbers
        self.drivers = tuple(self._driver(drive) for drive in plan.drives)
        self.loads = [numbers.block(load.wrench) for load in plan.loads]
        self.always = numbers.block([1.0, 0.0, 0.0])
        self.touch = numbers.block(plan.touch.numbers) if plan.touch else None
        placed, gravity = chain.base, np.asarray(chain.gravity, dtype=float)
        place = [*placed.rotation.ravel(), *placed.position]
        pull = placed.rotation.T @ gravity
        still = [0.0, 0.0, 0.0, *(-pull), 0.0, 0.0, 0.0, *place, 0.0, 0.0, 0.0]
        self.base = numbers.block([*place, *gravity] if plan.base else still)

    def _driver(self, plan: DrivePlan) -> _Driver:
        names = [part.node.joint.name for part in self.parts.nodes]
        index = names.index(plan.joint)
        part = self.parts.nodes[index]
        kind, slot = part.drive, part.drive_numbers
        if kind is None or slot is None:
            free = replace(part.node.joint, drive=Drive.EFFORT)
            kind, slot = drive_kind(free), self.parts.numbers.block(drive_numbers(free))
        currents = self.plan.currents
        current = currents.index(plan.joint) if plan.joint in currents else -1
        return _Driver(plan, part, index, self.parts.numbers.block(plan.numbers), kind, slot, current)

    @property
    def layout(self) -> StateLayout:
        """Where the state holds what."""
        return StateLayout.of(self.parts.size, len(self.plan.currents))

    @cached_property
    def rate(self) -> Schedule:
        """(time, state, row, step) -> derivative of the state."""
        return _Instant(self).rate()

    @cached_property
    def observe(self) -> Schedule:
        """(time, state, row, step) -> what is shown of an instant."""
        return _Instant(self).observe()


class _Instant:
    """The calls of one schedule, in the order in which one thing follows from another."""

    def __init__(self, loop: ClosedLoop) -> None:
        self.loop, self.plan, self.parts = loop, loop.plan, loop.parts
        self.none = loop.parts.none
        self.schedule = Schedule(loop.parts.numbers.size)
        self.time = self.schedule.input("time", 1)
        self.state = self.schedule.input("state", loop.layout.size)
        self.row = self.schedule.input("row", loop.plan.row_size)
        self.step = self.schedule.input("step", 1)
        self.signals = [self._signal(k) for k in range(loop.plan.signals)]
        self.way = self._outwards()
        self.powers: dict[str, list[Slot]] = {name: [] for name in WORKS}
        self.told: dict[int, Slot] = {}
        self.gear: dict[int, Slot] = {}
        self.change: dict[int, Slot] = {}
        self._push()
        self.recursion = self._drive()
        self.accelerations = self.recursion.run()
        self._need()
        self._lose()
        self.contact = self._power_of_loads()
        self._power_of_base()

    def _call(self, kernel: Kernel, *blocks: Slot) -> tuple[Slot, ...]:
        return self.schedule.call(kernel, *blocks)

    def _pack(self, *blocks: Slot) -> Slot:
        """Blocks that must stand side by side."""
        if not blocks:
            return self.none[1].part(0, 0)
        return self._call(packing_kernel(tuple(block.size for block in blocks)), *blocks)[0]

    def _signal(self, k: int) -> Slot:
        count = self.plan.degree + 1
        block = self.row.part(1 + k * count, count)
        return self._call(signal_kernel(self.plan.degree), self.time, self.row.part(0, 1), block)[0]

    def _outwards(self) -> Passes:
        n, layout = self.parts.size, self.loop.layout
        q, rates = self.state.part(layout.q.start, n), self.state.part(layout.v.start, n)
        exact = [driver for driver in self.loop.drivers if driver.plan.servo is None]
        if exact:
            places = tuple(driver.coordinate for driver in exact)
            moved = [self.signals[driver.plan.signal] for driver in exact]
            q, rates = self._call(replacing_kernel(n, places), q, rates, *moved)
        base = self.loop.base
        if self.plan.base:
            base = self._call(base_kernel(), base, *(self.signals[k] for k in self.plan.base))[0]
        posed = bool(self.plan.loads or self.plan.touch)
        way = Passes(self.parts, posed=posed, loaded=False, blocks=Blocks(self.schedule, q, rates, base))
        way.outwards()
        return way

    def _frame(self, point: int) -> tuple[Slot, Slot, Slot]:
        """Pose of the frame that a point is fixed to, pose of its link's axes, and its rate in them."""
        told = self.parts.points[point]
        way, station = self.way.ways[told.node], self.parts.station(told)
        assert way.root_pose and way.tip_pose  # noqa: S101
        if station is None:
            return way.tip_pose, way.root_pose, way.tip_rate
        return way.section_poses[station], way.root_pose, way.sections[station].part(12, 3)

    def _push(self) -> None:
        """Loads and contact, as wrenches on points, and the contact's mass."""
        wrenches = self.way.wrenches
        for load, numbers in zip(self.plan.loads, self.loop.loads, strict=True):
            signal = self.signals[load.signal] if load.signal >= 0 else self.loop.always
            pose, before = self._frame(load.point)[0], wrenches.get(load.point, self.none[FORCE])
            blocks = (pose, self.parts.offsets[load.point], numbers, signal, before)
            (wrenches[load.point],) = self._call(load_kernel(follower=load.follower), *blocks)
        self.dead = dict(wrenches)
        touch = self.plan.touch
        if touch and self.loop.touch:
            blocks = (*self._frame(touch.point), self.parts.offsets[touch.point], self.loop.touch)
            before = wrenches.get(touch.point, self.none[FORCE])
            (wrenches[touch.point],) = self._call(touch.touch.wrench(), *blocks, before)
            if touch.has_mass:
                node = self.parts.points[touch.point].node
                self.way.attached[node] = self._call(touch.touch.inertia(), *blocks)  # type: ignore[assignment]

    def _drive(self) -> Recursion:
        """Efforts of the servos, and the motions that are given."""
        efforts: dict[str, Slot] = {}
        feedback: dict[str, Slot] = {}
        given: dict[str, Slot] = {}
        followed: dict[int, Slot] = {}
        for k, driver in enumerate(self.loop.drivers):
            plan, signal = driver.plan, self.signals[driver.plan.signal]
            if plan.servo is None:
                if driver.part.motor >= 0:
                    followed[driver.part.motor] = signal.part(2, 1)
                else:
                    given[plan.joint] = signal.part(2, 1)
                continue
            place = driver.coordinate
            angle, speed = self.way.q.part(place, 1), self.way.v.part(place, 1)
            blocks = (driver.numbers, signal, angle, speed, self._current(driver), self.step)
            found = self._call(plan.servo.kernel(), *blocks)
            efforts[plan.joint], feedback[plan.joint], change, self.told[k] = found
            if driver.current >= 0:
                self.change[driver.current] = change
            self.powers["motor"].append(self._product(efforts[plan.joint], speed))
        parts, none = self.parts, self.none
        effort = self._pack(*(efforts.get(name, none[1]) for name in parts.efforts))
        swing = self._pack(*(feedback.get(name, none[2]) for name in parts.efforts))
        recursion = Recursion(
            self.way, effort, self._pack(*(given[name] for name in parts.given)), self.step, feedback=swing
        )
        recursion.followed = followed
        return recursion

    def _current(self, driver: _Driver) -> Slot:
        if driver.current < 0:
            return self.none[1]
        return self.state.part(self.loop.layout.currents.start + driver.current, 1)

    def _product(self, a: Slot, b: Slot) -> Slot:
        return self._call(Kernel("product", (1, 1), (1,), lambda x, y: [[x[0] * y[0]]]), a, b)[0]

    def _added(self, *blocks: Slot) -> Slot:
        """Sum of single numbers."""
        if len(blocks) == 1:
            return blocks[0]

        def build(*values: Any) -> list[list[Any]]:
            return [[v.total([value[0] for value in values])]]

        return self._call(Kernel(f"added {len(blocks)}", (1,) * len(blocks), (1,), build), *blocks)[0]

    def _need(self) -> None:
        """What the motors that follow their signals exactly must do."""
        inputs = self.way.coupled_inputs()
        torques: dict[int, Slot] = {}
        for k, driver in enumerate(self.loop.drivers):
            load, gear = self._losses_of(driver, inputs)
            if gear:
                torques[driver.part.motor] = gear
            self.gear[k] = gear or self.none[1]
            if driver.plan.servo is None and driver.part.motor not in inputs:
                self._needed(k, driver, load)
        loads = self.way.coupled_loads(torques)
        for k, driver in enumerate(self.loop.drivers):
            if driver.plan.servo is None and driver.part.motor in loads:
                speed, motor = self.way.motor(driver.part)[1], driver.part.motor
                held = self._call(driver.kind.coupled_motor(), driver.kind_numbers, speed, self.none[1], loads[motor])
                self._needed(k, driver, held[1])

    def _losses_of(self, driver: _Driver, inputs: dict[int, tuple[Slot, Slot]]) -> tuple[Slot, Slot | None]:
        """Load on the motor but for its inertia, and the gear's torque; the losses go to the powers."""
        part, none = driver.part, self.none[1]
        if part.motor in inputs:
            blocks = (driver.kind_numbers, *inputs[part.motor], *self.way.angle(part))
            lost = self._call(driver.kind.coupled_elastic(), *blocks)[2]
            torque = self._call(driver.kind.coupled(), *blocks)[1]
            own = self._call(driver.kind.coupled_motor(), driver.kind_numbers, self.way.motor(part)[1], none, none)[2]
            self.powers["friction"] += [lost.part(1, 1), own]
            self.powers["gear_damping"].append(lost.part(0, 1))
            return none, torque
        blocks = (driver.kind_numbers, *self.way.motor(part), *self.way.angle(part))
        forces, _, lost = self._call(driver.kind.elastic(), *blocks)
        self.powers["friction"].append(lost.part(1, 1))
        if part.motor >= 0:
            self.powers["gear_damping"].append(lost.part(0, 1))
            return forces.part(1, 1), self._gear_torque(driver, forces)
        if part.given < 0:
            return forces.part(0, 1), None
        root, hung = self.recursion.roots[driver.index], self.recursion.hung[driver.index]
        (force,) = self._call(times_kernel(), hung[0], root, hung[1])
        hinge, axis = self.way.ways[driver.index].hinge, part.axis
        along = self._call(part.hinge.load(), force, hinge, axis, self.none[FORCE])[1]
        return self._added(forces.part(0, 1), along), None

    def _gear_torque(self, driver: _Driver, forces: Slot) -> Slot:
        """The torque in an elastic gear: the force on the motor less the motor's friction."""
        motor = self._call(
            driver.kind.coupled_motor(), driver.kind_numbers, self.way.motor(driver.part)[1], self.none[1], self.none[1]
        )[1]
        less = Kernel("difference", (1, 1), (1,), lambda x, y: [[x[0] - y[0]]])
        return self._call(less, forces.part(1, 1), motor)[0]

    def _needed(self, k: int, driver: _Driver, load: Slot) -> None:
        signal, inertia = self.signals[driver.plan.signal], driver.kind_numbers.part(0, 1)
        found = self._call(needed_kernel(driver.plan.winding), driver.numbers, inertia, signal, load)
        self.told[k] = found[1]
        self.powers["motor"].append(self._product(found[0], signal.part(1, 1)))

    def _lose(self) -> None:
        """Losses of what no drive of the plan moves: locked springs, and the links."""
        driven = {driver.index for driver in self.loop.drivers}
        for index, part in enumerate(self.parts.nodes):
            if part.drive and part.drive_numbers and index not in driven:
                blocks = (part.drive_numbers, *self.way.motor(part), *self.way.angle(part))
                lost = self._call(part.drive.elastic(), *blocks)[2]
                self.powers["gear_damping"].append(lost.part(0, 1))
                self.powers["friction"].append(lost.part(1, 1))
            if part.link:
                link = part.link
                blocks = (
                    link.stiffness,
                    link.damping,
                    self.way.bend(link, self.way.q),
                    self.way.bend(link, self.way.v),
                )
                self.powers["link_damping"].append(self._call(link.kernels.elastic(), *blocks)[2])

    def _point(self, k: int) -> tuple[Slot, ...]:
        """Pose, rate and acceleration (less gravity) of a point in the world."""
        point = self.parts.points[k]
        way, number, link = self.way.ways[point.node], self.parts.station(point), self.parts.nodes[point.node].link
        pose, section, motion = way.tip_pose, way.tip, self.recursion.tips[point.node]
        if number is not None and link:
            pose, section = way.section_poses[number], way.sections[number]
            own = self._pack(*self.accelerations).part(link.first, link.kernels.n)
            (motion,) = self._call(link.kernels.motion(), self.recursion.roots[point.node], section, own)
        assert pose is not None  # noqa: S101
        rate = section.part(12, 3) if section else way.tip_rate
        kernel = point_kernel(on_section=section is not None)
        return self._call(kernel, pose, self.way.frame(section), rate, motion, self.parts.offsets[k])

    def _power_of_loads(self) -> Slot:
        """Powers of loads and contact; what is told of the contact."""
        for k, wrench in self.dead.items():
            pose, rate, _ = self._point(k)
            self.powers["loads"] += self._call(power_kernel(), wrench, pose, rate)
        touch = self.plan.touch
        if not (touch and self.loop.touch):
            return self._pack(*(self.none[1],) * CONTACT_TOLD)
        pose, _, motion = self._point(touch.point)
        told, power = self._call(touch.touch.told(), pose, motion, self.loop.touch)
        self.powers["contact"].append(power)
        return told

    def _power_of_base(self) -> None:
        """Power of what moves the base."""
        if not self.plan.base:
            return
        inertia, bias = self.recursion.at_base
        (force,) = self._call(times_kernel(), inertia, self.way.base.part(0, FORCE), bias)

        def build(push: Any, rate: Any, pose: Any) -> list[list[Any]]:
            velocity = v.matvec(v.transpose(v.tri(pose)), v.vec(pose, 12))
            return [[v.dot(v.vec(push), v.vec(rate)) + v.dot(v.vec(push, 3), velocity)]]

        kernel = Kernel("power of base", (FORCE, 3, 15), (1,), build)
        self.powers["base"] += self._call(
            kernel, force, self.way.base.part(FORCE, 3), self.way.base.part(FORCE + 3, 15)
        )

    def _works(self) -> list[Slot]:
        return [self._added(*blocks) if blocks else self.none[1] for blocks in self.powers.values()]

    def rate(self) -> Schedule:
        """The derivative of the state."""
        currents = [self.change[k] for k in sorted(self.change)]
        self.schedule.output("rate", self.way.v, *self.accelerations, *currents, *self._works())
        return self.schedule

    def observe(self) -> Schedule:
        """What is shown: q, v, a, drives (4 each), gear torques, contact (6), the base's row, powers."""
        drives = range(len(self.loop.drivers))
        self.schedule.output("q", self.way.q)
        self.schedule.output("v", self.way.v)
        self.schedule.output("a", *self.accelerations)
        self.schedule.output("drives", *(self.told[k] for k in drives))
        self.schedule.output("gear", *(self.gear[k] for k in drives))
        self.schedule.output("contact", self.contact)
        self.schedule.output("base", self.way.base)
        self.schedule.output("powers", *self._works())
        return self.schedule
