"""Joints whose drives command an effort, a torque or a voltage: free under the first value, or held by name."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from command import tmodes
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.sheet import Robot

WEIGHT = 9.81 * 0.5
"""Of 1 kg at 0.5 m [N*m]."""


def sheet(command: str, value: float, **joint: Any) -> dict[str, Any]:
    """A pendulum about y that hangs along z."""
    knee = {"name": "knee", "type": "revolute", "axis": [0, 1, 0], "child": "shank", **joint}
    signal = {"type": "constant", "value": value}
    body = {"mass": 1.0, "center": [0, 0, -0.5], "inertia": 0.01}
    return {
        "format": 1, "kind": "arm", "name": "knee", "gravity": 9.81, "joints": [knee],
        "links": [{"name": "shank", "bodies": [body]}], "tip": {"link": "shank", "position": [0, 0, -1]},
        "drives": [{"joint": "knee", "command": command, "signal": signal}],
        "integration": {"duration": 1.0, "output_step": 0.01},
    }  # fmt: skip


MOTOR = {"inertia": 0.05, "side": "joint"}
ELECTRIC = MOTOR | {"resistance": 2.0, "back_emf_constant": 0.5, "torque_constant": 0.5}


@pytest.mark.parametrize(("command", "value", "motor"), [("effort", 2.0, MOTOR), ("torque", 2.0, MOTOR),
                                                         ("voltage", 8.0, ELECTRIC)])  # fmt: skip
def test_the_effort_of_a_drive_turns_a_joint_against_its_weight(command, value, motor):
    rest = robot_rest(Robot.from_data(sheet(command, value, motor=motor)), efforts=True)
    assert dict(rest.efforts) == {"knee": pytest.approx(2.0)}
    assert rest.named["knee"] == pytest.approx(np.arcsin(2.0 / WEIGHT), rel=1e-9)
    assert rest.stable


def test_a_torque_winds_up_the_gear_behind_which_it_acts():
    arm = sheet("torque", 2.0, motor=MOTOR, gear={"stiffness": 100.0, "damping": 1.0})
    rest = robot_rest(Robot.from_data(arm), efforts=True)
    assert rest.named["knee"] == pytest.approx(np.arcsin(2.0 / WEIGHT), rel=1e-9)
    assert rest.named["knee.motor"] - rest.named["knee"] == pytest.approx(0.02, rel=1e-9)


def test_a_joint_that_is_held_feels_no_effort():
    robot = Robot.from_data(sheet("effort", 2.0, motor=MOTOR))
    for rest in (robot_rest(robot, held={"knee": 0.3}, efforts=True), robot_rest(robot, held={"knee": 0.3})):
        assert rest.named["knee"] == 0.3
        assert not rest.efforts


def test_static_says_which_robot_and_which_joints_are_free(tmp_path):
    file = tmp_path / "knee.yaml"
    file.write_text(json.dumps(sheet("effort", 2.0, motor=MOTOR) | {"real": {"links.shank.bodies.0.mass": 2.0}}))
    info = json.loads(tmodes("static", file, "--json").stdout)
    assert info["of"] == "nominal robot"
    assert info["efforts"] == {"knee": 2.0}
    assert info["held"] == []
    assert info["coordinates"]["knee"] == pytest.approx(np.arcsin(2.0 / WEIGHT), rel=1e-9)
    assert json.loads(tmodes("static", file, "--hold", "knee=0.3", "--json").stdout)["held"] == ["knee"]
    first, second = tmodes("static", file).stdout.splitlines()[:2]
    assert "nominal robot" in first
    assert "knee free" in second
