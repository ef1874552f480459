"""A tip that no joint moves shows nothing: it is said, and the farthest body stands for it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from see.runs import HOLD, sheet
from tmodes.analysis.consequences import consequences
from tmodes.analysis.headline_point import HeadlinePoint, headline_point
from tmodes.report.data import page_data
from tmodes.result import Result
from tmodes.sheet import Robot

MOVE = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.3}


def turning(center: list[float], tip: list[float] | None = None, **joint: Any) -> dict[str, Any]:
    """One joint on an elastic gear with a body, and a tip on its axis unless it is given."""
    own = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 0, 1],
           "motor": {"inertia": 0.01, "side": "joint"}, "gear": {"stiffness": 20.0, "damping": 0.01}}  # fmt: skip
    drive = {"joint": "j", "command": "position", "signal": MOVE,
             "controller": {"type": "pd", "position_gain": 500.0, "velocity_gain": 10.0}}  # fmt: skip
    links = [{"name": "l", "bodies": [{"mass": 1.0, "center": center, "inertia": 0.01}]}]
    integration = {"duration": 1.5, "output_step": 0.002}
    return sheet(joints=[own | joint], links=links, drives=[drive], integration=integration) | (
        {"tip": {"link": "l", "position": tip}} if tip else {}
    )


def stands(robot: Robot) -> HeadlinePoint | None:
    """What stands for the tip of a robot."""
    return headline_point(robot, robot.chain())


def test_the_farthest_body_stands_for_the_tip(tmp_path: Any) -> None:
    """Error and residual vibration are those of the body, 0.2 m from the axis, whose gear swings by 240 mrad."""
    robot = Robot.from_data(turning([0.2, 0, 0]))
    assert any("tip" in one for one in consequences(robot))
    result = tmodes.run(robot)
    summary = result.summary()
    assert summary["point"]["name"].endswith("link l")
    assert any(summary["point"]["reason"] in one for one in result.warnings)
    gear = summary["deformations"]["j.gear"]["max"]
    assert summary["tip_error"]["commanded"]["parts_m"]["gears"] == pytest.approx(0.2 * gear, rel=0.02)
    assert summary["vibration"]["actual"]["amplitude_m"] > 0.03
    assert summary["vibration"]["actual"]["modes"][0]["element"] == "j.gear"
    assert summary["settling"]["move_m"] > 0.05
    assert summary["settling"]["reason"].startswith(summary["point"]["name"])
    assert not any(name.startswith(("deviation", "tip_error")) for name in summary["error"]["figures"])
    result.save(tmp_path / "result.nc")
    assert Result.load(tmp_path / "result.nc").summary() == summary
    page = page_data([result])["runs"][0]
    assert not {"tip_error.commanded", "deviation.max"} & {fact["id"] for fact in page["facts"]}


def test_without_a_point_there_are_no_numbers() -> None:
    """A disc on the axis: no place of a body moves, so that there are angles alone; it says so."""
    summary = tmodes.run(Robot.from_data(turning([0, 0, 0.1]))).summary()
    assert summary["tip_error"] == {}
    assert summary["deviation"] is None
    assert summary["point"] == {"name": "", "reason": summary["point"]["reason"]}
    for one in (summary["settling"], summary["vibration"]["actual"]):
        assert summary["point"]["reason"] in one["reason"]


@pytest.mark.parametrize("seed", range(20))
def test_wherever_the_axis_is(seed: int) -> None:
    """A tip on any axis, anywhere along it, is found, and a tip that is off it is not."""
    random = np.random.default_rng(seed)
    axis = random.normal(size=3)
    axis /= np.linalg.norm(axis)
    along, off = random.uniform(-1, 1) * axis, np.cross(axis, random.normal(size=3))
    origin = {"position": random.normal(size=3).tolist(), "rpy": random.normal(size=3).tolist()}
    own = {"axis": axis.tolist(), "origin": origin}
    assert stands(Robot.from_data(turning([0.2, 0.1, 0], along.tolist(), **own)))
    assert stands(Robot.from_data(turning([0.2, 0.1, 0], (along + 1e-3 * off).tolist(), **own))) is None


def second(**more: Any) -> dict[str, Any]:
    """Two joints in a row, the tip on the axis of the second."""
    first = turning([0.2, 0, 0])
    joint = {"name": "k", "type": "revolute", "parent": "l", "child": "m", "axis": [0, 0, 1]}
    first["joints"].append(joint | more)
    first["links"].append({"name": "m", "bodies": [{"mass": 1.0, "center": [0, 0.3, 0], "inertia": 0.01}]})
    return first


def test_joints_in_a_row() -> None:
    """Both axes through the tip; the first beside it; one that slides; one that is held still; a link that bends."""
    coaxial = stands(Robot.from_data(second()))
    assert coaxial
    assert coaxial.name.endswith("link m")
    assert stands(Robot.from_data(second(origin={"position": [0.4, 0, 0]}))) is None
    assert stands(Robot.from_data(second(type="prismatic"))) is None
    held = second(origin={"position": [0.4, 0, 0]})
    held["drives"] = [{"joint": "j", "command": "prescribed", "signal": HOLD}]
    del held["joints"][0]["gear"], held["joints"][0]["motor"]
    assert stands(Robot.from_data(held))
    bends = second()
    bends["links"][0] = {"name": "l", "beam": {
        "model": "strain", "functions": 1, "length": 0.5, "damping_time": 1e-3,
        "section": {"shape": "round", "diameter": 0.02}, "material": "aluminium_6061"}}  # fmt: skip
    assert stands(Robot.from_data(bends)) is None


@pytest.mark.parametrize("name", ["spong1987", "manutec_r3", "deluca_siciliano1991", "filipovic2010"])
def test_published_robots_show_their_motion(name: str) -> None:
    assert stands(tmodes.load(name)) is None
