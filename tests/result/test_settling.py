# pyright: reportOptionalSubscript=false
"""When the tip has settled: the run is continued beyond its end, against the closed form of one damped vibration."""

from __future__ import annotations

import json

import numpy as np
import pytest

import tmodes
from arm.see.runs import sheet
from tmodes.sheet import Robot

STIFFNESS, INERTIA, RATIO, LENGTH = 40.0, 0.4, 0.1, 0.5
FREQUENCY = np.sqrt(STIFFNESS / INERTIA)
STEP = 0.02
"""Angle [rad] by which the motor jumps at once: the arm rings about it, with a known envelope."""


def ringing(duration: float, damping: float = 2 * RATIO * np.sqrt(STIFFNESS * INERTIA), **more: object) -> Robot:
    """A mass on a rigid link behind an elastic gear whose motor moves by a short quintic and then stands still."""
    move = {"type": "quintic", "start": 0.0, "end": STEP, "duration": 0.01}
    motor = {"inertia": 1.0, "side": "joint", "resistance": 1.0, "back_emf_constant": 1.0, "torque_constant": 1.0,
             "inductance": 0.0}  # fmt: skip
    return Robot.from_data(sheet(
        joints=[{"name": "hub", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1],
                 "motor": motor, "gear": {"stiffness": STIFFNESS, "damping": damping}}],
        links=[{"name": "rod", "bodies": [{"name": "bob", "mass": INERTIA / LENGTH**2, "center": [LENGTH, 0, 0]}]}],
        tip={"link": "rod", "position": [LENGTH, 0, 0]},
        drives=[{"joint": "hub", "command": "position", "signal": move,
                 "controller": {"type": "pd", "position_gain": 3e4, "velocity_gain": 400.0}}],
        real={"joints.hub.gear.stiffness": 1.05},
    ) | {"integration": {"duration": duration, "output_step": 1e-3, "relative_tolerance": 1e-9} | more})  # fmt: skip


def test_a_short_run_settles_as_a_long_one():
    """The continuation finds what a run that is long enough shows in its samples."""
    short, long = tmodes.run(ringing(0.6)), tmodes.run(ringing(8.0))
    info = short.settling
    assert info
    assert info["reason"] == ""
    deviation, time = long.motion["deviation"].values, long.motion["time"].values
    outside = time[deviation > 0.05 * deviation.max()]
    assert outside[-1] > 0.8  # beyond the end of the short run
    assert info["time_s"] == pytest.approx(outside[-1] - 0.01, abs=3e-3)
    assert long.settling["time_s"] == pytest.approx(info["time_s"], abs=3e-3)
    assert short.summary()["settling"] == info
    assert short.summary(0.5)["settling"]["band"] == 0.5


def test_what_does_not_decay_is_not_continued():
    """Without damping nothing settles: the samples alone are looked at, and say so."""
    info = tmodes.run(ringing(0.6, damping=0.0)).settling
    assert info["time_s"] is None
    assert "when the run ends" in info["reason"] or "after the end of the run" in info["reason"]


def test_a_run_that_ends_within_the_move():
    result = tmodes.run(ringing(0.008, output_step=1e-3))
    assert result.settling["time_s"] is None
    assert "simulate longer" in result.settling["reason"]
    assert json.loads(result.data.attrs["settling"]) == result.settling
