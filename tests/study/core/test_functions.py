"""Functions of a user that hang, print, and change what they are given: they spoil their own number alone."""

from __future__ import annotations

import json
import os
import signal
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

from command import tmodes
from study.core.studies import short
from tmodes.errors import SimulationError, TmodesError
from tmodes.study.quantities.call import called
from tmodes.study.ways import results

ALARMS = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs a system with alarms")
VALUES = np.array([[1.0], [0.9]])


def height(result):
    """Of both ways to the series."""
    return float(result.motion["tip"].values[-1, 2] + result.data["tip"].values[-1, 2])


def replaces(result):
    result.data["tip"] = 0.0 * result.data["tip"]
    return float(result.data["tip"].values[-1, 2])


def clears(result):
    result.data.attrs.clear()
    for variable in result.data.variables.values():
        variable.attrs.clear()
    return 1.0


def forgets(result):
    result.__dict__.clear()
    return 2.0


def ends(result):
    os._exit(1)


def hides(result):
    """It hides what stops it, and continues as long as it can."""
    while True:
        try:
            sum(range(1000))
        except Exception:  # noqa: S112
            continue


def stuck(result):
    """In code that no alarm interrupts, for hours."""
    return float(sum(range(10**12)))


def evaluated(threads, seconds=60.0, **functions):
    quantities = {name: {"function": name, "timeout": 0.3 if name == "hides" else seconds} for name in functions}
    asked = {**quantities, "height": {"function": "height"}, "peak": {"summary": "deviation.max_m"}}
    return short(asked, functions={**functions, "height": height}).evaluate(0, VALUES, threads=threads)


@pytest.mark.nightly
@ALARMS
@pytest.mark.parametrize("threads", [1, 2])
def test_what_one_changes_no_other_number_sees_and_one_that_hides_the_alarm_is_stopped(threads):
    rows = evaluated(threads, replaces=replaces, clears=clears, forgets=forgets, hides=hides)
    alone = evaluated(1)
    assert [*rows.reason] == ["hides: TimeoutError: took longer than 0.3 s"] * 2
    for name in ("height", "peak"):
        assert rows.quantities[name].tolist() == alone.quantities[name].tolist()
    assert rows.quantities["replaces"].tolist() == [0.0, 0.0]


@pytest.mark.nightly
@ALARMS
@pytest.mark.parametrize("function", [stuck, ends])
def test_one_that_takes_its_process_with_it_is_an_error_in_words(function, monkeypatch):
    """A process that does not come back is ended; the study does not wait for it for ever."""
    monkeypatch.setattr(results.os, "cpu_count", lambda: 2)
    with pytest.raises(SimulationError, match=f"has ended by itself: look at `{function.__name__}`"):
        evaluated(2, 0.3, **{function.__name__: function})


class TaskEndedError(BaseException):
    """As libraries raise it to end a task: no ``except Exception`` finds it."""


class MuteError(Exception):
    def __str__(self):
        raise RuntimeError


class Stubborn:
    def __array__(self, *_, **__):
        raise ValueError("no array")


RAISED = {
    "TaskEndedError: over": TaskEndedError("over"), "GeneratorExit:": GeneratorExit(), "SystemExit: 0": SystemExit(0),
    "MuteError, whose own text cannot be made": MuteError(),
    r"ValueError: \x1b[31m red \udc80 \x00": ValueError("\x1b[31m red\n \udc80 \x00"),
}  # fmt: skip


class Empty:
    """A result without data."""

    def __init__(self):
        self.data = xr.Dataset()


NOTHING = Empty()


@pytest.mark.parametrize("reason", list(RAISED))
def test_whatever_is_raised_is_a_reason_in_one_plain_line(reason):
    def raises(result):
        raise RAISED[reason]

    with pytest.raises(TmodesError) as wrong:
        called(raises, NOTHING, 60.0)
    assert str(wrong.value) == reason


@pytest.mark.parametrize(("value", "words"), [
    (10**400, "`int`, of which none can be made"), ([1, [2]], "`list`, of which none"), (Stubborn(), "no array"),
    (True, "`bool`"), (None, "`NoneType`"), ("1.0", "`str`"), (np.ones(1), r"an array of shape \(1,\)"),
])  # fmt: skip
def test_what_is_no_number_is_said(value, words):
    with pytest.raises(TmodesError, match=f"must return one number, got {words}" if words != "no array" else words):
        called(lambda _: value, NOTHING, 60.0)


def test_numbers_of_all_kinds_are_numbers():
    numbers: list[Any] = [2, 10**100, np.float32(2), np.int8(2)]
    assert [called(lambda _, one=one: one, NOTHING, 60.0) for one in numbers] == [2.0, 1e100, 2.0, 2.0]


def test_it_may_close_its_output_and_leave_the_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def leaves(result):
        os.chdir("/")
        sys.stdout.close()
        os.close(1)
        return 1.0

    assert called(leaves, NOTHING, 60.0) == 1.0
    print("both streams are open", file=sys.stderr)
    assert os.write(1, b"the descriptor too\n")
    assert Path.cwd().samefile(tmp_path)


STUDY = """
format: 1
kind: study
name: noisy
robot: filipovic2010
set: {integration.duration: 0.02, integration.output_step: 0.01}
parameters: {mass: {path: payload.mass, distribution: {type: uniform, low: 0.4, high: 0.6}}}
plan: {type: monte_carlo, runs: 3}
quantities: {a: {function: noisy}}
"""

NOISY = """
import os
from tmodes.study.quantities.function import quantity

@quantity("noisy")
def noisy(result):
    print("noise")
    os.write(1, b"of compiled code\\n")
    return 1.0
"""


def test_what_it_prints_is_not_in_the_json(tmp_path):
    (tmp_path / "noisy.py").write_text(NOISY, encoding="utf-8")
    (tmp_path / "study.yaml").write_text(STUDY, encoding="utf-8")
    line = ["study", tmp_path / "study.yaml", "--out", tmp_path / "out", "--no-page", "--json", "--threads", 1]
    done = tmodes("--use", tmp_path / "noisy.py", *line, env=os.environ)
    assert json.loads(done.stdout)["good"] == 3
    assert done.stderr.count("noise\n") == 3
    assert done.stderr.count("of compiled code\n") == 3
