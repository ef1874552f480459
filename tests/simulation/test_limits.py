"""Physical limits and honest ends: rigid by wish, nothing to lose, unstable steps, bad numbers."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import tmodes
from io_cases import KINDS, data_with, number_paths, value_of
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.analysis.spectrum import Spectrum, step_size_verdict, step_times_eigenvalue
from tmodes.errors import InputError, InputErrors, SimulationError, TmodesError
from tmodes.integrate.settings import Integration
from tmodes.io.sheet_check import sheet_from_data
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.motion_run import gathered
from tmodes.simulation.plan import Follow
from tmodes.simulation.warnings import jam_warnings, run_warnings

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


COORDINATES = {
    "gear": {"joint.motor"},
    "mode 1": {"link.azimuth1", "link.elevation1"},
    "mode 2": {"link.azimuth2", "link.elevation2"},
    "all": {"joint.motor", "link.azimuth1", "link.elevation1", "link.azimuth2", "link.elevation2"},
}
"""Coordinates that a rigid element takes away where the drive is controlled."""


@pytest.fixture(scope="module")
def robot():
    """The paper's robot as published."""
    return tmodes.load("filipovic2010")


def moved(robot, follow):
    """A run of one robot alone."""
    setup = run_setup(robot, follow)
    return gathered(setup, run_trajectory(setup))


@pytest.mark.parametrize("elements", [*RIGID])
@pytest.mark.parametrize("follow", [Follow.SHEET, Follow.WANTED])
def test_rigid_is_the_limit_of_stiff(robot, elements, follow):
    """Infinite stiffness takes the coordinate away; ten times stiffer comes nearer to it."""
    robot = robot.with_({"gear.damping": 40.0, **SHORT})  # so that the stiff motion dies out and the limit is seen
    limit, distance = moved(robot.with_(RIGID[elements]), follow), []
    for factor in (30.0, 300.0):
        near = moved(robot.with_({path: value_of(robot, path) * factor for path in RIGID[elements]}), follow)
        tips = np.abs(near.points.position[:, 0] - limit.points.position[:, 0]).max()
        kept = [near.coordinates.index(name) for name in limit.coordinates]
        gone = [k for k, name in enumerate(near.coordinates) if name not in limit.coordinates and "motor" not in name]
        bent = np.abs(near.q[:, gone]).max() if gone else 0.0
        distance.append(max(tips, bent, np.abs(near.q[:, kept] - limit.q).max() if kept else 0.0))
        assert set(near.coordinates) - set(limit.coordinates) >= COORDINATES[elements] - {"joint.motor"}
        assert not COORDINATES[elements] & set(limit.coordinates) - {"joint.motor"}
    assert distance[1] < 0.25 * distance[0]


@pytest.mark.parametrize("reading", ["printed", "consistent"])
@pytest.mark.parametrize("contact", [False, True])
@pytest.mark.parametrize("law", ["signed", "magnitude"])
def test_power_balance(robot, reading, contact, law):
    """With every loss on, the balance closes to 1e-8 of the energy moved."""
    change = {"reading": reading, "contact": contact, "environment.friction_law": law}
    change |= {"integration.error_estimate": False, "integration.model_error": False}
    result = tmodes.run(robot.with_(change))
    assert result.success
    assert not result.warnings
    assert result.summary()["energy"]["worst_residual_over_moved"] < 1e-8


def test_unstable_step_is_never_called_finished(robot):
    """rk4 beyond its stability limit: reported before, diverged after, with dt*omega; what it had is kept."""
    change = {"gear.stiffness": 4.7e9, "integration.method": "rk4", "integration.step": 1e-3}
    result = tmodes.run(robot.with_(change))
    assert result.status == "diverged"
    assert "dt*omega" in result.message
    assert "coordinate" in result.message
    assert "at t = " in result.message
    assert result.data.sizes["time"] >= 1
    assert all(np.isfinite(v.values).all() for v in result.data.data_vars.values() if v.dtype.kind == "f")


def test_what_was_done_is_kept_when_the_reference_is_lost(robot):
    """The reference's robot is the stiffer one here: both are kept as far as the reference came."""
    change = {"integration.method": "rk4", "integration.step": 2.5e-3, "integration.output_step": 2.5e-3}
    result = tmodes.run(robot.with_({**change, "contact": False}))
    assert result.status == "diverged"
    assert result.message.startswith("nominal run: diverged at t = ")
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
        tmodes.run(robot.with_({"gear.damping": 1e9, "integration.method": "dormand_prince"}))


def test_coarse_integration_is_warned_of(robot):
    """The energy monitor speaks when the balance does not close."""
    coarse = {"integration.relative_tolerance": 1e-2, "integration.absolute_tolerance": 1e-3}
    result = tmodes.run(robot.with_(coarse))
    assert any("energy balance" in warning for warning in result.warnings)
    assert result.success
    stopped = tmodes.run(robot.with_({**coarse, "integration.energy_stop": True}))
    assert stopped.status == "stopped"
    assert "energy balance" in stopped.message
    assert 1 <= stopped.data.sizes["time"] < result.data.sizes["time"]


def test_large_bending_is_warned_of(robot):
    """Beyond the small angles of the model the run says so, with the first time and the value."""
    result = tmodes.run(robot.with_({"payload.mass": 6.0, "contact": False, **SHORT}))
    assert any(
        "leaves the small angles of its model" in warning and "first at t = " in warning for warning in result.warnings
    )


def test_no_equilibrium_is_reported(robot):
    """A load that no contact can carry with it is refused before the run."""
    with pytest.raises(SimulationError, match="equilibrium"):
        run_setup(robot.with_({"payload.mass": 1e12}))


RAN: set[str] = set()
"""Robots that have run: many wrong numbers are the same right robot (`"1.0"`, 1e-400)."""


@pytest.mark.slow
@pytest.mark.parametrize("path", number_paths())
@pytest.mark.parametrize("kind", KINDS)
def test_every_bad_number_errs_or_runs(path, kind):
    """Each number zero, negative, not a number, infinite, text, absent …: a clear error, or a run without NaN."""
    try:
        sheet = sheet_from_data(data_with(path, KINDS[kind]))
    except TmodesError as error:
        info = f"{path}: {error}"  # what it says is tested where files are read
    else:
        info = shortly(sheet, path)
    assert not info or path.split(".")[0] in info, info


def shortly(sheet, path):
    """Run a little while; what an error says, or nothing after a run without NaN."""
    small = {"integration.duration": 0.02, "integration.max_wall_time": 2.0, "integration.output_step": 0.002}
    small |= {"integration.error_estimate": False, "integration.model_error": False}
    try:
        robot = sheet.with_({key: value for key, value in small.items() if key != path})
        if (same := robot.model_dump_json()) in RAN:
            return ""
        result = tmodes.run(robot)
    except TmodesError as error:
        return f"{path}: {error}"
    RAN.add(same)
    assert all(np.isfinite(v.values).all() for v in result.data.data_vars.values() if v.dtype.kind == "f")
    assert result.success or result.message
    return ""


@pytest.mark.parametrize("elements", [{}, *RIGID.values()])
def test_modes_of_any_robot(robot, elements):
    """Every elastic element gives its modes; with everything rigid only the motor's are left."""
    count = {"locked": 5, "free": 6, "controlled": 6}
    gone = sum({"gear.stiffness": 1}.get(path, 2) for path in elements)
    for state, modes in sheet_frequencies(robot.with_(elements), contact=True).items():
        assert sum(mode["undamped_frequency_Hz"] is not None for mode in modes) == count[state] - gone


def test_buckling_is_reported(robot):
    """A preload that buckles the arm: the run says so. Its rest is the bent shape, where it stands."""
    buckled = robot.with_({"environment.preload": 1500.0, "environment.friction": 0.0, "real": {}})
    warnings = tmodes.run(buckled.with_({**SHORT, "integration.duration": 0.02})).warnings
    assert any("pressed beyond its buckling load" in warning for warning in warnings)
    assert any("leaves the small angles of its model" in warning for warning in warnings)


def test_instability_is_reported(robot):
    """Friction that feeds power in: the run says so before it begins; modes, which leave friction out, do not."""
    pulled = robot.with_({"environment.preload": -5.0, "real": {}})
    (warning, _) = (text for text in tmodes.run(pulled.with_(SHORT)).warnings if "unstable at its start" in text)
    assert "friction of a contact that pulls" in warning
    assert all(mode["stable"] for modes in sheet_frequencies(robot, contact=True).values() for mode in modes)


@pytest.mark.parametrize("stiffness", [47.0, 4.7e3, 4.7e8])
def test_free_motor_has_one_rigid_turn(robot, stiffness):
    """Whatever the other frequencies, the turn of the whole arm is reported as such, and once."""
    modes = sheet_frequencies(robot.with_({"gear.stiffness": stiffness}), contact=False)["free"]
    whole = [mode for mode in modes if mode["undamped_frequency_Hz"] is not None]
    assert [mode["element"] for mode in whole].count("whole arm, free") == 1
    assert whole[0]["undamped_frequency_Hz"] == 0
    assert all(mode["undamped_frequency_Hz"] > 0.5 for mode in whole[1:])


def test_loads_that_cannot_be_held_cost_no_run(robot):
    """A move so rough that the arm could not hold its loads statically: the run is whole, and says where."""
    rough = {"reference.duration": 0.02, "contact": False, "integration.duration": 0.1}
    result = tmodes.run(robot.with_(rough))
    assert result.success
    assert any("static part of the deformations is that of the linear arm" in warning for warning in result.warnings)
    assert np.isfinite(result.data["deformation_stationary"].values).all()


def test_a_jammed_contact_is_warned_of(robot):
    """Friction and environment so large that the force has no single answer: seen in the fold, said in words."""
    rng, info = np.random.default_rng(5), []
    angles, rates = 0.2 * rng.standard_normal((400, 6)), rng.standard_normal((400, 6))
    for change in ({}, {"environment.friction": 2.0, "environment.mass": 10.0}):
        setup = run_setup(robot.with_(change))
        layout, states = setup.model.layout, np.zeros((400, len(setup.start)))
        states[:, layout.q], states[:, layout.v] = angles, rates
        seen = setup.model.observe(np.zeros(400), states, np.tile(setup.first_row, (400, 1)))
        info.append(jam_warnings(np.arange(400.0), seen["contact_fold"][:, 0]))
    assert info[0] == []
    assert "jams first at t = " in info[1][0]


def test_every_run_looks_for_a_jam(robot):
    """The warning is that of every run, whichever robot it is of."""
    run = moved(robot.with_(SHORT), Follow.SHEET)
    assert not any("jams" in warning for warning in run_warnings(run))
    jammed = replace(run, contact_fold=-np.ones(len(run.times)))
    assert any("the contact jams first at t = " in warning for warning in run_warnings(jammed))


@pytest.mark.parametrize(
    "change", [{"integration.output_step": 2e-3}, {"integration.duration": 1.0}, {"contact": False},
               {"reading": "printed"}]
)  # fmt: skip
def test_a_pair_must_move_alike(robot, change):
    """Two robots whose motions cannot be compared sample by sample are no pair."""
    with pytest.raises(InputError, match="actual robot"):
        RobotPair(robot, robot.with_(change))


def test_text_that_can_not_be_data(robot):
    """Plain data make a robot, or all that is wrong is reported."""
    data = robot.model_dump(mode="json", exclude_none=True)
    assert Robot.from_data(data) == robot
    joint, link = data["joints"][0], data["links"][0]
    wrong = {
        "joints": [joint | {"gear": {"stiffness": -1, "damping": 0}}],
        "links": [link | {"bodies": [{"name": "payload", "mass": "heavy", "inertia": 0}]}],
    }
    with pytest.raises(InputErrors, match=r"gear.stiffness[\s\S]*payload.mass|payload.mass[\s\S]*gear.stiffness"):
        Robot.from_data(data | wrong)


def test_singular_mass_matrix_names_the_coordinate():
    """A point mass on two hinges whose first link has no mass, stretched: both hinges move it alike."""
    joints = [{"name": name, "type": "revolute", "child": f"{name}_link", "axis": [0, 1, 0]} for name in ("j", "k")]
    joints[1]["origin"] = {"position": [0.5, 0, 0]}
    links = [{"name": "k_link", "bodies": [{"mass": 1, "center": [0.2, 0, 0]}]}]
    sheet = {"format": 1, "kind": "arm", "name": "two", "gravity": 0.0}
    sheet |= {"joints": joints, "links": links}
    stretched, bent = (
        Robot.from_data(sheet | {"initial": {"coordinates": {"j": 0.3, "k": angle}}}).with_(SHORT) for angle in (0, 0.5)
    )
    with pytest.raises(SimulationError, match=r"mass matrix at the start is singular: [jk] moves no mass in this pose"):
        tmodes.run(stretched)
    assert tmodes.run(bent).status == "finished"
