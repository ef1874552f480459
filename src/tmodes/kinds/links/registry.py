"""The kinds of bending links that tmodes brings; ``@LINKS.register`` adds more by their sheets."""

from __future__ import annotations

from tmodes.kinds.links import beam_sheet, modes_beam
from tmodes.kinds.links.modes_sheet import Mode
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.sheet import LINKS, BendingSheet

__all__ = ["BUILT_IN", "LINKS", "BendingSheet", "Mode", "RigidLink"]

BUILT_IN = (beam_sheet, modes_beam)
"""The modules whose members are registered."""
