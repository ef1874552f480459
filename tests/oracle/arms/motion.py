# pyright: reportAttributeAccessIssue=false
"""Where everything of a chain is, as CasADi expressions of its coordinates: composition of frames and nothing else."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from oracle.arms.line import Line, names_of
from oracle.arms.rotation import about
from tmodes.chain.chain import Chain, Joint, Node
from tmodes.frame import Placement
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam

__all__ = ["Frame", "Mass", "Motion"]


@dataclass(frozen=True)
class Frame:
    """Where (3,) and which way (3, 3, columns = axes) in the world."""

    place: Any
    axes: Any

    def then(self, place: Any, axes: Any) -> Frame:
        """A frame that is given in this one."""
        return Frame(self.place + self.axes @ ca.SX(place), self.axes @ ca.SX(axes))

    def placed(self, placement: Placement) -> Frame:
        """A frame whose placement in this one is a table of numbers."""
        return self.then(np.asarray(placement.position, float), np.asarray(placement.rotation, float))


@dataclass(frozen=True)
class Mass:
    """A rigid body: its center's frame, its mass [kg] and its inertia (3, 3) [kg*m^2] in the frame's axes."""

    frame: Frame
    mass: float
    inertia: Any


def _symbols(names: list[str]) -> dict[str, Any]:
    return {name: ca.SX.sym(name) for name in names}


@dataclass
class Motion:
    """Frames, masses and points of a chain; ``q`` holds motors, joints, then link coordinates, named."""

    chain: Chain
    masses: list[Mass] = field(default_factory=list)
    tips: list[Frame] = field(default_factory=list)
    lines: dict[int, Line] = field(default_factory=dict)
    links: dict[int, Frame] = field(default_factory=dict)

    def __post_init__(self) -> None:
        nodes = self.chain.nodes
        axes = self.chain.axes
        self.motor = _symbols([f"{axis.name}.motor" for axis in axes if axis.drive == drive_kind("elastic")])
        self.joint = _symbols([axis.name for axis in axes])
        self.link = {node.name: _symbols(_link_names(node)) for node in nodes}
        for index, node in enumerate(nodes):
            self._add(index, node)

    @property
    def coordinates(self) -> dict[str, Any]:
        """Every coordinate by its name, in order."""
        return self.motor | self.joint | {name: x for part in self.link.values() for name, x in part.items()}

    def _add(self, index: int, node: Node) -> None:
        base = Frame(ca.SX(np.asarray(self.chain.base.position)), ca.SX(np.asarray(self.chain.base.rotation)))
        parent = self.tips[node.parent] if node.parent >= 0 else base
        frame = self._turned(parent.placed(node.joint.placement), node.joint)
        self.links[index] = frame
        place, axes = self._link(index, node, frame)
        self.tips.append(frame.then(place, axes))
        bodies = () if isinstance(node.link, Beam) else node.link.bodies
        for body in bodies:
            self._body(self.tips[-1], body)

    def _turned(self, frame: Frame, joint: Joint) -> Frame:
        if not joint.axes:
            return frame
        if joint.kind not in {joint_kind("revolute"), joint_kind("prismatic")}:
            axes, place = joint.kind.place([self.joint[axis.name] for axis in joint.axes], joint.numbers)
            return frame.then(ca.vertcat(*place), ca.vertcat(*(ca.horzcat(*row) for row in axes)))
        moved = self.joint[joint.name] - (0.0 if joint.drive is drive_kind("spring") else joint.rest)
        if joint.kind is joint_kind("revolute"):
            return frame.then(np.zeros(3), about(joint.axis, moved))
        return frame.then(np.asarray(joint.axis, float) * moved, np.eye(3))

    def _link(self, index: int, node: Node, frame: Frame) -> tuple[Any, Any]:
        if isinstance(node.link, Segment):
            return _segment(node.link, self.link[node.name], node.name)
        if isinstance(node.link, Beam):
            return self._beam(index, node.link, frame, list(self.link[node.name].values()))
        return np.zeros(3), np.eye(3)

    def _beam(self, index: int, beam: Beam, frame: Frame, q: list[Any]) -> tuple[Any, Any]:
        asked = tuple(point.s for point in self.chain.points if point.node == index)
        line = self.lines[index] = Line(beam, q, asked)
        for station in line.stations:
            self.masses.append(Mass(frame.then(station.place, station.axes), station.mass, np.diag(station.inertia)))
        for s, body in beam.bodies:
            self._body(frame.then(*line.at(s)), body)
        return line.tip

    def _body(self, frame: Frame, body: Body) -> None:
        center = frame.then(np.asarray(body.center, float), np.eye(3))
        self.masses.append(Mass(center, body.mass, np.asarray(body.inertia, float)))

    def points(self) -> list[Frame]:
        """Frames of the chain's points, or of its default tip."""
        return [self._point(p.node, p.s).placed(p.offset) for p in self.chain.points or (self.chain.tip,)]

    def _point(self, node: int, s: float) -> Frame:
        return self.links[node].then(*self.lines[node].at(s)) if node in self.lines else self.tips[node]


def _link_names(node: Node) -> list[str]:
    link = node.link
    if isinstance(link, Beam):
        return [f"{node.name}.{name}" for name in names_of(link)]
    if isinstance(link, Segment):
        return [f"{node.name}.{name}" for name in ("bend_y", "bend_z") if getattr(link, name)]
    return []


def _segment(link: Segment, q: dict[str, Any], name: str) -> tuple[Any, Any]:
    """The chord turns about z, then about y; the tangent by 3/2 of each."""
    y, z = (q.get(f"{name}.{direction}", 0.0) for direction in ("bend_y", "bend_z"))

    def turned(factor: float) -> Any:
        return about([0, 0, 1], factor * z) @ about([0, 1, 0], factor * y)

    return link.length * turned(1.0)[:, 0], turned(1.5)
