"""docs/uncertain-axis.md: its commands run, and tell what the page says."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from patience import LONG
from tmodes.study.read import study_from_data

pytestmark = pytest.mark.nightly

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "uncertain-axis.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^    tmodes (.*)$", PAGE, re.MULTILINE)
FEWER = {"study": ["--runs", "4000", "--out", "plants"]}


@pytest.fixture(scope="module")
def answers(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, Any]]:
    """What each command of the page says; the study of fewer plants."""
    folder = tmp_path_factory.mktemp("axis")
    for name in ("axis_gains.yaml", "axis_plants.yaml"):
        shutil.copy(ROOT / "examples" / "studies" / name, folder)
    found = {}
    for command in COMMANDS:
        words = [*command.split(), *FEWER.get(command.split()[0], []), "--json"]
        line = [sys.executable, "-m", "tmodes.cli.main", *words]
        done = subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=LONG, check=False)
        assert done.returncode == 0, done.stderr
        found[words[0]] = json.loads(done.stdout)
    return found


def test_commands_run(answers: dict[str, dict[str, Any]]) -> None:
    assert [*answers] == ["linear", "optimize", "study"]
    assert answers["study"]["status"] == {"finished": 4000}


def test_gains_that_are_found_halve_the_worst_cost_of_those_of_the_sheet(answers: dict[str, dict[str, Any]]) -> None:
    """On the plants of the search, and on others."""
    found, others = answers["optimize"], answers["study"]["quantities"]["cost"]
    assert found["method"] == "gradient"
    assert found["cases"] == 128 * found["designs"]
    ((_, start), *_, (_, best)) = found["history"]
    said = f"cost {best:.4f} (−{100 * (1 - best / start):.1f} % against the start's {start:.3f})"
    assert said in PAGE
    assert 2 * best < start
    assert 2 * others["max"] < start
    assert f"| {others['p50']:.2f}" in re.sub(r"(0\.\d\d)\d", r"\1", PAGE)


@pytest.mark.nightly
def test_other_gains_by_hand_cost_what_the_page_says() -> None:
    study = yaml.safe_load((ROOT / "examples" / "studies" / "axis_plants.yaml").read_text(encoding="utf-8"))
    gains = {"position_gain": 20.0, "velocity_gain": 1.2, "integral_gain": 60.0, "filter_time": 1e-3}
    study["set"] |= {f"drives.0.controller.{name}": gain for name, gain in gains.items()}
    study["quantities"]["noise"]["expression"] = "1e-3*(20 + 1.2/(1e-3 + 5e-4))"
    read = study_from_data(study)
    cost = read.evaluate(0, read.design().values[:4000]).quantities["cost"].max()
    assert cost == pytest.approx(1.24, abs=0.005)
    assert "Ki 60 with the filter of the sheet costs 1.24 on" in PAGE


def test_the_regulator_of_the_page() -> None:
    space: dict[str, Any] = {}
    exec(compile(PAGE.split("```python")[1].split("```")[0], "docs/uncertain-axis.md", "exec"), space)  # noqa: S102
    assert space["stable"]
    tool = np.asarray(space["tool"])
    said = f"True rms {np.sqrt((tool**2).mean()):.2f} mm, at the end {tool[-1]:.2f} mm"
    assert f"    {said}\n" in PAGE
