"""Every command and every script of docs/pose-with-sag.md runs as it stands."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from command import tmodes

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "pose-with-sag.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^tmodes (.+)$", PAGE, flags=re.MULTILINE)
SCRIPTS = re.findall(r"```python\n(.*?)```", PAGE, flags=re.DOTALL)


@pytest.mark.parametrize("line", COMMANDS)
def test_command(line: str) -> None:
    code = 3 if "--tip 1.2," in line else 0  # out of reach
    assert "two_link_arm" in tmodes(*line.split(), code=code).stdout


@pytest.mark.parametrize("script", SCRIPTS)
def test_script(script: str) -> None:
    assert len(script.strip().splitlines()) <= 15
    known: dict[str, object] = {}
    exec(script, known)  # noqa: S102 - of our own page
    if "path" in known:
        steps = np.diff([[*one.values()] for one in np.ravel(np.array(known["path"], dtype=object))], axis=0)
        assert np.abs(steps).max() < 0.1
