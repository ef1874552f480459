"""The controllers that tmodes brings; ``Controller.register()`` adds more."""

from __future__ import annotations

from tmodes.kinds.controllers import pd, pid, state_feedback
from tmodes.kinds.controllers.contract import Controller, Measured

__all__ = ["BUILT_IN", "Controller", "Measured"]

BUILT_IN = (pd, pid, state_feedback)
"""The modules whose members are registered."""
