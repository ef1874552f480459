"""The examples of docs/derivatives.md run as they stand, and tell what the page says they tell."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes.compile.replay.tables import replay_methods
from tmodes.integrate.registry import integrators

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "derivatives.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


def test_the_examples_run() -> None:
    space: dict[str, Any] = {}
    for example in EXAMPLES:
        exec(compile(example, "docs/derivatives.md", "exec"), space)  # noqa: S102
    gradient, run = space["gradient"], space["run"]
    assert gradient.cost.checkpoints == gradient.cost.steps
    assert run.of["tip"]["gear.stiffness"].shape == (len(run.times), 3)
    assert run.by["payload.mass"].shape == (len(run.times), 19)
    apart = run.info["tip"] - space["goal"]
    assert gradient.value == pytest.approx(np.trapezoid((apart**2).sum(axis=1), run.times), rel=1e-12)
    slopes = 2 * (apart * run.of["tip"]["gear.stiffness"]).sum(axis=1)
    assert gradient.by["gear.stiffness"] == pytest.approx(np.trapezoid(slopes, run.times), rel=1e-9)
    assert space["at"].q.shape == (space["arm"].nq,) * 2


def test_every_method_is_reported_of() -> None:
    info, refused = re.findall(
        r"^the motion itself.*Methods: ([^;]*);(.*?)are refused", PAGE, re.MULTILINE | re.DOTALL
    )[0]
    assert set(re.findall(r"`(\w+)`", info)) == set(replay_methods())
    assert set(re.findall(r"`(\w+)`", refused)) == {*integrators()} - {*replay_methods()}
