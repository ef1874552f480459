"""``tmodes check`` and ``tmodes schema`` of arms."""

from __future__ import annotations

import json

from arm.cli.command import tmodes


def test_right():
    done = tmodes("check", "spong1987")
    assert "spong1987: right" in done.stdout
    told = json.loads(tmodes("check", "spong1987", "--json").stdout)
    assert told["ok"] is True
    assert told["kind"] == "arm"
    assert told["coordinates"] == ["joint.motor", "joint"]
    assert told["drives"] == ["joint"]


def test_all_that_is_wrong_in_one_go():
    wrong = ["--set", "links.link.bodies.bob.mass=-1", "--set", "joints.joint.axis=[0,0,0]"]
    done = tmodes("check", "spong1987", *wrong, "--json", code=2)
    told = json.loads(done.stdout)
    assert told["ok"] is False
    assert len(told["errors"]) == 2
    assert all(error["mend"] for error in told["errors"])


def test_a_doubtful_unit():
    done = tmodes("check", "quanser_2dsfl", "--set", "links.strip.beam.length=202")
    assert "warning" in done.stdout


def test_schema():
    schema = json.loads(tmodes("schema", "--arm").stdout)
    assert {"joints", "links", "drives"} <= set(schema["properties"])
    assert "link" in json.loads(tmodes("schema").stdout)["properties"]
