"""All numbers of a page after a slider, the verdict among them, are those of the native run of the changed sheet.

TMODES_LIVE_CHANGES: changes of each robot, ten for all that is claimed; TMODES_LIVE_ROBOTS: which.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tmodes import load, run
from tmodes.io.sheet_check import sheet_data
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.result import settling
from tmodes.sheet import Robot

from .all_numbers import different, near
from .chain import chain
from .node import drawn, live_in_node

CHANGES = int(os.environ.get("TMODES_LIVE_CHANGES", "2"))
ROBOTS = os.environ.get("TMODES_LIVE_ROBOTS", "chain released filipovic2010").split()


def robot_of(name: str) -> Robot:
    if name not in ("chain", "released"):
        return load(name)
    data = sheet_data(chain(2))
    data["integration"]["duration"] = 0.4
    if name == "chain":  # which has a tolerance, and limits of its joints
        data["task"] = {"tolerance": 0.02}
        data["joints"][0]["limits"] = {"speed": 1.0, "effort": 40.0, "lower": -1.0, "upper": 1.0}
    else:  # nothing is commanded, and nothing damps what swings
        data["drives"] = []
        for joint in data["joints"]:
            joint["axis"] = [0.0, 1.0, 0.0]
        data["initial"] = {"coordinates": {"j0": 0.3}}
    return Robot.from_data(data)


@pytest.mark.parametrize("name", [*ROBOTS[:1], *(pytest.param(one, marks=pytest.mark.nightly) for one in ROBOTS[1:])])
def test_all_numbers_are_those_of_the_native_run(name: str, tmp_path: Path) -> None:
    robot = robot_of(name)
    original = run(robot)
    bundle = live_bundle(original)
    assert bundle is not None
    live, method = live_map(robot.pair()), original.statistics["real"]["method"]
    jobs = [live.start, *drawn(live, CHANGES, seed=11, others=0.05)]
    for job, own in zip(jobs, live_in_node(bundle, jobs, tmp_path), strict=True):
        result = run(robot.with_({**live.changes(job), "integration.method": method}))
        assert not different(own, result)


def test_page_and_run_look_on_equally_far(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the steps of a continuation are used up, which rounding moves, both keep what is before the same time."""
    for name, value in {"_MOST_WORK": 0.0, "_NEGLIGIBLE": 1500}.items():
        monkeypatch.setattr(settling, name, value)
    robot = load("filipovic2010")
    original = run(robot)
    bundle = live_bundle(original)
    assert bundle is not None
    live = live_map(robot.pair())
    job = [one.value * (1.1 if one.path.endswith("payload.mass") else 1.0) for one in live.sliders]
    (own,) = live_in_node(bundle, [job], tmp_path)
    summary = run(robot.with_(live.changes(job))).summary()
    vibration = summary["vibration"]["actual"]
    assert vibration["cut"] == settling._COSTLY
    assert vibration["continued_s"] == pytest.approx(settling._evened(vibration["continued_s"]), rel=1e-9)
    assert own["facts"]["vibration.residual"]["note"].endswith(settling._COSTLY)
    assert near(own["facts"]["vibration.residual"]["value"], vibration["amplitude_m"])
    assert near(own["verdict"]["settling"]["time_s"], summary["settling"]["time_s"])


def test_what_the_steps_leave_out_is_said_of_a_tip_that_does_not_settle(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {"_MOST_WORK": 0.0, "_NEGLIGIBLE": 40}.items():
        monkeypatch.setattr(settling, name, value)
    found = run(load("spong1987").with_({"integration.duration": 1.2})).verdict
    assert found["settling"]["time_s"] is None
    assert found["sentence"].endswith(f"{settling._COSTLY}.")
    assert "too short" not in found["sentence"]
