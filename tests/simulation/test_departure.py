"""A start that is no equilibrium is said, whatever the reason, with what moves off; none that is, or that moves."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from simulation.sheets import arm, pendulum
from simulation.test_closed_start import LEVER, lever
from tmodes import run
from tmodes.cli.sheets import check
from tmodes.simulation.departure import departure
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.simulate import simulate_motion

RATE, FAST = 3.0, 2.0
SPIN = {"type": "expression", "formula": f"{RATE}*t"}
JERK = {"type": "expression", "formula": f"{FAST / 2}*t**2"}


def departed(setup: RunSetup) -> Any:
    """What moves off."""
    return departure(setup, setup.first_row)


def angle(setup: RunSetup) -> float:
    """Of the lever's link [rad], against the horizontal; positive upwards."""
    return float(setup.start[setup.model.coordinates.index("j")])


def test_a_base_that_begins_to_spin_or_to_accelerate_is_said_with_the_size_of_the_jump() -> None:
    """I a = m L^2 W^2 sin cos, and m L az cos; the way is the force over the spring that is left, to first order."""
    spun, lifted = run_setup(lever(base_motion={"yaw": SPIN})), run_setup(lever(base_motion={"z": JERK}))
    swing = -(RATE**2) * np.sin(angle(spun)) * np.cos(angle(spun))
    fall = -FAST / LEVER * np.cos(angle(lifted))
    for setup, wanted in ((spun, swing), (lifted, fall)):
        moved, spring = departed(setup), 1 / (1 / 2000.0 + 1 / 400.0)
        assert (moved.name, moved.unit, moved.bends, moved.at_once) == ("j", "rad/s^2", False, True)
        assert moved.acceleration == pytest.approx(wanted, rel=1e-9)
        assert moved.distance == pytest.approx(abs(wanted) * 2.0 * LEVER**3 / spring, rel=0.05)


def test_coordinates_that_are_placed_and_setpoints_that_move_at_once_are_said() -> None:
    placed = departed(run_setup(lever(initial={"coordinates": {"j": 0.1}})))
    assert (placed.name, placed.at_once, placed.distance) == ("j", False, None)
    assert placed.acceleration == pytest.approx(-2000 * 0.1 / 0.5 - 9.81 / LEVER * np.cos(0.1), rel=0.1)
    ramp = departed(run_setup(lever().with_({"drives.0.signal": SPIN})))
    assert (ramp.name, ramp.at_once, ramp.distance) == ("j", True, None)
    assert ramp.acceleration == pytest.approx(30.0 * RATE / 0.1, rel=1e-9)  # velocity_gain * rate / inertia


@pytest.mark.parametrize("off", [{"resolution": 1e-3}, {"noise": 1e-3}])
def test_what_a_sensor_rounds_and_its_noise_are_no_departure(off: dict[str, float]) -> None:
    law = {"type": "sampled_pid", "position_gain": 400.0, "velocity_gain": 30.0, "sample_time": 1e-3,
           "filter_time": 2e-3, "measured": "teeth"}  # fmt: skip
    teeth = {"name": "teeth", "type": "encoder", "joint": "j", "side": "motor", "sample_time": 1e-3, **off}
    setup = run_setup(lever(law, sensors=[teeth]))
    assert np.abs(setup.model.observe([0.0], setup.start, setup.first_row)["a"]).max() > 0.1
    assert departed(setup) is None


def test_setpoints_that_begin_with_next_to_no_rate_are_none() -> None:
    """30 N*m*s of 1e-8 rad/s: a spring of 2000 N*m/rad gives way to that by 1.5e-10 rad."""
    slow = {"type": "expression", "formula": "1e-8*t"}
    assert departed(run_setup(lever().with_({"drives.0.signal": slow}))) is None


def test_a_link_that_bends_is_named_with_the_acceleration_of_its_tip() -> None:
    section = {"bending_stiffness": 40.0, "torsional_stiffness": 30.0, "mass_per_length": 0.5,
               "polar_inertia_per_length": 1e-4}  # fmt: skip
    beam = {"model": "strain", "functions": 2, "length": 0.6, "section": section, "damping_time": 0.0}
    joint = {"name": "f", "type": "fixed", "child": "rod"}
    robot = arm(joints=[joint], links=[{"name": "rod", "beam": beam}], base_motion={"z": JERK},
                integration={"duration": 0.1, "output_step": 0.01})  # fmt: skip
    setup = run_setup(robot)
    moved = departed(setup)
    assert (moved.name, moved.bends, moved.unit) == ("rod", True, "m/s^2")
    first = setup.mechanics.jacobian(setup.start[setup.model.layout.q])[0, :3]
    found = setup.model.observe([0.0], setup.start, setup.first_row)["a"][0]
    assert moved.acceleration == pytest.approx(float(np.linalg.norm(first @ found)), rel=1e-9)


def test_a_python_controller_is_said_to_move_off_where_it_does() -> None:
    robot = pendulum({"inertia": 0.3}, {"stiffness": 100.0, "damping": 0.5},
                     {"command": "position", "signal": {"type": "constant", "value": 0.0},
                      "controller": {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}},
                     gravity=0.0, integration={"duration": 0.02, "output_step": 0.01})  # fmt: skip
    pushed = run(robot, controller=lambda time, q, v: [1.5])
    assert any("5 rad/s^2" in warning for warning in pushed.warnings)
    assert not simulate_motion(robot, controller=lambda time, q, v: [0.0]).warnings


@pytest.mark.parametrize("more", [{}, {"initial": {"rates": {"j": 0.1}}},
                                  {"base_motion": {"z": {"type": "quintic", "start": 0, "end": 1, "duration": 1}}}],
                         ids=["rest", "moving", "smooth"])  # fmt: skip
def test_what_rests_or_moves_on_purpose_is_not_said(more: dict[str, Any]) -> None:
    assert departed(run_setup(lever(**more))) is None


def test_rounding_of_a_stiff_gear_under_a_small_load_is_not_said() -> None:
    robot = lever(gravity=1e-6).with_({"joints.j.gear.stiffness": 1e8, "drives.0.signal.value": 1.0})
    assert departed(run_setup(robot)) is None


def test_check_says_what_the_run_says(capsys: pytest.CaptureFixture[str]) -> None:
    check("spong1987", ["initial.coordinates={joint: 0.2}"], as_json=True)
    said = json.loads(capsys.readouterr().out)["warnings"]
    check("spong1987", as_json=True)
    assert len(said) == len(json.loads(capsys.readouterr().out)["warnings"]) + 1
