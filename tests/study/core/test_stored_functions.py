"""What a folder has stored of a function is that of the function as it is now; one without identity is called again."""

from __future__ import annotations

import functools
import logging
import sys
import threading
from typing import Any

import numpy as np

from study.core.studies import short
from tmodes.study.runner import run_study
from tmodes.study.study import Study

FACTOR = 1.0
PLAN = {"type": "monte_carlo", "runs": 2}


def scaled(x: float, result: Any) -> float:
    return x


def globally(result: Any) -> float:
    return FACTOR


def of(function: Any) -> Study:
    return short({"y": {"function": "f"}}, functions={"f": function}, plan=PLAN)


def test_a_function_that_holds_another_number_is_called_again(tmp_path):
    for x in (1.0, 2.0, 2.0):
        assert run_study(of(functools.partial(scaled, x)), tmp_path, threads=1).rows.quantities["y"].tolist() == [x, x]
    assert len([*(tmp_path / "blocks").iterdir()]) == 2


def test_a_global_that_was_changed_here_counts_in_other_processes_too(tmp_path, monkeypatch):
    """There the module is imported again, and has the number of its file: so the function is called here."""
    monkeypatch.setattr(sys.modules[__name__], "FACTOR", 2.0)
    assert run_study(of(globally), tmp_path, threads=2).rows.quantities["y"].tolist() == [2.0, 2.0]


class Counting:
    """It changes while it is called."""

    def __init__(self) -> None:
        self.calls, self.lock = 0, threading.Lock()

    def __call__(self, result: Any) -> float:
        self.calls += 1
        return float(self.calls)


def test_what_nobody_can_identify_is_not_kept_and_that_is_said(tmp_path, caplog):
    function = Counting()
    with caplog.at_level(logging.WARNING):
        first = run_study(of(function), tmp_path, threads=1)
    assert "`f`" in caplog.text
    assert "lock" in caplog.text
    assert first.complete
    assert sorted(first.rows.quantities["y"]) == [1.0, 2.0]
    told: list[str] = []
    again = run_study(of(function), tmp_path, threads=1, notice=told.append)
    assert sorted(again.rows.quantities["y"]) == [3.0, 4.0]
    assert len(told) == 1


def test_a_function_that_changes_its_own_state_is_one_function_while_the_study_runs(tmp_path):
    function = Counting()
    del function.lock
    found = run_study(of(function), tmp_path, threads=1)
    assert found.complete
    np.testing.assert_array_equal(np.sort(found.rows.quantities["y"]), [1.0, 2.0])
