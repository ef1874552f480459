"""Statics do not depend on how the world is turned: the same rest, or the same reason why there is none."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest
from numpy.random import Generator, default_rng

from random_sheets import random_sheet, rotation, turned
from tmodes.analysis.describe.describe import statics_info
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.system import StaticSystem
from tmodes.errors import SimulationError
from tmodes.sheet import Robot

ROBOTS = int(os.environ.get("TMODES_ATTITUDES", "9"))
"""Random robots that are compared, each in two attitudes; by hand 120."""

X, Y, Z = np.eye(3).tolist()
BODY = {"mass": 1.0, "center": [0.3, 0, 0], "inertia": {"xx": 0.02, "yy": 0.1, "zz": 0.1}}
SPRUNG = {"state": "locked", "gear": {"stiffness": 300.0, "damping": 1.0}}


def level(rng: Generator) -> dict[str, Any]:
    """A robot whose axes, weight and surface stand along the axes of the world: exact zeros, which turns take away."""
    count = int(rng.integers(1, 4))
    joints = [{
        "name": f"joint{k}", "type": str(rng.choice(["revolute", "prismatic"])), "axis": [X, Y, Z][rng.integers(3)],
        "parent": f"link{k - 1}" if k else "base", "child": f"link{k}", "origin": {"position": [0.2 * k, 0.1 * k, 0]},
        **([{"state": "free"}, {"state": "free"}, SPRUNG][rng.integers(3)]),
    } for k in range(count)]  # fmt: skip
    normal = [Z, X, [0, 0.6, 0.8]][rng.integers(3)]
    shape = {"type": "plane", "position": [0, 0, -0.05], "normal": normal}
    law = {"law": str(rng.choice(["unilateral", "bilateral"])), "stiffness": 1e4, "damping": 1.0, "velocity": [0, 0, 0]}
    return {
        "format": 1, "kind": "arm", "name": "level", "gravity": [0, 0, float(rng.choice([-9.81, -9.81, 0.0]))],
        "joints": joints, "links": [{"name": f"link{k}", "bodies": [{"name": "body", **BODY}]} for k in range(count)],
        "tip": {"link": f"link{count - 1}", "position": [0.5, 0, 0]}, "loads": [], "drives": [],
        "integration": {"duration": 0.1, "output_step": 0.01}, "initial": {"state": "zero"},
        **({"contact": {**law, "shape": shape}} if rng.random() < 0.6 else {}),
    }  # fmt: skip


def assert_alike(sheet: dict[str, Any], seed: int) -> None:
    one, two = answer(sheet), answer(turned(sheet, rotation(seed)))
    assert one[0] == two[0]
    assert two[1:] == pytest.approx(one[1:], rel=1e-5, abs=1e-6)


def answer(sheet: dict[str, Any]) -> tuple[Any, ...]:
    """Words that must be the same, then numbers that must be alike."""
    try:
        rest = robot_rest(Robot.from_data(sheet))
    except SimulationError as none:
        return (str(none),)
    words = rest.stable, rest.neutral, [mode.coordinate for mode in rest.unstable_modes]
    return words, rest.lowest_frequency_Hz, *rest.q


@pytest.mark.parametrize("seed", range(13, 13 + ROBOTS))
def test_a_level_robot_rests_alike_in_all_attitudes(seed):
    sheet = level(default_rng(seed))
    assert_alike(sheet, 1000 * seed)
    assert_alike(sheet, 1000 * seed + 1)


@pytest.mark.parametrize("structure", range(3))
def test_a_random_robot_rests_alike_in_all_attitudes(structure):
    assert_alike(random_sheet(structure), structure)


def block(slope: list[float]) -> dict[str, Any]:
    """A body that two slides let go in a plane, on a surface across which only one of them is held."""
    slide = {"type": "prismatic", "state": "free"}
    joints = [slide | {"name": "x", "axis": X, "child": "carrier"}, slide | {"name": "z", "axis": Z, "child": "body"}]
    return {
        "format": 1, "kind": "arm", "name": "block", "gravity": [0, 0, -9.81], "joints": joints, "loads": [],
        "links": [{"name": "body", "bodies": [{"name": "body", **BODY, "center": [0, 0, 0]}]}],
        "integration": {"duration": 0.1, "output_step": 0.01}, "initial": {"state": "zero"},
        "contact": {"law": "unilateral", "stiffness": 1e5, "damping": 200.0, "friction": 0.6, "velocity": [0, 0, 0],
                    "shape": {"type": "plane", "position": [0, 0, 0], "normal": slope}},
    }  # fmt: skip


@pytest.mark.parametrize("attitude", [None, 3, 4])
def test_a_slope_without_a_stop_has_no_rest_which_is_found_out_at_once(attitude, monkeypatch):
    sheet = block([0.26, 0.14, 0.9553])
    sheet = sheet if attitude is None else turned(sheet, rotation(attitude))
    poses = []
    own = StaticSystem.stiffness
    monkeypatch.setattr(StaticSystem, "stiffness", lambda *given: poses.append(given) or own(*given))
    with pytest.raises(SimulationError, match="coordinate x has no spring and does not come to rest"):
        robot_rest(Robot.from_data(sheet))
    assert len(poses) < 200


@pytest.mark.parametrize("attitude", [None, 3, 4])
def test_a_body_on_a_level_floor_is_at_rest_wherever_it_is(attitude):
    sheet = block(Z)
    robot = Robot.from_data(sheet if attitude is None else turned(sheet, rotation(attitude)))
    rest = robot_rest(robot)
    assert rest.neutral == ("x",)
    assert statics_info(robot, rest)["neutral"] == ["x"]
    assert not rest.stable
    assert rest.unstable_modes == ()
    assert rest.named["z"] == pytest.approx(-9.81 / 1e5, rel=1e-9)
