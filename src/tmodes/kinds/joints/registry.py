"""The kinds of joints that tmodes brings; ``@JOINTS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.joints.contract import JOINTS, Coordinate, JointKind

__all__ = ["JOINTS", "Coordinate", "JointKind", "joint_kind"]

JOINTS.bring(
    "tmodes.kinds.joints",
    {"fixed": "fixed", "prismatic": "prismatic", "revolute": "revolute", "universal": "universal"},
)


def joint_kind(name: str) -> JointKind:
    """The kind of a name; raises :class:`tmodes.kinds.registry.UnknownKindError`."""
    return JOINTS[name]
