"""Forward dynamics: rates outwards, inertias inwards, accelerations outwards again. One pass is a step's whole cost."""

from __future__ import annotations

from tmodes.equations.recursion.ahead import Ahead
from tmodes.equations.recursion.general_joint import GeneralJoint
from tmodes.equations.recursion.hinge import Hinge
from tmodes.equations.recursion.parts import AxisPart, NodePart, Parts
from tmodes.equations.recursion.passes import Passes
from tmodes.equations.recursion.screw import Screw
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Divisible, Schedule, Slot
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Recursion", "forward_dynamics"]


def forward_dynamics(parts: Parts, *, loaded: bool = False) -> Schedule:
    """(q, v, base, wrenches, effort, given, step) -> accelerations of all coordinates.

    ``given`` are the accelerations of prescribed joints; ``step`` h > 0 gives those of a linearly implicit Euler step.
    """
    way = Passes(parts, posed=False, loaded=loaded, short=True)
    way.take_wrenches()
    schedule = way.schedule
    schedule.often = True
    effort, given = schedule.input("effort", len(parts.efforts)), schedule.input("given", len(parts.given))
    step = schedule.input("step", 1)
    way.outwards()
    schedule.output("a", *Recursion(way, effort, given, step, (Ahead(way, step), way.v)).run())
    return schedule


class Recursion:
    """The way in and the way out again of the articulated-body recursion.

    After the run: ``roots`` and ``tips``, accelerations of both ends of each link; ``hung``, inertia and bias force at
    each root.
    """

    def __init__(
        self,
        way: Passes,
        effort: Slot,
        given: Slot,
        step: Slot,
        start: tuple[Divisible, Slot],
        feedback: Slot | None = None,
    ) -> None:
        """``start``: coordinates and rates from which springs, dampers and friction start; those of ``way`` place all.

        ``feedback`` (2 per effort): see :meth:`DriveKernels.forward`.
        """
        self.way, self.effort, self.given, self.step, self.feedback = way, effort, given, step, feedback
        self.start = start
        self.followed: dict[int, Slot] = {}  # index of a motor that keeps a given motion -> its acceleration
        self.hung: dict[int, tuple[Slot, Slot]] = {}
        self.on_base: list[tuple[Kernel, tuple[Slot, ...]]] = []
        self.roots: list[Slot] = []
        self.tips: list[Slot] = []
        self.schedule, self.parts = way.schedule, way.parts
        self.loads: dict[int, tuple[Slot, Slot]] = {}
        self.joints: dict[int, Hinge | GeneralJoint | Screw] = {}
        self.held: dict[int, Slot] = {}
        self.solved: dict[int, Slot] = {}
        self.motor_terms: dict[int, Slot] = {}
        self.coupled = way.coupled_inputs()
        self.torques: dict[int, Slot] = {}
        self.coupled_loads: dict[int, Slot] = {}

    def run(self) -> list[Slot]:
        """Add all calls; the accelerations of the coordinates, in their order."""
        for index in reversed(range(len(self.parts.nodes))):
            self._inwards(index)
        self._couple_motors()
        return self._outwards()

    def _given(self, axis: AxisPart) -> Slot:
        return self.given.part(axis.given, 1) if axis.given >= 0 else self.way.none[1]

    def _inwards(self, index: int) -> None:
        part, way = self.parts.nodes[index], self.way.ways[index]
        inertia, bias = self._load(index)
        if part.link and way.tip:
            link = part.link
            q, v = (self.way.bend(link, block) for block in self.start)
            terms = self.way.terms_with_stations(index)
            blocks = (terms, way.tip, inertia, bias, link.stiffness, link.damping, q, v, self.step)
            inertia, bias, self.solved[index] = self.schedule.call(link.kernels.outward(), *blocks)
        self.hung[index] = (inertia, bias)
        drives = [self._drive(axis) for axis in part.axes]
        effort, own = (self.way.packed([drive[k] for drive in drives]) for k in range(2))
        parent = part.node.parent
        self.joints[index] = joint = self._joint(index, own)
        blocks = (inertia, bias, way.hinge, way.axis, effort, own)
        if parent < 0:
            (self.held[index],) = self.schedule.call(joint.hold(), *blocks)
            self.on_base.append((joint.outward(), blocks))
        elif isinstance(joint, Screw) and (sums := self._sole_body(parent)):
            outward = joint.outward(onto_body=True)
            *more, self.held[index] = self.schedule.call(outward, *blocks, *sums)
            self.loads[parent] = (more[0], more[1])
        else:
            *more, self.held[index] = self.schedule.call(joint.outward(), *blocks, *self._load(parent))
            self.loads[parent] = (more[0], more[1])

    def at_base(self) -> tuple[Slot, Slot]:
        """Inertia and bias force of all that hangs on the base, after the run."""
        sums = (self.way.none[21], self.way.none[FORCE])
        for kernel, blocks in self.on_base:
            inertia, bias, _ = self.schedule.call(kernel, *blocks, *sums)
            sums = (inertia, bias)
        return sums

    def _load(self, index: int) -> tuple[Slot, Slot]:
        """Inertia and bias force of what is fixed to a node's tip and of what hangs on it."""
        if index not in self.loads:
            self.loads[index] = self.way.load_of_tip(index)
        return self.loads[index]

    def _sole_body(self, index: int) -> tuple[Slot, Slot] | None:
        """The body of a node's rigid link and its bias force, where nothing else is known yet to be fixed to it."""
        pushed = any(self.parts.points[k].node == index for k in self.way.wrenches)
        body, push = self.parts.nodes[index].tip_body, self.way.ways[index].push
        more = pushed or index in self.loads or index in self.way.attached
        return None if more or body is None or push is None else (body, push)

    def _joint(self, index: int, own: Slot) -> Hinge | GeneralJoint | Screw:
        joint = self.way.ways[index].joint
        return joint.as_free() if isinstance(joint, Screw) and own is self.way.none[1] else joint

    def _start(self, index: int) -> tuple[Slot, Slot]:
        """Where a coordinate and its rate start from; zero without one."""
        none = self.way.none[1]
        return (none, none) if index < 0 else (self.start[0].part(index, 1), self.start[1].part(index, 1))

    def _drive(self, axis: AxisPart) -> tuple[Slot, Slot]:
        """Effort on a coordinate of a joint (its acceleration where that is given) and inertia of its own."""
        none = self.way.none[1]
        if axis.drive is None or axis.drive_numbers is None:
            return self._given(axis), none
        if axis.drive.bare and not self.feedback:
            return self.effort.part(axis.effort, 1), none
        if axis.motor in self.coupled:
            blocks = (axis.drive_numbers, *self.coupled[axis.motor], *self.way.angle(axis))
            effort, self.torques[axis.motor] = self.schedule.call(axis.drive.coupled(), *blocks)
            return effort, none
        if axis.motor in self.followed:
            blocks = (axis.drive_numbers, *self._start(axis.motor), *self._start(axis.angle), self.step)
            effort, own = self.schedule.call(axis.drive.followed(), *blocks)
            return effort, own
        effort = self.effort.part(axis.effort, 1) if axis.effort >= 0 else none
        feedback = self.feedback.part(2 * axis.effort, 2) if self.feedback and axis.effort >= 0 else self.way.none[2]
        angles = (*self._start(axis.motor), *self._start(axis.angle))
        blocks = (axis.drive_numbers, *angles, effort, feedback, self.step)
        effort, own, self.motor_terms[axis.angle] = self.schedule.call(axis.drive.forward(), *blocks)
        return effort, own

    def _couple_motors(self) -> None:
        self.coupled_loads = loads = self.way.coupled_loads(self.torques)
        for axis in self.parts.axes:
            if axis.motor in loads and axis.drive and axis.drive_numbers:
                effort = self.effort.part(axis.effort, 1)
                blocks = (axis.drive_numbers, self.way.motor(axis)[1], effort, loads[axis.motor])
                self.motor_terms[axis.angle] = self.schedule.call(axis.drive.coupled_motor(), *blocks)[0]

    def _outwards(self) -> list[Slot]:
        motors: dict[int, Slot] = dict(self.followed)
        joints: dict[int, Slot] = {}
        links: dict[int, Slot] = {}
        for index, (part, way) in enumerate(zip(self.parts.nodes, self.way.ways, strict=True)):
            parent = part.node.parent
            before = self.tips[parent] if parent >= 0 else self.way.base.part(0, FORCE)
            given = self.way.packed([self._given(axis) for axis in part.axes])
            blocks = (before, way.hinge, way.axis, self.held[index], given)
            root, joint = self.schedule.call(self.joints[index].onward(), *blocks)
            joints |= self._moved(part, joint, motors)
            self.roots.append(root)
            if part.link and way.tip:
                found = self.schedule.call(part.link.kernels.onward(), root, self.solved[index], way.tip)
                links[part.link.first], root = found
            self.tips.append(root)
        return self.way.by_coordinate(motors, joints, links)

    def _moved(self, part: NodePart, joint: Slot, motors: dict[int, Slot]) -> dict[int, Slot]:
        """Accelerations of a joint's coordinates; those of its motors are put among ``motors``."""
        found: dict[int, Slot] = {}
        for axis in part.axes:
            found[axis.angle] = moved = joint.part(axis.place, 1)
            if axis.motor >= 0 and axis.motor not in self.followed and axis.drive:
                (motors[axis.motor],) = self.schedule.call(axis.drive.motor(), self.motor_terms[axis.angle], moved)
        return found
