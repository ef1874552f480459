"""The hint for a command that is missing names those, and only those, that the joint can take."""

from __future__ import annotations

import itertools
import re
from typing import Any

import pytest

from simulation.sheets import arm
from tmodes.errors import InputErrors
from tmodes.sheet.parts import Command

MOTOR = {"inertia": 0.2, "side": "joint"}
MOTORS: dict[str, Any] = {
    "none": {},
    "plain": {"motor": MOTOR},
    "electric": {"motor": MOTOR | {"resistance": 1.0, "back_emf_constant": 0.5, "torque_constant": 0.5}},
}
GEARS: dict[str, Any] = {
    "none": {},
    "rigid": {"gear": {"stiffness": float("inf"), "damping": 0.0}},
    "elastic": {"gear": {"stiffness": 90.0, "damping": 0.1}},
}


def problem(has: dict[str, Any], command: str | None) -> str:
    """What is wrong with a robot of one joint whose drive has this command; empty where nothing is."""
    drive: dict[str, Any] = {"joint": "j", "signal": {"type": "constant", "value": 0.0}}
    if command:
        drive |= {"command": command}
    if command == "position":
        drive |= {"controller": {"type": "pd", "position_gain": 1.0, "velocity_gain": 1.0}}
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 0, 1], **has}
    links = [{"name": "l", "bodies": [{"name": "b", "mass": 1.0, "center": [0.1, 0, 0]}]}]
    try:
        arm(joints=[joint], links=links, drives=[drive])
    except InputErrors as error:
        return str(error)
    return ""


@pytest.mark.parametrize(("motor", "gear"), [p for p in itertools.product(MOTORS, GEARS) if p != ("none", "elastic")])
def test_the_hint_names_what_is_accepted(motor: str, gear: str) -> None:
    has = MOTORS[motor] | GEARS[gear]
    hint = problem(has, None).partition("add the line")[2]
    accepted = [str(command) for command in Command if not problem(has, str(command))]
    assert re.findall(r"command: (\w+)", hint) == accepted
    assert len(accepted) >= 2
