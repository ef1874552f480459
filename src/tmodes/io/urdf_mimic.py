"""Joints that mimic another: a chain of this program has none, so the whole group is held, and that is reported."""

from __future__ import annotations

from typing import Any

from tmodes.io.urdf_joint import MOVING, Follows, follows
from tmodes.io.urdf_tree import UrdfJoint
from tmodes.io.urdf_values import fault
from tmodes.io.words import nearest, shown

__all__ = ["hold_followers"]


def hold_followers(joints: tuple[UrdfJoint, ...], data: list[dict[str, Any]]) -> str:
    """Lock each joint that mimics, and the one it follows, where the mimic's own equation holds; what was locked.

    The leader stands at zero, or at its limit next to zero. Raises :class:`tmodes.errors.InputError` for a leader
    that does not exist, does not move, or follows another itself.
    """
    info = {joint.name: said for joint in joints if (said := follows(joint))}
    moving = {joint.name: sheet for joint, sheet in zip(joints, data, strict=True) if joint.type in MOVING}
    for joint in joints:
        if joint.name in info:
            _check_leader(joint, info[joint.name].leader, moving, info)
    for name, said in info.items():
        leader = moving[said.leader]
        leader |= {"state": "locked", "locked_at": _next_to_zero(leader)}
        moving[name] |= {"state": "locked", "locked_at": said.factor * leader["locked_at"] + said.offset}
    return _notice(info)


def _check_leader(joint: UrdfJoint, leader: str, moving: dict[str, Any], info: dict[str, Follows]) -> None:
    which = f"joint {joint.name}: mimic"
    if leader not in moving:
        close = nearest(leader, moving)
        hint = f"did you mean {shown(close)}?" if close else "name a joint that moves, or remove <mimic>"
        raise fault(joint.element, which, f"the unknown joint {shown(leader)}", "a joint that moves", hint)
    if leader in info:
        got, hint = f"{shown(leader)}, which mimics {shown(info[leader].leader)} itself", "name that joint instead"
        raise fault(joint.element, which, got, "a joint that moves by itself", hint)


def _next_to_zero(joint: dict[str, Any]) -> float:
    limits = joint.get("limits", {})
    return min(max(0.0, limits.get("lower", 0.0)), limits.get("upper", float("inf")))


def _notice(info: dict[str, Follows]) -> str:
    if not info:
        return ""
    pairs = ", ".join(f"{name} (follows {said.leader})" for name, said in info.items())
    few = pairs if len(pairs) <= 1500 else pairs[:1500] + " ..."
    return f"Joints coupled by mimic are held with those they follow, which is no part of the file: {few}."
