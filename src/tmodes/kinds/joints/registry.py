"""The kinds of joints by name."""

from __future__ import annotations

from tmodes.kinds.joints.contract import JointKind
from tmodes.kinds.joints.fixed import Fixed
from tmodes.kinds.joints.prismatic import Prismatic
from tmodes.kinds.joints.revolute import Revolute
from tmodes.kinds.joints.universal import Universal
from tmodes.kinds.registry import Registry

__all__ = ["JOINTS", "joint_kind", "register"]

JOINTS: Registry[JointKind] = Registry("joint", JointKind)
"""Revolute, prismatic, fixed, universal, and what a user registers."""

register = JOINTS.register
"""Decorator of a user's kind of joint."""

for _kind in (Revolute, Prismatic, Fixed, Universal):
    register(_kind)


def joint_kind(name: str) -> JointKind:
    """The kind of a name; raises :class:`tmodes.kinds.registry.UnknownKindError`."""
    return JOINTS.get(name)
