"""What a changed slider shows first: curves and verdict, then the picture, how it settles, and what takes longer."""

from __future__ import annotations

from typing import Any

import pytest

from see.scenes import short_robot
from tmodes import run
from tmodes.live.bundle import live_bundle

from .node import in_node

PROGRAM = """
import { readFileSync } from "node:fs";
import { openLive, unpack } from "./live.mjs";
const live = await openLive(unpack(new Uint8Array(readFileSync("bundle.tmpk"))));
const values = live.sliders.map(({ value }) => value);
const seen = (run) => ({
  scene: Boolean(run.scene), line: Boolean(run.line), modes: Boolean(run.vibration),
  series: Object.keys(run.series), facts: run.facts, verdict: run.verdict, pending: run.pending ?? [],
});
const heard = [];
const whole = await live.run(values, undefined, (run) => heard.push(run));
let pictures = 0;
let second = null;
const first = live.run(values, undefined, (run) => {
  if (run.scene) pictures += 1;
  second ??= live.run(values);
}).then(() => "done", (problem) => problem.name);
const names = [...heard, whole].map(seen);
const kept = Object.keys(heard[0].series).every((name) => heard[0].series[name] === whole.series[name]);
console.log(JSON.stringify({ stages: names, kept, first: await first, second: (await second).status, pictures }));
"""

LATER = {"deformation_stationary", "deformation_oscillatory"}


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What is heard of one run, and of one that a newer one ends as its curves are there."""
    bundle = live_bundle(run(short_robot()))
    assert bundle is not None
    return in_node(PROGRAM, bundle, tmp_path_factory.mktemp("order"))


def test_curves_come_first_then_the_picture_then_the_modes(found: dict[str, Any]) -> None:
    stages = found["stages"]
    assert [(one["scene"], one["line"], one["modes"]) for one in stages] == [
        (False, False, False), (True, True, False), (True, True, False), (True, True, True),
        (True, True, True),
    ]  # fmt: skip
    assert set(stages[0]["series"]) == set(stages[2]["series"]) == set(stages[4]["series"]) - LATER
    assert found["kept"]  # no curve is drawn again where nothing of it changed


def test_a_number_that_is_there_stays_as_it_is(found: dict[str, Any]) -> None:
    curves, picture, rest, modes, whole = (one["facts"] for one in found["stages"])
    assert {"tip_error.commanded", "deviation.max", "energy.residual"} <= set(curves)
    assert {"deflection.max", "moment.max"} <= set(picture) - set(curves)
    assert {"settling", "vibration.residual", "vibration.nominal"} <= set(rest) - set(picture)
    assert picture == {**picture, **curves}
    assert whole == modes == {**whole, **rest} == {**whole, **picture}


def test_what_is_not_there_yet_is_said_to_be_computed(found: dict[str, Any]) -> None:
    """Every fact and every field of the verdict that comes later is among those that are said to."""
    *early, whole = found["stages"]
    for one in early:
        assert set(whole["facts"]) - set(one["facts"]) <= set(one["pending"])
        fields = {key for key, value in whole["verdict"].items() if value != one["verdict"][key]} - {"sentence"}
        assert fields <= set(one["pending"])
    assert whole["pending"] == []
    assert early[0]["verdict"]["culprits"] == whole["verdict"]["culprits"] != []


def test_no_picture_is_made_where_a_newer_run_was_asked_for(found: dict[str, Any]) -> None:
    assert (found["first"], found["second"], found["pictures"]) == ("Superseded", "finished", 0)
