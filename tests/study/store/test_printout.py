"""What `tmodes study` prints: percentiles with their intervals where cases are drawn, read a column at a time."""

from __future__ import annotations

import json

import numpy as np
import pytest

from command import tmodes
from study.core.studies import study
from tmodes.study.result import StudyResult
from tmodes.study.rows import Rows
from tmodes.study.runner import run_study
from tmodes.study.statistics import statistics
from tmodes.study.table import TableColumns

STUDY = """
format: 1
kind: study
name: formula
parameters:
  x: {{distribution: {{type: uniform, low: 0, high: 2}}}}
  w: {{distribution: {{type: uniform, low: 0, high: 2}}}}
plan: {{{plan}}}
quantities: {{y: {{expression: "x**2", unit: mm}}, z: {{expression: "sqrt(1 - x)"}}}}
"""


def printed(folder, plan, *options):
    file = folder / "study.yaml"
    file.write_text(STUDY.format(plan=plan), encoding="utf-8")
    return tmodes("study", file, "--out", folder / "out", "--no-page", *options).stdout


def test_percentiles_have_their_intervals(tmp_path):
    info = json.loads(printed(tmp_path, "type: monte_carlo, runs: 1000", "--json"))
    table = run_study(study(), tmp_path / "other")  # nothing of another study
    assert table.parquet.exists()
    y = TableColumns(tmp_path / "out" / "table.parquet").numbers("y")
    found, known = info["quantities"]["y"], statistics(y)
    assert (found["known"], found["unit"], info["confidence"]) == (1000, "mm", 0.95)
    for percent, one in known.percentiles.items():
        key = f"p{percent:g}"
        assert found[key] == one.value
        assert found["intervals"][key] == [one.low, one.high]
        assert one.low < (percent / 50) ** 2 < one.high  # of these 1000 cases; x is uniform from 0 to 2
    lost = int((y > 1).sum())
    assert info["status"] == {"finished": 1000 - lost, "failed": lost}
    assert [each["case"] for each in info["failures"]] == np.flatnonzero(y > 1)[:5].tolist()
    assert info["warnings"][-1].startswith(f"and {lost - 5} more")


def test_too_few_cases_for_an_end_are_null(tmp_path):
    info = json.loads(printed(tmp_path, "type: monte_carlo, runs: 30", "--json"))
    low, high = info["quantities"]["y"]["intervals"]["p99"]
    assert low > 0
    assert high is None


def test_the_table_shows_them_and_says_what_they_are(tmp_path):
    text = printed(tmp_path, "type: monte_carlo, runs: 200")
    assert "50 %" in text
    assert text.count("[") == 6
    assert "95 % confidence" in text


@pytest.mark.parametrize("plan", ["type: grid, levels: 5", "type: random, runs: 20", "type: one_at_a_time"])
def test_cases_that_were_chosen_have_no_percentiles(plan, tmp_path):
    text = printed(tmp_path, plan)
    assert "50 %" not in text
    assert "least" in text
    info = json.loads(printed(tmp_path, plan, "--json"))
    assert info["confidence"] is None
    assert "intervals" not in info["quantities"]["y"]


def test_cases_that_repeat_values_have_no_intervals(tmp_path):
    """Those of Saltelli's plan share their values: as many independent ones would say more."""
    info = json.loads(printed(tmp_path, "type: saltelli, samples: 64", "--json"))
    assert info["drawn"]
    assert info["confidence"] is None


def test_it_never_has_all_rows(tmp_path, monkeypatch):
    """One column at a time: a study may be larger than memory."""
    result = run_study(study(), tmp_path)
    monkeypatch.setattr(StudyResult, "rows", property(lambda _: pytest.fail("all rows were read")))
    monkeypatch.setattr(StudyResult, "blocks", lambda _: pytest.fail("blocks were read"))
    assert result.info()["good"] == 8


def test_whether_rows_ended_well_is_found_once():
    """Not for each case again, which took minutes for 100,000 of them."""
    rows = Rows(np.arange(2), {}, {}, {}, ["finished", "failed"], ["", "x"], ["", ""], np.zeros(2))
    assert rows.good.tolist() == [True, False]
    assert rows.good is rows.good
