"""Forward dynamics: rates outwards, inertias inwards, accelerations outwards again. One pass is a step's whole cost."""

from __future__ import annotations

from typing import Any

from tmodes.equations.recursion.driven import Driven, Drives
from tmodes.equations.recursion.forces import point_motion
from tmodes.equations.recursion.general_joint import GeneralJoint
from tmodes.equations.recursion.hinge import Hinge
from tmodes.equations.recursion.link_kernels import times_kernel
from tmodes.equations.recursion.parts import AxisPart, Parts
from tmodes.equations.recursion.passes import Passes
from tmodes.equations.recursion.screw import Screw
from tmodes.kinds.kernel.schedule import Kernel, Schedule, Slot
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Ahead", "Recursion", "ahead_kernel", "forward_dynamics"]


def forward_dynamics(parts: Parts, *, loaded: bool = False) -> Schedule:
    """(q, v, base, wrenches, effort, given, step) -> accelerations of all coordinates.

    ``given`` are the accelerations of prescribed joints; ``step`` h > 0 gives those of a linearly implicit Euler step.
    """
    way = Passes(parts, posed=False, loaded=loaded, short=True)
    way.take_wrenches(loaded=loaded)
    schedule = way.schedule
    schedule.often = True
    effort, given = schedule.input("effort", len(parts.efforts)), schedule.input("given", len(parts.given))
    step = schedule.input("step", 1)
    way.outwards()
    schedule.output("a", *Recursion(way, Drives(effort, given, step, (Ahead(way, step), way.v))).run())
    return schedule


class Recursion(Driven):
    """The way in and the way out again of the articulated-body recursion.

    After the run: ``roots`` and ``tips``, accelerations of both ends of each link; ``hung``, inertia and bias force at
    each root.
    """

    way: Passes

    def __init__(self, way: Passes, drives: Drives) -> None:
        """As :class:`Driven`."""
        super().__init__(way, drives)
        self.hung: dict[int, tuple[Slot, Slot]] = {}
        self.on_base: list[tuple[Kernel, tuple[Slot, ...]]] = []
        self.roots: list[Slot] = []
        self.tips: list[Slot] = []
        self.loads: dict[int, tuple[Slot, Slot]] = {}
        self.joints: dict[int, Hinge | GeneralJoint | Screw] = {}
        self.held: dict[int, Slot] = {}
        self.solved: dict[int, Slot] = {}

    def run(self) -> list[Slot]:
        """Add all calls; the accelerations of the coordinates, in their order."""
        for index in reversed(range(len(self.parts.nodes))):
            self._inwards(index)
        self.couple_motors()
        self.accelerations = self._outwards()
        return self.accelerations

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
        drives = [self.drive(axis) for axis in part.axes]
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

    def _outwards(self) -> list[Slot]:
        joints: dict[int, Slot] = {}
        links: dict[int, Slot] = {}
        for index, (part, way) in enumerate(zip(self.parts.nodes, self.way.ways, strict=True)):
            parent = part.node.parent
            before = self.tips[parent] if parent >= 0 else self.way.base.part(0, FORCE)
            given = self.way.packed([self.given_acceleration(axis) for axis in part.axes])
            blocks = (before, way.hinge, way.axis, self.held[index], given)
            root, joint = self.schedule.call(self.joints[index].onward(), *blocks)
            joints |= {axis.angle: joint.part(axis.place, 1) for axis in part.axes}
            self.roots.append(root)
            if part.link and way.tip:
                found = self.schedule.call(part.link.kernels.onward(), root, self.solved[index], way.tip)
                links[part.link.first], root = found
            self.tips.append(root)
        return self.way.by_coordinate(self.motor_accelerations(joints), joints, links)

    def force_along(self, axis: AxisPart) -> Slot:
        """Force along a joint's coordinate by all that hangs on the joint, after the run."""
        way, hung = self.way.ways[axis.index], self.hung[axis.index]
        (force,) = self.schedule.call(times_kernel(), hung[0], self.roots[axis.index], hung[1])
        along = self.schedule.call(way.joint.load(), force, way.hinge, way.axis, self.way.none[FORCE])[1]
        return along.part(axis.place, 1)

    def point(self, k: int) -> tuple[Slot, ...]:
        """Pose, rate and acceleration (less gravity) of a point in the world, after the run."""
        return point_motion(self.way, k, self.roots, self.tips, lambda link: self.way.bend(link, self.packed()))


_GROUP = 8
"""Motors or joints that go in one call; so the code does not grow with the robot."""


class Ahead:
    """Stands for the block of all coordinates; a call is added where a coordinate of its group is first asked for.

    A group is some motors, some joints, or all coordinates of one link.
    """

    def __init__(self, way: Passes, step: Slot) -> None:
        self.way, self.step = way, step
        self.found: dict[int, Slot] = {}
        motors, joints = way.parts.motors, way.parts.joints
        firsts = [*motors[::_GROUP], *joints[::_GROUP], *(part.link.first for part in way.parts.nodes if part.link)]
        self.firsts = sorted({*firsts, way.parts.size})

    def part(self, start: int, size: int) -> Slot:
        """A block of them, within one group."""
        first = max(first for first in self.firsts if first <= start)
        if first not in self.found:
            count = min(other for other in self.firsts if other > first) - first
            blocks = self.way.q.part(first, count), self.way.v.part(first, count), self.step
            (self.found[first],) = self.way.schedule.call(ahead_kernel(count), *blocks)
        return self.found[first].part(start - first, size)


def ahead_kernel(size: int) -> Kernel:
    """(q, v, h) -> q + h v."""

    def build(q: Any, v: Any, step: Any) -> list[list[Any]]:
        return [[q[i] + step[0] * v[i] for i in range(size)]]

    return Kernel(f"ahead {size}", (size, size, 1), (size,), build, plain=True)
