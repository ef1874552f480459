"""What a joint moves must have mass: a moving end without any has no acceleration that a force would tell."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Axis, Chain, Joint, Node
from tmodes.chain.lowering import lowered
from tmodes.frame import Placement
from tmodes.kinds.links.contract import Body
from tmodes.kinds.schema.axes import cross_matrix
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet import Robot

__all__ = ["massless_issues"]

Array = NDArray[np.float64]

NEGLIGIBLE = 1e-13
"""Inertia about an axis over that about the others below which there is none [-]: round-off of a mass on the axis."""


def massless_issues(arm: Robot) -> Iterator[Issue]:
    """Joints that move nothing, each with the link that has no mass.

    The arm is taken as rigid in a general position, so that a mass lies on an axis only where it always does.
    """
    chain = lowered(arm)
    yield from _same_names(chain)
    sheets = {joint.name: index for index, joint in enumerate(arm.joints)}
    for index, (node, moved) in enumerate(zip(chain.nodes, _carried(chain), strict=True)):
        if got := _nothing_moved(node.joint, index, moved):
            link = arm.joints[sheets[node.joint.name]].child
            hint = f"give `{link}`, or a link that it carries, a body with mass and inertia; or fix the joint"
            expected = "a joint that moves mass"
            yield Issue(f"joints.{sheets[node.joint.name]}", f"`{link}`, a link that {got}", expected, hint)


def _same_names(chain: Chain) -> Iterator[Issue]:
    """Parts of a link have names of their own, such as ``upper.1``; a link may not be called so too."""
    names = [node.name for node in chain.nodes]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield Issue(
            "links",
            f"`{name}`, also the name of a part of a link",
            "links whose names no part of a link has",
            "rename the link",
        )


def _nothing_moved(joint: Joint, index: int, moved: Array) -> str:
    """What is missing in the inertia (6, 6), about the joint's frame, that a joint moves; empty when nothing is."""
    free = [k for k, axis in enumerate(joint.axes) if not _has_inertia(axis)]
    if free and moved[3, 3] <= 0:
        return f"has no mass and is moved by `{joint.name}`"
    columns = np.array([each.packed() for each in joint.kind.subspace(_general(joint, index), joint.numbers)])
    turning, along = float(np.trace(moved[:3, :3])), float(moved[3, 3])
    for column in columns[free]:
        size = turning * float(column[:3] @ column[:3]) + along * float(column[3:] @ column[3:])
        if float(column @ moved @ column) <= NEGLIGIBLE * size:
            return f"has no inertia about the axis of `{joint.name}`"
    return ""


def _has_inertia(axis: Axis) -> bool:
    """Whether a coordinate needs no mass: its motion is given, or a rotor turns with it."""
    return axis.drive.is_given or (axis.drive.carries_rotor and axis.joint.motor is not None)


def _carried(chain: Chain) -> list[Array]:
    """Inertia (6, 6) of all that each node's joint moves, about the frame of the joint as it has moved."""
    inertias = [_own(node) for node in chain.nodes]
    for index in range(len(chain.nodes) - 1, -1, -1):
        node = chain.nodes[index]
        if node.parent >= 0:
            joint = node.joint
            offset = _length(chain.nodes[node.parent]) @ joint.placement @ joint.placed(_general(joint, index))
            inertias[node.parent] = inertias[node.parent] + _seen(inertias[index], offset)
    return inertias


def _own(node: Node) -> Array:
    return sum((_spatial(body) for body in node.link.unbent_bodies()), np.zeros((6, 6)))


def _length(node: Node) -> Placement:
    """The chain's tip frame of a node in its link's frame, unbent."""
    return Placement(position=np.array([node.link.length, 0.0, 0.0]))


def _general(joint: Joint, index: int) -> list[float]:
    """A general position of a joint; no two alike."""
    return [0.5 + float(np.sin(2.0 + 3.0 * index + k)) / 3 for k in range(joint.kind.size)]


def _spatial(body: Body) -> Array:
    """Inertia (6, 6), rotation before translation, about the origin of the frame that carries a body."""
    lever = cross_matrix(body.center)
    upper = [body.inertia - body.mass * lever @ lever, body.mass * lever]
    return np.block([upper, [-body.mass * lever, body.mass * np.eye(3)]])


def _seen(inertia: Array, offset: Placement) -> Array:
    """The inertia of a frame placed at ``offset``, about the origin of the frame around it."""
    turn = np.kron(np.eye(2), offset.rotation)
    shift = np.eye(6)
    shift[3:, :3] = -cross_matrix(offset.position)
    return shift.T @ turn @ inertia @ turn.T @ shift
