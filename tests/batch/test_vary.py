"""Varied sheets: each lane is the run of its own sheet; wrong numbers and starts are reported with their lane."""

from __future__ import annotations

import math

import numpy as np
import pytest

import tmodes
from simulation.sheets import pendulum, torque
from tmodes.errors import InputError, InputErrors, TmodesError
from tmodes.simulation.batch.result import load_batch
from tmodes.simulation.simulate import simulate_motion

SHORT = {"integration.duration": 0.02, "integration.output_step": 1e-3}


@pytest.fixture(scope="module")
def robot():
    return tmodes.load("filipovic2010").with_(SHORT)


def swing(**more):
    """An elastic pendulum under a torque."""
    integration = {"duration": 0.2, "output_step": 0.01, **more}
    return pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(2.0), integration=integration)


def test_each_lane_is_the_run_of_its_sheet(robot):
    """Known and actual numbers vary together, by the paths of the 2010 sheet."""
    vary = {"payload.mass": [0.4, 0.5, 0.6, 0.7], "real.gear.stiffness": [0.5, 1.0, 1.5, 1.0],
            "gear.stiffness": [4000.0, 5000.0, 6000.0, 5000.0]}  # fmt: skip
    batch = tmodes.simulate_batch(robot, vary, tips=True, threads=2)
    assert batch.finished.all()
    for lane in range(4):
        run = simulate_motion(robot.with_({path: numbers[lane] for path, numbers in vary.items()}))
        assert np.abs(batch.states[lane] - run.states).max() < 1e-12 * np.abs(run.states).max()
        assert batch.tips is not None
        assert np.abs(batch.tips[lane] - run.points.position[:, 0]).max() < 1e-12
    assert {path: numbers.tolist() for path, numbers in batch.values.items()} == vary


@pytest.mark.parametrize("method", ["auto", "extrapolation"])
def test_each_lane_is_the_run_of_its_arm(method):
    arm = swing(method=method)
    masses = [0.8, 1.0, 1.7]
    batch = tmodes.simulate_batch(arm, {"links.link.bodies.bob.mass": masses}, tips=True)
    for lane, mass in enumerate(masses):
        run = simulate_motion(arm.with_({"links.link.bodies.bob.mass": mass}))
        n = len(run.coordinates)
        assert np.abs(batch.states[lane, :, :n] - run.q).max() < 1e-12
        assert batch.tips is not None
        assert np.abs(batch.tips[lane] - run.points.position[:, 0]).max() < 1e-12
        assert batch.statistics["steps"][lane] == run.statistics["steps"]


def test_each_lane_has_its_own_start_and_motion():
    """Initial state and signals are numbers of the sheet like all others."""
    arm, starts, efforts = swing(), [0.1, -0.4, 0.2], [2.0, -1.0, 0.5]
    vary = {"initial.coordinates.joint": starts, "drives.0.signal.value": efforts}
    batch = tmodes.simulate_batch(arm, vary)
    for lane, (start, effort) in enumerate(zip(starts, efforts, strict=True)):
        run = simulate_motion(arm.with_({"initial.coordinates.joint": start, "drives.0.signal.value": effort}))
        assert batch.states[lane, 0, 0] == start
        assert np.abs(batch.states[lane, :, :2] - run.q).max() < 1e-12


def test_the_tip_on_a_base_that_moves():
    """The tip is given in the world, which the base does not stand in."""
    ramp = {"type": "expression", "formula": "0.3*t"}
    arm = type(swing()).from_data(swing().model_dump(mode="json", exclude_none=True) | {"base_motion": {"x": ramp}})
    batch = tmodes.simulate_batch(arm, {"gravity": [9.0, 9.8]}, tips=True)
    run = simulate_motion(arm.with_({"gravity": 9.8}))
    assert batch.tips is not None
    assert np.abs(batch.tips[1] - run.points.position[:, 0]).max() < 1e-12
    assert batch.tips[1, -1, 0] - batch.tips[1, 0, 0] > 0.03


def test_a_lane_that_cannot_start_disturbs_no_other(robot):
    loads = [0.5, 1e12, 0.6]
    batch = tmodes.simulate_batch(robot, {"payload.mass": loads}, tips=True)
    good = tmodes.simulate_batch(robot, {"payload.mass": [0.5, 0.6]}, tips=True)
    assert batch.status == ("finished", "failed", "finished")
    assert "static equilibrium: none was found near the start" in batch.message[1]
    assert batch.counts[1] == 0
    assert np.isnan(batch.states[1]).all()
    assert batch.states[[0, 2]].tobytes() == good.states.tobytes()


def test_the_folder_holds_what_was_varied(robot, tmp_path):
    batch = tmodes.simulate_batch(robot, {"payload.mass": [0.4, 0.6]}, tips=True, out=tmp_path / "study")
    again = load_batch(tmp_path / "study")
    memory = tmodes.simulate_batch(robot, {"payload.mass": [0.4, 0.6]}, tips=True)
    assert again.values["payload.mass"].tolist() == batch.values["payload.mass"].tolist() == [0.4, 0.6]
    assert again.states.tobytes() == memory.states.tobytes()
    assert again.tips is not None
    assert memory.tips is not None
    assert again.tips.tobytes() == memory.tips.tobytes()


WRONG = {
    "case 1.*payload.mass": {"payload.mass": [0.4, -1.0]},
    "case 0.*payload.mass": {"payload.mass": [np.nan]},
    "Did you mean `payload.mass`": {"payload.mas": [0.4]},
    "one integration for all": {"integration.duration": [0.1, 0.2]},
    "same length": {"payload.mass": [0.4, 0.5], "gravity": [9.81]},
    "numbers": {"payload.mass": ["heavy"]},
    "no path": {},
    r"shapes .*\(\)": {"payload.mass": 0.4},
}


@pytest.mark.parametrize("info", list(WRONG))
def test_wrong_numbers_are_reported_with_their_lane(robot, info):
    with pytest.raises((InputError, InputErrors), match=info):
        tmodes.simulate_batch(robot, WRONG[info])


@pytest.mark.parametrize("first", [100.0, math.inf])
def test_a_rigid_gear_next_to_elastic_ones(first, tmp_path):
    """The batch has the coordinates of all lanes: where there is no motor apart, it moves as its joint."""
    stiffness = [first, 300.0, math.inf]
    batch = tmodes.simulate_batch(swing(), {"joints.joint.gear.stiffness": stiffness}, tips=True, out=tmp_path)
    assert batch.coordinates == ("joint.motor", "joint")
    assert batch.finished.all()
    for lane, value in enumerate(stiffness):
        run = simulate_motion(swing().with_({"joints.joint.gear.stiffness": value}))
        joint, motor = (run.coordinates.index(name) for name in ("joint", run.coordinates[0]))
        true = np.hstack([run.q[:, [motor, joint]], run.v[:, [motor, joint]]])
        assert np.abs(batch.states[lane, :, :4] - true).max() < 1e-12 * np.abs(true).max()
        assert np.abs(batch.states[lane, :, 4:] - run.states[:, 2 * run.q.shape[1] :]).max() < 1e-12
        assert batch.tips is not None
        assert np.abs(batch.tips[lane] - run.points.position[:, 0]).max() < 1e-12


OTHER_STATES = {
    "drives.0.delay": [0.0, 0.025, 0.007, 0.01],  # 0, 3, 1 and 1 commands that are under way
    "drives.0.sample_time": [0.02, 0.002, 0.013, 3.0],
    "joints.joint.motor.inductance": [0.0, 0.01],
}


@pytest.mark.parametrize("path", [*OTHER_STATES])
def test_lanes_have_states_of_their_own(path):
    """Commands under way in a delay, a current that is a state: each lane is the run by itself."""
    motor = {"inertia": 0.3, "resistance": 1.0, "side": "joint", "back_emf_constant": 0.5, "torque_constant": 0.5,
             "inductance": 0.0}  # fmt: skip
    law = {"type": "pd", "position_gain": 20.0, "velocity_gain": 3.0}
    drive = {"joint": "joint", "command": "position", "signal": {"type": "step", "start": 0.0, "end": 0.2, "time": 0.1},
             "controller": law, "sample_time": 0.01, "delay": 0.004}  # fmt: skip
    robot = swing().with_({"joints.joint.motor": motor, "drives": [drive]})
    batch = tmodes.simulate_batch(robot, {path: OTHER_STATES[path]}, tips=True)
    assert batch.finished.all()
    for lane, value in enumerate(OTHER_STATES[path]):
        run = simulate_motion(robot.with_({path: value}))
        assert np.abs(batch.states[lane, :, :4] - np.hstack([run.q, run.v])).max() < 1e-9
        missing = np.isnan(batch.states[lane]).all(axis=0)
        assert batch.states.shape[2] - missing.sum() == run.states.shape[1]
        assert batch.tips is not None
        assert np.abs(batch.tips[lane] - run.points.position[:, 0]).max() < 1e-9


def test_too_large_is_refused_before_the_lanes_are_prepared(robot):
    """One lane is enough to tell."""
    stages = []
    long = robot.with_({"integration.duration": 1e4, "integration.output_step": 0.1})
    with pytest.raises(TmodesError, match=r"at most 1\.8 GB in memory"):
        tmodes.simulate_batch(
            long, {"payload.mass": np.linspace(0.4, 0.6, 1000)}, progress=lambda *info: stages.append(info)
        )
    assert not stages


def test_a_stop_that_batches_do_not_watch_is_refused(robot):
    """Rather than left out without a word."""
    with pytest.raises(InputError, match=r"integration.energy_stop must be false: .*, got true.*tmodes run"):
        tmodes.simulate_batch(robot.with_({"integration.energy_stop": True}), {"payload.mass": [0.5]})
