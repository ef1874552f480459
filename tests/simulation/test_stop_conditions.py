"""Stop conditions of the 2010 robot: where they are located, what is kept, and what may be named."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.io.assignment import parse_assignment
from tmodes.io.sheet_write import robot_to_yaml
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.outputs import run_stops
from tmodes.simulation.plan import Follow

SHORT = {"integration.duration": 0.6, "integration.output_step": 0.01}
COMMAND = [sys.executable, "-m", "tmodes.cli.entry"]


@pytest.fixture(scope="module")
def robot():
    """The paper's robot as published."""
    return tmodes.load("filipovic2010")


@pytest.mark.parametrize("method", ["dormand_prince", "dop853", "rk4", "extrapolation", "midpoint"])
def test_a_motor_that_follows_its_reference_passes_an_angle(robot, method):
    """The motor of the nominal run passes an angle when the polynomials of the signal do."""
    changes = {**SHORT, "integration.method": method, "integration.stop": ["joint.motor.position > 2 deg"]}
    setup = run_setup(robot.with_(changes), Follow.WANTED)
    done = run_trajectory(setup, stops=run_stops(setup))
    signal = robot.drives[0].signal.schedule(robot.integration.duration)
    assert done.status == "stopped_by_condition"
    assert signal.at(done.times[-1]) == pytest.approx(np.deg2rad(2), abs=1e-13)
    motor = setup.model.layout.q.start + setup.model.coordinates.index("joint.motor")
    assert done.states[-1, motor] == pytest.approx(np.deg2rad(2), abs=1e-9)


@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_a_result_up_to_the_condition(robot, method):
    """A success with its own status: its last sample is where the condition triggers, the reference has one there."""
    sheet = robot.with_({**SHORT, "integration.method": method, "integration.stop": ["tip.speed > 0.05 m/s"]})
    result = tmodes.run(sheet)
    whole = tmodes.run(robot.with_({**SHORT, "integration.method": method}))
    assert (result.status, result.success) == ("stopped_by_condition", True)
    assert "`tip.speed > 0.05 m/s`, tip.speed reaches 0.05 m/s" in result.message
    end = float(result.data["time"][-1])
    assert f"t = {end:.9g} s" in result.message
    assert np.linalg.norm(result.data["tip_velocity"].values[-1]) == pytest.approx(0.05, abs=1e-12)
    count = result.data.sizes["time"] - 1
    assert result.data["q"].values[:count].tobytes() == whole.data["q"].values[:count].tobytes()
    motors = [one.data["q_nominal"].sel(coordinate="joint.motor").values for one in (whole, result)]
    between = np.interp(end, whole.data["time"].values, motors[0])
    assert motors[1][-1] == pytest.approx(between, abs=1e-4)
    assert result.summary()["error"]["figures"]["deviation.end_m"] > 0


def test_every_name_gives_a_number(robot):
    """All quantities that a message may offer have values at a state, one for each instant."""
    setup = run_setup(robot)
    states, rows = np.tile(setup.start, (3, 1)), np.tile(setup.first_row, (3, 1))
    outputs = setup.model.outputs
    values = setup.model.seen([*outputs.values()], np.zeros(3), states, rows)
    assert values.shape == (3, len(outputs))
    assert np.isfinite(values).all()


@pytest.mark.parametrize(
    ("stop", "error", "info"),
    [("joint.motor.positoin > 1", InputError, r"stop.0: unknown name .*Did you mean `joint.motor.position`"),
     ("contact.force < 5 Nm", InputError, "another dimension|unknown"),
     ("contact.force > 1 N", SimulationError, "holds at the start already")],
)  # fmt: skip
def test_what_is_refused(robot, stop, error, info):
    with pytest.raises(error, match=info):
        tmodes.run(robot.with_(SHORT), stop=[stop])


def test_a_sheet_with_a_wrong_condition_is_refused(robot):
    """With the place in the sheet, whatever the number of wrong values."""
    with pytest.raises(
        InputErrors,
        match=r"integration.stop.1 must be a name, > or <, and a number, .* got 'tip.z'",
    ) as errors:
        robot.with_({"integration.stop": ["tip.z < 0", "tip.z", "a = 1"]})
    assert len(errors.value.errors) == 2


@pytest.mark.parametrize("name", ["filipovic2010", "spong1987"])
def test_conditions_are_written_and_read_back(name, tmp_path):
    """In the sheet as YAML, with whatever a condition holds."""
    sheet = tmodes.load(name, {"integration.stop": ["tip.z < 250 mm", "abs(tip.velocity.x) > 90e-3"]})
    (tmp_path / "sheet.yaml").write_text(robot_to_yaml(sheet), encoding="utf-8")
    assert tmodes.load(tmp_path / "sheet.yaml") == sheet


def test_batches_refuse_conditions(robot):
    """They are not silently ignored."""
    from tmodes.simulation.vary.simulate import simulate_batch

    sheet = robot.with_({**SHORT, "integration.stop": ["tip.z < 0"]})
    with pytest.raises(InputError, match=r"integration.stop must be .*all lanes of a batch run to the end"):
        simulate_batch(sheet, {"payload.mass": [0.4, 0.5]})


@pytest.mark.parametrize("name", ["filipovic2010", "spong1987"])
def test_a_wrong_name_is_reported_by_check(name, tmp_path):
    """Before anything runs, and nothing is written."""
    from tmodes.cli.main import app

    sheet = tmodes.load(name, {"integration.stop": ["tip.q < 1"]})
    (tmp_path / "sheet.yaml").write_text(robot_to_yaml(sheet), encoding="utf-8")
    with pytest.raises(InputError, match=r"integration.stop.0: unknown name 'tip.q'.*Did you mean `tip.z`"):
        app(["check", str(tmp_path / "sheet.yaml")], standalone_mode=False)


def test_from_the_command_line(tmp_path):
    """The result is whole, the exit code is 0, and the way it ended is reported."""
    options = ["--stop", "joint.motor.position > 2 deg", "--no-report", "--duration", "0.6"]
    command = [*COMMAND, "run", "filipovic2010", *options, "--json", "--out", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    info = json.loads(done.stdout)
    assert info["status"] == "stopped_by_condition"
    assert "joint.motor.position > 2 deg" in done.stderr
    kept = tmodes.Result.load(tmp_path / "result.nc")
    assert kept.status == "stopped_by_condition"
    assert kept.robot.integration.stop == ("joint.motor.position > 2 deg",)


@pytest.mark.parametrize("name", ["filipovic2010", "spong1987"])
@pytest.mark.parametrize(
    ("assignment", "span"),
    [("relative_tolerance=1e-15", "from 1e-13 to 0.01"), ("relative_tolerance=0", "from 1e-13 to 0.01"),
     ("absolute_tolerance=1e-30", "from 1e-18 to 0.01"), ("duration=-1", "from 1e-12 to 1e+06"),
     ("output_step=0", "from 1e-12 to 1e+12"), ("step=0", "from 1e-12 to 1e+12"), ("max_steps=0", "from 1 to 1e+12"),
     ("line_points=5000", "from 2 to 1001"), ("max_wall_time=-1", "from 1e-12 to 1e+12"),
     ("energy_tolerance=0", "from 1e-12 to 1e+12")],
)  # fmt: skip
def test_refused_settings_tell_the_least_and_the_largest_value(name, assignment, span):
    path, value = parse_assignment(f"integration.{assignment}")
    with pytest.raises(InputErrors) as errors:
        tmodes.load(name, {path: value})
    assert span in str(errors.value)


def test_one_condition_needs_no_list(robot):
    assert robot.with_({"integration.stop": "tip.z < -5 m"}).integration.stop == ("tip.z < -5 m",)
    result = tmodes.run(robot.with_(SHORT), stop="tip.speed > 0.05 m/s")
    assert result.status == "stopped_by_condition"
    cases: list[Any] = [5, [5]]
    for wrong in cases:
        with pytest.raises(InputError, match="stop must be"):
            tmodes.run(robot, stop=wrong)
