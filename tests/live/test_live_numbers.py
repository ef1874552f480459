"""All numbers of a page after a slider, the verdict among them, are those of the native run of the changed sheet.

TMODES_LIVE_CHANGES: changes of each robot, ten for all that is claimed; TMODES_LIVE_ROBOTS: which.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes import load, run
from tmodes.io.sheet_check import sheet_data
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.report.data import page_data
from tmodes.result import settling
from tmodes.sheet import Robot

from .chain import chain
from .node import drawn, live_in_node

CHANGES = int(os.environ.get("TMODES_LIVE_CHANGES", "2"))
ROBOTS = os.environ.get("TMODES_LIVE_ROBOTS", "chain released filipovic2010").split()
EQUAL = 1e-6
ROUNDING = {"energy.residual"}
"""Rounding of a balance of energies, in its tenth digit and beyond."""

MOST_RESIDUAL = 1e-8


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


@pytest.mark.parametrize("name", ROBOTS)
def test_all_numbers_are_those_of_the_native_run(name: str, tmp_path: Path) -> None:
    robot = robot_of(name)
    original = run(robot)
    bundle = live_bundle(original)
    assert bundle is not None
    live, method = live_map(robot.pair()), original.statistics["real"]["method"]
    jobs = [live.start, *drawn(live, CHANGES, seed=11, others=0.05)]
    for job, own in zip(jobs, live_in_node(bundle, jobs, tmp_path), strict=True):
        result = run(robot.with_({**live.changes(job), "integration.method": method}))
        native = page_data([result])["runs"][0]
        assert own["status"] == native["status"]
        facts = {fact["id"]: fact for fact in native["facts"]}
        assert set(facts) <= set(own["facts"])
        for key, fact in facts.items():
            if key in ROUNDING:
                assert own["facts"][key]["value"] < MOST_RESIDUAL
            else:
                assert near(own["facts"][key]["value"], fact["value"]), (key, own["facts"][key], fact)
        largest = result.verdict["largest_m"] or 0.0
        ours, true = dict(leaves(own["verdict"])), dict(leaves(result.verdict))
        assert ours.keys() == true.keys()
        for key, value in true.items():
            assert near(ours[key], value, largest if key[0] == "culprits" else 0.0), (key, ours[key], value)
        extremes(own, native)


def near(own: Any, true: Any, scale: float = 0.0) -> bool:
    if isinstance(true, float | int) and isinstance(own, float | int):
        return bool(abs(own - true) <= EQUAL * max(abs(true), scale))
    return own == true


def leaves(found: Any, at: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    items = found.items() if isinstance(found, dict) else enumerate(found) if isinstance(found, list) else None
    if items is None:
        yield at, found
        return
    for key, value in items:
        yield from leaves(value, (*at, str(key)))


def extremes(own: dict[str, Any], native: dict[str, Any]) -> None:
    """Least and largest value of each curve that the page draws again, over the largest of its chart; spectra's marks.

    Of a small curve the integration itself has no more digits.
    """
    for chart in native["charts"]:
        size = max(float(np.abs(np.asarray(curve["values"], dtype=float)).max()) for curve in chart["curves"])
        for curve in chart["curves"]:
            source = curve["source"]
            if not source or chart["abscissa"] != "time" or source["along"] or source.get("less"):
                continue
            series = own["series"].get(source["variable"])
            if series is None or chart["id"] == "energy_balance":
                continue
            values = series.reshape(len(series), -1)[:, source["index"]] * source["factor"]
            true = np.asarray(curve["values"], dtype=float)
            assert abs(values.max() - true.max()) <= 2 * EQUAL * max(size, 1e-9), (chart["id"], curve["label"])
            assert abs(values.min() - true.min()) <= 2 * EQUAL * max(size, 1e-9), (chart["id"], curve["label"])
        if chart["abscissa"] == "frequency" and chart["id"] != "spectrum_tip_nominal":  # whose marks are said to be old
            # Marks go to the end of the chart's range, its values to the last frequency before that.
            last = (1 + EQUAL) * max(float(np.asarray(chart["at"])[-1]), *(mark["at"] for mark in chart["marks"]), 0.0)
            ours = [mark for mark in own["vibration"]["marks"] if mark["at"] <= last]
            assert [mark["label"] for mark in ours] == [mark["label"] for mark in chart["marks"]]
            assert all(near(one["at"], two["at"]) for one, two in zip(ours, chart["marks"], strict=True))


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
