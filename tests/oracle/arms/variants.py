"""The same chain, changed in one respect: springs, place in the world, stiffness, order of nodes, frames."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import casadi as ca
import numpy as np

from oracle.arms.line import Line, counts
from tmodes.chain.chain import Chain, Friction, Joint, Node
from tmodes.frame import Placement
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam, BeamPiece

__all__ = ["carried", "reordered", "rigidified", "split_placements", "stiffened", "without_springs"]


def _each(chain: Chain, joint: Callable[[Joint], Joint], link: Callable[[Any], Any]) -> Chain:
    nodes = tuple(replace(node, joint=joint(node.joint), link=link(node.link)) for node in chain.nodes)
    return replace(chain, nodes=nodes)


def without_springs(chain: Chain) -> Chain:
    """No stiffness, no damping and no friction anywhere: nothing hides a wrong inertia force."""
    return _each(chain, _slack_joint, lambda link: _scaled_link(link, 0.0, 0.0))


def _slack_joint(joint: Joint) -> Joint:
    gear = replace(joint.gear, stiffness=(0.0,), limits=(), damping=0.0, backlash=0.0) if joint.gear else None
    motor = replace(joint.motor, friction=Friction()) if joint.motor else None
    return replace(joint, gear=gear, motor=motor, friction=Friction())


def stiffened(chain: Chain, factor: float) -> Chain:
    """All links ``factor`` times as stiff, and without damping; the gears as they are."""
    return _each(chain, lambda joint: joint, lambda link: _scaled_link(link, factor, 0.0))


def _scaled_link(link: Any, stiffness: float, damping: float) -> Any:
    if isinstance(link, Beam):
        pieces = tuple(_scaled_piece(piece, stiffness) for piece in link.pieces)
        return replace(link, pieces=pieces, damping_time=damping * link.damping_time)
    if isinstance(link, Segment):
        return replace(
            link,
            stiffness_y=stiffness * link.stiffness_y,
            stiffness_z=stiffness * link.stiffness_z,
            damping_y=damping * link.damping_y,
            damping_z=damping * link.damping_z,
        )
    return link


def _scaled_piece(piece: BeamPiece, factor: float) -> BeamPiece:
    names = ("bend_y", "bend_z", "torsion", "axial", "shear_y", "shear_z")
    changed = {name: tuple(factor * value for value in getattr(piece, name)) for name in names}
    return replace(piece, **changed)


def carried(chain: Chain, placement: Placement) -> Chain:
    """The chain and its gravity carried to another place and direction in the world."""
    gravity = np.asarray(placement.rotation) @ np.asarray(chain.gravity)
    return replace(chain, base=placement @ chain.base, gravity=gravity)


def reordered(chain: Chain, order: list[int]) -> Chain:
    """The nodes in another order (parents before children); ``order[i]`` is the old index of the new node i."""
    new = {old: i for i, old in enumerate(order)} | {-1: -1}
    nodes: list[Node] = [replace(chain.nodes[old], parent=new[chain.nodes[old].parent]) for old in order]
    points = tuple(replace(point, node=new[point.node]) for point in chain.points)
    return replace(chain, nodes=tuple(nodes), points=points)


def split_placements(chain: Chain, placement: Placement) -> Chain:
    """Every joint's placement made of two, with a fixed joint and an empty link between: the same mechanism."""
    nodes: list[Node] = []
    for node in chain.nodes:
        parent = 2 * node.parent + 1 if node.parent >= 0 else -1
        fixed = Joint(f"{node.joint.name}_flange", joint_kind("fixed"), node.joint.placement @ placement.inverse())
        nodes.append(Node(f"{node.name}_flange", parent, fixed, RigidLink()))
        moved = replace(node, parent=len(nodes) - 1, joint=replace(node.joint, placement=placement))
        nodes.append(moved)
    points = tuple(replace(point, node=2 * point.node + 1) for point in chain.points)
    return replace(chain, nodes=tuple(nodes), points=points)


def rigidified(chain: Chain) -> Chain:
    """Every beam as rigid bodies where its sections are when nothing is bent, and a fixed joint at its tip."""
    nodes: list[Node] = []
    tips = {-1: -1}
    for index, node in enumerate(chain.nodes):
        placed = replace(node, parent=tips[node.parent])
        if isinstance(node.link, Beam):
            line = Line(node.link, ca.SX.zeros(sum(counts(node.link))))
            nodes.append(replace(placed, link=RigidLink(_bodies(node.link, line))))
            end = Joint(f"{node.joint.name}_end", joint_kind("fixed"), _numbers(*line.tip))
            nodes.append(Node(f"{node.name}_end", len(nodes) - 1, end, RigidLink()))
        else:
            nodes.append(placed)
        tips[index] = len(nodes) - 1
    points = tuple(replace(point, node=tips[point.node]) for point in chain.points)
    return replace(chain, nodes=tuple(nodes), points=points)


def _numbers(place: Any, axes: Any) -> Placement:
    return Placement(np.array(ca.evalf(ca.SX(axes))), np.array(ca.evalf(ca.SX(place))).ravel())


def _bodies(beam: Beam, line: Line) -> tuple[Body, ...]:
    """Sections and bodies at stations as bodies in the link frame."""
    sections = [
        (_numbers(station.place, station.axes), Body(station.mass, inertia=np.diag(station.inertia)))
        for station in line.stations
    ]
    carried_by = [(_numbers(*line.at(s)), body) for s, body in beam.bodies]
    return tuple(_placed(placement, body) for placement, body in [*sections, *carried_by])


def _placed(placement: Placement, body: Body) -> Body:
    turn = placement.rotation
    return Body(body.mass, placement.position + turn @ body.center, turn @ body.inertia @ turn.T)
