"""The kinds of joints that tmodes brings; ``@JOINTS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.joints import fixed, prismatic, revolute, universal
from tmodes.kinds.joints.contract import JOINTS, Coordinate, JointKind

__all__ = ["BUILT_IN", "JOINTS", "Coordinate", "JointKind", "joint_kind"]

BUILT_IN = (revolute, prismatic, fixed, universal)
"""The modules whose members are registered."""


def joint_kind(name: str) -> JointKind:
    """The kind of a name; raises :class:`tmodes.kinds.registry.UnknownKindError`."""
    return JOINTS[name]
