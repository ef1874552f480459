"""The outward pass over a chain, which every schedule begins with: rates, sections, and poses where they are needed."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain
from tmodes.equations.recursion.driven import Coordinates
from tmodes.equations.recursion.general_joint import GeneralJoint
from tmodes.equations.recursion.hinge import POSE, Hinge
from tmodes.equations.recursion.link_kernels import (
    body_inertia_kernel,
    body_kernel,
    point_kernel,
    push_kernel,
    sum_kernel,
)
from tmodes.equations.recursion.parts import LinkPart, NodePart, Parts
from tmodes.equations.recursion.screw import TURN, Screw, rates_kernel, turn_kernel
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.kinds.kernel.spatial import FORCE
from tmodes.kinds.noted.functions import array

__all__ = ["BASE", "Blocks", "Passes", "Way", "resting_base"]

BASE = 2 * FORCE - 3 + POSE
"""Numbers of the base: acceleration less gravity (6) and rate (3) in its own axes, pose in the world (15)."""

_TOGETHER = 8


def resting_base(chain: Chain, factor: float = 1.0) -> NDArray[np.float64]:
    """The row of a base that stands still under ``factor`` times gravity."""
    placed = chain.base
    pull = placed.rotation.T @ (factor * array(chain.gravity))
    return np.concatenate([np.zeros(3), -pull, np.zeros(3), placed.rotation.ravel(), placed.position, np.zeros(3)])


@dataclass
class Way:
    """What the outward pass found of a node: ``joint``, the kernels of its joint, to be called with ``axis``.

    ``axis`` are the numbers of a joint's axis or of its short way, or the columns of its motion.
    """

    joint: Hinge | GeneralJoint | Screw
    axis: Slot
    hinge: Slot
    root_rate: Slot
    tip_rate: Slot
    root_pose: Slot | None = None
    tip_pose: Slot | None = None
    carried_pose: Slot | None = None
    terms: Slot | None = None
    tip: Slot | None = None
    push: Slot | None = None
    """Bias force of the body of a rigid link, where it is known."""
    sections: tuple[Slot, ...] = ()
    section_poses: list[Slot] = field(default_factory=list)


@dataclass(frozen=True)
class Blocks:
    """What the passes start from, in the schedule that they add to: coordinates, rates, and the base."""

    schedule: Schedule
    q: Slot
    v: Slot
    base: Slot

    @classmethod
    def as_inputs(cls, parts: Parts) -> Blocks:
        """Inputs of a new schedule."""
        schedule = Schedule(parts.numbers.size, zeros=tuple(parts.none.values()))
        q, v = schedule.input("q", parts.size), schedule.input("v", parts.size)
        return cls(schedule, q, v, schedule.input("base", BASE))


class Passes(Coordinates):
    """Blocks of one schedule by what they mean; each pass adds its calls.

    ``attached``: index of a node -> inertia and bias force of what moves with its tip next to its own body, as those of
    the tip.
    """

    def __init__(
        self, parts: Parts, *, posed: bool, loaded: bool, blocks: Blocks | None = None, short: bool = False
    ) -> None:
        """``posed``: poses in the world are needed; ``loaded``: forces act on the points.

        ``short``: joints take the short way where they have one, else all take the general one.
        """
        self.short = short
        self.posed = posed or loaded
        blocks = blocks or Blocks.as_inputs(parts)
        super().__init__(parts, blocks.schedule, blocks.q, blocks.v)
        self.base = blocks.base
        self.ways: list[Way] = []
        self.turns: dict[int, Slot] = {}
        self.attached: dict[int, tuple[Slot, Slot]] = {}

    def parent(self, part: NodePart) -> Way | None:
        """What was found of the parent, None for the base."""
        return self.ways[part.node.parent] if part.node.parent >= 0 else None

    def outwards(self) -> None:
        """Rates, and poses where they are needed, from the base to the tips."""
        call = self.schedule.call
        for part in self.parts.nodes:
            parent = self.parent(part)
            rate = parent.tip_rate if parent else self.base.part(FORCE, 3)
            angle, speed = self._pair(part.angle, part.size)
            tip = parent.tip.part(0, 9) if parent and parent.tip else self.none[9]
            if self.short and part.screw and part.way:
                blocks, body = (part.way, rate, self._turn(part.angle), speed), part.tip_body
                inward = rates_kernel(part.screw, with_body=body is not None)
                hinge, root_rate, *push = call(inward, *blocks, *([body] if body else []))
                way = Way(part.screw, part.way, hinge, root_rate, root_rate, push=push[0] if push else None)
            else:
                blocks = (part.placement, tip, part.axis, rate, angle, speed)
                hinge, root_rate, *columns = call(part.hinge.inward(), *blocks)
                way = Way(part.hinge, columns[0] if columns else part.axis, hinge, root_rate, root_rate)
            if self.posed:
                pose = parent.carried_pose if parent else self.base.part(FORCE + 3, POSE)
                assert pose is not None  # noqa: S101
                (way.root_pose,) = call(way.joint.pose(), pose, rate, hinge, way.axis, speed)
                way.tip_pose = way.carried_pose = way.root_pose
            if part.link:
                self._bend_outwards(part.link, way)
            self.ways.append(way)

    def _turn(self, angle: int) -> Slot:
        """Cosine and sine of the angle of a joint with a short way; eight at a time cost little more than one.

        They are called where the first is needed: so they are found while one joint waits for the joint before.
        """
        if angle not in self.turns:
            first = angle - (angle - self.parts.joints.start) % _TOGETHER
            group = range(first, min(first + _TOGETHER, self.parts.joints.stop))
            phases = self.parts.phases.part(TURN * (first - self.parts.joints.start), TURN * len(group))
            (both,) = self.schedule.call(turn_kernel(len(group)), self.q.part(first, len(group)), phases)
            self.turns |= {index: both.part(TURN * k, TURN) for k, index in enumerate(group)}
        return self.turns[angle]

    def _bend_outwards(self, link: LinkPart, way: Way) -> None:
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
        if part.tip_body and way.push:
            (inertia,), bias = self.schedule.call(body_inertia_kernel(), part.tip_body), way.push
        elif part.tip_body:
            kernel = body_kernel(on_section=way.tip is not None)
            inertia, bias = self.schedule.call(kernel, part.tip_body, self.frame(way.tip), way.tip_rate)
        if index in self.attached:
            inertia, bias = self.schedule.call(sum_kernel(), inertia, bias, *self.attached[index])
        for k in self.wrenches:
            point = self.parts.points[k]
            if point.node == index and self.parts.station(point) is None:
                bias = self.pushed(k, way, way.tip, bias)
        return inertia, bias

    def frame(self, section: Slot | None) -> Slot:
        """Rotation of a section in its link."""
        return section.part(0, 9) if section else self.none[9]

    def pushed(self, k: int, way: Way, section: Slot | None, bias: Slot) -> Slot:
        """A bias force less the wrench on point ``k``, which moves with a section of the link, or with its axes."""
        assert way.root_pose is not None  # noqa: S101
        arm, wrench = self.parts.offsets[k].part(9, 3), self.wrenches[k]
        kernel = push_kernel(on_section=section is not None)
        return self.schedule.call(kernel, way.root_pose, self.frame(section), arm, wrench, bias)[0]

    def terms_with_stations(self, index: int) -> Slot:
        """Inertia terms of a bending link with the bodies at its stations, less the forces on its points there."""
        part, way = self.parts.nodes[index], self.ways[index]
        link, terms = part.link, way.terms
        assert link is not None  # noqa: S101
        assert terms is not None  # noqa: S101
        for number, (section, (_, body)) in enumerate(zip(way.sections, link.stations, strict=True)):
            force = self.none[FORCE]
            for k in self.wrenches:
                point = self.parts.points[k]
                if point.node == index and self.parts.station(point) == number:
                    force = self.pushed(k, way, section, force)
            if body or force is not self.none[FORCE]:
                (terms,) = self.schedule.call(link.kernels.station_load(), terms, section, body or self.none[10], force)
        return terms

    def frame_of(self, k: int) -> tuple[Slot, Slot, Slot]:
        """Pose of the frame that a point is fixed to, pose of its link's axes, and its rate in them."""
        point = self.parts.points[k]
        way, station = self.ways[point.node], self.parts.station(point)
        assert way.root_pose is not None  # noqa: S101
        assert way.tip_pose is not None  # noqa: S101
        if station is None:
            return way.tip_pose, way.root_pose, way.tip_rate
        return way.section_poses[station], way.root_pose, way.sections[station].part(12, 3)

    def pose(self, k: int) -> tuple[Slot, Slot]:
        """Pose and velocity of a point, and its rate, in world axes."""
        point = self.parts.points[k]
        here, station = self.ways[point.node], self.parts.station(point)
        pose, section = here.tip_pose, here.tip
        if station is not None:
            pose, section = here.section_poses[station], here.sections[station]
        assert pose is not None  # noqa: S101
        rate = section.part(12, 3) if section else here.tip_rate
        blocks = (pose, self.frame(section), rate, self.none[FORCE], self.parts.offsets[k])
        found = self.schedule.call(point_kernel(on_section=section is not None), *blocks)
        return found[0], found[1]

    def offset(self, k: int) -> Slot:
        """Placement of a point in the frame of :meth:`frame_of`."""
        return self.parts.offsets[k]

    def takes_mass(self, k: int) -> bool:
        """Whether an inertia can be attached at a point: not at a station inside a link."""
        return self.parts.station(self.parts.points[k]) is None

    def touched(self, k: int, touch: Any, numbers: Slot, wrench: Slot, step: Slot | None, mode: Slot) -> None:
        """A contact on a point: its push is in ``wrench``; ``step``: a mass moves with the point, in steps of this."""
        self.wrenches[k] = wrench
        if step is not None:
            blocks = (*self.frame_of(k), self.offset(k), numbers, step, mode)
            inertia, bias = self.schedule.call(touch.inertia(), *blocks)
            self.attached[self.parts.points[k].node] = (inertia, bias)

    def link_losses(self) -> list[Slot]:
        """Power lost in the dampers of each link [W]."""
        return [self.elastic(part.link)[2] for part in self.parts.nodes if part.link]

    def elastic(self, link: LinkPart) -> tuple[Slot, ...]:
        """Forces of a link's springs and dampers on its coordinates, their energy, and the power lost."""
        blocks = (link.stiffness, link.damping, self.bend(link, self.q), self.bend(link, self.v))
        return self.schedule.call(link.kernels.elastic(), *blocks)
