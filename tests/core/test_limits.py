"""Physical limits and honest ends: rigid by wish, nothing to lose, singular, unstable steps, bad numbers."""

from __future__ import annotations

import math

import numpy as np
import pytest

from io_cases import bad_numbers
from tmodes.analysis.spectrum import MotorState, Spectrum
from tmodes.analysis.stability import step_size_verdict, step_times_eigenvalue
from tmodes.analysis.validity import jam_warnings
from tmodes.equations.lagrange.coordinates import deformations
from tmodes.errors import InputError, InputErrors, SimulationError, TmodesError
from tmodes.integrate.settings import Integration
from tmodes.paper.mechanism import Drive
from tmodes.paper.model import PaperModel
from tmodes.paper.modes import all_modes, vibration_modes
from tmodes.paper.regime import run_paper
from tmodes.paper.sheet import PaperPair, PaperRobot
from tmodes.paper.simulate import simulate

RIGID = {
    "gear": {"gear.stiffness": math.inf},
    "mode 1": {"link.modes.0.bending_stiffness": math.inf},
    "mode 2": {"link.modes.1.bending_stiffness": math.inf},
    "all": {
        "gear.stiffness": math.inf,
        "link.modes.0.bending_stiffness": math.inf,
        "link.modes.1.bending_stiffness": math.inf,
    },
}
SHORT = {"integration.duration": 0.3, "integration.output_step": 0.01, "integration.relative_tolerance": 1e-8}


@pytest.mark.parametrize("elements", list(RIGID))
@pytest.mark.parametrize("drive", [Drive.CONTROLLED, Drive.PRESCRIBED])
def test_rigid_is_the_limit_of_stiff(robot, elements, drive):
    """Infinite stiffness takes the coordinate away; a thousand times stiffer comes a thousand times nearer to it."""
    robot = robot.with_({"gear.damping": 40.0, **SHORT})  # so that the stiff motion dies out and the limit is seen
    rigid = robot.with_(RIGID[elements])
    limit = run_paper(rigid, drive).trajectory.states[:, :6]
    held = np.stack(deformations(limit.T), axis=1)
    numbers, distance = dict(robot.numbers()), []
    for factor in (30.0, 300.0):
        stiff = {path: numbers[path] * factor for path in RIGID[elements]}
        near = run_paper(robot.with_(stiff), drive).trajectory.states[:, :6]
        distance.append(np.abs(near - limit).max())
    assert distance[1] < 0.25 * distance[0]
    names = {"gear": [4], "mode 1": [0, 2], "mode 2": [1, 3], "all": [0, 1, 2, 3, 4]}[elements]
    assert np.abs(held[:, names]).max() < 1e-12


def test_rigid_gear_still_has_a_torque(robot):
    """The torque of a rigid gear is what the arm asks of it: the balance at the motor closes."""
    run = run_paper(robot.with_({"gear.stiffness": math.inf, **SHORT}), Drive.CONTROLLED)
    t = run.trajectory
    seen = run.model.observe(t.times, t.states, run.rows, run.parameters)
    motor = robot.motor
    at_motor = motor.torque_constant * seen["current"] - motor.friction * t.states[:, 11] + seen["gear_torque"]
    assert np.allclose(at_motor, motor.inertia * seen["acceleration"][:, 5], atol=1e-9 * np.abs(at_motor).max())


@pytest.mark.parametrize("reading", ["printed", "consistent"])
@pytest.mark.parametrize("contact", [False, True])
@pytest.mark.parametrize("law", ["signed", "magnitude"])
def test_power_balance(robot, reading, contact, law):
    """With every loss on, the balance closes to 1e-8 of the energy moved."""
    change = {"reading": reading, "contact": contact, "environment.friction_law": law}
    result = simulate(robot.with_(change))
    assert result.success
    assert not result.warnings
    assert result.summary()["energy"]["worst_residual_over_moved"] < 1e-8


def test_unstable_step_is_never_called_finished(robot):
    """rk4 beyond its stability limit: told before, diverged after, with dt*omega; what it had is kept."""
    change = {"gear.stiffness": 4.7e9, "integration.method": "rk4", "integration.step": 1e-3}
    result = simulate(robot.with_(change))
    assert result.status == "diverged"
    assert "dt*omega" in result.message
    assert "coordinate" in result.message
    assert "at t = " in result.message
    assert result.data.sizes["time"] >= 1
    assert all(np.isfinite(v.values).all() for v in result.data.data_vars.values() if v.dtype.kind == "f")


def test_what_was_done_is_kept_when_the_reference_is_lost(robot):
    """The reference's robot is the stiffer one here: both are kept as far as the reference came."""
    change = {"integration.method": "rk4", "integration.step": 2.5e-3, "integration.output_step": 2.5e-3}
    result = simulate(robot.with_({**change, "contact": False}))
    assert result.status == "diverged"
    assert result.message.startswith("reference: diverged at t = ")
    assert 3 < result.data.sizes["time"] < 800
    assert all(np.isfinite(v.values).all() for v in result.data.data_vars.values() if v.dtype.kind == "f")


def spectrum(eigenvalues):
    return Spectrum(eigenvalues, ("q",) * len(eigenvalues))


def test_step_verdict():
    """|R(z)| = 1 of the classical method on the imaginary axis at 2.828."""
    ring = np.array([1000j, -1000j])
    assert step_size_verdict(Integration(method="rk4", step=2.82e-3), spectrum(ring)).stable
    assert not step_size_verdict(Integration(method="rk4", step=2.84e-3), spectrum(ring)).stable
    decay = np.array([-1000.0 + 0j])
    assert step_size_verdict(Integration(method="rk4", step=2.78e-3), spectrum(decay)).stable
    assert not step_size_verdict(Integration(method="rk4", step=2.79e-3), spectrum(decay)).stable
    adaptive = step_size_verdict(Integration(step=1.0), spectrum(ring))
    assert adaptive.stable
    assert step_times_eigenvalue(adaptive, {"mean_step_s": 2e-3}) == pytest.approx(2.0)
    assert step_times_eigenvalue(adaptive, {"mean_step_s": None}) is None
    fixed = step_size_verdict(Integration(method="rk4", step=1e-3), spectrum(ring))
    assert step_times_eigenvalue(fixed, {"mean_step_s": 9.0}) == pytest.approx(1.0)


def test_too_stiff_is_reported_before_the_run(robot):
    """Steps that no one would wait for are refused with their number and the coordinate."""
    with pytest.raises(SimulationError, match=r"too stiff.* coordinate \w+ .* steps"):
        simulate(robot.with_({"gear.damping": 1e9, "integration.method": "dormand_prince"}))


def test_coarse_integration_is_warned_of(robot):
    """The energy monitor speaks when the balance does not close."""
    coarse = {"integration.relative_tolerance": 1e-2, "integration.absolute_tolerance": 1e-3}
    result = simulate(robot.with_(coarse))
    assert any("energy balance" in warning for warning in result.warnings)
    assert result.success
    stopped = simulate(robot.with_({**coarse, "integration.energy_stop": True}))
    assert stopped.status == "stopped"
    assert "energy balance" in stopped.message
    assert 1 <= stopped.data.sizes["time"] < result.data.sizes["time"]


def test_large_bending_is_warned_of(robot):
    """Beyond the small angles of the model the run says so, with the first time and the value."""
    result = simulate(robot.with_({"payload.mass": 6.0, "contact": False, **SHORT}))
    assert any("small-angle range" in warning and "first at t = " in warning for warning in result.warnings)


def test_singular_mass_matrix_names_the_coordinate(robot):
    """Masses that vanish are found before the run."""
    mechanism, parameters = robot.split(Drive.CONTROLLED, contact=False)
    parameters.vector[parameters.names.index("motor.inertia")] = 0.0
    model = PaperModel(mechanism)
    with pytest.raises(SimulationError, match="theta"):
        model.check_mass_matrix(model.rest(0.0, parameters), parameters)


def test_no_equilibrium_is_reported(robot):
    """A link that cannot carry its load is refused before the run."""
    with pytest.raises(SimulationError, match="equilibrium"):
        simulate(robot.with_({"link.modes.1.bending_stiffness": 1e-6, "contact": False}))


CASES = list(bad_numbers())


@pytest.mark.slow
@pytest.mark.parametrize(("name", "path", "kind", "text"), CASES, ids=[case[0] for case in CASES])
def test_every_bad_number_errs_or_runs(name, path, kind, text, tmp_path):
    """Each number zero, negative, not a number, infinite, text, absent …: a clear error, or a run without NaN."""
    from tmodes.robots import load_robot

    file = tmp_path / "robot.yaml"
    file.write_text(text, encoding="utf-8")
    try:
        sheet = load_robot(str(file))
    except InputErrors as errors:
        info = str(errors)
    else:
        info = shortly(sheet, path)
    assert not info or path.split(".")[0] in info, info


def shortly(sheet, path):
    """Run a little while; what an error says, or nothing after a run without NaN."""
    small = {"integration.duration": 0.02, "integration.max_wall_time": 2.0, "integration.output_step": 0.002}
    try:
        result = simulate(sheet.with_({key: value for key, value in small.items() if key != path}))
    except TmodesError as error:
        return f"{path}: {error}"
    assert all(np.isfinite(v.values).all() for v in result.data.data_vars.values() if v.dtype.kind == "f")
    assert result.success or result.message
    return ""


@pytest.mark.parametrize("elements", [{}, *RIGID.values()])
def test_modes_of_any_robot(robot, elements):
    """Every elastic element gives its modes; with everything rigid only the motor's are left."""
    count = {"locked": 5, "free": 6, "controlled": 6}
    gone = sum({"gear.stiffness": 1}.get(path, 2) for path in elements)
    for state, modes in all_modes(robot.with_(elements)).items():
        assert len(modes) == count[state] - gone


def test_instability_is_reported(robot):
    """A preload that buckles the arm, and friction that feeds power in: `modes` and the run say so."""
    buckled = robot.with_({"environment.preload": 1500.0, "environment.friction": 0.0, "real": {}})
    worst = min(vibration_modes(buckled, MotorState.LOCKED, contact=True), key=lambda mode: mode.damping_ratio)
    assert not worst.stable
    assert worst.damping_ratio < 0
    assert "turning" not in worst.element
    pulled = robot.with_({"environment.preload": -5.0, "real": {}})
    assert any(not mode.stable for mode in vibration_modes(pulled, MotorState.LOCKED, contact=True))
    assert any("unstable at its start" in warning for warning in simulate(pulled.with_(SHORT)).warnings)
    assert all(mode["stable"] for modes in all_modes(robot).values() for mode in modes)


@pytest.mark.parametrize("stiffness", [47.0, 4.7e3, 4.7e8])
def test_free_motor_has_one_rigid_turn(robot, stiffness):
    """Whatever the other frequencies, the turn of the whole arm is told as such, and once."""
    modes = vibration_modes(robot.with_({"gear.stiffness": stiffness}), MotorState.FREE)
    assert [mode.element for mode in modes].count("whole arm, turning freely") == 1
    assert modes[0].frequency_Hz == 0
    assert all(mode.frequency_Hz > 0.5 for mode in modes[1:])


def test_loads_that_cannot_be_held_cost_no_run(robot):
    """A move so rough that the arm could not hold its loads statically: the run is whole, and says where."""
    rough = {"reference.duration": 0.02, "contact": False, "integration.duration": 0.1}
    result = simulate(robot.with_(rough))
    assert result.success
    assert any("stationary part T_st" in warning for warning in result.warnings)
    assert np.isfinite(result.data["deformation_stationary"].values).all()


def test_a_jammed_contact_is_warned_of(robot):
    """Friction and environment so large that the force has no single answer: seen in the fold, told in words."""
    rng = np.random.default_rng(5)
    angles, rates = 0.2 * rng.standard_normal((400, 6)), rng.standard_normal((400, 6))
    states = np.column_stack([angles, rates, np.zeros((400, 5))])
    info = []
    for change in ({}, {"environment.friction": 2.0, "environment.mass": 10.0}):
        mechanism, parameters = robot.with_(change).split(Drive.CONTROLLED)
        seen = PaperModel(mechanism).observe(np.zeros(400), states, np.zeros((400, 4)), parameters)
        info.append(jam_warnings(np.arange(400.0), seen["contact_fold"]))
    assert info[0] == []
    assert "jams first at t = " in info[1][0]


def test_a_pair_must_move_alike(robot):
    """Two robots whose motions cannot be compared sample by sample are no pair."""
    for change in (
        {"integration.output_step": 2e-3},
        {"contact": False},
        {"reference.end": 1.0},
        {"reading": "printed"},
    ):
        with pytest.raises(InputError, match="real robot"):
            PaperPair(robot, robot.with_(change))


def test_text_that_can_not_be_data(robot):
    """Plain data make a robot, or all that is wrong is told."""
    data = robot.model_dump(mode="json")
    assert PaperRobot.from_data(data) == robot
    with pytest.raises(InputErrors, match=r"gear.stiffness.*\n.*payload.mass|payload.mass.*\n.*gear.stiffness"):
        PaperRobot.from_data(
            data | {"gear": {"stiffness": -1, "damping": 0}, "payload": {"mass": "heavy", "inertia": 0}}
        )
