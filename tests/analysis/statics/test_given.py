"""Numbers that are given in Python and at --at: with units as in a sheet, and angles of many turns are doubted."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.analysis.describe.describe import describe
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import equilibrium
from tmodes.analysis.statics.loads import Load
from tmodes.errors import InputError
from tmodes.io.sheet_plausible import implausible_numbers
from tmodes.model.model import Model
from tmodes.sheet import Robot

SHEET: dict[str, Any] = {
    "format": 1, "kind": "arm", "name": "two",
    "joints": [
        {"name": "slide", "type": "prismatic", "child": "cart", "axis": [1, 0, 0]},
        {"name": "elbow", "type": "revolute", "child": "rod", "axis": [0, 1, 0],
         "motor": {"inertia": 1e-3, "side": "joint"}, "gear": {"stiffness": "80 Nm/rad", "damping": "0.1 Nms/rad"}},
    ],
    "links": [
        {"name": "cart", "bodies": [{"mass": 1.0, "inertia": 0.01}]},
        {"name": "rod", "bodies": [{"mass": 0.5, "center": [0.3, 0, 0], "inertia": "100 kgcm²"}]},
    ],
    "tip": {"link": "rod", "position": [0.6, 0, 0]},
    "drives": [
        {"joint": "slide", "command": "prescribed", "signal": {"type": "constant", "value": 0.0}},
        {"joint": "elbow", "command": "prescribed", "signal": {"type": "constant", "value": 0.0}},
    ],
}  # fmt: skip


@pytest.fixture(scope="module")
def robot() -> Robot:
    return Robot.from_data(SHEET)


def test_held_coordinates_take_text_with_a_unit(robot: Robot) -> None:
    with_text = robot_rest(robot, held={"elbow.motor": "45deg", "slide": "20 cm"}).q
    np.testing.assert_array_equal(with_text, robot_rest(robot, held={"elbow.motor": math.pi / 4, "slide": 0.2}).q)


def test_starts_rates_and_loads_take_text_with_a_unit(robot: Robot) -> None:
    model, load = Model(robot.chain()), Load("tip", ["0.01 kN", 0, "-2 N"], ["20 Ncm", 0, 0])
    np.testing.assert_allclose(load.wrench(), [10.0, 0.0, -2.0, 0.2, 0.0, 0.0], rtol=1e-14)
    with_text = equilibrium(model, [load], start={"elbow": "10 deg"}, rates={"slide": "3 m/s", "elbow.motor": "30 rpm"})
    numbers = equilibrium(model, [load], start={"elbow": math.pi / 18}, rates={"slide": 3.0, "elbow.motor": math.pi})
    np.testing.assert_allclose(with_text.q, numbers.q, rtol=1e-14)


@pytest.mark.parametrize(
    "held", [{"elbow": "45 kg"}, {"elbow": "x"}, {"elbow": None}, {"elbow": math.nan}, {"elbow": [1]}, {"elbow": True},
             {"slide": "45 deg"}, {"elbow": 1e9}, {"elbwo": 1.0}]
)  # fmt: skip
def test_what_is_no_value_of_a_coordinate_is_refused(robot: Robot, held: dict[str, Any]) -> None:
    cases: list[dict[str, Any]] = [{"held": held}, {"start": held}, {"rates": held}]
    for given in cases:
        with pytest.raises(InputError):
            equilibrium(Model(robot.chain()), **given)


@pytest.mark.parametrize("force", ["10 N", [1, 2], [1, 2, "3 kg"], None, [1, 2, math.nan], np.zeros((3, 3))])
def test_what_is_no_force_is_refused(force: Any) -> None:
    with pytest.raises(InputError, match="force"):
        Load("tip", force).wrench()


def test_a_pose_of_more_than_a_turn_is_doubted(robot: Robot) -> None:
    def doubts(value: float | str) -> list[list[str]]:
        held = {"elbow.motor": value}
        found = (describe(robot, held)["warnings"], vibrations(robot, held=held).warnings)
        return [[one for one in warnings if "turns" in one] for warnings in found]

    assert all(len(one) == 1 and '"45 deg"' in one[0] for one in doubts(45.0))
    assert doubts("45 deg") == doubts(-3.0) == [[], []]


@pytest.mark.parametrize(
    ("changes", "doubted"),
    [
        ({"initial.coordinates.elbow": 90.0}, True), ({"initial.coordinates.elbow": 1.5}, False),
        ({"joints.elbow.limits": {"lower": -170.0, "upper": 2.0}}, True),
        ({"joints.elbow.limits": {"lower": -12.0, "upper": 12.0}}, False),
        ({"joints.elbow.limits.upper": 31.4159}, False), ({"joints.elbow.limits.upper": 5000.0}, None),
    ],
)  # fmt: skip
def test_angles_of_a_sheet_that_look_like_degrees(robot: Robot, changes: dict[str, Any], doubted: bool | None) -> None:
    found = [one for one in implausible_numbers(robot.with_(changes)) if "turns" in one]
    assert bool(found) is bool(doubted)


def test_a_sheet_takes_no_assignment(robot: Robot) -> None:
    for sheet, name, value in ((robot, "gravity", 0), (robot, "gravty", 0), (robot.joints[1].gear, "stiffness", 5)):
        with pytest.raises(tmodes.TmodesError, match=name):
            setattr(sheet, name, value)
    with pytest.raises(tmodes.TmodesError, match="gravity"):
        del robot.gravity
    assert robot.with_({"gravity": "9.81 m/s²"}).gravity == (0.0, 0.0, -9.81)
