"""The controllers that tmodes brings; ``@CONTROLLERS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.controllers import pd, pid, sampled_pid, state_feedback
from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured, OwnState

__all__ = ["BUILT_IN", "CONTROLLERS", "Controller", "Measured", "OwnState"]

BUILT_IN = (pd, pid, state_feedback, sampled_pid)
"""The modules whose members are registered."""
