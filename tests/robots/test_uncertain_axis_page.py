"""docs/uncertain-axis.md: its commands run, and tell what the page says."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from patience import LONG
from tmodes.study.read import study_from_data

pytestmark = pytest.mark.nightly

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "uncertain-axis.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^    tmodes (.*)$", PAGE, re.MULTILINE)
FEWER = {"study axis_plants.yaml": ["--runs", "4000", "--out", "plants"],
         "study axis_lqg_plants.yaml": ["--runs", "4000", "--out", "lqg"]}  # fmt: skip


@pytest.fixture(scope="module")
def answers(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, Any]]:
    """What each command of the page says; the study of fewer plants."""
    folder = tmp_path_factory.mktemp("axis")
    for name in ("axis_gains.yaml", "axis_plants.yaml", "axis_laws.yaml", "axis_lqg_weights.yaml",
                 "axis_hinf_weights.yaml", "axis_lqg_plants.yaml"):  # fmt: skip
        shutil.copy(ROOT / "examples" / "studies" / name, folder)
    found = {}
    for command in COMMANDS:
        words = [*command.split(), *FEWER.get(command, []), "--json"]
        line = [sys.executable, "-m", "tmodes.cli.main", *words]
        done = subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=LONG, check=False)
        assert done.returncode == 0, done.stderr
        found[words[0] if words[0] in ("linear", "compare") else words[1]] = json.loads(done.stdout)
    return found


def test_commands_run(answers: dict[str, dict[str, Any]]) -> None:
    assert [*answers] == [
        "linear", "axis_gains.yaml", "axis_plants.yaml", "compare", "axis_lqg_weights.yaml", "axis_hinf_weights.yaml",
        "axis_lqg_plants.yaml",
    ]  # fmt: skip
    for name in ("axis_plants.yaml", "axis_lqg_plants.yaml"):
        assert answers[name]["status"] == {"finished": 4000}


def test_gains_that_are_found_halve_the_worst_cost_of_those_of_the_sheet(answers: dict[str, dict[str, Any]]) -> None:
    """On the plants of the search, and on others."""
    found, others = answers["axis_gains.yaml"], answers["axis_plants.yaml"]["quantities"]["cost"]
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


def test_the_league_says_what_the_page_says(answers: dict[str, dict[str, Any]]) -> None:
    """Which law fails, and that the worst cases are those of the table."""
    said = {one["name"]: one["cases"] for one in answers["compare"]["variants"]}
    table = dict(re.findall(r"^      (\S.*?) {2,}\d[\d.]* % \(.*?\) +([\d.e+]+)", PAGE, re.MULTILINE))
    assert table.keys() == said.keys()
    for name, worst in table.items():
        assert (said[name]["fails"]["share"] > 0.2) == (name == "LQG, firm")
        if name != "LQG, firm":
            assert 1e3 * said[name]["worst_m"] == pytest.approx(float(worst), rel=2e-3)


@pytest.mark.parametrize(("name", "least"), [("axis_lqg_weights.yaml", 0.39), ("axis_hinf_weights.yaml", 0.18)])
def test_weights_that_are_found(answers: dict[str, dict[str, Any]], name: str, least: float) -> None:
    """How much better than those by hand they are in the worst of 64 plants."""
    ((_, start), *_, (_, best)) = answers[name]["history"]
    assert best < (1 - least) * start
    assert float(re.findall(rf"{name}\n\n    Best design: .*: cost ([\d.]+)", PAGE)[0]) == pytest.approx(best, rel=2e-3)


def test_one_lqg_on_other_plants(answers: dict[str, dict[str, Any]]) -> None:
    cost = answers["axis_lqg_plants.yaml"]["quantities"]["cost"]
    assert "| LQG, careful | 0.827 | 0.898 |" in PAGE
    assert cost["p50"] == pytest.approx(0.898, rel=5e-3)


def test_the_move_of_the_page(capsys: pytest.CaptureFixture[str]) -> None:
    exec(compile(PAGE.split("```python")[1].split("```")[0], "docs/uncertain-axis.md", "exec"), {})  # noqa: S102
    for line in capsys.readouterr().out.splitlines():
        assert f"    {line}\n" in PAGE
