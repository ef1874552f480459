"""What a robot or a run does not have is said: at once where it is a mistake, else as the reason of the row."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from study.core.studies import short, study
from tmodes.errors import InputErrors
from tmodes.study.quantities.summary import summary_number
from tmodes.study.runner import run_study


@pytest.mark.parametrize(("quantity", "which"), [
    ({"series": "tip.q", "reduce": "max"}, "quantities.mine.series: unknown name"),
    ({"static": "sagg"}, "quantities.mine.static: unknown number"),
])  # fmt: skip
def test_the_quantity_is_named_and_no_folder_is_left(quantity, which, tmp_path):
    with pytest.raises(InputErrors, match=which):
        run_study(short({"mine": quantity}), tmp_path / "results" / "out")
    assert not [*tmp_path.iterdir()]


def test_a_frequency_that_the_robot_does_not_have_is_a_reason():
    one = short({"high": {"static": "frequency.locked.99"}, "mass": {"static": "mass"}})
    rows = one.evaluate(0, one.design().values[:2])
    assert rows.status == ["failed"] * 2
    assert rows.reason == ["high: the robot has no frequency.locked.99"] * 2
    assert np.isfinite(rows.quantities["mass"]).all()


def test_why_there_is_no_number_in_a_summary():
    summary = {"settling": {"time_s": None, "reason": "it still moves"}, "contact_force": None}
    value, unit, why = summary_number(summary, "settling.time_s")
    assert np.isnan(value)
    assert (unit, why) == ("s", "it still moves")
    assert summary_number(summary, "contact_force.max_N")[2] == "the summary has no contact_force.max_N"


def test_a_function_that_exits_is_the_reason_of_its_row():
    def leaves(result):
        raise SystemExit(7)

    one = short({"mine": {"function": "leaves"}}, functions={"leaves": leaves})
    rows = one.evaluate(0, one.design().values[:1])
    assert rows.reason == ["mine: SystemExit: 7"]


def test_a_plan_may_be_left_out():
    cases: Any = study(plan=None).sheet.plan
    assert (cases.name_of_kind(), cases.runs) == ("monte_carlo", 1000)
    choices = {"x": {"choices": [{"name": "a", "set": {}}, {"name": "b", "set": {}}]}}
    assert study(choices, {"y": {"expression": "x"}}, plan=None).design().values.tolist() == [[0.0], [1.0]]
