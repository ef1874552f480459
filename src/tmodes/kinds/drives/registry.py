"""The kinds of drives that tmodes brings; ``@DRIVES.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.drives import effort, elastic, free, prescribed, spring
from tmodes.kinds.drives.contract import DRIVES, Angles, DriveKind, Elastic, Forward

__all__ = ["BUILT_IN", "DRIVES", "Angles", "DriveKind", "Elastic", "Forward", "drive_kind"]

BUILT_IN = (effort, elastic, spring, free, prescribed)
"""The modules whose members are registered."""


def drive_kind(name: str) -> DriveKind:
    """The kind of a name; raises :class:`tmodes.kinds.registry.UnknownKindError`."""
    return DRIVES[name]
