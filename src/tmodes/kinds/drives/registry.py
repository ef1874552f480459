"""The kinds of drives by name."""

from __future__ import annotations

from tmodes.kinds.drives.contract import DriveKind
from tmodes.kinds.drives.effort import Effort
from tmodes.kinds.drives.elastic import ElasticDrive
from tmodes.kinds.drives.free import Free
from tmodes.kinds.drives.prescribed import Prescribed
from tmodes.kinds.drives.spring import Spring
from tmodes.kinds.registry import Registry

__all__ = ["DRIVES", "drive_kind", "register"]

DRIVES: Registry[DriveKind] = Registry("drive", DriveKind)
"""Effort, elastic, spring, free, prescribed, and what a user registers."""

register = DRIVES.register
"""Decorator of a user's kind of drive."""

for _kind in (Effort, ElasticDrive, Spring, Free, Prescribed):
    register(_kind)


def drive_kind(name: str) -> DriveKind:
    """The kind of a name; raises :class:`tmodes.kinds.registry.UnknownKindError`."""
    return DRIVES.get(name)
