"""Whatever stands in the sections `control` and `sensors`: a plan of a run, or an error that says what does not fit."""

from __future__ import annotations

import random
from typing import Any

import numpy as np
import pytest

from contracts.test_blocks import IMPEDANCE, LQG, LQR, NOTCH, PD, PID, SHAPED, STEPS, Sheet, spong
from simulation.sheets import arm, beam
from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.sheet import Robot
from tmodes.simulation.plan import planned
from tmodes.simulation.simulate import simulate_motion

LAWS: dict[str, Sheet] = {
    "pd": PD, "pid": PID | {"type": "pid"}, "sampled_pid": PID, "lqr": LQR, "lqg": LQG, "notch": NOTCH,
    "loop_shaping": SHAPED,
    "state_feedback": {"type": "state_feedback", "position_gains": {"joint.motor": 80.0}, "velocity_gains": {}},
    "gravity_pd": PD | {"type": "gravity_pd"},
    "computed_torque": {"type": "computed_torque", "position_gain": 100.0, "velocity_gain": 20.0},
    "feedback_linearisation": {"type": "feedback_linearisation", "pole": 10.0},
    "passivity_based": {"type": "passivity_based", "damping": 5.0, "position_gain": 100.0, "velocity_gain": 20.0},
    "singular_perturbation": {"type": "singular_perturbation", "position_gain": 25.0, "velocity_gain": 10.0},
    "impedance": IMPEDANCE,
    "force": IMPEDANCE | {"type": "force", "direction": [1, 0, 0], "force": 4.0, "integral_gain": 3.0, "input": "raw"},
    "pole_placement": {"type": "pole_placement", "poles": [[2.0, 0.7], [4.0, 0.7]]},
    "low_pass": {"type": "low_pass", "input": "raw", "frequency": 40.0},
    "lead_lag": {"type": "lead_lag", "input": "raw", "frequency": 40.0, "ratio": 2.0},
    "feed_forward": {"type": "feed_forward", "inputs": ["raw"], "signals": [{"type": "constant", "value": 1.0}]},
    "disturbance_observer": PD | {"type": "disturbance_observer", "bandwidth": 6.0, "input": "raw"},
}  # fmt: skip
MEASURED: dict[str, Sheet] = {
    "encoder": {"joint": "joint"}, "accelerometer": {}, "gyro": {},
    "strain_gauge": {"link": "link", "at": 0.5, "z": 0.01},
    "flange": {"link": "link"}, "output": {"output": "tip.x"},
}  # fmt: skip
NAMES = ("raw", "law", "a", "b", "a.x", "joint", "tip", "elbow", "joint.motor.position", "joint.torque", "tip.x",
         "joint.setpoint", "contact.force.z", "gravity.z", "", "a.noise1", "law.joint")  # fmt: skip
USUAL = ("joint.motor.position", "joint.setpoint", "tip.x", "joint.velocity")
VALUES = (0.0, -1.0, 1e-3, 0.01, 7, "10 ms", "3 kg", "2 Hz", "5 rad", None, True, [], {}, [1.0], {"joint": 2.0}, "x",
          float("nan"), 1e300, "joint", "raw")  # fmt: skip


def some(dice: random.Random) -> tuple[Sheet, list[Sheet], list[Sheet]]:
    """A drive, sensors and blocks: mostly valid, wires at random, then a few values replaced."""
    free = ["a", "b", "raw", "law", "tip"]
    dice.shuffle(free)
    sensors = [{"type": kind, "name": free.pop(), **MEASURED[kind]}
               for kind in dice.choices(sorted(MEASURED), k=dice.randrange(3))]  # fmt: skip
    for sensor in sensors:
        if dice.random() < 0.5:
            sensor |= {"sample_time": 0.01, "delay": dice.choice((0.0, 0.015)), "noise": dice.choice((0.0, 1e-3))}
    control = [_block(dice, free.pop()) for _ in range(dice.randrange(1, 4))]
    drive = {"controller": dict(LAWS[dice.choice(sorted(LAWS))])} if dice.random() < 0.3 else {}
    if not drive and dice.random() < 0.9:
        control[-1]["drives"] = ["joint"]
    groups = [one for one in (*sensors, *control, *(one["block"] for one in control), *drive.values()) if one]
    for _ in range(dice.choice((0, 0, 0, 1, 2))):
        one = dice.choice(groups)
        one[dice.choice([*one, "sample_time", "wire"])] = dice.choice((*VALUES, *NAMES))
    return drive, sensors, control


def _block(dice: random.Random, name: str) -> Sheet:
    own = dict(LAWS[dice.choice(sorted(LAWS))])
    found: Sheet = {"name": name, "block": own}
    if dice.random() < 0.1:
        found["drives"] = dice.choice((["joint"], ["joint", "joint"], ["elbow"]))
    if dice.random() < 0.6:
        found["of"] = "joint" if dice.random() < 0.9 else "elbow"
    if dice.random() < 0.3 and "sample_time" not in own:
        found |= {"sample_time": dice.choice((0.01, 1e-3)), "delay": dice.choice((0.0, 0.004))}
    if "input" in own:
        own["input"] = dice.choice(NAMES if dice.random() < 0.4 else USUAL)
    if "measured" in own:
        own["measured"] = dice.choices(NAMES if dice.random() < 0.4 else USUAL, k=dice.randrange(1, 3))
    return found


def bent(until: float, **more: Any) -> Robot:
    """A motor that turns a beam, without a gear."""
    drive = {"joint": "joint", "command": "position", "signal": STEPS} | more.pop("drive")
    link = {"name": "link", "beam": beam({"bend_z": 2}, 1.0, 40.0, 0.5, damping_time=1e-3)}
    joint = {"name": "joint", "type": "revolute", "child": "link", "axis": [0, 0, 1],
             "motor": {"inertia": 0.2, "side": "joint"}}  # fmt: skip
    return arm(joints=[joint], links=[link], drives=[drive], initial={"state": "zero"},
               integration={"duration": until, "output_step": 0.01}, **more)  # fmt: skip


def outcome(seed: int, *, run: bool) -> str:
    """What is wrong with sections at random; empty where a plan is made of them, and with ``run`` a run of it."""
    dice = random.Random(seed)  # noqa: S311  # a reproducible choice, not a secret
    drive, sensors, control = some(dice)
    try:
        more: Sheet = {"drive": drive, "sensors": sensors, "control": control}
        robot = bent(0.03, **more) if dice.random() < 0.4 else spong(STEPS, 0.03, 0.01, **more)
        planned(robot)
        if run:
            simulate_motion(robot)
    except (InputError, InputErrors, SimulationError) as error:
        return str(error)
    return ""


def test_sections_at_random() -> None:
    """Rings, missing wires, wrong names, units and values: nothing but errors of tmodes, which name the place."""
    said = {seed: outcome(seed, run=False) for seed in range(300)}
    valid = [seed for seed, words in said.items() if not words]
    assert len(valid) >= 10
    wrong = [words for words in said.values() if words]
    assert all(words.removeprefix("unknown key `").startswith(("control", "sensors", "drives")) for words in wrong)
    assert all(len(words) > 40 for words in wrong)
    for seed in valid[:12]:
        outcome(seed, run=True)


def law(block: Sheet) -> Sheet:
    return {"control": [{"name": "a", "drives": ["joint"], "block": block}]}


FOUND: dict[str, tuple[Sheet, str]] = {
    "a designed law that commands nothing": ({"drive": {"controller": PD}, "control": [
        {"name": "a", "of": "joint", "block": LQR}]}, "control.a.drives"),
    "computed torque that commands nothing": ({"drive": {"controller": PD}, "control": [
        {"name": "a", "of": "joint", "block": LAWS["computed_torque"]}]}, "control.a.drives"),
    "a law of one joint without it": ({"drive": {"controller": PD}, "control": [
        {"name": "a", "block": LAWS["gravity_pd"]}]}, "control.a.of"),
    "a filter at a drive that reads nothing": ({"drive": {"controller": NOTCH}}, "drives.0.controller"),
    "a filter at a drive that reads its own effect": ({"drive": {"controller": NOTCH | {"input": "joint.torque"}}},
                                                      "drives.0.controller"),
    "a measurement that is not there": ({"control": [{"name": "a", "drives": ["joint"], "block": LQG | {
        "measured": ["nothing"]}}]}, "control.a.block.measured"),
    "a weight below zero": (law(LQR | {"state_weights": {"joint.motor": -1.0}}), "state_weights.joint.motor"),
    "a noise below zero": (law(LQG | {"process_noise": {"joint'": -1.0}}), "process_noise.joint'"),
    "no weight on what drifts": (law(LQR | {"state_weights": {}}) | {"p": {"g": 0.0}}, "control.a.block.state_weights"),
    "an integral without a weight": (law(LQR | {"integral": True, "integral_weight": 0.0}), "state_weights"),
    "poles that grow": (law(LAWS["pole_placement"] | {"poles": [[2.0, -0.7], [4.0, 0.7]]}), "poles.0.1 must be"),
    "poles that are no pairs": (law(LAWS["pole_placement"] | {"poles": [2.0]}), "poles.0 must be a list of"),
    "no commands to add to": (law(LAWS["feed_forward"] | {"inputs": [], "signals": []}), "a list of at least 1 items"),
    "a wire that is nearly a block": ({"control": [{"name": "law", "of": "joint", "block": PD}, {
        "name": "a", "drives": ["joint"], "block": NOTCH | {"input": "lax"}}]}, "Did you mean `law`"),
    "a key of the level further out": (law(NOTCH | {"of": "joint"}), "put `of` into the group `control.a`"),
}  # fmt: skip


@pytest.mark.parametrize("name", FOUND)
def test_what_random_sections_have_found(name: str) -> None:
    more, place = FOUND[name]
    with pytest.raises((InputError, InputErrors)) as caught:
        planned(spong(STEPS, 1.0, 0.1, **more))
    assert place in str(caught.value)


def test_a_filter_at_a_drive_reads_an_output() -> None:
    """As the same filter in the section `control`."""
    block = LAWS["low_pass"] | {"input": "joint.setpoint"}
    as_block: Sheet = {"control": [{"name": "a", "drives": ["joint"], "block": block}]}
    both: tuple[Sheet, Sheet] = ({"drive": {"controller": block}}, as_block)
    found = [simulate_motion(spong(STEPS, 0.5, 0.05, **more)).q for more in both]
    assert np.array_equal(found[0], found[1])
    assert np.abs(found[0]).max() > 0.01
