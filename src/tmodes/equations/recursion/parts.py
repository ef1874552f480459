"""The parts of a chain for the recursion: the kernels of each node, and its numbers in the vector of parameters."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Axis, Chain, Joint, Node, Point
from tmodes.equations.recursion.drive_kernels import SIDES, DriveKernels, drive_kernels, drive_numbers
from tmodes.equations.recursion.framing import STRAIGHT, Framing
from tmodes.equations.recursion.general_joint import GeneralJoint, held_numbers
from tmodes.equations.recursion.hinge import HELD, Hinge
from tmodes.equations.recursion.link_kernels import BODY, BendingLink
from tmodes.equations.recursion.screw import Screw, screw_numbers
from tmodes.kinds.kernel.schedule import Numbers, Slot
from tmodes.kinds.kernel.spatial import FORCE, INERTIA
from tmodes.kinds.links.contract import Body, Link
from tmodes.kinds.noted.functions import array, by_size

__all__ = ["LinkPart", "NodePart", "Parts", "packed_bodies"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class LinkPart:
    """A bending link: its kernels, where its numbers stand, and its stations (s, body or None)."""

    kernels: BendingLink
    tables: Slot
    stiffness: Slot
    damping: Slot
    stations: tuple[tuple[float, Slot | None], ...]
    first: int
    names: tuple[str, ...]

    @property
    def own(self) -> slice:
        """Where its coordinates stand."""
        return slice(self.first, self.first + len(self.names))


@dataclass(frozen=True)
class AxisPart:
    """A coordinate of a joint and its drive: kernels and numbers, and indices (-1 where it has none).

    ``index``: of the node; ``place``: of the coordinate in its joint; ``drive`` is None where the motion is given and
    no parallel spring acts.
    """

    axis: Axis
    node: Node
    index: int
    place: int
    drive: DriveKernels | None
    drive_numbers: Slot | None
    angle: int
    motor: int
    effort: int
    given: int

    @property
    def input(self) -> int:
        """Index of the coordinate that its motor turns: the motor's own, else the joint's."""
        return self.motor if self.motor >= 0 else self.angle


@dataclass(frozen=True)
class NodePart:
    """A node: its joint's kernels, numbers and coordinates, its link.

    ``screw`` and ``way``: kernels and numbers of the short way to its joint, where there is one.
    """

    node: Node
    hinge: Hinge | GeneralJoint
    placement: Slot
    axis: Slot
    axes: tuple[AxisPart, ...]
    link: LinkPart | None
    tip_body: Slot | None
    screw: Screw | None = None
    way: Slot | None = None

    @property
    def angle(self) -> int:
        """Index of the joint's first coordinate, -1 where it does not move."""
        return self.axes[0].angle if self.axes else -1

    @property
    def size(self) -> int:
        """Number of the joint's coordinates."""
        return len(self.axes)


@dataclass
class Parts:
    """Everything that the passes need of a chain. Rigid links stand in frames of our own choice, see Framing."""

    chain: Chain
    numbers: Numbers = field(default_factory=Numbers)
    nodes: list[NodePart] = field(default_factory=list)
    points: tuple[Point, ...] = ()
    offsets: list[Slot] = field(default_factory=list)

    def __post_init__(self) -> None:
        chain = self.chain
        self.points, self.framing = chain.points or (chain.tip,), Framing(chain)
        joints = [node.joint for node in chain.nodes]
        sizes = dict.fromkeys((1, 2, 3, SIDES, FORCE, HELD, 9, BODY, INERTIA))
        sizes |= dict.fromkeys(size for joint in joints if joint.kind.size > 1 for size in _block_sizes(joint))
        self.none = {size: self.numbers.block(np.zeros(size)) for size in sizes}
        axes = chain.axes
        motors = [axis.motor for axis in axes if axis.drive.has_motor]
        self.motors = range(len(motors))
        self.joints = range(len(motors), len(motors) + len(axes))
        self.names = motors + [axis.name for axis in axes]
        self.efforts = [axis.name for axis in axes if axis.drive.takes_effort]
        self.given = [axis.name for axis in axes if axis.drive.is_given]
        info = (self.names, self.efforts, self.given)
        self._places = tuple({name: place for place, name in enumerate(names)} for names in info)
        for index, node in enumerate(chain.nodes):
            self.nodes.append(self._node(index, node))
        self.phases = self.numbers.block(self._phases())
        self.couplings = None if chain.couplings is None else self.numbers.block(chain.couplings)
        self.offsets = [self._offset(point) for point in self.points]

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return len(self.names)

    def bodies(self) -> list[list[int]]:
        """The coordinates of each motor, joint and link, in the order of the nodes."""
        found: list[list[int]] = []
        for part in self.nodes:
            found += [[index] for axis in part.axes for index in (axis.motor, axis.angle) if index >= 0]
            found += [[*range(self.size)[part.link.own]]] if part.link else []
        return found

    @cached_property
    def held(self) -> list[int]:
        """The coordinates whose accelerations are given."""
        return [axis.angle for axis in self.axes if axis.given >= 0]

    @property
    def axes(self) -> list[AxisPart]:
        """All coordinates of the joints, in their order."""
        return [axis for part in self.nodes for axis in part.axes]

    @cached_property
    def driven(self) -> list[int]:
        """The coordinate that each effort acts along."""
        along = {axis.effort: axis.input for axis in self.axes}
        return [along[index] for index in range(len(self.efforts))]

    def _node(self, index: int, node: Node) -> NodePart:
        joint, link = node.joint, node.link
        along = self.framing.axis(index)
        on_section = node.parent >= 0 and self.chain.nodes[node.parent].link.bends
        placed, screw = self.framing.placements[index], self.framing.screws[index]
        driven = tuple(axis.drive.is_given for axis in joint.axes)
        aside = any(by_size(placed.position))
        placement = self.numbers.block([*placed.rotation.ravel(), *placed.position])
        hinge: Hinge | GeneralJoint
        if joint.kind.is_simple:
            axis = _axis_of(along) if joint.moves else 2
            hinge = Hinge(joint.kind, axis, driven == (True,), aside, on_section)
            numbers = self.numbers.block(along)
        else:
            hinge = GeneralJoint(joint.kind, joint.numbers.size, driven, aside, on_section)
            numbers = self.numbers.block(joint.numbers)
        return NodePart(
            node, hinge, placement, numbers,
            axes=tuple(self._axis(index, node, place, axis) for place, axis in enumerate(joint.axes)),
            link=self._link(index, node.name, link) if link.bends else None,
            tip_body=self._tip_body(index, link),
            screw=Screw.of(screw, driven=driven == (True,)) if screw else None,
            way=self.numbers.block(screw_numbers(screw)) if screw else None,
        )  # fmt: skip

    def _axis(self, index: int, node: Node, place: int, axis: Axis) -> AxisPart:
        angle, effort, given = (places.get(axis.name, -1) for places in self._places)
        kernels = numbers = None
        if not axis.drive.is_given or node.joint.spring:
            kernels = drive_kernels(node.joint, axis.drive)
            numbers = self.numbers.block(drive_numbers(node.joint, axis.drive))
        motor = self._places[0][axis.motor] if axis.drive.has_motor else -1
        return AxisPart(axis, node, index, place, kernels, numbers, angle, motor, effort, given)

    def _link(self, index: int, name: str, link: Link) -> LinkPart:
        first, block = len(self.names), self.numbers.block
        stations = link.stations(tuple(point.s for point in self.points if point.node == index))
        numbers = link.numbers(stations)
        names = tuple(f"{name}.{coordinate}" for coordinate in link.coordinates)
        self.names += names
        bodies = [(s, link.bodies_at(s)) for s in stations]
        at_stations = tuple((s, block(packed_bodies(there)) if there else None) for s, there in bodies)
        blocks = (block(numbers.tables), block(numbers.stiffness), block(numbers.damping))
        return LinkPart(BendingLink(numbers.structure), *blocks, at_stations, first, names)

    def _phases(self) -> list[tuple[float, float]]:
        """Cosine and sine of what each joint's angle is measured from in its short way, in the order of the joints."""
        screws = zip(self.nodes, self.framing.screws, strict=True)
        phases = {part.angle: screw.phase for part, screw in screws if screw}
        return [phases.get(angle, STRAIGHT) for angle in self.joints]

    def _tip_body(self, index: int, link: Link) -> Slot | None:
        bodies = self.framing.bodies(index, link.bodies_at(1.0))
        return self.numbers.block(packed_bodies(bodies)) if bodies else None

    def _offset(self, point: Point) -> Slot:
        offset = self.framing.offset(point.node, point.offset)
        return self.numbers.block([*offset.rotation.ravel(), *offset.position])

    def station(self, point: Point) -> int | None:
        """The number of the station at which a point stands, None for a tip."""
        link = self.nodes[point.node].link
        if link is None or not link.stations or point.s >= 1.0:
            return None
        return [s for s, _ in link.stations].index(point.s)


def _block_sizes(joint: Joint) -> tuple[int, ...]:
    """Sizes of the blocks of a joint of several coordinates that may be zero."""
    n = joint.kind.size
    return n, held_numbers(n), held_numbers(0)


def _axis_of(axis: Array) -> int | None:
    """0, 1 or 2 for an axis of the frame itself."""
    for k in range(3):
        if np.array_equal(axis, np.eye(3)[k]):
            return k
    return None


def packed_bodies(bodies: tuple[Body, ...]) -> Array:
    """Mass, first moment and inertia about the frame's origin of bodies that move as one."""
    total = np.zeros(10)
    for body in bodies:
        c = array(body.center)
        inertia = body.inertia + body.mass * (c @ c * np.eye(3) - np.outer(c, c))
        six = [inertia[0, 0], inertia[1, 1], inertia[2, 2], inertia[0, 1], inertia[0, 2], inertia[1, 2]]
        total = total + np.array([body.mass, *(body.mass * c), *six])
    return total
