"""Every example of docs/adding.md is complete: it runs by itself, in a process of its own."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from patience import LONG

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "adding.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"^## (.*?)\n.*?^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


def test_there_is_one_of_each() -> None:
    assert [title for title, _ in EXAMPLES] == [
        "A controller",
        "A sensor, a profile, a shaper",
        "A contact",
        "A link",
        "A figure",
    ]


@pytest.mark.nightly("A figure", "A contact", "A link")
@pytest.mark.parametrize(("title", "example"), EXAMPLES, ids=[title for title, _ in EXAMPLES])
def test_example_runs(title: str, example: str, tmp_path: Path) -> None:
    script = tmp_path / "own.py"
    script.write_text(example, encoding="utf-8")
    environment_is_quiet = [sys.executable, "-W", "error", str(script)]
    done = subprocess.run(environment_is_quiet, cwd=tmp_path, capture_output=True, text=True, timeout=LONG, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("finished"), (title, done.stdout)
