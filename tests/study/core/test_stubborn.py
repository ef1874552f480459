"""Cases that do not come to their end, each in its own way: rows with their reason, without numbers; others stay."""

from __future__ import annotations

import numpy as np
import pytest

from patience import bounded
from study.core.studies import short, study
from tmodes.errors import InputErrors
from tmodes.study.rows import GOOD

SERIES = {"peak": {"series": "tip.speed", "reduce": "max"}, "twice": {"expression": "2*peak"}}
GEAR = {
    "gear": {"path": "gear.stiffness", "relative": True, "distribution": {"type": "uniform", "low": 1, "high": 1e6}}
}


def rows_of(*gears, **settings):
    changes = {f"integration.{name}": value for name, value in settings.items()}
    changes = {"integration.duration": 0.1, "integration.output_step": 0.01} | changes
    asked = short(SERIES, GEAR, set=changes)
    return asked.evaluate(0, np.array([[gear] for gear in gears]))


STUBBORN = {
    "diverged": ((1.0, 1e6), {"method": "rk4", "step": 1e-3}, "t ="),
    "stopped": ((1.0, 1e4), {"method": "dormand_prince", "max_steps": 1000}, "max_steps"),
}


@pytest.mark.parametrize("status", list(STUBBORN))
def test_it_is_a_row_without_numbers(status):
    gears, settings, words = STUBBORN[status]
    rows = rows_of(*gears, **settings)
    assert [*rows.status] == ["finished", status], rows.reason
    assert words in rows.reason[1]
    for values in rows.quantities.values():
        assert np.isfinite(values).tolist() == [True, False]
    alone = rows_of(gears[0], **settings)
    assert rows.quantities["peak"][0] == pytest.approx(alone.quantities["peak"][0], rel=1e-12)


def test_a_limit_on_time_ends_all_soon():
    """Whatever the tolerance asks for."""
    with bounded(60.0):
        rows = rows_of(1.0, 1.1, duration=1000.0, output_step=1.0, max_wall_time=1e-3)
    assert [*rows.status] == ["stopped", "stopped"]
    assert all("max_wall_time" in why for why in rows.reason)
    assert np.isnan(rows.quantities["peak"]).all()
    assert not set(rows.status) & set(GOOD)


@pytest.mark.parametrize(("path", "value", "words"), [
    ("integration.relative_tolerance", 1e-17, "must be a number from 1e-13"),
    ("integration.output_step", 1e-12, "samples, about"),
    ("integration.duration", -1.0, "integration.duration"),
])  # fmt: skip
def test_settings_for_which_no_run_can_end_are_refused_at_once(path, value, words):
    """R15 and R16: with the number of samples, or the range."""
    with pytest.raises(InputErrors, match=words):
        short(SERIES, GEAR, set={path: value})


def test_a_tolerance_below_rounding_as_a_parameter_is_a_row():
    tolerance = {"path": "integration.relative_tolerance", "distribution": {"type": "uniform", "low": 0, "high": 1}}
    rows = short(SERIES, {"tol": tolerance}).evaluate(0, np.array([[1e-8], [1e-17]]))
    assert [*rows.status] == ["finished", "refused"]
    assert "relative_tolerance" in rows.reason[1]


@pytest.mark.parametrize("plan", [
    {"type": "monte_carlo", "runs": 10**12}, {"type": "saltelli", "samples": 2**22, "second_order": True},
    {"type": "grid", "levels": 100_000},
])  # fmt: skip
def test_plans_that_are_too_large_take_no_memory(plan):
    names = {name: {"distribution": {"type": "uniform", "low": 0, "high": 1}} for name in "abcdefgh"}
    with pytest.raises(InputErrors, match=r"at most|from 1 to"):
        study(names, {"y": {"expression": "a"}}, plan=plan)
