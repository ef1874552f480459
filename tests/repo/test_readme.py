"""The README keeps its promises: two commands, and examples that run."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from patience import LONG
from quick_start import quick_start

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"^```python\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)


def test_quick_start_has_exactly_two_lines() -> None:
    run, test = quick_start(README)
    assert run.endswith(".venv/bin/tmodes run two_link_arm --out results/two_link_arm")
    assert test.endswith(".venv/bin/pytest --quiet --numprocesses auto")
    assert all("--constraint constraints.txt" in line for line in (run, test))


def test_pipeline_is_the_same_everywhere() -> None:
    line = next(line for line in README.splitlines() if line.startswith("    Sheet (YAML"))
    assert line in (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").splitlines()


def test_every_command_is_in_the_table() -> None:
    from tmodes.cli.main import COMMANDS

    info = set(re.findall(r"^\| `tmodes (\w+)", README, re.MULTILINE))
    assert info == {*COMMANDS}


def test_there_is_an_example() -> None:
    assert EXAMPLES


@pytest.mark.parametrize("example", EXAMPLES)
def test_example_runs(example: str, tmp_path: Path) -> None:
    command = [sys.executable, "-W", "error", "-c", example]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=LONG, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("Tip is up to ")
    for word in (
        "two_link_arm: finished",
        "5 of 5 runs finished",
        "Dimensions:  (case: 8)",
        "{'elbow.gear.stiffness': ",
    ):
        assert word in done.stdout
