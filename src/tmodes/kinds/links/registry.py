"""The kinds of bending links that tmodes brings; ``@LINKS.register`` adds more by their sheets."""

from __future__ import annotations

from tmodes.kinds.links.modes_sheet import Mode
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.sheet import LINKS, BendingSheet

__all__ = ["LINKS", "BendingSheet", "Mode", "RigidLink"]

LINKS.bring(
    "tmodes.kinds.links",
    {"strain": "beam_sheet", "segments": "beam_sheet", "rigid": "beam_sheet", "modes": "modes_beam"},
)
