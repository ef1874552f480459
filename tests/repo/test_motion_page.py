"""The page on motion without ringing: its example and its commands print what it says."""

from __future__ import annotations

import io
import re
import shlex
from contextlib import redirect_stdout
from pathlib import Path

import pytest

import tmodes
from command import tmodes as command
from tmodes.io.yaml_file import parse_yaml

PAGE = (Path(__file__).parents[2] / "docs" / "motion-without-ringing.md").read_text(encoding="utf-8")


@pytest.mark.nightly
def test_its_example() -> None:
    ((code, said),) = re.findall(r"```python\n(.*?)```\n\n((?:    [^\n]*\n)+)", PAGE, re.DOTALL)
    assert len(code.splitlines()) <= 15
    printed = io.StringIO()
    with redirect_stdout(printed):
        exec(code, {})  # noqa: S102
    assert printed.getvalue().splitlines() == [line.removeprefix("    ") for line in said.splitlines()]


def test_its_commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What stands below a command is part of what it prints, line by line."""
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^((?:    \$ tmodes [^\n]*\n)+)((?:    [^$\n][^\n]*\n)*)", PAGE, re.MULTILINE)
    assert len(blocks) == 6
    for commands, said in blocks:
        done = command("--version")
        for line in commands.splitlines():
            done = command(*shlex.split(line.strip().removeprefix("$ tmodes ")))
            assert done.returncode == 0, done.stderr
        lines = [re.sub(r"\s+", " ", one).strip() for one in done.stdout.splitlines()]
        for one in said.splitlines():
            assert re.sub(r"\s+", " ", one).strip() in lines, one
    assert (tmp_path / "left.svg").exists()
    assert (tmp_path / "results" / "report.html").exists()


def test_its_sheet() -> None:
    (text,) = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)
    robot = tmodes.load("quanser_2dsfl").with_({"drives.0.signal": parse_yaml(text, "the page")[0]["signal"]})
    assert robot.drives[0].signal.move_ends() == pytest.approx(0.2 + 0.9068 + 0.4476, abs=1e-3)
