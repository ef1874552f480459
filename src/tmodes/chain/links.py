"""From the sheet of a link to nodes of a chain."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from tmodes.chain.chain import Body, Joint, Node, Placement, RigidLink
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.sheet import LoweredLink, Spot, moved_body, placed, sheet_body
from tmodes.sheet.parts import LinkSheet

__all__ = ["Lowered", "Spot", "lowered_link", "placed"]


@dataclass(frozen=True)
class Lowered:
    """The nodes of a link, and where its places are.

    ``tip``: the tip frame in the chain's tip frame of the last node; ``undeformed``: the tip frame in the link's frame
    as it is at rest; ``spot``: the place of a station.
    """

    nodes: tuple[Node, ...]
    tip: Placement
    undeformed: Placement
    spot: Callable[[float], Spot]


def lowered_link(link: LinkSheet, node: Node, frame: Placement, chord: float) -> Lowered:
    """Nodes of a link that hangs on the joint of ``node``.

    ``frame``: the link's frame in the frame that the joint has moved; ``chord`` [m]: distance of a rigid link's tip
    frame from its own frame along x.
    """
    if link.beam is None:
        return _rigid(link, node, frame, chord)
    info = link.beam.lowered(link.bodies)
    return _bending(info, node, frame) if info.bends else _rigid_beam(info, node, frame)


def _rigid(link: LinkSheet, node: Node, frame: Placement, chord: float) -> Lowered:
    bodies = tuple(sheet_body(body, frame) for body in link.bodies)
    out = Placement(position=np.array([chord, 0.0, 0.0]))
    tip = frame @ out
    return Lowered((replace(node, link=RigidLink(bodies)),), tip, out, lambda _: Spot(0, 1.0, tip))


def _rigid_beam(info: LoweredLink, node: Node, frame: Placement) -> Lowered:
    """A beam that does not bend, as one rigid link."""

    def spot(s: float) -> Spot:
        return Spot(0, 1.0, frame @ info.spot(s).placement)

    bodies = tuple(moved_body(body, frame) for link in info.links for body in link.all_bodies)
    nodes = (replace(node, link=replace(info.rigid, bodies=bodies)),)
    return Lowered(nodes, frame @ info.tip, info.undeformed, spot)


def _bending(info: LoweredLink, node: Node, frame: Placement) -> Lowered:
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

    return Lowered(tuple(nodes), info.tip, info.undeformed, spot)


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
