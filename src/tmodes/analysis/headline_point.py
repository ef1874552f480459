"""The point by which a run is judged: the tip, or where that cannot move with the joints, the farthest body."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, Joint, Point
from tmodes.equations.lagrange.registry import SYSTEMS
from tmodes.frame import Placement
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command

__all__ = ["HeadlinePoint", "headline_point"]

Array = NDArray[np.float64]

_TURN = 0.7
"""Change of a joint [rad, m] by which its effect on a point is found."""

_STILL = 1e-9
"""Travel [m] up to which a point does not move."""


class HeadlinePoint(NamedTuple):
    """What stands for a tip that no joint moves: another ``point``, None where there is none, and both in words."""

    point: Point | None
    name: str
    reason: str


def headline_point(robot: Robot, chain: Chain) -> HeadlinePoint | None:
    """What stands for the tip, which lies on the axes of all joints that move; None where the tip shows the motion.

    ``chain``: that of the robot.
    """
    if chain.equations in SYSTEMS:
        return None
    still = {
        drive.joint for drive in robot.drives if drive.command is Command.PRESCRIBED and _keeps(drive.signal, robot)
    }
    moving = [node.joint.name for node in chain.nodes if node.joint.moves and node.joint.name not in still]
    if not moving or _travel(chain, chain.tip, still) > _STILL:
        return None
    tip = f"the tip does not move with any joint that moves ({', '.join(moving[:4])}): it lies on their axes"
    farthest, name = max(_bodies(chain), key=lambda one: _travel(chain, one[0], still), default=(None, ""))
    if farthest is None or _travel(chain, farthest, still) <= _STILL:
        return HeadlinePoint(None, "", f"{tip}, as all bodies do; look at the angles of the joints")
    hint = f"its error, settling and vibration are those of {name}; set `tip` to a point that moves"
    return HeadlinePoint(farthest, name, f"{tip}; {hint}")


def _keeps(signal: Any, robot: Robot) -> bool:
    """Whether a signal has one value all along."""
    powers = signal.schedule(robot.integration.duration).coefficients
    return not powers[:, 1:].any() and bool((powers[:, 0] == powers[0, 0]).all())


def _bodies(chain: Chain) -> Iterator[tuple[Point, str]]:
    """The centre of each body of a rigid link, and the ends of links that bend."""
    for k, node in enumerate(chain.nodes):
        if node.link.bends:
            yield Point("end", k), f"the end of link {node.name}"
        else:
            for body in node.link.all_bodies:
                place = Placement(position=np.asarray(body.center, dtype=float))
                yield Point("body", k, 1.0, place), f"the centre of mass of link {node.name}"


def _travel(chain: Chain, point: Point, still: set[str]) -> float:
    """How far a point moves with one of the joints before it, or infinity where a link that bends carries it [m]."""
    if chain.nodes[point.node].link.bends and point.s > 0:
        return np.inf
    place, k, most = point.offset.position, point.node, 0.0
    while k >= 0:
        joint = chain.nodes[k].joint
        if joint.moves and joint.name not in still:
            most = max(most, _effect(joint, place))
        place = (joint.placement @ joint.placed([0.0] * len(joint.axes)) @ Placement(position=place)).position
        k = chain.nodes[k].parent
        if k >= 0 and chain.nodes[k].link.bends:
            return np.inf
    return most


def _effect(joint: Joint, place: Array) -> float:
    """How far a place of its link moves with a joint's coordinates, one by one and together [m]."""
    turns = [*np.eye(len(joint.axes)), np.ones(len(joint.axes))]
    ends = [joint.placed([_TURN * float(q) for q in turn]) @ Placement(position=place) for turn in turns]
    begin = joint.placed([0.0] * len(joint.axes)) @ Placement(position=place)
    return max(float(np.linalg.norm(end.position - begin.position)) for end in ends)
