# pyright: reportOperatorIssue=false
"""The scene of a page says where everything was: held against kinematics and against what the result holds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from see.scenes import arm_result, robot_result
from tmodes.analysis.modes.modes import modes_about
from tmodes.analysis.modes.of_sheet import servos_of
from tmodes.analysis.spectrum import MotorState
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.report.data import modes_of
from tmodes.report.pack import Coarse, TwoParts, displaced, kept, pack, stations_shown, steady
from tmodes.report.scene import line_of, scene_of
from tmodes.report.scene_parts import actual, section_of, solid_bar
from tmodes.sheet import Robot

RESULTS = [robot_result, arm_result]


def plain(values: Any) -> NDArray[np.float64]:
    """The numbers of a packed array, as the page gets them."""
    if isinstance(values, TwoParts):
        return plain(values.large) + plain(values.small)
    if isinstance(values, Coarse):
        low, high = values.values.min(), values.values.max()
        scale, middle = (high - low) / 65000, (high + low) / 2
        return middle + scale * np.round((values.values - middle) / scale)
    return np.asarray(values, dtype=float)


def frames(result: Any) -> Any:
    """The samples that a scene shows where nobody chooses."""
    return np.isin(result.data["time"].values, scene_of(result)["times"])


def turned(scene: dict[str, Any]) -> NDArray[np.float64]:
    """The axes of all roots (m, L, 3, 3)."""
    roots = plain(scene["roots"])
    return Rotation.from_quat(roots.reshape(-1, 4)).as_matrix().reshape(*roots.shape[:2], 3, 3)


@pytest.mark.parametrize("made", RESULTS)
def test_the_reference_ends_where_the_result_says(made: Any) -> None:
    result = made()
    scene = scene_of(result)
    line, reference = plain(scene["line"]), plain(scene["reference"])
    info = result.data.isel(time=frames(result))
    assert np.abs(line - info["line"].transpose("time", ..., "s", "axis").values).max() < 1e-6
    if made is robot_result:
        assert np.abs(reference[:, -1, -1] - info["tip_nominal"].values).max() < 1e-6
    else:
        hand = info["tip_nominal"].values - reference[:, -1, 0]
        assert np.allclose(np.linalg.norm(hand, axis=1), 0.25, atol=1e-6)
        assert np.abs(reference[:, 0, -1] - reference[:, 1, 0]).max() < 1e-6
    for name, variable in (("tipReference", "tip_nominal"), ("tipCommanded", "tip_commanded")):
        assert np.abs(plain(scene[name]) - info[variable].values).max() < 1e-12
    assert scene["gravity"] == list(result.robot.gravity)


@pytest.mark.parametrize("made", RESULTS)
def test_roots_look_along_their_links(made: Any) -> None:
    scene = scene_of(made())
    line = plain(scene["line"])
    first = -11 * line[:, :, 0] + 18 * line[:, :, 1] - 9 * line[:, :, 2] + 2 * line[:, :, 3]  # exact for cubics
    along = first / np.linalg.norm(first, axis=-1, keepdims=True)
    assert np.abs(along - turned(scene)[..., 0]).max() < 3e-4
    roots = plain(scene["roots"])
    assert ((roots[1:] * roots[:-1]).sum(axis=-1) > 0).all()


def test_the_rigid_robot_lies_along_its_motor() -> None:
    result = robot_result()
    info = result.data.isel(time=frames(result))
    theta = info["q"].sel(coordinate="joint.motor").values
    tip = 0.9 * np.stack([np.cos(theta), np.sin(theta), 0 * theta], axis=-1)
    assert np.abs(plain(scene_of(result)["rigid"])[:, -1, -1] - tip).max() < 1e-6


def test_the_reference_is_enlarged_about_its_own_rigid_arm() -> None:
    result = robot_result()
    info = result.data.isel(time=frames(result))
    theta = info["q_nominal"].sel(coordinate="joint.motor").values
    tip = 0.9 * np.stack([np.cos(theta), np.sin(theta), 0 * theta], axis=-1)
    assert np.abs(plain(scene_of(result)["referenceRigid"])[:, -1, -1] - tip).max() < 1e-6
    scene = scene_of(arm_result())
    bent = plain(scene["reference"]) - plain(scene["referenceRigid"])
    gear = arm_result().data["deformation_nominal"].isel(time=frames(arm_result())).values[:, 0]
    assert np.abs(bent[:, 0, 0]).max() < 1e-6
    assert np.abs(bent[:, 0, -1]).max() > 0.1 * np.abs(gear).max()


def test_a_base_that_moves_carries_the_ghosts_too() -> None:
    result = arm_result()
    scene = scene_of(result)
    rigid, reference = plain(scene["rigid"]), plain(scene["reference"])
    assert np.ptp(rigid[:, 0, 0, 2]) > 0.08
    assert np.abs(rigid[:, 0, 0] - reference[:, 0, 0]).max() < 1e-6


def test_small_displacements_keep_their_digits() -> None:
    rigid = np.random.default_rng(1).uniform(-1, 1, (200, 4, 15, 3))
    moved = 1e-4 * np.sin(np.arange(rigid.size)).reshape(rigid.shape)
    coarse = kept(rigid)
    shown = displaced(rigid + moved, rigid, coarse)
    assert isinstance(shown, TwoParts)
    assert np.abs(plain(shown) - plain(coarse) - moved).max() < 1e-8


def test_an_array_that_stands_twice_is_packed_once() -> None:
    one = Coarse(np.arange(50_000.0))
    assert len(pack({"a": one, "b": one})) < len(pack({"a": one})) + 100


def test_a_run_of_one_frame_has_a_scene() -> None:
    one = scene_of(robot_result(), np.array([3]))
    assert plain(one["line"]).shape == (1, 2, 7, 3)


def test_turning_is_reported_without_jumps_of_sign() -> None:
    angle = np.linspace(0, 30, 400)
    found = np.stack([0 * angle, 0 * angle, np.sin(angle / 2), np.cos(angle / 2)], axis=-1)[:, None]
    jumping = found * np.where(np.sin(3 * angle) > 0, 1, -1)[:, None, None]
    assert np.allclose(np.abs((steady(jumping) * found).sum(axis=-1)), 1)
    assert ((steady(jumping)[1:] * steady(jumping)[:-1]).sum(axis=-1) > 0.99).all()


def test_stations_get_fewer_where_there_are_many() -> None:
    assert list(stations_shown(7, 100, 2)) == [0, 1, 2, 3, 4, 5, 6]
    few = stations_shown(21, 3000, 10)
    assert len(few) == 13
    assert (few[0], few[-1]) == (0, 20)


@pytest.mark.parametrize("made", RESULTS)
def test_modes_are_those_of_the_result(made: Any) -> None:
    result = made()
    modes = modes_of(result)
    for case, info in result.frequencies.items():
        wanted = [mode for mode in info if mode["frequency_Hz"] > 0][:8]
        found = [mode for mode in modes if mode["case"] == case]
        for name, key in (("frequency", "frequency_Hz"), ("damping", "damping_ratio")):
            assert [mode[name] for mode in found] == pytest.approx([mode[key] for mode in wanted], rel=1e-6, abs=1e-12)
        assert [mode["element"] for mode in found] == [mode["element"] for mode in wanted]
    sizes = [np.hypot(np.linalg.norm(m["real"], axis=-1), np.linalg.norm(m["imaginary"], axis=-1)).max() for m in modes]
    assert sizes == pytest.approx([1.0] * len(modes), rel=1e-5)


def test_the_tip_of_a_mode_moves_by_the_jacobian() -> None:
    result = robot_result()
    robot = actual(result).robot
    rest = robot_rest(robot, contact=True)
    jacobian = rest.model.jacobian(rest.q)[0, :3]
    shaped = modes_about(rest, MotorState.CONTROLLED, servos_of(robot, rest.model))
    moving = [mode for mode in shaped if mode.motion is not None and mode.frequency_Hz > 0]
    assert len(moving) >= 4
    for mode, one in zip(modes_of(result), moving, strict=False):
        tip = mode["real"][-1, -1] + 1j * mode["imaginary"][-1, -1]
        wanted = jacobian @ one.motion
        share = np.vdot(wanted, tip) / np.vdot(wanted, wanted)
        assert np.abs(tip - share * wanted).max() < 1e-5 * np.abs(tip).max()


def test_the_line_panel_holds_the_series_of_the_result() -> None:
    for result, links in ((robot_result(), ["link.1", "link.2"]), (arm_result(), ["rod"])):
        panel = line_of(result)
        assert panel is not None
        assert panel["links"] == links
        moment = next(one for one in panel["quantities"] if one["id"] in {"bending_moment", "moment"})
        info = np.abs(result.data[moment["id"]].isel(time=frames(result))).max()
        assert np.abs(plain(moment["values"])).max() == pytest.approx(float(info), rel=1e-4)
        assert panel["places"].shape == (len(links), plain(moment["values"]).shape[2])
        assert panel["places"][0, -1] == pytest.approx(0.6 if links != ["rod"] else 0.8)


def test_colours_are_of_bending_links_only_and_of_displacement_of_all() -> None:
    colours = {one["id"]: plain(one["values"]) for one in scene_of(arm_result())["colours"]}
    assert list(colours) == ["bending_moment", "torsion", "deflection", "stress", "strain", "displacement"]
    assert not colours["stress"][:, 1].any()
    assert colours["displacement"][:, 1].max() > 0
    peak = arm_result().summary()["links"]["rod"]["stress"]["max_Pa"]
    assert colours["stress"].max() == pytest.approx(peak, rel=1e-3)


def test_what_stands_on_what() -> None:
    scene = scene_of(arm_result())
    assert [(link["name"], link["parent"], link["bends"]) for link in scene["links"]] == [
        ("rod", -1, True), ("hand", 0, False)]  # fmt: skip
    assert [(joint["link"], joint["drawing"], joint["elastic"]) for joint in scene["joints"]] == [
        (0, "cylinder", True), (1, "cylinder", False)]  # fmt: skip
    assert scene["contact"] is None
    contact = scene_of(robot_result())["contact"]
    assert contact["surface"] == {"kind": "ball", "center": [0, 0, 0], "radius": pytest.approx(0.9), "inside": True}


def test_a_solid_bar_is_found_again_by_its_stiffness_and_mass() -> None:
    young, density, radius, sides = 210e9, 7850.0, 0.009, (0.02, 0.005)
    stiffness = young * np.pi * radius**4 / 4
    round_bar = solid_bar(stiffness, stiffness, density * np.pi * radius**2, 3)
    assert round_bar is not None
    assert round_bar["sizes"] == pytest.approx(np.full((3, 2), radius), rel=0.02)
    (wide, high), area = sides, 4 * sides[0] * sides[1]
    flat = solid_bar(young * 4 / 3 * wide * high**3, young * 4 / 3 * high * wide**3, density * area, 2)
    assert flat is not None
    assert (flat["shape"], flat["guessed"]) == ("box", True)
    assert flat["sizes"] == pytest.approx(np.array([sides, sides]), rel=0.02)
    assert solid_bar(np.inf, 1.0, 1.0, 2) is None


def test_sections_come_from_the_sheet() -> None:
    arm = Robot.from_data(json_sheet(arm_result()))
    section = section_of(arm, "rod", np.linspace(0, 1, 4))
    assert section is not None
    assert (section["shape"], section["guessed"]) == ("round", False)
    assert section["sizes"] == pytest.approx(np.full((4, 2), 0.01))
    assert section_of(arm, "hand", np.linspace(0, 1, 4)) is None


def json_sheet(result: Any) -> Any:
    """The data sheet that a result keeps."""
    import json

    return json.loads(result.data.attrs["robot_real"])
