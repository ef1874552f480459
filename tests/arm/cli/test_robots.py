"""``tmodes robots``: arms beside the robot of 2010."""

from __future__ import annotations

import json

from arm.cli.command import tmodes


def test_list():
    told = {one["name"]: one for one in json.loads(tmodes("robots", "--json").stdout)}
    assert told["filipovic2010"]["kind"] == "robot"
    assert told["spong1987"]["kind"] == "arm"
    assert told["ur5_elastic"]["kind"] == "arm, with a URDF"
    assert all(one["title"] and one["citation"] for one in told.values())
    table = tmodes("robots").stdout
    assert "spong1987" in table
    assert "filipovic2010" in table


def test_a_sheet_can_be_edited_and_checked(tmp_path):
    text = tmodes("robots", "spong1987").stdout
    assert "# k [N*m/rad]" in text
    (tmp_path / "mine.yaml").write_text(text.replace("name: spong1987", "name: mine"), encoding="utf-8")
    assert "mine: right" in tmodes("check", tmp_path / "mine.yaml").stdout
    told = json.loads(tmodes("robots", "spong1987", "--json").stdout)
    assert told["joints"][0]["name"] == "joint"


def test_an_unknown_name():
    done = tmodes("robots", "spong", code=2)
    assert "spong1987" in done.stderr
