"""Studies of a robot through the command: failing cases, more quantities without simulation, motions, the summary."""

from __future__ import annotations

import json

import pyarrow.parquet as pq
import pytest

from command import tmodes
from tmodes.errors import InputError
from tmodes.io.sheet_check import sheet_data
from tmodes.study.read import read_study
from tmodes.study.result import load_study
from tmodes.study.runner import run_study

STUDY = """\
format: 1
kind: study
name: gear
robot: filipovic2010
set: {integration.output_step: 0.01, integration.duration: 0.2, integration.relative_tolerance: 1e-7}
parameters:
  payload: {path: payload.mass, distribution: {type: uniform, low: 0.4 kg, high: 0.6 kg}}
plan: {type: monte_carlo, runs: 6}
quantities:
  peak: {series: deviation, reduce: max, unit: mm}
keep: {every: 1}
"""


@pytest.fixture
def sheet(tmp_path):
    file = tmp_path / "gear.yaml"
    file.write_text(STUDY)
    return file


def more(sheet, text):
    sheet.write_text(STUDY.replace("keep:", f"{text}\nkeep:"))
    return sheet


def test_the_summary_and_the_folder(sheet, tmp_path):
    out = tmp_path / "out"
    printed = tmodes("study", sheet, "--out", out, "--no-page").stdout
    assert "gear: 6 cases: 6 finished" in printed
    assert str(out / "table.parquet") in printed
    data = json.loads(tmodes("study", sheet, "--out", out, "--no-page", "--json").stdout)
    assert (data["cases"], data["good"], data["status"]) == (6, 6, {"finished": 6})
    assert data["quantities"]["peak"]["unit"] == "mm"
    assert pq.read_schema(out / "table.parquet").field("payload").metadata[b"unit"] == b"kg"
    assert load_study(out).kept(5).tip.shape == (21, 3)


@pytest.mark.nightly
def test_series_of_kept_motions_and_formulas_are_added_without_computing(sheet, tmp_path, monkeypatch):
    out = tmp_path / "out"
    run_study(read_study(sheet), out)
    asked = "  low: {series: tip.z, reduce: min, unit: mm}\n  both: {expression: low + peak, unit: mm}"
    study = read_study(more(sheet, asked))
    fresh = run_study(study, tmp_path / "fresh").rows
    monkeypatch.setattr("tmodes.study.evaluate.evaluated", lambda *_: pytest.fail("it is computed"))
    added = run_study(study, out).rows
    assert list(added.quantities) == ["peak", "low", "both"]
    assert added.units == fresh.units
    for name, values in fresh.quantities.items():
        assert added.quantities[name] == pytest.approx(values, rel=1e-9)


def test_a_failing_case_is_a_row_and_only_all_of_them_are_an_error(sheet, tmp_path):
    """R16: a payload below zero is refused by the sheet; of two, one; of one, all."""
    plan = "plan: {type: list, rows: [VALUES]}"
    text = STUDY.replace("plan: {type: monte_carlo, runs: 6}", plan)
    sheet.write_text(text.replace("VALUES", "{payload: 0.5}, {payload: -1.0}"))
    done = tmodes("study", sheet, "--out", tmp_path / "some", "--no-page")
    assert "2 cases: 1 finished, 1 refused" in done.stdout
    assert "case 1 refused: " in done.stderr
    row = pq.read_table(tmp_path / "some" / "table.parquet").to_pylist()[1]
    assert (row["status"], row["peak"]) == ("refused", None)
    assert "payload.mass" in row["reason"]
    sheet.write_text(text.replace("VALUES", "{payload: -2.0}, {payload: -1.0}"))
    tmodes("study", sheet, "--out", tmp_path / "all", "--no-page", code=3)


def test_a_function_that_raises_is_the_reason_of_its_row(sheet, tmp_path):
    """R24; and it is not sent to other machines."""

    def fragile(result):
        if sheet_data(result.robot)["links"][0]["bodies"][0]["mass"] > 0.5:
            raise ValueError("too heavy for me")
        return 1.0

    text = STUDY.replace("peak: {series: deviation, reduce: max, unit: mm}", "mine: {function: fragile}")
    sheet.write_text(text.replace("runs: 6", "runs: 4"))
    study = read_study(sheet, functions={"fragile": fragile})
    rows = run_study(study, tmp_path / "out").rows
    assert "" in rows.reason, rows.reason
    heavy = rows.parameters["payload"] > 0.5
    assert heavy.any()
    assert not heavy.all()
    assert [status == "failed" for status in rows.status] == heavy.tolist()
    assert all(("too heavy for me" in reason) == bad for reason, bad in zip(rows.reason, heavy, strict=True))
    from tmodes.study.tasks import Task, order

    with pytest.raises(InputError, match="plain data on other machines"):
        order(study, Task(0, study.design().values, ("mine",)))


def test_too_many_cases_are_refused_before_anything_is_made(sheet, tmp_path):
    """R15."""
    sheet.write_text(STUDY.replace("runs: 6", "runs: 1000000000000"))
    assert "from 1 to 2e+07" in tmodes("study", sheet, "--out", tmp_path / "out", "--no-page", code=2).stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("options", "info"),
    [
        (["--on", "cloud"], "must be one of dask, dask+tls"),
        (["--on", "dask://here"], "dask://HOST:PORT"),
        (["--resource", "cores"], "KEY=VALUE"),
        (["--set", "payload.mas=1"], "Did you mean"),
    ],
)
def test_wrong_lines_are_refused(options, info, sheet, tmp_path):
    assert info in tmodes("study", sheet, "--out", tmp_path / "out", "--no-page", *options, code=2).stderr
    assert not (tmp_path / "out").exists()


def test_the_line_changes_the_robot_and_the_number_of_cases(sheet, tmp_path):
    line = "--set", "integration.duration=0.1", "--runs", 3, "--no-page", "--out", tmp_path / "out"
    tmodes("study", sheet, *line)
    result = load_study(tmp_path / "out")
    assert len(result.rows) == 3
    assert result.kept(0).times[-1] == pytest.approx(0.1)
