"""What is reported of an arm: masses, exact frequencies of bare beams, sag, stiffness, notices."""

from __future__ import annotations

import json

import numpy as np
import pytest

from analysis.sheets import clamped_sheet, locked_sheet
from tmodes.analysis.describe.describe import describe, statics_info
from tmodes.analysis.modes.of_sheet import servos_of, vibrations
from tmodes.analysis.statics.at_rest import first_commands, robot_rest
from tmodes.analysis.statics.loads import Load
from tmodes.kinds.links.beam_functions import bare_beam
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.model.model import Model
from tmodes.robots.load import load
from tmodes.sheet import Robot


def taper(mass: float) -> Beam:
    """A beam of stepped stiffness (4, 1) and even mass."""
    pieces = [BeamPiece(end, (k, k), (k, k), (k, k), (0.0, 0.0), (mass, mass), ((0.3, 0.3), (0.0, 0.0), (0.0, 0.0)))
              for end, k in ((0.5, 4.0), (1.0, 1.0))]  # fmt: skip
    return Beam(2.0, tuple(pieces), bend_y=3)


def test_bare_beam_of_one_section():
    """beta^2 sqrt(EI/rhoA)/L^2 and (pi/2) sqrt(GJ/rhoIp)/L; tip compliance L^3/3EI."""
    piece = BeamPiece(
        1.0, (6.0, 6.0), (24.0, 24.0), (3.0, 3.0), (0.0, 0.0), (1.5, 1.5), ((0.3, 0.3), (0.0, 0.0), (0.0, 0.0))
    )
    found = bare_beam(Beam(2.0, (piece,), bend_y=3))
    first = 1.8751040687119611**2 * np.sqrt(6.0 / 1.5) / 2.0**2 / (2 * np.pi)
    assert found.bend_y_Hz == pytest.approx(first, rel=1e-10)
    assert found.bend_z_Hz == pytest.approx(2 * first, rel=1e-10)
    assert found.twist_Hz == pytest.approx(np.sqrt(3.0 / 0.3) / 2.0 / 4, rel=1e-10)
    assert found.mass == pytest.approx(3.0)
    assert found.compliance == pytest.approx((8 / 18, 8 / 72))


def test_bare_beam_of_two_sections():
    """Tip compliance by hand: (L^3 - (L/2)^3)/3EI1 + (L/2)^3/3EI2."""
    assert bare_beam(taper(1.0)).compliance[0] == pytest.approx(7 / 12 + 1 / 3)


def test_two_link_arm():
    """Printed lengths and stiffnesses; the tip's compliance 7/8 and 1/8 in the two links."""
    info = describe(load("deluca_siciliano1991"))  # pyright: ignore
    json.dumps(info, allow_nan=False)
    assert info["total_mass_kg"] == pytest.approx(2.3)
    bare = 1.8751040687119611**2 * np.sqrt(1.0 / 0.2) / 0.5**2 / (2 * np.pi)
    assert [link["bare_bend_z_Hz"] for link in info["links"]] == pytest.approx([bare, bare], rel=1e-9)
    assert [joint["kind"] for joint in info["joints"]] == ["AR", "AR"]
    y = info["stiffness"]["directions"][1]
    assert y["stiffness"] == pytest.approx(3.0)
    assert y["shares"]["upper_arm.bend_z"] == pytest.approx(7 / 8)
    assert info["sag"]["displacement_size_m"] == pytest.approx(0.0, abs=1e-12)
    assert info["warnings"] == []


def test_functions_that_a_link_lacks_are_said():
    info = describe(load("deluca_siciliano1991"))  # pyright: ignore
    assert [note for note in info["notes"] if "upper_arm" in note and "twist" in note]


def test_what_swings_to_its_rest_has_no_sag():
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 1, 0], "state": "free"}
    bodies = [{"mass": 1.0, "center": [0.3, 0, 0], "inertia": 0.01}]
    info = describe(Robot.from_data({
        "format": 1, "kind": "arm", "name": "pendulum", "gravity": 9.81, "joints": [joint],
        "links": [{"name": "l", "bodies": bodies}], "tip": {"link": "l", "position": [0.5, 0, 0]},
        "integration": {"duration": 1.0, "output_step": 0.1},
    }))  # fmt: skip
    assert info["sag"]["position_m"] == pytest.approx([0, 0, -0.5], abs=1e-9)
    assert info["sag"]["displacement_m"] is None
    assert info["sag"]["displacement_size_m"] is None


def test_single_elastic_joint():
    """100 N*m/rad, 1 kg at 1 m that hangs: locked w^2 = 100 + 9.8."""
    arm = load("spong1987")
    model = Model(arm.chain())  # pyright: ignore
    assert first_commands(arm, model) == {"joint.motor": 0.0}  # pyright: ignore
    info = describe(arm)  # pyright: ignore
    assert info["gears"][0]["stiffness"] == [100.0]
    assert info["joints"][0]["kind"] == "AE"
    assert servos_of(arm, model)["joint.motor"] == (80.0, 12.0)  # pyright: ignore
    modes = vibrations(arm).states  # pyright: ignore
    assert set(modes) == {"locked", "free", "controlled"}
    assert 2 * np.pi * modes["locked"][0]["frequency_Hz"] == pytest.approx(np.sqrt(109.8), rel=1e-9)


def test_notices():
    """A gear a thousand times too soft sags far, past its joint's limits."""
    arm = load("spong1987", {"joints.joint.limits": {"lower": -0.1, "upper": 0.1},
                                   "joints.joint.gear.stiffness": 5.0, "drives.0.signal.start": 0.5})  # fmt: skip
    warnings = describe(arm)["warnings"]  # pyright: ignore
    assert any("joint joint stands at" in info for info in warnings)
    rest = robot_rest(arm)  # pyright: ignore
    gamma = rest.named["joint"]
    assert 5.0 * (0.5 - gamma) == pytest.approx(9.8 * np.sin(gamma), abs=1e-9)


@pytest.mark.parametrize("data", [locked_sheet(), clamped_sheet(functions={"bend_y": 0, "bend_z": 0})])
def test_an_arm_in_which_nothing_moves(data):
    arm = Robot.from_data(data)
    info, still = describe(arm), statics_info(arm, robot_rest(arm))
    assert info["coordinates"] == []
    assert info["total_mass_kg"] == pytest.approx(1.0)
    assert any("nothing in it moves or bends" in warning for warning in info["warnings"])
    assert any("nothing in it moves or bends" in warning for warning in still["warnings"])
    found = vibrations(arm)
    assert found.states == {"locked": []}
    assert "nothing in it moves or bends" in found.warnings[0]
    model = Model(arm.chain())
    assert model.jacobian(np.zeros((3, 0))).shape == (3, 1, 6, 0)
    assert model.mass_matrix(np.zeros(0)).shape == (0, 0)
    assert [matrix.shape for matrix in model.linearize(np.zeros(0))] == [(0, 0)] * 3


def test_ways_that_are_not_modelled_have_no_stiffness():
    """A sagging beam without stretch and twist: 3 EI/L^3 across, nothing honest along and about its line."""
    info = statics_info(arm := Robot.from_data(clamped_sheet()), robot_rest(arm))
    x, _, z, about_x, about_y, _ = info["stiffness"]["directions"]
    for one, kind in ((x, "stretch"), (about_x, "twist")):
        assert (one["stiffness"], one["compliance"], one["shares"]) == (None, None, {})
        assert one["why"] == f"not modelled (no {kind} functions)"
    assert z["stiffness"] == pytest.approx(300.0, rel=1e-2)
    assert about_y["stiffness"] == pytest.approx(100.0, rel=0.1)


def test_ways_that_are_modelled_keep_their_stiffness():
    """GJ/L with a function of twist; an upper arm across lets the tip give along a forearm that does not stretch."""
    twisting = Robot.from_data(clamped_sheet(functions={"twist": 1, "bend_y": 3}, basis="legendre"))
    info = statics_info(twisting, robot_rest(twisting))["stiffness"]["directions"]
    assert info[3]["stiffness"] == pytest.approx(60.0, rel=1e-2)
    assert info[1]["why"] == "not modelled (no bend_z functions)"
    elbow = load("deluca_siciliano1991", {"drives.1.signal.start": np.pi / 2})
    x = describe(elbow)["stiffness"]["directions"][0]  # pyright: ignore
    assert x["why"] is None
    assert x["shares"]["upper_arm.bend_z"] == pytest.approx(3 / 4, rel=1e-6)


def test_a_link_of_segments_has_its_own_mass():
    """1 kg, of which the model has 33/140 at the tips."""
    link = describe(Robot.from_data(clamped_sheet(model="segments", segments=2, functions=None)))["links"][0]
    assert link["mass_kg"] == pytest.approx(1.0)
    assert link["equivalent_mass_kg"] == pytest.approx(33 / 140)


def test_a_load_far_beyond_the_functions_is_bad():
    """F L^2/EI = 536: three functions cannot have the shape, whatever the angle says."""
    arm = Robot.from_data(clamped_sheet(section={"shape": "round", "diameter": 0.02}, material="steel"))
    stiffness = describe(arm)["links"][0]["bending_stiffness_y_Nm2"][0]
    info = statics_info(arm, robot_rest(arm, [Load("tip", (0.0, 0.0, -536.0 * stiffness))]))
    assert info["links"][0]["verdict"] == "bad"
    assert any("yield strength" in warning for warning in info["warnings"])
    assert any("take more functions.bend_y" in warning for warning in info["warnings"])


def test_highest_functions_are_not_converged():
    """beta L = 1.8751, 4.6941, 7.8548: the third frequency of three functions is off by more than 1 %, and marked."""
    beam = {"functions": {"bend_y": 3}, "basis": "tip_weighted", "rotary_inertia": "none"}
    found = vibrations(Robot.from_data({**clamped_sheet(**beam), "gravity": 0.0}))
    exact = np.array([1.8751040687119611, 4.694091132974175, 7.854757438237613]) ** 2 * 10 / (2 * np.pi)
    for mode, right in zip(found.states["locked"], exact, strict=True):
        assert mode["converged"] == (mode["frequency_Hz"] / right < 1.01)
        assert 1 + mode["frequency_error"] == pytest.approx(mode["frequency_Hz"] / right, rel=2e-3)
    assert [mode["converged"] for mode in found.states["locked"]] == [True, True, False]
    assert found.links[0]["verdict"] == "good"
    assert "not converged" in found.warnings[0]


@pytest.mark.nightly
def test_the_error_of_a_frequency_at_the_most_functions():
    """Each direction is compared with more functions of its own, also than a sheet may ask for."""
    beam = {"functions": {"bend_y": 12, "bend_z": 3}, "basis": "tip_weighted", "rotary_inertia": "none"}
    found = vibrations(Robot.from_data({**clamped_sheet(**beam), "gravity": 0.0})).states["locked"]
    exact = np.array([1.8751040687119611, 4.694091132974175, 7.854757438237613]) ** 2 * 10 / (2 * np.pi)
    for direction, least in (("bend_y", 1e-7), ("bend_z", 2e-5)):
        modes = [row for row in found if row["element"].endswith(direction)]
        for row, right in zip(modes, exact, strict=False):
            error = row["frequency_Hz"] / right - 1
            assert row["frequency_error"] == pytest.approx(error, rel=0.05, abs=least)
    assert [row["converged"] for row in modes] == [True, True, False]
