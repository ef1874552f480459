"""The passes over a chain as schedules of kernels: forward dynamics, forces of inertia, forces of elasticity.

Forward dynamics is one articulated-body recursion: rates outwards, inertias inwards, accelerations outwards.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from tmodes.equations.arm.drive_kernels import mixing_kernel
from tmodes.equations.arm.hinge import HELD, POSE
from tmodes.equations.arm.link_kernels import body_kernel, point_kernel, push_kernel
from tmodes.equations.arm.parts import LinkPart, NodePart, Parts
from tmodes.equations.arm.schedule import Schedule, Slot
from tmodes.equations.arm.spatial import FORCE

__all__ = ["BASE", "Passes", "elastic_forces", "forward_dynamics", "inertia_forces"]

BASE = 2 * FORCE - 3 + POSE
"""Numbers of the base: acceleration less gravity (6) and rate (3) in its own axes, pose in the world (15)."""


@dataclass
class _Way:
    """What the outward pass found of a node."""

    hinge: Slot
    root_rate: Slot
    tip_rate: Slot
    root_pose: Slot | None = None
    tip_pose: Slot | None = None
    carried_pose: Slot | None = None
    terms: Slot | None = None
    tip: Slot | None = None
    sections: tuple[Slot, ...] = ()
    section_poses: list[Slot] = field(default_factory=list)


class Passes:
    """Blocks of one schedule by what they mean; each pass adds its calls."""

    def __init__(self, parts: Parts, *, posed: bool, loaded: bool) -> None:
        """``posed``: poses in the world are needed; ``loaded``: forces act on the points."""
        self.parts, self.posed, self.loaded = parts, posed or loaded, loaded
        self.schedule = Schedule(parts.numbers.size)
        self.q = self.schedule.input("q", parts.size)
        self.v = self.schedule.input("v", parts.size)
        self.base = self.schedule.input("base", BASE)
        self.ways: list[_Way] = []
        self.none = parts.none

    def take_wrenches(self) -> None:
        """The input of forces on the points (6 each, in world axes)."""
        if self.loaded:
            self.wrenches = self.schedule.input("wrenches", 6 * len(self.parts.points))

    def angle(self, part: NodePart) -> tuple[Slot, Slot]:
        """Coordinate and rate of a joint."""
        return self._pair(part.angle)

    def motor(self, part: NodePart) -> tuple[Slot, Slot]:
        """Angle and rate of a motor."""
        return self._pair(part.motor)

    def _pair(self, index: int) -> tuple[Slot, Slot]:
        return (self.none[1], self.none[1]) if index < 0 else (self.q.part(index, 1), self.v.part(index, 1))

    def bend(self, link: LinkPart, block: Slot) -> Slot:
        """The link's part of a block of all coordinates."""
        return block.part(link.first, link.kernels.n)

    def parent(self, part: NodePart) -> _Way | None:
        """What was found of the parent, None for the base."""
        return self.ways[part.node.parent] if part.node.parent >= 0 else None

    def outwards(self) -> None:
        """Rates, and poses where they are needed, from the base to the tips."""
        call = self.schedule.call
        for part in self.parts.nodes:
            parent = self.parent(part)
            rate = parent.tip_rate if parent else self.base.part(FORCE, 3)
            angle, speed = self.angle(part)
            tip = parent.tip.part(0, 9) if parent and parent.tip else self.none[9]
            hinge, root_rate = call(part.hinge.inward(), part.placement, tip, part.axis, rate, angle, speed)
            way = _Way(hinge, root_rate, root_rate)
            if self.posed:
                pose = parent.carried_pose if parent else self.base.part(FORCE + 3, POSE)
                assert pose is not None  # noqa: S101
                (way.root_pose,) = call(part.hinge.pose(), pose, rate, hinge, part.axis, speed)
                way.tip_pose = way.carried_pose = way.root_pose
            if part.link:
                self._bend_outwards(part.link, way)
            self.ways.append(way)

    def _bend_outwards(self, link: LinkPart, way: _Way) -> None:
        q, v = self.bend(link, self.q), self.bend(link, self.v)
        blocks = (link.tables, way.root_rate, q, v)
        way.terms, way.tip, *sections = self.schedule.call(link.kernels.inward(), *blocks)
        way.tip_rate, way.sections = way.tip.part(12, 3), tuple(sections)
        if way.root_pose:
            pose, root = link.kernels.pose(), (way.root_pose, way.root_rate)
            way.tip_pose, way.carried_pose = self.schedule.call(pose, *root, way.tip, v)
            way.section_poses = [self.schedule.call(pose, *root, section, v)[0] for section in way.sections]

    def load_of_tip(self, index: int) -> tuple[Slot, Slot]:
        """Inertia and bias force of what is fixed to a node's tip, less the forces on its points."""
        part, way = self.parts.nodes[index], self.ways[index]
        inertia, bias = self.none[21], self.none[FORCE]
        if part.tip_body:
            kernel = body_kernel(on_section=way.tip is not None)
            inertia, bias = self.schedule.call(kernel, part.tip_body, self.frame(way.tip), way.tip_rate)
        for k, point in enumerate(self.parts.points if self.loaded else ()):
            if point.node == index and self.parts.station(point) is None:
                bias = self._pushed(k, way, way.tip, bias)
        return inertia, bias

    def frame(self, section: Slot | None) -> Slot:
        """Rotation of a section in its link."""
        return section.part(0, 9) if section else self.none[9]

    def _pushed(self, k: int, way: _Way, section: Slot | None, bias: Slot) -> Slot:
        assert way.root_pose is not None  # noqa: S101
        arm, wrench = self.parts.offsets[k].part(9, 3), self.wrenches.part(6 * k, 6)
        kernel = push_kernel(on_section=section is not None)
        return self.schedule.call(kernel, way.root_pose, self.frame(section), arm, wrench, bias)[0]

    def terms_with_stations(self, index: int) -> Slot:
        """Inertia terms of a bending link with the bodies at its stations, less the forces on its points there."""
        part, way = self.parts.nodes[index], self.ways[index]
        link, terms = part.link, way.terms
        assert link and terms is not None  # noqa: S101
        for number, (section, (_, body)) in enumerate(zip(way.sections, link.stations, strict=True)):
            force = self.none[FORCE]
            for k, point in enumerate(self.parts.points if self.loaded else ()):
                if point.node == index and self.parts.station(point) == number:
                    force = self._pushed(k, way, section, force)
            if body or force is not self.none[FORCE]:
                (terms,) = self.schedule.call(link.kernels.station_load(), terms, section, body or self.none[10], force)
        return terms

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


def forward_dynamics(parts: Parts, *, loaded: bool = False) -> Schedule:
    """(q, v, base, wrenches, effort, given, step) -> accelerations of all coordinates.

    ``given`` are the accelerations of prescribed joints; ``step`` h > 0 gives those of a linearly implicit Euler step.
    """
    way = Passes(parts, posed=False, loaded=loaded)
    way.take_wrenches()
    schedule = way.schedule
    effort, given = schedule.input("effort", len(parts.efforts)), schedule.input("given", len(parts.given))
    step = schedule.input("step", 1)
    way.outwards()
    return _Recursion(way, effort, given, step).run()


class _Recursion:
    """The way in and the way out again of the articulated-body recursion."""

    def __init__(self, way: Passes, effort: Slot, given: Slot, step: Slot) -> None:
        self.way, self.effort, self.given, self.step = way, effort, given, step
        self.schedule, self.parts = way.schedule, way.parts
        self.loads: list[tuple[Slot, Slot]] = []
        self.held: dict[int, Slot] = {}
        self.solved: dict[int, Slot] = {}
        self.motor_terms: dict[int, Slot] = {}
        self.coupled = way.coupled_inputs()
        self.torques: dict[int, Slot] = {}

    def run(self) -> Schedule:
        self.loads = [self.way.load_of_tip(i) for i in range(len(self.parts.nodes))]
        for index in reversed(range(len(self.parts.nodes))):
            self._inwards(index)
        self._couple_motors()
        self._outwards()
        return self.schedule

    def _given(self, part: NodePart) -> Slot:
        return self.given.part(part.given, 1) if part.given >= 0 else self.way.none[1]

    def _inwards(self, index: int) -> None:
        part, way = self.parts.nodes[index], self.way.ways[index]
        inertia, bias = self.loads[index]
        if part.link and way.tip:
            link = part.link
            q, v = self.way.bend(link, self.way.q), self.way.bend(link, self.way.v)
            terms = self.way.terms_with_stations(index)
            blocks = (terms, way.tip, inertia, bias, link.stiffness, link.damping, q, v, self.step)
            inertia, bias, self.solved[index] = self.schedule.call(link.kernels.outward(), *blocks)
        effort, own = self._drive(index, part)
        parent = part.node.parent
        sums = self.loads[parent] if parent >= 0 else (self.way.none[21], self.way.none[FORCE])
        *more, self.held[index] = self.schedule.call(
            part.hinge.outward(), inertia, bias, way.hinge, part.axis, effort, own, *sums
        )
        if parent >= 0:
            self.loads[parent] = (more[0], more[1])

    def _drive(self, index: int, part: NodePart) -> tuple[Slot, Slot]:
        none = self.way.none[1]
        if part.drive is None or part.drive_numbers is None:
            return self._given(part), none
        if part.motor in self.coupled:
            blocks = (part.drive_numbers, *self.coupled[part.motor], *self.way.angle(part))
            effort, self.torques[part.motor] = self.schedule.call(part.drive.coupled(), *blocks)
            return effort, none
        effort = self.effort.part(part.effort, 1) if part.effort >= 0 else none
        blocks = (part.drive_numbers, *self.way.motor(part), *self.way.angle(part), effort, self.step)
        effort, own, self.motor_terms[index] = self.schedule.call(part.drive.forward(), *blocks)
        return effort, own

    def _couple_motors(self) -> None:
        loads = self.way.coupled_loads(self.torques)
        for index, part in enumerate(self.parts.nodes):
            if part.motor in loads and part.drive and part.drive_numbers:
                effort = self.effort.part(part.effort, 1)
                blocks = (part.drive_numbers, self.way.motor(part)[1], effort, loads[part.motor])
                self.motor_terms[index] = self.schedule.call(part.drive.coupled_motor(), *blocks)[0]

    def _outwards(self) -> None:
        tips: list[Slot] = []
        motors: dict[int, Slot] = {}
        joints: dict[int, Slot] = {}
        links: dict[int, Slot] = {}
        for index, (part, way) in enumerate(zip(self.parts.nodes, self.way.ways, strict=True)):
            parent = part.node.parent
            before = tips[parent] if parent >= 0 else self.way.base.part(0, FORCE)
            blocks = (before, way.hinge, part.axis, self.held[index], self._given(part))
            root, joint = self.schedule.call(part.hinge.onward(), *blocks)
            if part.angle >= 0:
                joints[part.angle] = joint
            if part.motor >= 0 and part.drive:
                (motors[part.motor],) = self.schedule.call(part.drive.motor(), self.motor_terms[index], joint)
            if part.link and way.tip:
                found = self.schedule.call(part.link.kernels.onward(), root, self.solved[index], way.tip)
                links[part.link.first], root = found
            tips.append(root)
        self.schedule.output("a", *self.way.by_coordinate(motors, joints, links))


def inertia_forces(parts: Parts, *, loaded: bool = False) -> Schedule:
    """(q, v, base, wrenches, a) -> forces of inertia and gravity along the coordinates, less the wrenches.

    Further outputs: ``base_force`` (6: moment, force, in base axes), ``points`` (pose 15, rate 3, acceleration 6 each),
    ``moment`` (3: sum of mass times position). Rotors are left out: they are a diagonal of numbers.
    """
    way = Passes(parts, posed=True, loaded=loaded)
    way.take_wrenches()
    schedule = way.schedule
    a = schedule.input("a", parts.size)
    way.outwards()
    roots, tips = _accelerations(way, a)
    _points(way, a, roots, tips)
    _moment(way)
    loads: list[Slot] = []
    for index, tip in enumerate(tips):
        inertia, bias = way.load_of_tip(index)
        loads.append(schedule.call(_times_kernel(), inertia, tip, bias)[0])
    joints: dict[int, Slot] = {}
    links: dict[int, Slot] = {}
    at_base = way.none[FORCE]
    for index in reversed(range(len(parts.nodes))):
        part, found = parts.nodes[index], way.ways[index]
        force = loads[index]
        if part.link and found.tip:
            terms = way.terms_with_stations(index)
            blocks = (terms, found.tip, roots[index], way.bend(part.link, a), force)
            force, links[part.link.first] = schedule.call(part.link.kernels.load(), *blocks)
        parent = part.node.parent
        total = loads[parent] if parent >= 0 else at_base
        total, along = schedule.call(part.hinge.load(), force, found.hinge, part.axis, total)
        if part.angle >= 0:
            joints[part.angle] = along
        if parent >= 0:
            loads[parent] = total
        else:
            at_base = total
    schedule.output("forces", *way.by_coordinate({}, joints, links))
    schedule.output("base_force", at_base)
    return schedule


def _times_kernel() -> Any:
    from tmodes.equations.arm.kernel import Kernel
    from tmodes.equations.arm.spatial import INERTIA, Force, Inertia

    def build(inertia: Any, motion: Any, bias: Any) -> list[list[Any]]:
        return [(Inertia.of(inertia).times(Force.of(motion)) + Force.of(bias)).packed()]

    return Kernel("times", (INERTIA, FORCE, FORCE), (FORCE,), build)


def _accelerations(way: Passes, a: Slot) -> tuple[list[Slot], list[Slot]]:
    """Accelerations of the roots and of the tips when all coordinates accelerate as given."""
    roots: list[Slot] = []
    tips: list[Slot] = []
    held = way.parts.none[HELD]
    for part, found in zip(way.parts.nodes, way.ways, strict=True):
        before = tips[part.node.parent] if part.node.parent >= 0 else way.base.part(0, FORCE)
        given = a.part(part.angle, 1) if part.angle >= 0 else way.none[1]
        root, _ = way.schedule.call(part.hinge.as_driven().onward(), before, found.hinge, part.axis, held, given)
        roots.append(root)
        if part.link and found.tip:
            (root,) = way.schedule.call(part.link.kernels.motion(), root, found.tip, way.bend(part.link, a))
        tips.append(root)
    return roots, tips


def _points(way: Passes, a: Slot, roots: list[Slot], tips: list[Slot]) -> None:
    """Pose, rate and acceleration of each named point."""
    told: list[Slot] = []
    for point, offset in zip(way.parts.points, way.parts.offsets, strict=True):
        found, link = way.ways[point.node], way.parts.nodes[point.node].link
        number = way.parts.station(point)
        pose, section, motion = found.tip_pose, found.tip, tips[point.node]
        if number is not None and link:
            pose, section = found.section_poses[number], found.sections[number]
            (motion,) = way.schedule.call(link.kernels.motion(), roots[point.node], section, way.bend(link, a))
        assert pose is not None  # noqa: S101
        rate = section.part(12, 3) if section else found.tip_rate
        kernel = point_kernel(on_section=section is not None)
        told += way.schedule.call(kernel, pose, way.frame(section), rate, motion, offset)
    way.schedule.output("points", *told)


def _moment(way: Passes) -> None:
    """Sum of mass times position, for the potential of gravity."""
    total = way.none[3]
    for part, found in zip(way.parts.nodes, way.ways, strict=True):
        if part.link and part.link.kernels.kind.own_terms and found.root_pose:
            terms = found.terms
            for section, (_, body) in zip(found.sections, part.link.stations, strict=True):
                if body:
                    blocks = (terms, section, body, way.none[FORCE])
                    (terms,) = way.schedule.call(part.link.kernels.station_load(), *blocks)
            (total,) = way.schedule.call(part.link.kernels.moment(), terms, found.root_pose, total)
        if part.tip_body and found.tip_pose:
            (total,) = way.schedule.call(_body_moment(), part.tip_body, found.tip_pose, total)
    way.schedule.output("moment", total)


def _body_moment() -> Any:
    from tmodes.equations.arm import vectors as v
    from tmodes.equations.arm.kernel import Kernel
    from tmodes.equations.arm.link_kernels import BODY

    def build(body: Any, pose: Any, sum_: Any) -> list[list[Any]]:
        return [v.add(v.vec(sum_), v.scale(body[0], v.vec(pose, 9)), v.matvec(v.tri(pose), v.vec(body, 1)))]

    return Kernel("body moment", (BODY, POSE, 3), (3,), build)


def elastic_forces(parts: Parts) -> Schedule:
    """(q, v) -> forces of springs, dampers and friction along the coordinates, as on the left side of the equations.

    Further outputs: ``energies`` (gears, links) and ``losses`` (gear damping, friction, link damping) of each part in
    the order of the nodes; ``energies`` of a node: gear then link.
    """
    way = Passes(parts, posed=False, loaded=False)
    schedule = way.schedule
    motors: dict[int, Slot] = {}
    joints: dict[int, Slot] = {}
    links: dict[int, Slot] = {}
    energies: list[Slot] = []
    losses: list[Slot] = []
    coupled = way.coupled_inputs()
    torques: dict[int, Slot] = {}
    for part in parts.nodes:
        none = way.none[1]
        energy, lost, bend_energy, bend_lost = none, way.none[3].part(0, 2), none, none
        if part.motor in coupled and part.drive and part.drive_numbers:
            blocks = (part.drive_numbers, *coupled[part.motor], *way.angle(part))
            joints[part.angle], energy, lost = schedule.call(part.drive.coupled_elastic(), *blocks)
            torques[part.motor] = schedule.call(part.drive.coupled(), *blocks)[1]
        elif part.drive and part.drive_numbers:
            blocks = (part.drive_numbers, *way.motor(part), *way.angle(part))
            forces, energy, lost = schedule.call(part.drive.elastic(), *blocks)
            joints[part.angle] = forces.part(0, 1)
            motors[part.motor] = forces.part(1, 1)
        if part.link:
            link = part.link
            blocks = (link.stiffness, link.damping, way.bend(link, way.q), way.bend(link, way.v))
            links[link.first], bend_energy, bend_lost = schedule.call(link.kernels.elastic(), *blocks)
        energies += [energy, bend_energy]
        losses += [lost, bend_lost]
    losses += _coupled_motors(way, torques, motors)
    schedule.output("forces", *way.by_coordinate(motors, joints, links))
    schedule.output("energies", *energies)
    schedule.output("losses", *losses)
    return schedule


def _coupled_motors(way: Passes, torques: dict[int, Slot], motors: dict[int, Slot]) -> list[Slot]:
    """Forces on coupled motors, put among ``motors``; the friction they lose, as losses of further parts."""
    loads = way.coupled_loads(torques)
    lost: list[Slot] = []
    for part in way.parts.nodes:
        if part.motor in loads and part.drive and part.drive_numbers:
            blocks = (part.drive_numbers, way.motor(part)[1], way.none[1], loads[part.motor])
            _, motors[part.motor], friction = way.schedule.call(part.drive.coupled_motor(), *blocks)
            lost += [way.none[1], friction, way.none[1]]
    return lost
