"""The error of the tip in its parts: closed form of a planar arm, random arms, and what a run and its page show."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import tmodes
from random_chains import random_chain, random_state
from see.runs import NASTY, result_of, run_of, sheet
from tmodes.analysis.error_parts import element_steps, substitutions, tips
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.analysis.spectrum import growth_warnings, spectrum_of
from tmodes.frame import along
from tmodes.interface.summary import summary_rows
from tmodes.model.model import Model
from tmodes.plot import all_figures
from tmodes.result import Result
from tmodes.result.paths import part_names
from tmodes.result.summary import largest_elements
from tmodes.sheet import Robot, RobotPair

LENGTHS = 0.7, 0.4
SECTION = {"shape": "tube", "outer_diameter": 0.02, "thickness": 0.002}
MATERIAL = {"young": 70e9, "shear": 26e9, "density": 2700.0}


def planar(lengths: tuple[float, float] = LENGTHS) -> Model:
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
        for name, length in zip(("upper", "lower"), lengths, strict=True)
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


ELEMENTS = [
    ([0.4, -0.7], [0.402, -0.697], [0.4012, -0.6985], [-0.01, -0.02],
     [[7.11789186087497e-05, -0.000824483924012076], [-0.00021916688715251098, -0.0007172626925381898],
      [-0.00018779328681017837, -0.004524207433980909], [-0.0007546247108281001, -0.0023833813844359453]]),
    ([1.1, 0.5], [1.1005, 0.4998], [1.08, 0.49], [-0.3, -0.5],
     [[0.02115466261896115, -0.005488409394052596], [0.00489993913375214, 2.0107861802953764e-05],
      [0.13548096450176922, -0.03638543786816606], [0.06022814855428693, -0.016287354834920942]]),
]  # fmt: skip
"""Setpoints, motors, joints, curvatures [1/m]; steps of both gears and both links: reference values computed by
quadrature along the arcs, links of 0.6 and 0.5 m."""


@pytest.mark.parametrize(("setpoints", "motors", "joints", "curvatures", "steps"), ELEMENTS)
def test_each_gear_and_link_has_its_step(setpoints, motors, joints, curvatures, steps):
    """Joint one before joint two, then link one before link two."""
    model = planar((0.6, 0.5))
    names = model.coordinates
    values = dict(zip(("one.motor", "two.motor", "one", "two"), [*motors, *joints], strict=True))
    values |= {"upper.bend_z1": 0.6 * curvatures[0], "lower.bend_z1": 0.5 * curvatures[1]}
    actual = np.array([[values[name] for name in names]])
    commanded = np.zeros_like(actual)
    driven = [names.index(f"{name}.motor") for name in ("one", "two")]
    commanded[0, driven] = setpoints
    _, moved, _, _ = substitutions(model, actual, commanded, driven)
    which, shapes = element_steps(model, moved, actual)
    assert which == [("gears", "one"), ("gears", "two"), ("links", "upper"), ("links", "lower")]
    found = np.diff(tips(model, [moved, *shapes])[:, 0], axis=0)
    assert np.abs(found[:, :2] - steps).max() < 1e-9


@pytest.mark.nightly("1")
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
    names, steps = element_steps(model, shapes[1], shapes[3])
    gears = [part for part, _ in names].count("gears")
    assert np.array_equal(steps[gears - 1] if gears else shapes[1], shapes[2])
    assert np.array_equal(steps[-1], shapes[3])


def test_along_a_zero_error():
    assert (along(np.zeros((3, 3))) == 0).all()
    assert along(np.array([[1.0, 0, 0], [-1.0, 0, 0]])) == pytest.approx([0.0, 0.0])


def test_parts_of_a_run():
    """They add up to the tip less the commanded and less the nominal one; the commanded one is where a rigid arm is."""
    data, (_, run) = result_of("swinging").data, run_of("swinging")
    for parts, path in (("tip_error", "tip_commanded"), ("tip_error_nominal", "tip_nominal")):
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
        row = next(row for row in summary_rows(summary) if row[0] == f"error from {which} path")
        assert f"controller {one['parts_m']['controller'] * 1e3:.3g} mm" in row[-1]
        for part, elements in one["elements_m"].items():
            assert sum(elements.values()) == pytest.approx(one["parts_m"][part], abs=1e-14)
        assert (one["environment_m"] is None) == ("contact_force" not in result_of("swinging").data)
    assert summary["tip_error"]["nominal"]["max_m"] == pytest.approx(summary["deviation"]["max_m"], rel=1e-12)
    assert "tip_error.commanded.max_m" in summary["error"]["figures"]


def double_pendulum(tolerance: float = 1e-3) -> Robot:
    """A driven joint that carries a free one."""
    inertia = {"xx": 0.1, "yy": 0.1, "zz": 0.1}
    place = {"from": "frame", "origin": {"position": [0.5, 0, 0]}}
    turn = {"type": "revolute", "axis": [0, 1, 0]}
    joints = [
        {"name": "a", "parent": "base", "child": "l1", **turn, "motor": {"inertia": 0.1, "side": "joint"},
         "gear": {"stiffness": 500.0, "damping": 1.0}},
        {"name": "b", "parent": "l1", "child": "l2", "state": "free", **turn, **place},
        {"name": "tool", "parent": "l2", "child": "hand", "type": "fixed", **place},
    ]  # fmt: skip
    bodies = [{"name": "m", "mass": 1.0, "center": [0.4, 0, 0], "inertia": inertia}]
    move = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.3}
    control = {"type": "pd", "position_gain": 100.0, "velocity_gain": 10.0}
    return Robot.from_data(sheet(
        joints=joints, links=[{"name": name, "bodies": bodies} for name in ("l1", "l2")], gravity=9.81,
        drives=[{"joint": "a", "command": "position", "signal": move, "controller": control}],
        integration={"method": "dormand_prince", "relative_tolerance": tolerance, "duration": 0.4, "output_step": 0.01},
        initial={"state": "zero"}, real={"joints.a.gear.stiffness": 0.8},
    ))  # fmt: skip


def test_a_free_joint_is_no_gear():
    """It is named, and moves the commanded tip, whose error counts as well."""
    found = tmodes.run(double_pendulum()).summary()
    one = found["tip_error"]["commanded"]
    assert list(one["parts_m"]) == ["controller", "gears, free joints", "links"]
    assert [(part, *own) for part, own in one["elements_m"].items()] == [
        ("gears", "a"),
        ("links",),
        ("free joints", "b"),
    ]
    assert "free joint b" in [name for name, _ in largest_elements(one)]
    exact = tmodes.run(double_pendulum(1e-7)).summary()["tip_error"]["commanded"]["max_m"]
    assert abs(one["max_m"] - exact) <= found["error"]["figures"]["tip_error.commanded.max_m"]


PRESSED = st.fixed_dictionaries({"stiffness": st.floats(50.0, 2e3), "push": st.floats(1.0, 30.0),
                                 "length": st.floats(0.3, 1.5)})  # fmt: skip


@settings(max_examples=5, deadline=None)
@given(pressed=PRESSED)
def test_what_of_a_gear_is_by_the_contact(pressed):
    """A rod held by its motor, pressed at its end: all that its gear gives way is by the contact, F L^2/k."""
    length, hinge = pressed["length"], {"name": "hub", "type": "revolute", "parent": "base", "child": "rod"}
    hinge |= {"axis": [0, 0, 1], "motor": {"inertia": 0.1, "side": "joint"}}
    hinge["gear"] = {"stiffness": pressed["stiffness"], "damping": 1.0}
    robot = Robot.from_data(sheet(
        joints=[hinge], links=[{"name": "rod", "bodies": [{"name": "b", "mass": 0.5, "center": [length / 2, 0, 0]}]}],
        tip={"link": "rod", "position": [length, 0, 0]}, integration={"duration": 0.05, "output_step": 0.01},
        drives=[{"joint": "hub", "command": "prescribed", "signal": {"type": "constant", "value": 0.0}}],
        contact={"law": "bilateral", "stiffness": 1.0, "damping": 0.0, "preload": pressed["push"],
                 "shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, 1, 0]}},
    ))  # fmt: skip
    found = tmodes.run(robot.with_({"gravity": 0.0})).summary()["tip_error"]["commanded"]
    assert found["environment_m"]["gears"] == pytest.approx(found["parts_m"]["gears"], rel=1e-6)
    assert found["environment_m"]["links"] == 0.0
    assert found["max_m"] == pytest.approx(pressed["push"] * length**2 / pressed["stiffness"], rel=0.1)


@pytest.mark.parametrize("name", ["swinging"])
def test_modes_about_the_end_are_those_of_a_robot_that_stays_there(name):
    """They differ from those at the start, and name the vibrations that the tip has there."""
    result = result_of(name)
    ends = [drive.signal.schedule(9.0).at(9.0) for drive in result.actual.drives]
    still = {f"drives.{k}.signal": {"type": "constant", "value": float(end)} for k, end in enumerate(ends)}
    pair = result.robot.with_(still).pair()
    for which, robot, state in (("actual", pair.real, "controlled"), ("nominal", pair.nominal, "locked")):
        wanted = [mode["frequency_Hz"] for mode in sheet_frequencies(robot)[state]]
        assert [mode["frequency_Hz"] for mode in result.end_frequencies[which]] == pytest.approx(wanted, rel=1e-6)
    ringing = {mode["element"]: mode for mode in result.end_frequencies["nominal"]}
    for mode in result.vibration["nominal"]["modes"]:
        if mode["element"]:
            assert ringing[mode["element"]]["damped_frequency_Hz"] == pytest.approx(mode["frequency_Hz"], rel=0.05)


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
    assert "tip_errors" not in all_figures(result)


def test_parts_of_a_deformation_that_cancel_are_not_given():
    """T_st far above the deflection itself, as where motors jerk at the start, is no number to print."""
    result = result_of("swinging")
    assert "max_stationary" in result.summary()["deformations"]["shoulder.gear"]
    data = result.data.copy(deep=True)
    data["deformation_stationary"].loc[{"deformation_kind": "shoulder.gear", "time": 0.0}] = 1.49e3
    summary = Result(data).summary()
    assert "max_stationary" not in summary["deformations"]["shoulder.gear"]
    row = next(row for row in summary_rows(summary) if row[0] == "deflection of gear shoulder")
    assert "static" not in row[4]


def test_a_double_eigenvalue_zero_does_not_grow():
    """Two inertias on a spring that turn freely: rounding parts the double zero."""
    state = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-1e4, 1e4, 0, 0], [1e4, -1e4, 0, 0]], dtype=float)
    turn = np.eye(4) + 1e-3 * np.random.default_rng(0).normal(size=(5, 4, 4))
    spectra = [spectrum_of(np.linalg.solve(one, state @ one), ["a", "b"]) for one in turn]
    assert max(spectrum.eigenvalues.real.max() for spectrum in spectra) > 1e-7
    assert not any(growth_warnings(spectrum, "robot", "") for spectrum in spectra)
    assert growth_warnings(spectrum_of(np.array([[0.0, 1.0], [3.0, 0.0]]), ["a"]), "robot", "")
