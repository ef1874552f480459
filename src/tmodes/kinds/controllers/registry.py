"""The controllers that tmodes brings; ``@CONTROLLERS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.controllers.contract import CONTROLLERS, Block, Controller, LinearPlant, Measured, OwnState, Port

__all__ = ["CONTROLLERS", "Block", "Controller", "LinearPlant", "Measured", "OwnState", "Port"]

CONTROLLERS.bring(
    "tmodes.kinds.controllers",
    {
        "pd": "pd",
        "pid": "pid",
        "sampled_pid": "pid",
        "state_feedback": "state_feedback",
        "gravity_pd": "model_based",
        "computed_torque": "model_based",
        "feedback_linearisation": "model_based",
        "lqr": "state_space",
        "lqg": "lqg",
        "pole_placement": "state_space",
        "loop_shaping": "loop_shaping",
        "notch": "filters",
        "low_pass": "filters",
        "lead_lag": "filters",
        "disturbance_observer": "disturbance_observer",
        "passivity_based": "passivity_based",
        "singular_perturbation": "singular_perturbation",
        "impedance": "impedance",
        "force": "force",
        "feed_forward": "feed_forward",
    },
)
