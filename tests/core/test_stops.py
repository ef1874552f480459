"""Stop conditions of the 2010 robot: where they are located, what is kept, and what may be named."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np
import pytest
from tmodes.io.write import robot_to_yaml

from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.io.assignment import parse_assignment
from tmodes.io.sheet_write import arm_to_yaml
from tmodes.paper.mechanism import Drive
from tmodes.paper.model import PaperModel
from tmodes.paper.quantities import robot_quantities, robot_stops
from tmodes.paper.regime import run_paper
from tmodes.paper.sheet import PaperRobot
from tmodes.paper.simulate import simulate
from tmodes.result.record import PaperResult
from tmodes.simulation.stops import Instants

SHORT = {"integration.duration": 0.6, "integration.output_step": 0.01}
COMMAND = [sys.executable, "-m", "tmodes.cli.entry"]


@pytest.mark.parametrize("method", ["dormand_prince", "dop853", "rk4", "extrapolation", "midpoint"])
def test_a_motor_that_follows_its_reference_passes_an_angle(robot, method):
    """theta is theta_o of the planned robot: it passes an angle when the polynomials of the reference do."""
    sheet = robot.with_({**SHORT, "integration.method": method})
    run = run_paper(sheet, Drive.PRESCRIBED, stops=robot_stops(sheet, ["theta.position > 2 deg"], Drive.PRESCRIBED))
    schedule = robot.reference.schedule()
    assert run.trajectory.status == "stopped_by_condition"
    time = run.trajectory.times[-1]
    assert schedule.at(time) == pytest.approx(np.deg2rad(2), abs=1e-9)
    assert run.trajectory.states[-1, 5] == pytest.approx(np.deg2rad(2), abs=1e-13)


@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_a_result_up_to_the_condition(robot, method):
    """A success with its own status: its last sample is where the condition sets in, the reference has one there."""
    sheet = robot.with_({**SHORT, "integration.method": method, "integration.stop": ["tip.speed > 0.05 m/s"]})
    result = simulate(sheet)
    whole = simulate(robot.with_({**SHORT, "integration.method": method}))
    assert (result.status, result.success) == ("stopped_by_condition", True)
    assert "`tip.speed > 0.05 m/s`, tip.speed reaches 0.05 m/s" in result.message
    end = float(result.data["time"][-1])
    assert f"t = {end:.9g} s" in result.message
    assert np.linalg.norm(result.data["tip_velocity"].values[-1]) == pytest.approx(0.05, abs=1e-12)
    count = result.data.sizes["time"] - 1
    assert result.data["q"].values[:count].tobytes() == whole.data["q"].values[:count].tobytes()
    between = np.interp(end, whole.data["time"].values, whole.data["q_reference"].values[:, 5])
    assert result.data["q_reference"].values[-1, 5] == pytest.approx(between, abs=1e-4)
    assert result.summary()["error"]["figures"]["deviation.end_m"] > 0


def test_every_name_gives_a_number(robot):
    """All quantities that a message may offer have values at a state, one for each instant."""
    mechanism, parameters = robot.split(Drive.CONTROLLED)
    model = PaperModel(mechanism)
    states = np.tile(model.rest(0.0, parameters), (3, 1))
    rows = robot.reference.schedule().rows_at(np.zeros(3))
    for name, quantity in robot_quantities(model, parameters).items():
        values = quantity.of(Instants(np.zeros(3), states, rows))
        assert values.shape == (3,), name
        assert np.isfinite(values).all(), name


@pytest.mark.parametrize(
    ("stop", "error", "info"),
    [("theta.positoin > 1", InputError, "Did you mean `theta.position`"),
     ("contact.force < 5 Nm", InputError, "another dimension|unknown"),
     ("contact.force > 1 N", SimulationError, "holds at the start already")],
)  # fmt: skip
def test_what_is_refused(robot, stop, error, info):
    with pytest.raises(error, match=info):
        simulate(robot.with_(SHORT), stop=[stop])


def test_a_sheet_with_a_wrong_condition_is_refused(robot):
    """With the place in the sheet, whatever the number of wrong values."""
    with pytest.raises(InputErrors, match=r"integration.stop.1: got 'tip.z'") as errors:
        robot.with_({"integration.stop": ["tip.z < 0", "tip.z", "a = 1"]})
    assert len(errors.value.errors) == 2


@pytest.mark.parametrize("name", ["filipovic2010", "spong1987"])
def test_conditions_are_written_and_read_back(name, tmp_path):
    """In the sheet as YAML, with whatever a condition holds."""
    from tmodes.robots.load import load

    sheet = load(name, {"integration.stop": ["tip.z < 250 mm", "abs(tip.velocity.x) > 90e-3"]})
    written = robot_to_yaml(sheet) if isinstance(sheet, PaperRobot) else arm_to_yaml(sheet)
    (tmp_path / "sheet.yaml").write_text(written, encoding="utf-8")
    assert load(tmp_path / "sheet.yaml") == sheet


def test_batches_refuse_conditions(robot):
    """They are not silently ignored."""
    from tmodes.simulation.vary.simulate import simulate_batch

    sheet = robot.with_({**SHORT, "integration.stop": ["tip.z < 0"]})
    with pytest.raises(InputError, match=r"integration.stop: .*all lanes of a batch run to the end"):
        simulate_batch(sheet, {"payload.mass": [0.4, 0.5]})


@pytest.mark.parametrize("name", ["filipovic2010", "spong1987"])
def test_a_wrong_name_is_reported_by_check(name, tmp_path):
    """Before anything runs, and nothing is written."""
    from tmodes.cli.main import app
    from tmodes.robots.load import load

    sheet = load(name, {"integration.stop": ["tip.q < 1"]})
    written = robot_to_yaml(sheet) if isinstance(sheet, PaperRobot) else arm_to_yaml(sheet)
    (tmp_path / "sheet.yaml").write_text(written, encoding="utf-8")
    with pytest.raises(InputError, match=r"integration.stop.0: got the unknown name 'tip.q'.*Did you mean `tip.z`"):
        app(["check", str(tmp_path / "sheet.yaml")], standalone_mode=False)


def test_from_the_command_line(tmp_path):
    """The result is whole, the exit code is 0, and the way it ended is told."""
    options = ["--stop", "theta.position > 2 deg", "--no-figures", "--duration", "0.6"]
    command = [*COMMAND, "run", "filipovic2010", *options, "--json", "--out", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    info = json.loads(done.stdout)
    assert info["status"] == "stopped_by_condition"
    assert "theta.position > 2 deg" in done.stderr
    kept = PaperResult.load(tmp_path / "result.nc")
    assert kept.status == "stopped_by_condition"
    assert kept.robot.integration.stop == ("theta.position > 2 deg",)


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
    from tmodes.robots.load import load

    path, value = parse_assignment(f"integration.{assignment}")
    with pytest.raises(InputErrors) as errors:
        load(name, {path: value})
    assert span in str(errors.value)
