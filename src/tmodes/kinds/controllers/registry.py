"""The controllers that tmodes brings; ``@CONTROLLERS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured, OwnState

__all__ = ["CONTROLLERS", "Controller", "Measured", "OwnState"]

CONTROLLERS.bring(
    "tmodes.kinds.controllers",
    {"pd": "pd", "pid": "pid", "sampled_pid": "sampled_pid", "state_feedback": "state_feedback"},
)
