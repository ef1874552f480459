"""A run in the page starts where the native one does: in the equilibrium of its closed loop."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from simulation.sheets import arm
from tmodes import load, run
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.sheet import Robot

from .node import live_in_node

LAW = {
    "type": "sampled_pid",
    "position_gain": 300.0,
    "integral_gain": 40.0,
    "velocity_gain": 30.0,
    "sample_time": 0.002,
}


def loaded() -> Robot:
    """A lever of 1 kg under a sampled PID; a motor with a winding, and with dry friction that sticks."""
    motor = {"inertia": 0.1, "side": "joint", "friction": {"viscous": 0.1, "coulomb": 0.2}, "resistance": 1.0,
             "inductance": 1e-3, "back_emf_constant": 1.0, "torque_constant": 1.0}  # fmt: skip
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, -1, 0], "motor": motor,
             "gear": {"stiffness": 800.0, "damping": 1.0}}  # fmt: skip
    link = {"name": "l", "bodies": [{"name": "m", "mass": 1.0, "center": [0.3, 0, 0], "inertia": 0.01}]}
    drive = {"joint": "j", "command": "position", "signal": {"type": "constant", "value": 0.2}, "controller": LAW}
    return arm(joints=[joint], links=[link], drives=[drive], integration={"duration": 0.1, "output_step": 0.01})


def test_a_page_starts_in_the_equilibrium_of_the_closed_loop(tmp_path: Path) -> None:
    """As it stands and with a heavier link: equal coordinates, and none moves."""
    sheet = loaded()
    result = run(sheet)
    bundle: Any = live_bundle(result)
    live = live_map(sheet.pair(), (0.0, 1.0))
    values = [slider.value for slider in live.sliders]
    heavier = [1.2 * slider.value if "mass" in slider.path else slider.value for slider in live.sliders]
    assert heavier != values
    for page, native in zip(live_in_node(bundle, [values, heavier], tmp_path),
                            [result, run(sheet.with_(live.changes(heavier)))], strict=True):  # fmt: skip
        q, true = page["series"]["q"], native.data["q"].values
        assert np.abs(true - true[0]).max() < 1e-11
        assert np.abs(q - true).max() < 1e-10


@pytest.mark.nightly
def test_a_page_starts_in_equilibrium_as_soon_as_the_drive_carries_the_arm(tmp_path: Path) -> None:
    """The drive is too weak for the arm as it stands, which falls: that is warned of. A lighter arm is carried."""
    sheet = loaded().with_({"drives.j.saturation": {"torque": 2.0}})
    result = run(sheet)
    assert any("no equilibrium" in warning for warning in result.warnings)
    bundle: Any = live_bundle(result)
    live = live_map(sheet.pair(), (0.0, 1.0))
    values = [slider.value for slider in live.sliders]
    light = [0.5 * slider.value if slider.path.endswith("mass") else slider.value for slider in live.sliders]
    native = run(sheet.with_(live.changes(light)))
    assert not any("no equilibrium" in warning for warning in native.warnings)
    for page, true in zip(live_in_node(bundle, [values, light], tmp_path), [result, native], strict=True):
        assert np.abs(page["series"]["q"] - true.data["q"].values).max() < 1e-7


@pytest.mark.nightly
def test_a_page_of_a_start_in_balance_is_not_green_where_the_drive_no_longer_holds(tmp_path: Path) -> None:
    changes = {"drives.0.saturation": {"torque": 50.0}, "task.tolerance": 0.9, "integration.duration": 0.2}
    sheet = load("two_link_arm").with_(changes)
    bundle: Any = live_bundle(run(sheet))
    live = live_map(sheet.pair(), tuple(bundle["stations"].tolist()))
    heavy = [5.0 if slider.path.endswith("payload.mass") else slider.value for slider in live.sliders]
    native = run(sheet.with_(live.changes(heavy)))
    own, other = live_in_node(bundle, [live.start, heavy], tmp_path)
    assert any("no equilibrium" in warning for warning in native.warnings)
    assert own["verdict"]["level"] == "good"
    assert other["verdict"]["level"] == native.verdict["level"] == "neutral"
    first = native.summary()["first_frequency_Hz"]["controlled"]
    assert other["facts"]["frequency.first"]["value"] == pytest.approx(first, rel=1e-6)
