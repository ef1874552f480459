"""Chain: a tree of joints and links in the terms of the recursion. What every kind of file becomes before it moves.

    Robot (what a person writes: YAML, URDF + elasticity, DH)  ->  Chain  ->  kernels, one per kind of joint and link

A chain is made of nodes, parents before children. A node is a joint and the link that it carries:

    parent's tip frame --placement--> joint frame --joint--> link frame --link--> tip frame --placement--> next joint

A rigid link has its tip frame in its link frame; a beam runs along x of its link frame from s = 0 to s = 1, its tip.
All numbers are SI and reflected to the joint side of the reducer. Everything here is final, checked before, and plain.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.frame import Placement
from tmodes.kinds.drives.contract import DriveKind, Dry
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.contract import Coordinate, JointKind
from tmodes.kinds.links.contract import Link
from tmodes.kinds.noted.functions import array, number

__all__ = [
    "Axis", "Chain", "Friction", "Gear", "Joint", "Motor", "Node", "ParallelSpring", "Point", "joint_of_element",
    "line_before", "node_of_line",
]  # fmt: skip

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Friction:
    """Friction torque [N*m] (or force [N]) at a rate v: viscous v + (coulomb + extra/(1 + (v/stribeck)^2)) sgn v.

    ``smoothing`` > 0: ``sgn v`` is v/sqrt(v^2 + smoothing^2), else that of a set, up to coulomb + extra at rest;
    ``stribeck_rate`` 0: in motion there is no ``extra``. ``braked``: a brake adds to coulomb in a run.
    """

    viscous: float = 0.0
    coulomb: float = 0.0
    static_extra: float = 0.0
    stribeck_rate: float = 0.0
    smoothing: float = 0.0
    braked: bool = False

    @property
    def dry(self) -> Dry:
        """The structure of its dry part."""
        if not (self.coulomb > 0 or self.static_extra > 0 or self.braked):
            return Dry.NONE
        if self.smoothing > 0:
            return Dry.SMOOTH
        return Dry.FALLS if self.static_extra > 0 and self.stribeck_rate > 0 else Dry.DROPS

    def without_sticking(self) -> Friction:
        """The same without dry friction that is a set at rest."""
        return Friction(self.viscous) if self.dry.is_set else self


@dataclass(frozen=True)
class Motor:
    """A motor, joint side: rotor inertia [kg*m^2], friction; and its electric side where a voltage drives it.

    ``resistance`` [ohm], ``back_emf`` [V*s/rad] and ``torque_constant`` [N*m/A] after the reducer, ``inductance`` [H].
    """

    inertia: float
    friction: Friction = Friction()
    resistance: float | None = None
    back_emf: float = 0.0
    torque_constant: float = 1.0
    inductance: float = 0.0


@dataclass(frozen=True)
class Gear:
    """An elastic gear between motor and joint.

    ``stiffness`` [N*m/rad] of each range of the torque, rising ``limits`` [N*m] between the ranges (K1/K2/K3 with
    T1/T2; one number and no limit: linear); ``damping`` [N*m*s/rad]; ``backlash`` [rad] half-width of the play.
    """

    stiffness: tuple[float, ...]
    limits: tuple[float, ...] = ()
    damping: float = 0.0
    backlash: float = 0.0


@dataclass(frozen=True)
class ParallelSpring:
    """Between the links of a joint, next to what drives it: -stiffness (q - rest) - damping q' on its coordinate q.

    ``stiffness`` [N*m/rad or N/m], ``rest`` [rad or m], ``damping`` [N*m*s/rad or N*s/m].
    """

    stiffness: float
    rest: float = 0.0
    damping: float = 0.0


class Axis(NamedTuple):
    """A coordinate of a joint: its name among the coordinates of the chain, its unit, its drive."""

    name: str
    joint: Joint
    coordinate: Coordinate
    drive: DriveKind

    @property
    def motor(self) -> str:
        """Name of its motor's coordinate."""
        return f"{self.name}.motor"

    @property
    def element(self) -> str:
        """Name of the elastic element that alone says where the joint is: a gear, or a spring of a joint without drive.

        Empty where there is none.
        """
        if self.drive.has_gear:
            return f"{self.name}.gear"
        return f"{self.name}.spring" if self.joint.spring and not self.drive.is_driven else ""

    @property
    def rest(self) -> float:
        """Where that element is relaxed [rad or m], but for one whose motor turns."""
        spring = None if self.drive.has_gear else self.joint.spring
        return spring.rest if spring else self.joint.rest


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint: ``axis`` (3,), a unit vector in the joint frame; ``friction`` acts on the joint's own rates.

    ``drive``, ``motor``, ``gear``, ``friction`` and ``spring`` are those of each of its coordinates; ``drives``: where
    the kinds of drive differ between them. ``parameters``: further numbers of its kind;
    ``drive_parameters``: of its kind of drive.
    """

    name: str
    kind: JointKind
    placement: Placement = field(default_factory=Placement)
    axis: Array = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    drive: DriveKind = field(default_factory=partial(drive_kind, "effort"))
    motor: Motor | None = None
    gear: Gear | None = None
    friction: Friction = Friction()
    spring: ParallelSpring | None = None
    rest: float = 0.0
    """Where the locked motor of a spring stands [rad or m]."""
    lower: float = -np.inf
    upper: float = np.inf
    parameters: tuple[float, ...] = ()
    drive_parameters: tuple[float, ...] = ()
    drives: tuple[DriveKind, ...] = ()

    @property
    def moves(self) -> bool:
        """Whether it has a coordinate."""
        return self.kind.moves

    @property
    def axes(self) -> tuple[Axis, ...]:
        """Its coordinates."""
        coordinates = enumerate(self.kind.coordinates)
        return tuple(Axis(each.of(self.name), self, each, self.drive_of(k)) for k, each in coordinates)

    @property
    def numbers(self) -> Array:
        """Axis and parameters, as the formulas of its kind take them."""
        return array([*self.axis, *self.parameters])

    def driven_by(self, *drives: DriveKind) -> Joint:
        """The same joint with a kind of drive for each coordinate."""
        return replace(self, drive=drives[0] if drives else self.drive, drives=drives if len(drives) > 1 else ())

    def without_sticking(self) -> Joint:
        """The same joint without dry friction that is a set at rest."""
        motor = self.motor and replace(self.motor, friction=self.motor.friction.without_sticking())
        return replace(self, motor=motor, friction=self.friction.without_sticking())

    def braked(self) -> Joint:
        """The same joint with a brake: on its motor, where it has one."""
        if self.motor is None:
            return replace(self, friction=replace(self.friction, braked=True))
        return replace(self, motor=replace(self.motor, friction=replace(self.motor.friction, braked=True)))

    def drive_of(self, place: int) -> DriveKind:
        """The kind of drive of one of its coordinates."""
        return self.drives[place] if self.drives else self.drive

    def placed(self, q: Sequence[float]) -> Placement:
        """The link's frame in the joint's at coordinates q."""
        return Placement(*self.kind.placement(q, [*map(number, self.numbers)]))


@dataclass(frozen=True, eq=False)
class Node:
    """A joint and the link it carries; ``parent`` is an index of an earlier node, -1 for the base."""

    name: str
    parent: int
    joint: Joint
    link: Link


@dataclass(frozen=True, eq=False)
class Point:
    """A named point of a node's link at s (1, its tip, for a rigid link too), offset in the section's axes."""

    name: str
    node: int
    s: float = 1.0
    offset: Placement = field(default_factory=Placement)


@dataclass(frozen=True, eq=False)
class Chain:
    """The whole tree. ``base`` places it in the world; ``gravity`` (3,) [m/s^2] in world axes; ``tip`` is a Point.

    ``couplings`` (square, one row per elastic drive): gear inputs = couplings @ motor angles; None: each its own.
    ``equations``: which ones move it, with ``parameters`` of their own.
    """

    name: str
    nodes: tuple[Node, ...]
    gravity: Array
    base: Placement = field(default_factory=Placement)
    points: tuple[Point, ...] = ()
    couplings: Array | None = None
    equations: str = "recursion"
    parameters: Mapping[str, float] = field(default_factory=dict)

    @property
    def axes(self) -> list[Axis]:
        """The coordinates of all joints, in their order."""
        return [axis for node in self.nodes for axis in node.joint.axes]

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names: ``joint.motor`` of each elastic drive, joints, then ``link.kind`` of each link."""
        axes, bending = self.axes, (node for node in self.nodes if node.link.bends)
        links = (f"{node.name}.{coordinate}" for node in bending for coordinate in node.link.coordinates)
        return *(axis.motor for axis in axes if axis.drive.has_motor), *(axis.name for axis in axes), *links

    @property
    def sliding(self) -> set[str]:
        """Names of the coordinates of joints and motors that are distances [m]."""
        return {name for axis in self.axes if axis.coordinate.slides for name in (axis.name, axis.motor)}

    def units(self, coordinates: Iterable[str]) -> dict[str, str]:
        """Unit of each coordinate: of a joint or motor that slides m, of a link's stretch and shear none, else rad."""
        joints, sliding = {name for axis in self.axes for name in (axis.name, axis.motor)}, self.sliding
        units = {}
        for name in coordinates:
            plain = name not in joints and name.rpartition(".")[2].startswith(("stretch", "shear"))
            units[name] = "-" if plain else "m" if name in sliding else "rad"
        return units

    @property
    def tip(self) -> Point:
        """The point that is called the tip: the first of ``points``, else the end of the last node."""
        return self.points[0] if self.points else Point("tip", len(self.nodes) - 1)


def joint_of_element(name: str) -> str:
    """The joint's coordinate of ``joint.gear`` and of ``joint.spring``."""
    return name.removesuffix(".gear").removesuffix(".spring")


def node_of_line(chain: Chain, name: str) -> Node | None:
    """The node whose link has a line of this name; None for a line that a system draws between its points."""
    nodes = {node.name: node for node in chain.nodes}
    return nodes[name] if name in nodes else nodes.get(name.rpartition(".")[0])


def line_before(chain: Chain, name: str, lines: Sequence[str]) -> str | None:
    """The one of ``lines`` on which a line stands, the nearest towards the base; None for the base."""
    node = node_of_line(chain, name)
    own = [line for line in lines if node_of_line(chain, line) is node]
    if node is not None and name in own and own.index(name):
        return own[own.index(name) - 1]
    while node is not None and node.parent >= 0:
        node = chain.nodes[node.parent]
        if own := [line for line in lines if node_of_line(chain, line) is node]:
            return own[-1]
    return None
