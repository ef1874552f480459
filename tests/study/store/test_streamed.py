"""What is shown of a long study is read from its table, column by column, and is what all rows in memory show."""

from __future__ import annotations

import numpy as np
import pyarrow.parquet as pq
import pytest

from study.core.studies import UNIFORM, short, study
from tmodes.study import table
from tmodes.study.page import write_page
from tmodes.study.result import StudyResult, load_study
from tmodes.study.runner import run_study

PARAMETERS = {
    "z": {"distribution": UNIFORM}, "size": {"choices": [{"name": name, "set": {}} for name in ("small", "large")]},
}  # fmt: skip
QUANTITIES = {"y": {"expression": "sqrt(0.9 - z) + size", "unit": "mm"}, "a": {"expression": "z**2"}}


@pytest.fixture
def result(tmp_path):
    return run_study(study(PARAMETERS, QUANTITIES, plan={"type": "monte_carlo", "runs": 700}), tmp_path / "study")


def test_rows_of_the_table_are_those_of_the_blocks(result, monkeypatch):
    monkeypatch.setattr(table, "_AT_ONCE", 64)
    found, known = result.shown_rows, result.rows
    assert found is not known
    for part in ("case", "seconds", "good"):
        np.testing.assert_array_equal(getattr(found, part), getattr(known, part))
    for part in ("parameters", "quantities"):
        assert [*getattr(found, part)] == [*getattr(known, part)]
        for name, values in getattr(known, part).items():
            np.testing.assert_array_equal(getattr(found, part)[name], values)
    for part in ("status", "reason", "method"):
        assert [*getattr(found, part)] == [*getattr(known, part)]
        assert getattr(found, part)[3] == getattr(known, part)[3]
    assert found.units == dict(known.units)
    assert 0 < int(found.good.sum()) < len(found)


@pytest.mark.parametrize("robot", [False, True])
def test_the_page_is_the_same(robot, result, tmp_path, monkeypatch):
    if robot:
        result = run_study(short({"peak": {"series": "deviation", "reduce": "max"}}, plan={
            "type": "monte_carlo", "runs": 30}), tmp_path / "robot")  # fmt: skip
    with monkeypatch.context() as patch:
        patch.setattr(StudyResult, "shown_rows", StudyResult.rows)
        whole = write_page(result, tmp_path / "whole.html").read_text(encoding="utf-8")
    fresh = load_study(result.folder)
    monkeypatch.setattr(StudyResult, "rows", property(lambda _: pytest.fail("all rows were read")))
    assert write_page(fresh, tmp_path / "part.html").read_text(encoding="utf-8") == whole


def test_a_table_of_something_else_is_not_read(result):
    """Nor one that is not there: the blocks are what is verified."""
    table = pq.read_table(result.parquet)
    pq.write_table(table.replace_schema_metadata({"tmodes.engine": "another"}), result.parquet)
    assert result.shown_rows is result.rows
    pq.write_table(table.slice(0, 10), result.parquet)
    assert result.shown_rows is result.rows
    result.parquet.unlink()
    assert result.shown_rows is result.rows
