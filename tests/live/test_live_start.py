"""A run in the page starts where the native one does: in the equilibrium of its closed loop."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from simulation.sheets import arm
from tmodes import run
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
