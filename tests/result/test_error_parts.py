"""The error of the tip in its parts: closed form of a planar arm, random arms, and what a run and its page show."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from arm.random_chains import random_chain, random_state
from arm.see.runs import NASTY, result_of, run_of, sheet
from tmodes.analysis.error_parts import along, substitutions, tips
from tmodes.analysis.spectrum import growth_warnings, spectrum_of
from tmodes.cli.summary_text import summary_rows
from tmodes.model.model import Model
from tmodes.result import Result
from tmodes.result.paths import part_names
from tmodes.sheet import Robot, RobotPair

LENGTHS = 0.7, 0.4
SECTION = {"shape": "tube", "outer_diameter": 0.02, "thickness": 0.002}
MATERIAL = {"young": 70e9, "shear": 26e9, "density": 2700.0}


def planar() -> Model:
    """Two joints about z with elastic gears; links that bend as circular arcs."""
    joints = [
        {"name": name, "type": "revolute", "parent": parent, "child": child, "axis": [0, 0, 1],
         "motor": {"inertia": 0.02, "side": "joint"}, "gear": {"stiffness": 900.0, "damping": 1.0}}
        for name, parent, child in (("one", "base", "upper"), ("two", "upper", "lower"))
    ]  # fmt: skip
    beam = {"model": "strain", "functions": {"bend_z": 1}, "damping_time": 0.0, "section": SECTION,
            "material": MATERIAL}  # fmt: skip
    links = [
        {"name": name, "beam": beam | {"length": length}}
        for name, length in zip(("upper", "lower"), LENGTHS, strict=True)
    ]
    return Model(Robot.from_data(sheet(joints=joints, links=links, tip={"link": "lower", "at": 1.0})).chain())


def arcs(angles: tuple[float, float], bends: tuple[float, float]) -> np.ndarray:
    """The tip of a chain of circular arcs that turn by ``bends`` [rad], each joint on the bent end before it."""
    place, direction = 0j, 0.0
    for angle, bend, length in zip(angles, bends, LENGTHS, strict=True):
        direction += angle
        share = (np.exp(1j * bend) - 1) / (1j * bend) if bend else 1.0
        place += length * share * np.exp(1j * direction)
        direction += bend
    return np.array([place.real, place.imag, 0.0])


@pytest.mark.parametrize("size", [0.01, 0.2])
def test_closed_form_of_a_planar_arm(size):
    """Motors off their setpoints, gears that give way, links bent to arcs: small and large."""
    model = planar()
    setpoints, motors, joints, bends = np.array([0.3, -0.8]) + size * np.array(
        [[0.0, 0.0], [0.3, -0.2], [0.9, 0.4], [-0.3, 1.5]]
    )
    bends = bends - [0.3, -0.8]
    place = dict(zip(model.coordinates, range(model.nq), strict=True))
    q, commanded = np.zeros((2, 1, model.nq))
    driven = [place[f"{name}.motor"] for name in ("one", "two")]
    q[0, driven], commanded[0, driven] = motors, setpoints
    for k, (joint, link) in enumerate((("one", "upper"), ("two", "lower"))):
        q[0, place[joint]], q[0, place[f"{link}.bend_z1"]] = joints[k], bends[k]
        commanded[0, place[joint]] = 7.0  # of a joint behind a gear it is not looked at
    found = tips(model, substitutions(model, q, commanded, driven))[:, 0]
    straight = (0.0, 0.0)
    expected = [arcs(setpoints, straight), arcs(motors, straight), arcs(joints, straight), arcs(joints, bends)]
    assert np.abs(found - expected).max() < 1e-9  # the arc itself is integrated to that
    parts = np.diff(found, axis=0)
    error = expected[3] - expected[0]
    assert along(parts) == pytest.approx(np.diff(expected, axis=0) @ error / np.linalg.norm(error), abs=1e-9)
    assert along(parts).sum() == pytest.approx(np.linalg.norm(parts.sum(axis=0)), abs=1e-14)


@pytest.mark.parametrize("seed", range(3))
def test_parts_of_any_arm_add_up(seed):
    """Trees of joints and links of every kind, in any state."""
    model = Model(random_chain(seed, 4))
    states = np.stack([random_state(seed + k, model.coordinates)[0] for k in (10, 20)])
    driven = [axis.input for axis in model.parts.axes if axis.axis.drive.is_driven]
    shapes = substitutions(model, states[:1], states[1:], driven)
    found = tips(model, shapes)
    whole = model.points(states[:1]).position[:, 0]
    assert np.abs(np.diff(found, axis=0).sum(axis=0) - (whole - found[0])).max() < 1e-14
    assert (shapes[1][0, driven] == states[0, driven]).all()
    assert (shapes[0][0, driven] == states[1, driven]).all()
    assert not shapes[2][:, model.deformations].any()


def test_along_a_zero_error():
    assert (along(np.zeros((3, 3))) == 0).all()
    assert along(np.array([[1.0, 0, 0], [-1.0, 0, 0]])) == pytest.approx([0.0, 0.0])


def test_parts_of_a_run():
    """They add up to the tip less the commanded and less the nominal one; the commanded one is where a rigid arm is."""
    data, (_, run) = result_of("swinging").data, run_of("swinging")
    for parts, path in (("tip_error", "tip_commanded"), ("tip_error_nominal", "tip_reference")):
        assert np.abs(data[parts].sum("error_part") - (data["tip"] - data[path])).max() < 1e-14
    assert list(data["error_part"].values) == ["controller", "gears", "links"] == part_names(run)
    turn, lift = data["wanted"].sel(drive=["shoulder", NASTY]).transpose("drive", "time").values
    reach = 0.8 + 0.2 * np.cos(lift)
    rigid = np.stack([reach * np.cos(turn), reach * np.sin(turn), -0.2 * np.sin(lift)], axis=1)
    assert np.abs(data["tip_commanded"].values - rigid).max() < 1e-12
    assert np.abs(data["tip_error"].sel(error_part="links").values).max() > 1e-4


def test_what_is_shown_of_it():
    """Summary and terminal: the components along the largest error add up to it."""
    summary = result_of("swinging").summary()
    for which, one in summary["tip_error"].items():
        assert sum(one["parts_m"].values()) == pytest.approx(one["max_m"], rel=1e-12)
        row = next(row for row in summary_rows(summary) if row[0] == f"tip error to {which}")
        assert f"{one['parts_m']['controller'] * 1e3:.3g} controller" in row[3]
    assert summary["tip_error"]["nominal"]["max_m"] == pytest.approx(summary["deviation"]["max_m"], rel=1e-12)
    assert "tip_error.commanded.max_m" in summary["error"]["figures"]


def test_an_arm_of_other_dimensions():
    """An actual arm that is longer than the nominal one has that as a part of its own."""
    robot = tmodes.load("spong1987").with_({"integration.duration": 0.02})
    longer = RobotPair(robot, robot.with_({"tip.position": [0.0, 0.0, -1.001]}))
    data = tmodes.run(longer).data
    assert [*data["error_part"].values][-1] == "geometry"
    assert np.abs(data["tip_error"].sum("error_part") - (data["tip"] - data["tip_commanded"])).max() < 1e-14


def test_without_setpoints_there_are_no_parts():
    """A pendulum that is let go has no commanded path."""
    result = result_of("pendulum")
    assert "tip_error" not in result.data
    assert result.summary()["tip_error"] == {}
    assert "tip_errors" not in result.figures()


def test_parts_of_a_deformation_that_cancel_are_not_given():
    """T_st far above the deflection itself, as where motors jerk at the start, is no number to print."""
    result = result_of("swinging")
    assert "max_stationary" in result.summary()["deformations"]["shoulder.gear"]
    data = result.data.copy(deep=True)
    data["deformation_stationary"].loc[{"deformation_kind": "shoulder.gear", "time": 0.0}] = 1.49e3
    summary = Result(data).summary()
    assert "max_stationary" not in summary["deformations"]["shoulder.gear"]
    row = next(row for row in summary_rows(summary) if row[0] == "largest shoulder.gear")
    assert "T_st" not in row[3]


def test_a_double_eigenvalue_zero_does_not_grow():
    """Two inertias on a spring that turn freely: rounding parts the double zero."""
    state = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-1e4, 1e4, 0, 0], [1e4, -1e4, 0, 0]], dtype=float)
    turn = np.eye(4) + 1e-3 * np.random.default_rng(0).normal(size=(5, 4, 4))
    spectra = [spectrum_of(np.linalg.solve(one, state @ one), ["a", "b"]) for one in turn]
    assert max(spectrum.eigenvalues.real.max() for spectrum in spectra) > 1e-7
    assert not any(growth_warnings(spectrum, "robot", "") for spectrum in spectra)
    assert growth_warnings(spectrum_of(np.array([[0.0, 1.0], [3.0, 0.0]]), ["a"]), "robot", "")
