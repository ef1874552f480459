"""Where a schedule of an instant has each kind of output: the slots that the table of outputs names."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from tmodes.equations.line.schedule import moved_link
from tmodes.equations.loop.closed_loop import Powers, gear_torque
from tmodes.equations.loop.friction import contact_fold
from tmodes.equations.loop.instant import Instant
from tmodes.equations.recursion.forces import balance
from tmodes.equations.recursion.hinge import POSE
from tmodes.equations.recursion.link_kernels import times_kernel
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import BASE, Blocks, Passes
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, Numbers, Slot, kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Seen", "lines_of"]


class Seen:
    """The slot of each kind of output at one instant."""

    def __init__(self, instant: Instant, numbers: Numbers | None = None) -> None:
        """``numbers``: where those of stations along links are put; by default behind those of the loop."""
        self.instant, self.schedule, self.loop, self.parts = instant, instant.schedule, instant.loop, instant.parts
        self.layout, self.call, self.way = instant.loop.layout, instant.call, instant.way
        self.numbers = numbers or Numbers(instant.loop.parts.numbers.size)

    @cached_property
    def powers(self) -> Powers:
        """Powers by kind; what is reported of drives, gears and the contact."""
        return Powers(self.instant)

    @cached_property
    def coordinates(self) -> Blocks:
        """Coordinates, rates and the base, as the passes take them."""
        q, rates = (self.instant.pack(block.part(0, self.parts.size)) for block in (self.way.q, self.way.v))
        return Blocks(self.schedule, q, rates, self.way.base)

    @cached_property
    def gravity(self) -> Slot:
        """Gravity in the world."""
        moves = bool(self.instant.plan.base)
        return self.loop.base.part(12, 3) if moves else self.call(_pull(), self.way.base)[0]

    @cached_property
    def momenta(self) -> dict[str, list[Slot]]:
        """Momenta along the coordinates and of the base: forces of inertia at rest, of accelerations like the rates."""
        here = self.coordinates
        still = self.call(_still(self.parts.size), here.q)[0]
        base = self.call(_moved_base(), here.base)[0]
        mechanics = self.loop.mechanics
        way = mechanics.passes(Blocks(self.schedule, here.q, still, base), posed=True)
        return mechanics.inertia(way, here.v) | {"rates": [base.part(0, FORCE)]}

    @cached_property
    def energies(self) -> dict[str, Slot]:
        """Energies by kind; rotors and motors that follow their signals have theirs too."""
        found = self.momenta
        pairs = [(here, self.coordinates.v) for here in [self.instant.pack(*found["forces"])]]
        pairs += [(force, found["rates"][0]) for force in found.get("base_force", ())]
        kinetic = [self.call(_half(a.size), a, b)[0] for a, b in pairs]
        for inertia, place in self._rotors():
            kinetic.append(self.call(_rotor(), inertia, self.coordinates.v.part(place, 1))[0])
        mechanics = self.loop.mechanics
        elastic = mechanics.elastic(mechanics.passes(self.coordinates, posed=False))["energies"]
        elastic = [slot.part(k, 1) for slot in elastic for k in range(slot.size)]
        return {
            "kinetic": self.sum(kinetic), "gravity": self.call(_weight(), found["moment"][0], self.gravity)[0],
            "elastic_gear": self.sum(elastic[::2]), "elastic_link": self.sum(elastic[1::2]),
        }  # fmt: skip

    def _rotors(self) -> Iterator[tuple[Slot, int]]:
        """Inertia of each motor, and the index of the coordinate that it turns."""
        given = {driver.part.angle: driver.kind_numbers for driver in self.loop.drivers if driver.part.given >= 0}
        for axis in self.parts.axes:
            numbers = axis.drive_numbers if axis.effort >= 0 else given.get(axis.angle)
            if axis.node.joint.motor and numbers:
                yield numbers.part(0, 1), axis.input if axis.effort >= 0 else axis.angle

    def sum(self, slots: Sequence[Slot]) -> Slot:
        """Sum of single numbers."""
        none = self.parts.none[1]
        return self.powers.added(*[slot for slot in slots if slot != none] or [none])

    @cached_property
    def line_pass(self) -> tuple[Passes, Any]:
        """An outward pass with all forces on points, and the balance of forces under the accelerations."""
        way = Passes(self.parts, posed=True, loaded=True, blocks=self.coordinates)
        way.wrenches = dict(self.instant.dead)
        if touch := self.instant.plan.touch:
            before = way.wrenches.get(touch.point, self.parts.none[FORCE])
            (way.wrenches[touch.point],) = self.call(_pushed(), before, self.touched.part(0, 3))
        return way, balance(way, self.instant.pack(*self.instant.accelerations))

    @cached_property
    def touched(self) -> Slot:
        """What is reported of the contact; of the equations of rest before the accelerations are known."""
        touch, none = self.instant.plan.touch, self.parts.none
        if not (self.instant.plan.at_rest and touch and self.loop.touch):
            return self.powers.contact
        still = self.instant.pack(self.call(_upheld(), self.gravity)[0], none[3])
        blocks = (self.way.pose(touch.point)[0], still, self.loop.touch, self.instant.mode, none[3])
        return self.call(touch.touch.info(), *blocks)[0]

    @cached_property
    def lines(self) -> dict[tuple[int, int, float], Slot]:
        """Places of lines that were asked for."""
        return {}

    def state(self, column: int, size: int = 1) -> Slot:
        """Numbers of the state."""
        return self.instant.state.part(column, size)

    def moved(self, kind: str, k: int, size: int = 1) -> Slot:
        """Coordinates (``q``) or rates (``v``)."""
        return getattr(self.way, kind).part(k, size)

    def acceleration(self, k: int) -> Slot:
        """An acceleration of a coordinate."""
        for block in self.instant.accelerations:
            if k < block.size:
                return block.part(k, 1)
            k -= block.size
        raise IndexError(k)

    def drive(self, drive: int, column: int) -> Slot:
        """Effort, voltage, current and setpoint of a drive."""
        return self.powers.info[drive].part(column, 1)

    def wire(self, name: str) -> Slot:
        """A signal of a block."""
        return self.instant.wire(name)

    def gear(self, drive: int) -> Slot:
        """Torque of a gear."""
        return self.powers.gear[drive]

    def wound(self, drive: int) -> Slot | None:
        """The same of the equations of rest, before the accelerations are known; None of gears that are coupled."""
        driver = self.loop.drivers[drive]
        if driver.part.motor in self.way.coupled_inputs():
            return None
        return gear_torque(self.instant, driver) if driver.part.motor >= 0 else self.parts.none[1]

    def control(self, column: int) -> Slot:
        """An own state of a controller."""
        own = [self.instant.own[k] for k in sorted(self.instant.own) if self.instant.own[k].size]
        return self.instant.pack(*own).part(column, 1)

    def pose(self, point: int, column: int, size: int = 1) -> Slot:
        """Rotation (9), position (3) and velocity (3) of a point, then its rate (3)."""
        found = self.way.pose(point)
        return found[0].part(column, size) if column < POSE else found[1].part(column - POSE, size)

    def speed(self, point: int) -> Slot:
        """Speed of a point."""
        return self.call(_length(), self.pose(point, 12, 3))[0]

    def angle(self, point: int, k: int) -> Slot:
        """Roll, pitch or yaw of a point."""
        return self.call(_angles(), self.pose(point, 0, 9))[0].part(k, 1)

    def gain(self, point: int, k: int) -> Slot:
        """Acceleration of a point in the world."""
        motion = self.instant.solution.point(point)[2]
        return self.call(_added(), motion.part(0, 3), self.gravity)[0].part(k, 1)

    def upheld(self, point: int, k: int) -> Slot:
        """Acceleration of a point less gravity, along its own axes, where nothing moves."""
        return self.call(_turned_back(), self.pose(point, 0, 9), self.call(_upheld(), self.gravity)[0])[0].part(k, 1)

    def proper(self, point: int, k: int) -> Slot:
        """Acceleration of a point less gravity, along its own axes."""
        motion = self.instant.solution.point(point)[2]
        return self.call(_turned_back(), self.pose(point, 0, 9), motion.part(0, 3))[0].part(k, 1)

    def body_rate(self, point: int, k: int) -> Slot:
        """Angular velocity of a point about its own axes."""
        return self.call(_turned_back(), self.pose(point, 0, 9), self.pose(point, POSE, 3))[0].part(k, 1)

    def contact(self, column: int) -> Slot:
        """What is reported of the contact."""
        return self.touched.part(column, 1)

    def fold(self) -> Slot:
        """See :func:`tmodes.equations.loop.friction.contact_fold`."""
        return contact_fold(self.instant.solution, self.instant.begin)

    def bent(self, angle: int) -> Slot:
        """Output of a gear less its input; of a joint on its spring alone how far it is from where that is relaxed."""
        axis = next(axis for axis in self.parts.axes if axis.angle == angle)
        coupled, rest = self.way.coupled_inputs(), axis.drive_numbers
        if axis.motor >= 0:
            given = coupled[axis.motor][0] if axis.motor in coupled else self.moved("q", axis.motor)
        else:
            assert rest is not None  # noqa: S101
            place = 1 if axis.axis.drive.has_gear else rest.size - 2  # the joint's, else its spring's
            given = rest.part(place, 1)
        return self.call(_difference(), self.moved("q", angle), given)[0]

    def apart(self, first: int) -> Slot:
        """Distance of the tip from a place that is given."""
        return self.call(_length(), self.step(first))[0]

    def step(self, first: int, k: int = 0, size: int = 3) -> Slot:
        """The same as a vector, or a component of it."""
        given = self.instant.given.part(first, 3)
        return self.call(_difference(3), self.pose(0, 9, 3), given)[0].part(k, size)

    def energy(self, *kinds: str) -> Slot:
        """Sum of energies."""
        return self.sum([self.energies[kind] for kind in kinds])

    def power(self, k: int) -> Slot:
        """Power of a kind of work."""
        return self.powers.works[k]

    def on_base(self, k: int) -> Slot:
        """Force and moment by the robot on its base, in the world, about the base's origin."""
        inertia, bias = self.instant.solution.at_base()
        (force,) = self.call(times_kernel(), inertia, self.way.base.part(0, FORCE), bias)
        return self.call(_base_load(), force, self.way.base.part(FORCE + 3, POSE))[0].part(k, 1)

    def base(self, k: int) -> Slot:
        """The base's row."""
        return self.way.base.part(k, 1)

    def along(self, node: int, number: int, s: float, column: int) -> Slot:
        """A number of the line of a link at a station."""
        if (node, number, s) not in self.lines:
            line = lines_of(self.parts, node, s)[number]
            (place,) = line.places(moved_link(*self.line_pass, self.numbers, node))
            self.lines[node, number, s] = place
        return self.lines[node, number, s].part(column, 1)


def lines_of(parts: Parts, node: int, s: float) -> Any:
    """The lines of the link of a node, with one place ``s`` each; none of a rigid one."""
    part = parts.nodes[node]
    stations = tuple(station for station, _ in part.link.stations) if part.link else ()
    return part.node.link.lines(stations, np.array([s])) if part.link else ()


@kernel("length", (3,), (1,))
def _length(a: Any) -> list[list[Any]]:
    """Vector -> its length, whose slope is none where it is zero."""
    square = v.dot(v.vec(a), v.vec(a))
    return [[f.if_else(square > 0, f.sqrt(f.if_else(square > 0, square, 1.0)), 0.0)]]


def _difference(size: int = 1) -> Kernel:
    """(a, b) -> a - b."""

    def build(a: Any, b: Any) -> list[list[Any]]:
        return [[a[i] - b[i] for i in range(size)]]

    return Kernel(f"less {size}", (size, size), (size,), build)


@kernel("added vectors", (3, 3), (3,))
def _added(a: Any, b: Any) -> list[list[Any]]:
    return [v.add(v.vec(a), v.vec(b))]


@kernel("upheld", (3,), (3,))
def _upheld(gravity: Any) -> list[list[Any]]:
    """Gravity -> acceleration less gravity of what is at rest."""
    return [v.scale(-1.0, v.vec(gravity))]


@kernel("turned back", (9, 3), (3,))
def _turned_back(r: Any, a: Any) -> list[list[Any]]:
    """R^T a."""
    return [v.matvec(v.transpose(v.tri(r)), v.vec(a))]


@kernel("roll pitch yaw", (9,), (3,))
def _angles(r: Any) -> list[list[Any]]:
    """Rotation Rz(yaw) Ry(pitch) Rx(roll) -> the angles."""
    return [[f.atan2(r[7], r[8]), f.atan2(-r[6], f.sqrt(r[7] * r[7] + r[8] * r[8])), f.atan2(r[3], r[0])]]


@kernel("pull of a resting base", (BASE,), (3,))
def _pull(base: Any) -> list[list[Any]]:
    """Row of a base at rest -> gravity in the world."""
    return [v.scale(-1.0, v.matvec(v.tri(base, FORCE + 3), v.vec(base, 3)))]


@kernel("base for momenta", (BASE,), (BASE,))
def _moved_base(base: Any) -> list[list[Any]]:
    """Row of a base -> one at rest that accelerates by its rate and velocity."""
    world = v.tri(base, FORCE + 3)
    linear = v.matvec(v.transpose(world), v.vec(base, FORCE + 3 + 12))
    still = v.zero()
    return [v.flat(v.vec(base, FORCE), linear, still, world, v.vec(base, FORCE + 3 + 9), still)]


@kernel("rotor energy", (1, 1), (1,))
def _rotor(inertia: Any, speed: Any) -> list[list[Any]]:
    return [[inertia[0] * speed[0] * speed[0] / 2]]


@kernel("weight energy", (3, 3), (1,))
def _weight(moment: Any, gravity: Any) -> list[list[Any]]:
    return [[-v.dot(v.vec(moment), v.vec(gravity))]]


@kernel("pushed back", (FORCE, 3), (FORCE,))
def _pushed(wrench: Any, force: Any) -> list[list[Any]]:
    """(wrench on a point, force by it on a surface) -> wrench on it with the reaction."""
    return [[*(wrench[i] - force[i] for i in range(3)), *(wrench[i] for i in range(3, FORCE))]]


@kernel("load on base", (FORCE, POSE), (FORCE,))
def _base_load(force: Any, pose: Any) -> list[list[Any]]:
    """(moment and force by the base in its axes, its pose) -> force and moment on it in the world."""
    world = v.tri(pose)
    return [v.flat(*(v.scale(-1.0, v.matvec(world, v.vec(force, start))) for start in (3, 0)))]


def _still(size: int) -> Kernel:
    """Coordinates -> rates of zero."""
    return Kernel(f"still {size}", (size,), (size,), lambda q: [[0.0 * q[i] for i in range(size)]])


def _half(size: int) -> Kernel:
    """(momenta, rates) -> half of their product."""

    def build(a: Any, b: Any) -> list[list[Any]]:
        return [[v.total([a[i] * b[i] for i in range(size)]) / 2]]

    return Kernel(f"half product {size}", (size, size), (1,), build)
