"""Derivatives through samples of controllers and sensors, and of laws that are designed from the robot."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tmodes import run, simulate_batch
from tmodes.errors import InputError
from tmodes.gradients.changes import number_at
from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
from tmodes.gradients.lowering import lowered
from tmodes.gradients.quantities import reduced_output
from tmodes.io.sheet_check import sheet_data
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation.replay import Replay

Array = NDArray[np.float64]

STEPS = {"integration.duration": 0.2, "integration.output_step": 0.004, "integration.method": "dormand_prince",
         "integration.relative_tolerance": 1e-10, "integration.absolute_tolerance": 1e-12}  # fmt: skip
END = reduced_output("tip.z", "end")
PLANT = ("joints.shoulder.gear.stiffness", "links.forearm.bodies.payload.mass", "real.joints.shoulder.gear.stiffness")
LQR = {"state_weights": {"shoulder": 1e4, "elbow": 1e4}, "effort_weight": 1e-2}
RATES = ("shoulder'", "elbow'", "shoulder.motor'", "elbow.motor'")
LQG = LQR | {"type": "lqg", "sample_time": 0.002, "measured": ["first", "second"], "measurement_noise": [1e-9],
             "process_noise": dict.fromkeys(RATES, 1e-4)}  # fmt: skip
SENSORS = [
    {"name": "first", "type": "encoder", "joint": "shoulder", "noise": 1e-5, "seed": 3, "sample_time": 0.002},
    {"name": "second", "type": "encoder", "joint": "elbow", "sample_time": 0.002, "delay": 0.001},
]


@cache
def robot(name: str) -> Robot:
    arm = load("two_link_arm").with_(STEPS)
    if name == "few rows":
        looser = {"integration.relative_tolerance": 1e-7, "integration.absolute_tolerance": 1e-9}
        return robot("lqg").with_({"integration.method": "extrapolation"} | looser)
    if name == "pid":  # two periods, and commands that are late by part of one
        return arm.with_({"drives.0.sample_time": 0.002, "drives.0.delay": 0.0005, "drives.1.sample_time": 0.003})
    data = sheet_data(arm)
    drives = [{key: value for key, value in one.items() if key != "controller"} for one in data["drives"]]
    block = {"lqr": LQR | {"type": "lqr"}, "lqr sampled": LQR | {"type": "lqr", "sample_time": 0.002}}.get(name, LQG)
    law = {"name": "law", "drives": ["shoulder", "elbow"], "block": block}
    return Robot.from_data(data | {"drives": drives, "control": [law], "sensors": SENSORS if block is LQG else []})


PATHS = {
    "pid": (*PLANT, "drives.0.controller.position_gain", "drives.1.controller.integral_gain", "drives.0.signal.end"),
    "lqr": (*PLANT, "control.law.block.effort_weight", "drives.0.signal.end", "drives.1.signal.duration"),
    "lqr sampled": (*PLANT, "control.law.block.state_weights.shoulder"),
    "lqg": (*PLANT, "control.law.block.effort_weight"),
}


@pytest.mark.nightly("pid", "lqr")
@pytest.mark.parametrize("name", ["pid", "lqr", pytest.param("lqr sampled", marks=pytest.mark.nightly), "lqg"])
def test_gradients_are_those_of_other_runs(name: str) -> None:
    here = robot(name)
    found = adjoint_gradient(here, END, PATHS[name])
    for path in PATHS[name]:
        value, steps = number_at(path, sheet_data(here)), 1e-3 * np.array([-2, -1, 1, 2])
        tips = simulate_batch(here, {path: value * (1 + steps)}, tips=True).tips
        assert tips is not None
        ends = tips[:, -1, 2]
        slope = (8 * (ends[2] - ends[1]) - (ends[3] - ends[0])) / (12e-3 * value)
        assert found.by[path] == pytest.approx(slope, rel=2e-5, abs=1e-8 / abs(value))


FED = {"type": "quintic", "start": 3.0, "end": 5.0, "duration": 0.15}
FOLLOWED = {"type": "quintic", "start": -0.4, "end": -0.2, "duration": 0.15}


def fed(block: Any) -> Robot:
    """Under a designed law with a reference, an effort fed forward by one drive, and one by a block for the other."""
    drives = [
        {key: value for key, value in one.items() if key != "controller"}
        for one in sheet_data(load("two_link_arm").with_(STEPS))["drives"]
    ]
    drives[0]["feed_forward"] = FED
    added = {"type": "feed_forward", "inputs": ["law.elbow"], "signals": [FED]}
    control = [
        {"name": "law", "drives": ["shoulder", "elbow"], "block": block | {"reference": {"shoulder.motor": FOLLOWED}}},
        {"name": "sum", "drives": ["elbow"], "block": added},
    ]
    sensors = SENSORS if "measured" in block else []
    return Robot.from_data(sheet_data(robot("pid")) | {"drives": drives, "control": control, "sensors": sensors})


@pytest.mark.nightly("block1")
@pytest.mark.parametrize("block", [LQG, LQR | {"type": "lqr"}])
def test_gradients_by_what_is_fed_forward_and_followed_are_those_of_other_runs(block: Any) -> None:
    """Only one of two drives feeds forward, the other one a block."""
    here = fed(block)
    moved = (f"control.law.block.reference.shoulder.motor.{name}" for name in ("end", "duration"))
    paths = ["drives.0.feed_forward.end", "control.sum.block.signals.0.start", *moved]
    found = adjoint_gradient(here, END, paths)
    for path in paths:
        value, ends = number_at(path, sheet_data(here)), []
        for step in (-1e-3, 1e-3):
            tips = simulate_batch(here, {path: [value * (1 + step)]}, tips=True).tips
            assert tips is not None
            ends.append(tips[0, -1, 2])
        assert found.by[path] == pytest.approx((ends[1] - ends[0]) / (2e-3 * value), rel=1e-4, abs=1e-7)
    assert all(found.by.values())


@pytest.mark.parametrize("most_bytes", [1e9, 1e5])
@pytest.mark.parametrize("name", ["pid", "lqg", "few rows"])
def test_the_same_steps_give_the_same_samples_and_both_sweeps_the_same_number(name: str, most_bytes: float) -> None:
    replay = lowered(robot(name)).recorded(most_bytes)
    done = replay.recording
    assert (min(done.used) < max(done.used)) == (name == "few rows")
    rounding = 1e-7 if name == "few rows" else 1e-8  # weights of rows reach 100
    assert np.abs(replay.samples() - done.samples).max() < rounding
    rng, count = np.random.default_rng(5), 9
    start, weights = rng.normal(size=(count, done.samples.shape[1])), rng.normal(size=done.samples.shape)
    parameters = replay.parameters * rng.normal(size=(count, len(replay.parameters)))
    signals = np.zeros((count, *done.rows.shape))
    signals[:, :, 1:] = 0.1 * rng.normal(size=(count, *done.rows[:, 1:].shape))
    slopes, found = replay.along(start, parameters, signals), replay.back(weights)
    other = start @ found.start + parameters @ found.parameters + np.tensordot(signals, found.rows, 2)
    assert np.abs(np.tensordot(slopes, weights, 2) - other).max() <= 1e-9 * np.abs(slopes * weights).sum((1, 2)).max()


def test_a_step_that_is_tried_twice_keeps_the_state_before_its_samples() -> None:
    """The first step of this run is refused and taken again shorter, after the samples of time 0."""
    here = lowered(robot("lqg"))
    replay: Any = here.recorded()
    assert isinstance(replay, Replay)
    assert (replay.recording.kept[0] == here.start).all()


def test_commands_are_those_after_the_samples_of_each_instant() -> None:
    here = robot("pid")
    shown = forward_sensitivities(here, quantities=["drives"]).info["drives"][:, 0]
    assert shown == pytest.approx(run(here).data["effort"].values[:, 0], rel=1e-9)


def test_instants_of_samples_are_structure() -> None:
    with pytest.raises(InputError) as caught:
        adjoint_gradient(robot("pid"), END, ["drives.0.sample_time"])
    assert caught.value.which == "drives.0.sample_time"


def test_errors_from_the_path_by_the_weights_of_a_designed_law() -> None:
    """The nominal run, from which the commanded path follows, has no law; its derivative by a weight is none."""
    here, path = robot("lqr"), "control.law.block.effort_weight"
    slope, steps = (
        adjoint_gradient(here, reduced_output("tip_error", "rms"), [path]).by[path],
        [-2e-3, -1e-3, 1e-3, 2e-3],
    )
    tips = [adjoint_gradient(here.with_({path: 1e-2 * (1 + one)}), reduced_output("tip_error", "rms")) for one in steps]
    a, b, c, d = (one.value for one in tips)
    assert slope == pytest.approx((8 * (c - b) - (d - a)) / (12e-3 * 1e-2), rel=1e-6)
