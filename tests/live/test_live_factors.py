"""Factors of the actual robot are offered where a run has a nominal run that the page can make, and nowhere else."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.live.numbers import has_reference
from tmodes.result import Result, assemble_result
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion
from tmodes.studio.sheets import slider_records

from .chain import chain
from .node import drawn, live_in_node, worst_difference

FACTOR = {"real": {"joints.j0.gear.stiffness": 0.8}}
PUSH = {"type": "step", "start": 0.0, "end": 2.0, "time": 0.05}


def pushed() -> Robot:
    """Torques of the motors, and no wanted position."""
    drives = [{"joint": f"j{k}", "command": "torque", "signal": PUSH} for k in range(2)]
    return chain(2).with_({"drives": drives, "gravity": 0.0})


def result_of(arm: Robot) -> Result:
    return assemble_result(simulate_motion(arm), arm)


def real_ones(sliders: Any) -> list[str]:
    return [info["path"] for info in sliders if info["path"].startswith("real:")]


@pytest.mark.parametrize("arm", [chain(2), pushed(), pushed().with_(FACTOR)], ids=["position", "torque", "factor"])
def test_the_factors_are_offered_where_the_run_is_compared(arm: Robot) -> None:
    """As the native run has it, so does the page."""
    result = result_of(arm)
    compared = "tip_nominal" in result.data
    bundle = live_bundle(result)
    assert bundle is not None
    assert has_reference(arm) == compared == ("reference" in bundle["runs"])
    assert bool(real_ones(bundle["sliders"])) == compared
    assert [one["path"] for one in bundle["leftOut"] if one["path"] == "real"] == ([] if compared else ["real"])


def test_what_is_not_offered_would_make_a_reference_run() -> None:
    """`tmodes run` of such a sheet with a factor compares, which the page of the run without one cannot; it says so."""
    assert simulate_motion(pushed()).reference is None
    assert simulate_motion(pushed().with_(FACTOR)).reference is not None
    assert "no nominal run" in live_map(pushed().pair()).left_out["real"]


@pytest.mark.nightly
def test_what_is_known_of_such_an_arm_keeps_its_sliders(tmp_path: Path) -> None:
    """Its gears among them; moved, the page's run is that of the saved sheet, with all that is compared: nothing."""
    arm, live = pushed(), live_map(pushed().pair())
    assert "joints.j0.gear.stiffness.0" in {slider.path for slider in live.sliders}
    bundle = live_bundle(result_of(arm))
    assert bundle is not None
    (values,) = drawn(live, 1, seed=2)
    (run,) = live_in_node(bundle, [values], tmp_path)
    saved = result_of(arm.with_(live.changes(values)))
    assert "deviation" not in run["series"]
    assert "deviation" not in saved.data
    assert worst_difference(run["series"], saved.data, {"energy_balance": 1.0})[0] < 1e-8


def test_the_studio_offers_them_all_the_same() -> None:
    """It runs natively, where a factor makes a nominal run."""
    from tmodes.io.sheet_check import sheet_data

    arm = pushed()
    info = slider_records(arm, json.loads(json.dumps(sheet_data(arm))))
    assert any("actual / nominal" in one["label"] for one in info)
