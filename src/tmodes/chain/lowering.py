"""From the data sheet of a robot to a Chain: frames, joints, drives and points."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node, ParallelSpring, Point
from tmodes.frame import Placement
from tmodes.kinds.drives.contract import DriveKind
from tmodes.kinds.drives.drive import FrictionSheet, MotorSheet
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.joint import JointSheet, MeasuredFrom
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.registry import RigidLink
from tmodes.kinds.links.sheet import LoweredLink, Spot, moved_body, placed, sheet_body
from tmodes.kinds.noted.functions import zeros
from tmodes.kinds.schema.axes import unit
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command, LinkSheet, TipSheet
from tmodes.sheet.topology import last_link, parents, rooted_order

__all__ = ["LoweredNodes", "Spot", "lowered", "lowered_link", "placed"]


class _Hung(NamedTuple):
    """A lowered link and the index of its first node in the chain."""

    first: int
    link: LoweredNodes

    @property
    def last(self) -> int:
        return self.first + len(self.link.nodes) - 1


def lowered(robot: Robot) -> Chain:
    """The chain of a robot; see :meth:`tmodes.sheet.Robot.chain`."""
    names, hung, nodes = parents(robot.joints), {}, []
    for index in rooted_order(robot.joints):
        joint = robot.joints[index]
        holder: _Hung | None = hung.get(names[index])
        placement, frame = _frames(joint, holder)
        node = Node(joint.child, holder.last if holder else -1, _joint(joint, placement, robot), RigidLink())
        chord = joint.dh.chord() if joint.dh else 0.0
        sheet = robot.link(joint.child)
        link = lowered_link(sheet, node, frame, chord)
        hung[joint.child] = _Hung(len(nodes), link)
        first, *rest = link.nodes  # each but the first hangs on the one before
        nodes += [first, *(replace(each, parent=k) for k, each in enumerate(rest, len(nodes)))]
    tip = robot.tip or TipSheet(link=last_link(robot.joints))
    points = [("tip", tip), *((point.name, point) for point in robot.points)]
    return Chain(
        name=robot.name,
        nodes=tuple(nodes),
        gravity=np.array(robot.gravity),
        base=placed(robot.base),
        points=tuple(_point(name, point, hung) for name, point in points),
        couplings=_couplings(robot, nodes),
        equations=robot.equations,
        parameters=dict(robot.parameters),
    )


def _frames(joint: JointSheet, holder: _Hung | None) -> tuple[Placement, Placement]:
    """The joint's frame in the chain's tip frame of its parent, and the link's frame in the joint's moved one."""
    tip = holder.link.tip if holder else Placement()
    if joint.measured_from is MeasuredFrom.FRAME and holder:
        tip = tip @ holder.link.undeformed.inverse()
    if joint.dh:
        return tip @ Placement(*joint.dh.before()), Placement(*joint.dh.after())
    return tip @ placed(joint.origin), Placement()


def _joint(sheet: JointSheet, placement: Placement, robot: Robot) -> Joint:
    axis, parameters = unit(sheet.axis) if sheet.axis else np.array([0.0, 0.0, 1.0]), sheet.numbers
    if sheet.is_locked:
        still = Placement(*sheet.kind.placement([sheet.locked_at] * sheet.kind.size, [*axis, *parameters]))
        return Joint(sheet.name, joint_kind("fixed"), placement @ still, axis)
    drives, limits = tuple(_drive(sheet, name, robot) for name in sheet.coordinates), sheet.limits
    drive, gear = drives[0], sheet.gear
    gear = Gear(gear.stiffness, gear.torque_limits, gear.damping, gear.backlash) if gear else None
    spring = ParallelSpring(*(value for _, value in sheet.spring)) if sheet.spring else None
    lower, upper = (limits.lower, limits.upper) if limits else (None, None)
    return Joint(
        name=sheet.name,
        kind=sheet.kind,
        placement=placement,
        axis=axis,
        drive=drive,
        motor=_motor(sheet.motor) if sheet.motor and drive.takes_effort else None,
        gear=gear if drive.has_gear else None,
        friction=_friction(sheet.friction),
        spring=spring,
        rest=sheet.locked_at,
        lower=-np.inf if lower is None else lower,
        upper=np.inf if upper is None else upper,
        parameters=parameters,
        drive_parameters=sheet.drive_numbers,
        drives=drives if len({*drives}) > 1 else (),
    )


def _drive(sheet: JointSheet, coordinate: str, robot: Robot) -> DriveKind:
    if not sheet.is_active:
        return drive_kind("spring" if sheet.is_elastic else "free")
    kind = drive_kind(sheet.drive or ("elastic" if sheet.is_elastic else "effort"))
    commands = [drive.command for drive in robot.drives if drive.joint == coordinate]
    return drive_kind("prescribed") if Command.PRESCRIBED in commands and not kind.has_motor else kind


def _friction(sheet: FrictionSheet | None) -> Friction:
    if sheet is None:
        return Friction()
    rates = sheet.stribeck_rate or 0.0, sheet.smoothing or 0.0
    return Friction(sheet.viscous, *sheet.dry, *rates)


def _motor(sheet: MotorSheet) -> Motor:
    info = sheet.at_joint()
    return Motor(
        inertia=info.inertia,
        friction=Friction(info.viscous, info.coulomb, info.static_extra, info.stribeck_rate, info.smoothing),
        resistance=info.resistance,
        back_emf=info.back_emf,
        torque_constant=info.torque_constant,
        inductance=info.inductance,
    )


def _point(name: str, sheet: TipSheet, hung: dict[str, _Hung]) -> Point:
    first, link = hung[sheet.link]
    spot = link.spot(1.0 if sheet.at is None else sheet.at)
    return Point(name, first + spot.node, spot.s, spot.placement @ placed(sheet))


def _couplings(robot: Robot, nodes: list[Node]) -> NDArray[np.float64] | None:
    """Gear inputs over motor angles, in the order of the nodes with an elastic drive; None where each has its own."""
    if not robot.couplings:
        return None
    names = [axis.name for node in nodes for axis in node.joint.axes if axis.drive.has_motor]
    given = [factor for factors in robot.couplings.values() for factor in factors.values()]
    matrix = np.eye(len(names)) + zeros((len(names), len(names)), given)
    for joint, factors in robot.couplings.items():
        row = names.index(joint)
        matrix[row] = 0.0
        for motor, factor in factors.items():
            matrix[row, names.index(motor)] = factor
    return matrix


@dataclass(frozen=True)
class LoweredNodes:
    """The nodes of a link, and where its places are.

    ``tip``: the tip frame in the chain's tip frame of the last node; ``undeformed``: the tip frame in the link's frame
    as it is at rest; ``spot``: the place of a station.
    """

    nodes: tuple[Node, ...]
    tip: Placement
    undeformed: Placement
    spot: Callable[[float], Spot]


def lowered_link(link: LinkSheet, node: Node, frame: Placement, chord: float) -> LoweredNodes:
    """Nodes of a link that hangs on the joint of ``node``.

    ``frame``: the link's frame in the frame that the joint has moved; ``chord`` [m]: distance of a rigid link's tip
    frame from its own frame along x.
    """
    if link.beam is None:
        return _rigid(link, node, frame, chord)
    info = link.beam.lowered(link.bodies)
    return _bending(info, node, frame) if info.bends else _rigid_beam(info, node, frame)


def _rigid(link: LinkSheet, node: Node, frame: Placement, chord: float) -> LoweredNodes:
    bodies = tuple(sheet_body(body, frame) for body in link.bodies)
    out = Placement(position=np.array([chord, 0.0, 0.0]))
    tip = frame @ out
    return LoweredNodes((replace(node, link=RigidLink(bodies)),), tip, out, lambda _: Spot(0, 1.0, tip))


def _rigid_beam(info: LoweredLink, node: Node, frame: Placement) -> LoweredNodes:
    """A beam that does not bend, as one rigid link."""

    def spot(s: float) -> Spot:
        return Spot(0, 1.0, frame @ info.spot(s).placement)

    bodies = tuple(moved_body(body, frame) for link in info.links for body in link.all_bodies)
    along = info.rigid.beam.seen_from(frame) if info.rigid.beam else None
    nodes = (replace(node, link=replace(info.rigid, bodies=bodies, beam=along)),)
    return LoweredNodes(nodes, frame @ info.tip, info.undeformed, spot)


def _bending(info: LoweredLink, node: Node, frame: Placement) -> LoweredNodes:
    """The elements of a link in a row, joined rigidly."""
    root, joint = _root(node, frame @ info.root, info.at_root)
    nodes = list(root)
    for k, link in enumerate(info.links):
        name = node.name if len(info.links) == 1 else f"{node.name}.{k + 1}"
        own = joint if k == 0 else Joint(name, joint_kind("fixed"))
        nodes.append(Node(name, node.parent, own, link))

    def spot(s: float) -> Spot:
        found = info.spot(s)
        return found._replace(node=len(root) + found.node)

    return LoweredNodes(tuple(nodes), info.tip, info.undeformed, spot)


def _root(node: Node, root: Placement, bodies: tuple[Body, ...] = ()) -> tuple[tuple[Node, ...], Joint]:
    """What stands before a beam whose root is at ``root`` in the joint's moved frame, and the joint that carries it.

    Turning the frames of the joint itself is enough where its motion commutes with the offset of the root, as that of
    a revolute joint does whose axis meets the root. Else, and for bodies at the root, a rigid link comes first.
    """
    joint = node.joint
    if joint.kind.commutes(joint.axis, root.rotation, root.position) and not bodies:
        axis = root.rotation.T @ joint.axis if joint.moves else joint.axis
        return (), replace(joint, placement=joint.placement @ root, axis=axis)
    name = f"{node.name}.root"
    first = replace(node, name=name, link=RigidLink(tuple(moved_body(body, root) for body in bodies)))
    return (first,), Joint(name, joint_kind("fixed"), root)
