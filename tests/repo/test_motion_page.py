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
from tmodes.sheet.task import ReferenceKind, Task

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


def test_its_sheets() -> None:
    text, task = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)
    robot = tmodes.load("quanser_2dsfl").with_({"drives.0.signal": parse_yaml(text, "the page")[0]["signal"]})
    assert robot.drives[0].signal.move_ends() == pytest.approx(0.2 + 0.9068 + 0.4476, abs=1e-3)
    robot = tmodes.load("two_link_arm").with_(parse_yaml(task, "the page")[0])
    for kind, off in (("sag", 0.90e-3), ("rigid", 4.3e-3)):
        found = robot.with_({"task.reference": kind}).run(error_estimate=False, model_error=False)
        assert found.summary()["tip_error"]["commanded"]["max_m"] == pytest.approx(off, rel=0.02)
    row = next(line for line in PAGE.splitlines() if line.startswith("| `reference` | `rigid`"))
    assert re.findall(r"`(\w+)`", row.split("|")[2]) == [*ReferenceKind]
    assert set(re.findall(r"^\| `(\w+)` \|", PAGE.partition("| key | what it is |")[2], re.MULTILINE)) | {
        "tolerance"
    } == {*Task.model_fields}
