"""The page of a robot at rest, without a run, and the first move that could be made of it."""

from __future__ import annotations

from typing import Any

from tmodes.report.data import page_data
from tmodes.result import Result
from tmodes.result.run import movable_joints, run
from tmodes.result.verdict import unjudged
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command

__all__ = ["STILL", "first_move", "rest_page", "standing"]

STILL = 1e-6
"""Length of the run of a robot that is only looked at [s]."""

_TURN, _SLIDE, _TIME = 0.5, 0.1, 1.0
"""A first move of a joint that turns [rad], of one that slides [m], and how long it takes [s]."""


def rest_page(robot: Robot, result: Result | None = None, *, light: bool = False) -> dict[str, Any]:
    """The data of a page on a robot at rest: its shape and its modes, without a run.

    ``result``: of :func:`standing`, where it is there already; ``light``: without the modes.
    """
    page = page_data([result or standing(robot)], [robot.name], light=light)
    page["subtitle"] = f"{robot.title or robot.name}: at rest, with its modes of vibration"
    page["runs"][0] |= {"charts": [], "facts": [], "events": [], "line": None, "warnings": []}
    still = unjudged("The robot stands still: nothing was simulated.")
    page["runs"][0] |= {"status": "at rest", "message": "nothing was simulated", "verdict": still}
    return page


def standing(robot: Robot) -> Result:
    """A run too short for anything to move."""
    still = {"integration.duration": STILL, "integration.output_step": STILL, "integration.stop": []}
    still |= {"integration.method": "auto"}  # a fixed step may be longer than that
    return run((robot if robot.drives else _held(robot)).pathless.with_(still))


def _held(arm: Robot) -> Robot:
    """An arm whose joints stand still, where its sheet moves none."""
    if arm.initial.coordinates or arm.initial.rates:
        return arm
    return arm.with_({"drives": [_drive(name, _HOLD) for name, _ in movable_joints(arm.chain())]})


def first_move(robot: Robot) -> list[dict[str, Any]]:
    """Drives that move the first joint of a robot without drives, smoothly and as prescribed, and hold the others."""
    first, *others = [name for name, _ in movable_joints(robot.chain())]
    slides = any(joint.type == "prismatic" for joint in robot.joints if first in joint.coordinates)
    end = _SLIDE if slides else _TURN
    move = {"type": "quintic", "start": 0.0, "end": end, "duration": _TIME, "delay": 0.0}
    return [_drive(first, move), *(_drive(name, _HOLD) for name in others)]


_HOLD = {"type": "constant", "value": 0.0}


def _drive(joint: str, signal: dict[str, Any]) -> dict[str, Any]:
    return {"joint": joint, "command": str(Command.PRESCRIBED), "signal": dict(signal)}
