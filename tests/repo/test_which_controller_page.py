"""Every command and every script of docs/which-controller.md runs as it stands, and prints what the page says."""

from __future__ import annotations

import io
import re
import shlex
from contextlib import redirect_stdout
from pathlib import Path

import pytest

from command import tmodes as command

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "which-controller.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^    \$ tmodes ([^\n]*)\n((?:    [^$\n][^\n]*\n)*)", PAGE, re.MULTILINE)
SCRIPTS = re.findall(r"```python\n(.*?)```\n\n((?:    [^\n]*\n)+)", PAGE, re.DOTALL)


def lines(said: str) -> list[str]:
    """Its lines without what depends on the machine: the time of a run, the last number of a row of the league."""
    every = [re.sub(r"\s+", " ", one).strip() for one in said.splitlines()]
    return [re.sub(r"( %) \S+$", r"\1", one) for one in every]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """With the file of the page, and the same with another plan."""
    monkeypatch.chdir(tmp_path)
    (text,) = re.findall(r"`(\w+\.yaml)`, for.*?```yaml\n(.*?)```", PAGE, re.DOTALL)
    (tmp_path / text[0]).write_text(text[1], encoding="utf-8")
    (plan,) = re.findall(r"`(plan: {type: tolerance})`", PAGE)
    (tmp_path / "corners.yaml").write_text(f"{text[1]}{plan}\n", encoding="utf-8")
    return tmp_path


LONG = "compare ", "tune "
"""Of commands that take a minute."""


@pytest.mark.parametrize(("line", "said"), [
    pytest.param(line, said, marks=[pytest.mark.nightly] if any(word in line for word in LONG) else [])
    for line, said in COMMANDS
])  # fmt: skip
@pytest.mark.usefixtures("folder")
def test_command(line: str, said: str) -> None:
    done = lines(command(*shlex.split(line)).stdout)
    assert [one for one in lines(said) if one not in done] == []


@pytest.mark.parametrize(("code", "said"), SCRIPTS)
def test_script(code: str, said: str) -> None:
    assert len(code.splitlines()) <= 15
    printed = io.StringIO()
    with redirect_stdout(printed):
        exec(code, {})  # noqa: S102 - of our own page
    assert lines(printed.getvalue()) == lines(said)
