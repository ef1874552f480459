"""``tmodes robots``: the published robots."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

from command import tmodes


def test_list():
    info = {one["name"]: one for one in json.loads(tmodes("robots", "--json").stdout)}
    assert info["filipovic2010"]["kind"] == "2010 robot"
    assert info["spong1987"]["kind"] == "arm"
    assert info["ur5_elastic"]["kind"] == "arm, with a URDF"
    assert all(one["title"] and one["citation"] for one in info.values())
    table = tmodes("robots").stdout
    assert "spong1987" in table
    assert "filipovic2010" in table


def test_a_sheet_can_be_edited_and_checked(tmp_path):
    text = tmodes("robots", "spong1987").stdout
    assert "# k [N*m/rad]" in text
    (tmp_path / "mine.yaml").write_text(text.replace("name: spong1987", "name: mine"), encoding="utf-8")
    assert "mine: valid" in tmodes("check", tmp_path / "mine.yaml").stdout
    info = json.loads(tmodes("robots", "spong1987", "--json").stdout)
    assert info["joints"][0]["name"] == "joint"


def test_an_unknown_name():
    done = tmodes("robots", "spong", code=2)
    assert "spong1987" in done.stderr


@pytest.mark.parametrize(
    ("typed", "meant"), [("spong1978", "spong1987"), ("panda", "panda_elastic"), ("ur5", "ur5_elastic")]
)
def test_what_was_meant(typed, meant):
    for command in ("robots", "check"):
        assert f"Did you mean `{meant}`?" in tmodes(command, typed, code=2).stderr


def test_a_reader_that_goes_away():
    """As of ``| head``: the reading end is closed before the first letter."""
    reading, writing = os.pipe()
    os.close(reading)
    line = [sys.executable, "-m", "tmodes.cli.entry", "robots"]
    done = subprocess.run(line, stdout=writing, stderr=subprocess.PIPE, text=True, check=False)
    os.close(writing)
    assert (done.returncode, done.stderr) == (0, "")
