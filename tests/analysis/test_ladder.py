# pyright: reportAttributeAccessIssue=false
"""The ladder: its rungs are models with known errors, its motion is the sheet's own, its advice is the cheapest."""

from __future__ import annotations

import json
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from analysis.sheets import clamped_sheet
from command import tmodes
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.errors import InputError
from tmodes.sheet import Robot
from tmodes.simulation.hierarchy.hierarchy import Ladder, ladder
from tmodes.simulation.hierarchy.motion import moved, with_motion
from tmodes.simulation.hierarchy.variants import rungs
from tmodes.simulation.simulate import simulate_motion

LENGTH, EI, MASS = 0.7, 12.0, 1.1


def sheet(**changes: Any) -> dict[str, Any]:
    """A bare beam on a driven hinge about z, behind an elastic gear where asked."""
    beam = {"model": "strain", "functions": {"bend_z": 2}, "basis": "legendre", "length": LENGTH, "damping_time": 1e-3,
            "rotary_inertia": "none", "section": {"bending_stiffness": EI, "mass_per_length": MASS}}  # fmt: skip
    joint = {"name": "hub", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1],
             **changes.pop("joint", {})}  # fmt: skip
    rod = {"name": "rod", "beam": beam}
    return {
        "format": 1,
        "kind": "arm",
        "name": "slewing",
        "gravity": [0, 0, 0],
        "joints": [joint],
        "links": [rod],
        **changes,
    }


ELASTIC = {"motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 300.0, "damping": 1.0}}


@pytest.fixture(scope="module")
def climbed() -> Ladder:
    return ladder(Robot.from_data(sheet()), 3e-2, finest=4)


def test_rungs_are_all_models(climbed: Ladder) -> None:
    names = ["rigid", "segments(1)", "segments(2)", "segments(3)", "strain(1)", "strain(2)", "strain(3)", "strain(4)"]
    assert [rung.model for rung in climbed.rungs] == names
    assert [rung.coordinates for rung in climbed.rungs] == [1, 2, 3, 4, 2, 3, 4, 5]


@pytest.mark.parametrize(("model", "percent"), [
    ("strain(1)", 27.193), ("strain(2)", 0.47543), ("strain(3)", 0.03017), ("segments(1)", -18.8), ("segments(2)", 31)
])  # fmt: skip
def test_first_frequency_is_off_by_what_is_known_of_each_model(climbed: Ladder, model: str, percent: float) -> None:
    """Errors of a clamped bare beam against 1.8751^2 sqrt(EI/rhoA L^4), in %."""
    exact = 1.875104068712**2 * np.sqrt(EI / (MASS * LENGTH**4)) / (2 * np.pi)
    found = next(rung for rung in climbed.rungs if rung.model == model)
    assert 100 * (found.frequencies_Hz[0] / exact - 1) == pytest.approx(percent, rel=0.03)
    assert found.frequency_error == pytest.approx(abs(percent) / 100, rel=0.05)


def test_errors_fall_and_the_fewest_coordinates_within_the_tolerance_are_advised(climbed: Ladder) -> None:
    strains = [rung.tip_error for rung in climbed.rungs[4:]]
    assert all(a is not None and b is not None and a > b for a, b in pairwise(strains))
    assert strains[-1] == 0.0
    assert climbed.rungs[0].tip_error == pytest.approx(1.0, rel=1e-4)
    good = [rung for rung in climbed.rungs if rung.within(climbed.tolerance)]
    assert climbed.recommended in {rung.model for rung in good}
    assert climbed.recommended == "strain(2)"
    assert climbed.converged
    assert all(rung.cost_us > 0 for rung in climbed.rungs)


def test_highest_eigenvalue_is_that_of_the_undamped_beam() -> None:
    """w_max of three functions, free tip: 118 sqrt(EI/rhoA L^4)."""
    data = sheet()
    data["links"][0]["beam"]["damping_time"] = 0.0
    found = ladder(Robot.from_data(data), 0.5, finest=3)
    assert found.rungs[-1].highest_eigenvalue == pytest.approx(118 * np.sqrt(EI / (MASS * LENGTH**4)), rel=0.01)


def command(**drive: Any) -> dict[str, Any]:
    """The slewing beam behind an elastic gear, its motor under one command."""
    motor = {"inertia": 0.1, "side": "joint", "torque_constant": 0.4, "back_emf_constant": 0.4, "resistance": 2.0}
    settings = {"duration": 0.3, "output_step": 0.003}
    return sheet(joint=ELASTIC | {"motor": motor}, drives=[{"joint": "hub", **drive}], integration=settings)


SINE = {"type": "sine", "amplitude": 2.0, "frequency": 3.0}
STEP = {"type": "step", "start": 0.1, "end": 0.3, "time": 0.1}
SMOOTH = {"type": "trapezoid", "start": 0.1, "end": 0.4, "duration": 0.25, "ramp_fraction": 0.3}
PD = {"type": "pd", "position_gain": 80.0, "velocity_gain": 9.0}


def rigid(law: dict[str, Any]) -> dict[str, Any]:
    """The beam on a joint without a gear, whose setpoint jumps: only a controller can move it."""
    drive = {"joint": "hub", "command": "position", "signal": STEP, "controller": law}
    return sheet(drives=[drive], integration={"duration": 0.3, "output_step": 0.003})


FORCE = {"point": "tip", "frame": "world", "force": [0, 3.0, 0], "signal": SINE}
MOTIONS = {
    "torque": command(command="torque", signal=SINE),
    "voltage": command(command="voltage", signal=SINE),
    "position": command(command="position", signal=SMOOTH, controller=PD),
    "a jump": command(command="position", signal=STEP, controller=PD),
    "a jump of a rigid joint": rigid(PD),
    "effort": sheet(drives=[{"joint": "hub", "command": "effort", "signal": SINE}], integration={"duration": 0.3}),
    "a load": command(command="position", signal=SMOOTH, controller=PD) | {"loads": [FORCE]},
    "a load alone": sheet(joint=ELASTIC, loads=[FORCE], integration={"duration": 0.3}),
}


@pytest.mark.parametrize("name", MOTIONS)
def test_the_motion_is_that_of_the_sheet_whatever_it_commands(name: str) -> None:
    """The nominal run where there is one, else the run: a motor that jumps is moved by its controller."""
    robot, words = with_motion(Robot.from_data(MOTIONS[name]), 3.0)
    assert words == ""
    run = simulate_motion(robot)
    true = (run.reference or run).points.position[:, 0]
    found = moved(robot, 1e-9)
    every = (len(true) - 1) // (len(found.tip) - 1)
    assert np.abs(found.tip - true[::every]).max() < 1e-6 * found.deflection.max() + 1e-9
    assert ("setpoints" in found.how) == (run.reference is not None)
    assert found.deflection.max() > 1e-5


def test_links_of_an_effort_are_judged_by_what_the_effort_does() -> None:
    """Torque on a free hub: two segments have 0.44 of the beam's inertia about it, and go 2.3 times as far."""
    found = ladder(Robot.from_data(MOTIONS["effort"]), 0.05, finest=3)
    assert "own motion" in found.move
    segments = next(rung for rung in found.rungs if rung.model == "segments(2)")
    assert segments.tip_difference_m == pytest.approx(0.204, rel=0.05)
    assert found.converged
    assert found.recommended == "strain(2)"


def test_a_controller_of_coordinates_that_a_rung_has_not_leaves_that_rung_out() -> None:
    """Feedback of bending in a sheet whose setpoint jumps: other models of the link have no such coordinate."""
    law = {"type": "state_feedback", "position_gains": {"hub": 80.0, "rod.bend_z1": 1.0},
           "velocity_gains": {"hub": 9.0}}  # fmt: skip
    found = ladder(Robot.from_data(rigid(law)), 3e-2, finest=2)
    why = {rung.model: rung.why for rung in found.rungs}
    assert "rod.bend_z1" in why["rigid"]
    assert "rod.bend_z1" in why["segments(1)"]
    assert why["strain(2)"] == ""
    assert found.recommended.startswith("strain")


def test_a_robot_that_nothing_moves_makes_a_move_of_all_joints() -> None:
    moving, words = with_motion(Robot.from_data(sheet(joint=ELASTIC, initial={"coordinates": {"hub.motor": 0.4}})), 3.0)
    assert "quintic" in words
    assert moving.integration.duration == pytest.approx(1.3)
    assert float(moving.drives[0].signal.schedule(1.3).at(1.3)) == pytest.approx(0.6)


def test_directions_that_do_not_bend_stay_so() -> None:
    for name, arm in rungs(Robot.from_data(sheet()), 3):
        beam = arm.link("rod").beam
        assert beam is not None
        assert beam.functions is not None
        assert (beam.functions.bend_y, beam.functions.twist) == (0, 0)
        if name.startswith("strain"):
            assert beam.functions.bend_z == int(name[7])


def test_an_arm_without_beams_and_a_foolish_tolerance_are_refused() -> None:
    data = sheet()
    data["links"] = [{"name": "rod", "bodies": [{"name": "b", "mass": 1.0, "center": [0.2, 0, 0]}]}]
    with pytest.raises(InputError, match="beam"):
        ladder(Robot.from_data(data))
    for tolerance in (0.0, -1.0, 1.0, float("nan")):
        with pytest.raises(InputError, match="tolerance"):
            ladder(Robot.from_data(sheet()), tolerance)


def test_command_reports_the_ladder(tmp_path: Any) -> None:
    file = tmp_path / "slewing.yaml"
    file.write_text(json.dumps(sheet()), encoding="utf-8")  # which is YAML too
    command = ["hierarchy", file, "--finest", "3", "--tolerance", "0.05"]
    info = json.loads(tmodes(*command, "--json").stdout)
    assert info["recommended"] == "strain(2)"
    assert len(info["rungs"]) == 7
    assert set(info["units"]) <= {*info, *info["rungs"][0]}
    shown = tmodes(*command).stdout
    assert "<- recommended" in shown
    assert "Recommended: strain(2), the cheapest within 5 % of strain(3)." in shown


@pytest.mark.nightly
def test_a_clamped_beam_has_a_rigid_rung_without_coordinates():
    """On the rigid rung nothing moves: it is off by the whole sag; the finest first frequency is 5.596 Hz."""
    found = ladder(Robot.from_data(clamped_sheet(functions={"bend_y": 1})), finest=3)
    assert (found.rungs[0].coordinates, found.rungs[0].frequencies_Hz) == (0, ())
    assert found.rungs[0].tip_error == pytest.approx(1.0, rel=1e-6)
    exact = 1.8751040687119611**2 * 10 / (2 * np.pi)
    assert found.rungs[-1].frequencies_Hz[0] == pytest.approx(exact, rel=1e-3)


def test_modes_are_rungs_of_a_straight_beam_that_bends_alike_in_both_planes() -> None:
    """One mode is one segment; two have their masses at other places. Modes of a modes link of as many are its own."""
    given = sheet()
    given["links"][0]["beam"]["functions"] = {"bend_y": 1, "bend_z": 1}
    found = dict(rungs(Robot.from_data(given), 1))
    assert [name for name in found if name.startswith("modes")] == ["modes(1)", "modes(2)", "modes(3)"]
    first = {
        name: sheet_frequencies(arm)["locked"][0]["frequency_Hz"] for name, arm in found.items() if name != "rigid"
    }
    assert first["modes(1)"] == pytest.approx(first["segments(1)"], rel=1e-9)
    assert found["modes(3)"].links[0].beam is not None
    assert found["modes(3)"].links[0].beam.coordinate_count == 6
    assert found["modes(3)"].links[0].beam.section_pieces()[1].start.bend_z == pytest.approx(EI)
    again = dict(rungs(found["modes(2)"], 1))
    assert again["modes(2)"].links == found["modes(2)"].links
    assert not any(name.startswith("modes") for name, _ in rungs(Robot.from_data(sheet()), 1))
