"""Coordinates that a sheet names, in controllers and in its initial state, are those that the robot has."""

from __future__ import annotations

from typing import Any

import pytest

from random_chains import random_chain
from tmodes.errors import InputError, InputErrors
from tmodes.kinds.controllers.contract import Measured
from tmodes.model.model import Model
from tmodes.sheet import Robot

SHEET: dict[str, Any] = {
    "format": 1, "kind": "arm", "name": "one",
    "joints": [{"name": "joint", "type": "revolute", "child": "link", "axis": [0, 0, 1],
                "motor": {"inertia": 0.002, "side": "joint"}, "gear": {"stiffness": 1.5, "damping": 0.0}}],
    "links": [{"name": "link", "bodies": [{"mass": 0.1, "center": [0.1, 0, 0], "inertia": 1e-6}]}],
    "tip": {"link": "link"},
    "drives": [{"joint": "joint", "command": "position", "signal": {"type": "constant", "value": 0.0},
                "controller": {"type": "state_feedback", "position_gains": {"joint.motor": 60.0, "joint": -58.0}}}],
}  # fmt: skip


@pytest.mark.parametrize(
    "path",
    ["drives.0.controller.position_gains.joint.current", "drives.0.controller.velocity_gains.joint.current",
     "drives.0.controller.rest.link.bend_y1", "drives.0.controller.position_gains.jiont",
     "initial.coordinates.link.bend_y1", "initial.rates.joint.current", "initial.coordinates.elbow"],
)  # fmt: skip
def test_a_name_that_is_no_coordinate_is_refused_with_the_sheet(path: str) -> None:
    with pytest.raises(InputErrors) as caught:
        Robot.from_data(SHEET).with_({path: 1.0})
    (error,) = caught.value.errors
    assert error.which == path
    assert "joint.motor" in error.expected


def test_what_controllers_are_asked_for_at_run_time_is_refused_by_name() -> None:
    with pytest.raises(InputError, match="elbow"):
        Measured(0.0, 0.0, 0.0, 0.0, 0.0, names=("joint",)).coordinate("elbow")


@pytest.mark.parametrize("seed", range(20))
def test_coordinates_of_a_chain_are_those_of_its_model(seed: int) -> None:
    chain = random_chain(seed)
    assert chain.coordinates == Model(chain).coordinates
