"""What a joint moves must have mass: a force gives a massless moving end no finite acceleration."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Axis, Chain, Joint, Node
from tmodes.frame import Placement
from tmodes.kinds.links.contract import Body
from tmodes.kinds.noted.functions import array, least_eigenvalue_exceeds, number, sqrt, zeros
from tmodes.kinds.noted.number import is_noted
from tmodes.kinds.schema.axes import cross_matrix
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet import Robot

__all__ = ["Carried", "carried_by_joints", "massless_issues"]

Array = NDArray[np.float64]

NEGLIGIBLE = 1e-13
"""Inertia about an axis over that about the others below which there is none [-]: round-off of a mass on the axis."""


def massless_issues(robot: Robot) -> Iterator[Issue]:
    """Joints that move nothing, each with the link that has no mass.

    The robot is taken as rigid in a general position, so that a mass lies on an axis only where it always does.
    """
    chain = robot.chain()
    yield from _same_names(chain)
    sheets = {joint.name: index for index, joint in enumerate(robot.joints)}
    carried = _carried(chain)
    wrong = {index: got for index in range(len(carried)) if (got := _nothing_moved(chain, index, carried[index]))}
    where = "a link that it carries" if wrong else "a link before it"
    for index, got in (wrong or _dependent(chain, carried)).items():
        number = sheets[chain.nodes[index].joint.name]
        link = robot.joints[number].child
        hint = f"give `{link}`, or {where}, a body with mass and inertia; or fix the joint"
        yield Issue(f"joints.{number}", f"`{link}`, a link that {got}", "a joint that moves mass", hint)


class Carried(NamedTuple):
    """What one joint carries, about its axis, in a general position of the robot.

    ``mass`` [kg]; ``inertia`` [kg*m^2, kg] along its coordinate; ``weight``: what that takes to be held [N*m, N].
    """

    mass: float
    inertia: float
    weight: float


def carried_by_joints(chain: Chain) -> dict[str, Carried]:
    """What each joint of one coordinate carries, by its name."""
    found, turned = {}, []
    for index, (node, moved) in enumerate(zip(chain.nodes, _carried(chain), strict=True)):
        before = turned[node.parent] if node.parent >= 0 else chain.base.rotation
        placed = node.joint.placement @ node.joint.placed(_general(node.joint, index))
        turned.append(before @ placed.rotation)
        subspace = [each.packed() for each in node.joint.kind.subspace(_general(node.joint, index), node.joint.numbers)]
        if len(subspace) == 1:
            column = np.array(subspace[0])
            pull = turned[-1].T @ array(chain.gravity)
            push = moved @ column
            found[node.joint.name] = Carried(number(moved[3, 3]), number(column @ push), abs(number(push[3:] @ pull)))
    return found


def _same_names(chain: Chain) -> Iterator[Issue]:
    """Parts of a link have names of their own, such as ``upper.1``; a link may not be called so too."""
    names = [node.name for node in chain.nodes]
    for name in sorted({name for name in names if names.count(name) > 1}):
        got = f"`{name}`, also the name of a part of a link"
        yield Issue("links", got, "links whose names no part of a link has", "rename the link")


def _nothing_moved(chain: Chain, index: int, moved: Array) -> str:
    """What is missing in the inertia (6, 6), about the joint's frame, that a joint moves; empty when nothing is."""
    joint = chain.nodes[index].joint
    columns = _columns(joint, index)
    if len(columns) and moved[3, 3] <= 0 and not (moved[:3, :3].any() and columns[:, :3].any()):
        return f"has no mass and is moved by `{joint.name}`"
    turning, along = number(np.trace(moved[:3, :3])), number(moved[3, 3])
    for column in columns:
        size = turning * number(column[:3] @ column[:3]) + along * number(column[3:] @ column[3:])
        if number(column @ moved @ column) <= NEGLIGIBLE * size:
            return f"has no inertia about the axis of `{joint.name}`"
    return ""


def _columns(joint: Joint, index: int) -> Array:
    """Motions (k, 6) of the joint's coordinates that have no inertia but that of what they move."""
    free = [k for k, axis in enumerate(joint.axes) if not _has_inertia(axis)]
    found = [each.packed() for each in joint.kind.subspace(_general(joint, index), joint.numbers)]
    return np.array(found).reshape(-1, 6)[free]


def _dependent(chain: Chain, carried: list[Array]) -> dict[int, str]:
    """The first joint that moves no mass but as the joints before it do, so that the mass matrix is singular.

    None where every link that is moved has mass and inertia of its own. The mass matrix is that of the composite rigid
    bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, Table 6.2).
    """
    columns = [_columns(node.joint, index) for index, node in enumerate(chain.nodes)]
    own = [least_eigenvalue_exceeds(_own(node), 0.0) for node, of in zip(chain.nodes, columns, strict=True) if len(of)]
    if all(own):
        return {}
    starts = np.cumsum([0, *map(len, columns)])
    mass = zeros((starts[-1], starts[-1]), *carried, *columns)
    for index, of in enumerate(columns):
        force, at = carried[index] @ of.T, index
        while len(of) and at >= 0:
            block = columns[at] @ force if len(columns[at]) else np.zeros((0, len(of)))
            mass[starts[at] : starts[at + 1], starts[index] : starts[index + 1]] = block
            force, at = _upward(chain, at) @ force, chain.nodes[at].parent
    mass = np.triu(mass) + np.triu(mass, 1).T
    scale = 1 / sqrt(np.diag(mass))
    scaled = mass * np.outer(scale, scale)
    if not len(scaled) or not _singular(scaled):
        return {}
    ends = ((k, starts[k + 1]) for k, of in enumerate(columns) if len(of))
    index = next(k for k, end in ends if _singular(scaled[:end, :end]))
    return {index: f"moves with `{chain.nodes[index].joint.name}` only as it does with the joints before"}


def _singular(scaled: Array) -> bool:
    return (
        not least_eigenvalue_exceeds(scaled, NEGLIGIBLE)
        if is_noted(scaled)
        else bool(np.linalg.eigvalsh(scaled)[0] < NEGLIGIBLE)
    )


def _upward(chain: Chain, index: int) -> Array:
    """What carries a force (6,) in the frame of a node's joint, as it has moved, to that of its parent's."""
    joint, parent = chain.nodes[index].joint, chain.nodes[index].parent
    length = chain.nodes[parent].link.length if parent >= 0 else 0.0
    tip = Placement(position=np.array([length, 0.0, 0.0]))  # of the parent's link in its frame, unbent
    offset = tip @ joint.placement @ joint.placed(_general(joint, index))
    shift = np.block([[np.eye(3), np.zeros((3, 3))], [-cross_matrix(offset.position), np.eye(3)]])
    return shift.T @ np.kron(np.eye(2), offset.rotation)


def _has_inertia(axis: Axis) -> bool:
    """Whether a coordinate needs no mass: its motion is given, or a rotor turns with it."""
    motor = axis.joint.motor
    return axis.drive.is_given or (axis.drive.carries_rotor and motor is not None and motor.inertia > 0)


def _carried(chain: Chain) -> list[Array]:
    """Inertia (6, 6) of all that each node's joint moves, about the frame of the joint as it has moved."""
    inertias = [_own(node) for node in chain.nodes]
    for index in range(len(chain.nodes) - 1, -1, -1):
        node = chain.nodes[index]
        if node.parent >= 0:
            up = _upward(chain, index)
            inertias[node.parent] = inertias[node.parent] + up @ inertias[index] @ up.T
    return inertias


def _own(node: Node) -> Array:
    return sum((_spatial(body) for body in node.link.unbent_bodies()), np.zeros((6, 6)))


def _general(joint: Joint, index: int) -> list[float]:
    """A general position of a joint; no two alike."""
    return [0.5 + float(np.sin(2.0 + 3.0 * index + k)) / 3 for k in range(joint.kind.size)]


def _spatial(body: Body) -> Array:
    """Inertia (6, 6), rotation before translation, about the origin of the frame that carries a body."""
    lever = cross_matrix(body.center)
    upper = [body.inertia - body.mass * lever @ lever, body.mass * lever]
    return np.block([upper, [-body.mass * lever, body.mass * np.eye(3)]])
