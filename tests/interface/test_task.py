"""The task of a sheet: read and written, wrong ones refused, and every command on its path as `follow` writes it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
from command import tmodes as command
from tmodes.errors import InputError, InputErrors
from tmodes.interface.studies import changed_study
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_write import robot_to_yaml
from tmodes.sheet.robot import RobotPair
from tmodes.study.read import study_of_robot

TURN = {"type": "joints", "points": [[0.5]]}
MOVE = {"type": "polynomial", "duration": 0.5}
TASK = {"path": TURN, "profile": MOVE, "tolerance": 0.01}
STILL = {"drives.joint.signal": {"type": "constant", "value": 0.0}, "integration.duration": 0.6}
BARE: dict[str, Any] = {"error_estimate": False, "model_error": False}


def spong(**more: Any) -> Any:
    return tmodes.load("spong1987", STILL | {"task": TASK | more})


@pytest.mark.parametrize("task", [
    {"tolerance": 0.001}, {"path": TURN}, {"path": [TURN, TURN], "reference": "inverse", "least_time": True},
    {"path": {"type": "line", "to": [0.7, 0.0, 0.2], "rpy": [0.0, 0.1, 0.0]}, "fit": 1e-9, "reference": "optimal"},
    {"path": TURN, "profile": {"type": "s_curve", "speed": 0.5, "acceleration": 3.0, "jerk": 60.0, "delay": 0.1}},
    {"path": TURN, "profile": {"type": "toppra", "share": 0.5}, "shaper": {"type": "zvd"}, "tolerance": 0.1},
    {"path": TURN, "shaper": {"type": "ei", "frequencies": [8.0], "damping": [0.1], "tolerated": 0.1}},
])  # fmt: skip
def test_reads_back_as_written(task: dict[str, Any], tmp_path: Path) -> None:
    robot, file = tmodes.load("spong1987", {"task": task}), tmp_path / "robot.yaml"
    file.write_text(robot_to_yaml(robot), encoding="utf-8")
    assert tmodes.load(file) == robot == tmodes.Robot.from_data(sheet_data(robot))
    given = sheet_data(robot)["task"]
    assert {key: given[key] for key in task if key not in ("shaper", "profile", "path")} == {
        key: value for key, value in task.items() if key not in ("shaper", "profile", "path")
    }
    assert not {"start", "end"} & set(given.get("profile", {}))
    assert set(given) == set(task)


@pytest.mark.parametrize(("task", "which"), [
    ({}, "task"), ({"reference": "sag"}, "task.reference"), ({"profile": MOVE, "tolerance": 0.1}, "task.profile"),
    ({"shaper": {"type": "zv"}}, "task.shaper"), ({"least_time": True}, "task.least_time"),
    ({"paht": TURN}, "task.paht"),
    ({"path": "line"}, "task.path"), ({"path": [TURN, {"type": "joints", "pointz": 1}]}, "task.path.1.pointz"),
    ({"path": TURN, "profile": {"type": "quintic", "start": 0.0}}, "task.profile.duration"),
    ({"path": TURN, "least_time": 1}, "task.least_time"), ({"tolerance": "1 kg"}, "task.tolerance"),
])  # fmt: skip
def test_wrong_keys_are_named(task: dict[str, Any], which: str) -> None:
    with pytest.raises(InputErrors) as caught:
        tmodes.load("spong1987", {"task": task})
    assert which in [one.which for one in caught.value.errors]


@pytest.mark.nightly("optimal")
@pytest.mark.parametrize("reference", ["rigid", "motors", "sag", "quasi_static", "inverse", "optimal"])
def test_a_run_is_that_of_the_sheet_that_follow_writes(reference: str, tmp_path: Path) -> None:
    robot, file = spong(reference=reference), tmp_path / "followed.yaml"
    run = robot.run(**BARE)
    found = robot.follow(out=file)
    other = tmodes.load("spong1987", STILL | {"task": {"tolerance": 0.01}})
    assert sheet_data(other.follow(TURN, profile=MOVE, reference=reference).robot) == sheet_data(found.robot)
    again = tmodes.load(file).run(**BARE)
    assert all(np.array_equal(run.data[name], again.data[name], equal_nan=True) for name in again.data)
    assert found.robot.task.tolerance == run.robot.task.tolerance == 0.01
    assert not run.robot.task.paths
    summary = run.summary()
    assert summary["tip_error"] == again.summary()["tip_error"]
    assert summary["verdict"]["largest_m"] == pytest.approx(summary["tip_error"]["commanded"]["max_m"], rel=1e-12)


def test_options_go_before_the_task() -> None:
    robot = spong(reference="sag")
    found = robot.follow(profile={"type": "polynomial", "duration": 0.7}, reference="motors")
    assert (found.reference, found.duration) == ("motors", pytest.approx(0.7))
    assert (robot.follow().reference, robot.follow().duration) == ("sag", pytest.approx(0.5))
    assert robot.with_({"task.profile.duration": "400 ms"}).follow(reference="rigid").duration == pytest.approx(0.4)


@pytest.mark.parametrize(("changes", "which"), [
    ({"drives.joint.signal": {"type": "quintic", "start": 0.0, "end": 1.0, "duration": 1.0}}, "drives.joint.signal"),
    ({"drives.joint.motion": {"type": "constant", "value": 0.0}}, "drives.joint.motion"),
    ({"drives.joint.feed_forward": {"type": "constant", "value": 0.0}}, "drives.joint.feed_forward"),
])  # fmt: skip
def test_a_drive_with_a_motion_of_its_own_is_refused(changes: dict[str, Any], which: str) -> None:
    robot = spong().with_(changes)
    with pytest.raises(InputError) as caught:
        robot.run()
    assert caught.value.which == which
    assert any(which in warning for warning in robot.check().warnings)
    assert not spong().check().warnings


def test_a_path_out_of_reach_is_found_by_check() -> None:
    assert any("path 1" in one for one in spong(path={"type": "line", "to": [9.0, 0.0, 0.0]}).check().warnings)


STIFFNESS, DURATION = "joints.joint.gear.stiffness", "task.profile.duration"
DRAWN = {"k": {"path": STIFFNESS, "distribution": {"type": "uniform", "low": 80.0, "high": 120.0}}}
FIRM = {"drives.0.controller.position_gain": 160.0}
PEAK = {"peak": {"series": "tip_error", "reduce": "max"}}

COMMANDS: dict[str, Callable[[Any], Any]] = {
    "batch": lambda robot: robot.batch(vary={STIFFNESS: (80, 120, 2)}, threads=1).rows.quantities,
    "simulate_batch": lambda robot: tmodes.simulate_batch(robot, {STIFFNESS: [80.0, 90.0]}).states,
    "study": lambda robot: robot.study({"parameters": DRAWN, "plan": {"type": "grid", "levels": 2}, "quantities": PEAK},
                                       threads=1).rows.quantities,
    "gradient": lambda robot: robot.gradient(tmodes.reduced_output("tip_error", "rms"), [STIFFNESS]).by,
    "learn": lambda robot: robot.learn(iterations=1, samples=20).rms,
    "linearize": lambda robot: robot.linearize(time=0.3).system.A,
    "loop": lambda robot: robot.linearize(closed=True).system.A,
    "shaper": lambda robot: robot.shaper(where="path").shaper.frequencies,
    "tune": lambda robot: robot.tune(["drives.0.controller.position_gain"], trials=3).after,
    "compare": lambda robot: robot.compare({"own": {}, "firm": FIRM}).data["nominal_largest_m"].values,
    "outputs": lambda robot: [*robot.outputs],
}  # fmt: skip


@pytest.mark.nightly("tune")
@pytest.mark.parametrize("name", COMMANDS)
def test_commands_follow_the_path(name: str) -> None:
    robot = spong(reference="motors")
    own, other = COMMANDS[name](robot), COMMANDS[name](robot.commanded())
    if isinstance(own, dict):
        assert own.keys() == other.keys()
        own, other = list(own.values()), list(other.values())
    np.testing.assert_array_equal(np.asarray(own), np.asarray(other))


VARIED: dict[str, Callable[[Any], Any]] = {
    "batch": lambda robot: robot.batch(vary={DURATION: (0.4, 0.6, 2)}),
    "simulate_batch": lambda robot: tmodes.simulate_batch(robot, {DURATION: [0.4, 0.5]}),
    "study": lambda robot: robot.study({"parameters": {"k": DRAWN["k"] | {"path": DURATION}},
                                        "plan": {"type": "grid", "levels": 2}, "quantities": PEAK}),
    "gradient": lambda robot: robot.gradient(tmodes.reduced_output("tip_error", "rms"), [DURATION]),
}  # fmt: skip


@pytest.mark.parametrize("name", VARIED)
def test_the_task_stays_while_numbers_change(name: str) -> None:
    with pytest.raises((InputError, InputErrors)) as caught:
        VARIED[name](spong())
    got = {one.got for one in getattr(caught.value, "errors", [caught.value])}
    assert got == {"a key of the task"}


def test_a_study_is_changed_before_its_references_are_made() -> None:
    asked = {"parameters": DRAWN, "plan": {"type": "grid", "levels": 2}, "quantities": PEAK}
    study = study_of_robot(spong(reference="motors"), asked)
    changed = changed_study(study, {"task.reference": "rigid", "joints.joint.gear.damping": 0.5}, None)
    own = spong().with_({"joints.joint.gear.damping": 0.5}).commanded()
    assert changed.robot
    assert sheet_data(changed.robot) == sheet_data(own)


def test_references_are_compared_on_one_task() -> None:
    """A slow move under gravity: the sag's reference is nearer to the path, and moves the motors away from it."""
    slow = spong(profile={"type": "polynomial", "duration": 4.0})
    found = slow.compare({"rigid": {}, "sag": {"task.reference": "sag"}})
    assert [one.name for one in found.ranked] == ["sag", "rigid"]
    rows = slow.follow(reference="sag").info()
    twist = 9.8 * np.sin(0.5) / 100.0  # of the gear that carries 1 kg at 1 m
    assert rows["joints"]["joint"]["end"] == pytest.approx(0.5, abs=1e-6)
    assert rows["setpoints"]["joint"]["end"] == pytest.approx(0.5 + twist, abs=1e-6)
    assert slow.follow().info()["setpoints"] == slow.follow().info()["joints"]


def test_a_pair_needs_its_drives_to_follow() -> None:
    robot = spong()
    with pytest.raises(InputError) as caught:
        tmodes.run(RobotPair(robot, robot))
    assert caught.value.which == "task.path"
    pair = robot.commanded().pair()
    assert np.array_equal(tmodes.run(pair).data["q"], robot.run().data["q"])


def test_tuned_gains_stay_with_the_task(tmp_path: Path) -> None:
    file = tmp_path / "tuned.yaml"
    spong().tune(["drives.0.controller.position_gain"], trials=3, out=file)
    assert tmodes.load(file).task == spong().task


def test_the_command_reads_the_task(tmp_path: Path) -> None:
    file = tmp_path / "task.yaml"
    file.write_text(robot_to_yaml(spong()), encoding="utf-8")
    assert "joints of 0.5 in 0.5 s" in command("follow", str(file)).stdout
    assert "in 0.7 s" in command("follow", str(file), "--profile", "{type: polynomial, duration: 0.7}").stdout
