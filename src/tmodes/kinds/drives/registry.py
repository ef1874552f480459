"""The kinds of drives that tmodes brings; ``@DRIVES.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.drives.contract import DRIVES, Angles, DriveKind, Elastic, Forward

__all__ = ["DRIVES", "Angles", "DriveKind", "Elastic", "Forward", "drive_kind"]

DRIVES.bring(
    "tmodes.kinds.drives",
    {"effort": "effort", "elastic": "elastic", "free": "free", "prescribed": "prescribed", "spring": "spring"},
)


def drive_kind(name: str) -> DriveKind:
    """The kind of a name; raises :class:`tmodes.kinds.registry.UnknownKindError`."""
    return DRIVES[name]
