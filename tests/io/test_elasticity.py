"""An elasticity file over a URDF: the undeformed arm stays exactly where it was, its mass is counted once."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from io_frames import chain_frames, matrix, sheet_frames
from tmodes.errors import InputError, InputErrors, TmodesError
from tmodes.io.elasticity import section_axes
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_files import read_sheet
from tmodes.io.urdf import read_urdf
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.links.strain import Beam
from tmodes.sheet import Robot

INERTIAL = """<inertial><origin xyz="0.1 0.02 0.2" rpy="0.3 -0.4 0.5"/><mass value="2.4"/>
<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="-0.003"/></inertial>"""

URDF = f"""<robot name="bent">
  <link name="ground"/>
  <link name="upper">{INERTIAL}</link>
  <link name="fore">{INERTIAL}</link>
  <link name="hand">{INERTIAL}</link>
  <link name="camera"/>
  <joint name="pan" type="revolute"><parent link="ground"/><child link="upper"/>
    <origin xyz="0 0 0.3" rpy="0.1 0.2 0.3"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="9" velocity="2"/></joint>
  <joint name="lift" type="revolute"><parent link="upper"/><child link="fore"/>
    <origin xyz="0.3 0.4 1.2" rpy="1.0 -0.5 0.7"/><axis xyz="0 1 0"/></joint>
  <joint name="turn" type="continuous"><parent link="fore"/><child link="hand"/>
    <origin xyz="0 0 -0.5" rpy="0 1.5707963267948966 0"/><axis xyz="1 0 0"/></joint>
  <joint name="eye" type="fixed"><parent link="fore"/><child link="camera"/>
    <origin xyz="0.1 0 -0.2" rpy="0 0 1"/></joint>
</robot>
"""

BEAM = "model: strain, functions: 3, damping_time: 0.001"
TUBE = "section: {shape: tube, outer_diameter: 0.06, thickness: 0.003}, material: steel"
GIVEN = "section: {bending_stiffness: 1000.0}"
BOTH = f"""links:
  upper: {{beam: {{{BEAM}, {GIVEN}}}}}
  fore: {{beam: {{{BEAM}, {TUBE}}}, keep_inertial: replaced}}
"""
ANGLES = {"pan": 0.7, "lift": -1.1, "turn": 2.3}


def file_of(folder: Path, text: str, urdf: str = URDF) -> Path:
    (folder / "bent.urdf").write_text(urdf)
    path = folder / "bent.yaml"
    path.write_text(f"urdf: bent.urdf\n{text}")
    return path


def arm_of(folder: Path, text: str) -> Any:
    return sheet_from_data(*read_sheet(file_of(folder, text)))


def said(folder: Path, text: str) -> str:
    path = file_of(folder, text)
    with pytest.raises((InputError, InputErrors)) as caught:
        read_sheet(path)
    return str(caught.value).replace(f"{folder}/", "")


def test_the_undeformed_arm_is_exactly_the_urdf(tmp_path: Path) -> None:
    bent = read_sheet(file_of(tmp_path, BOTH))[0]
    rigid = sheet_frames(read_urdf(tmp_path / "bent.urdf").data, ANGLES)
    chain = chain_frames(bent, ANGLES)
    for joint, link in (("turn", "hand"), ("eye", "camera")):
        np.testing.assert_allclose(chain[joint], rigid[link], atol=2e-15, rtol=0)
    lengths = [node.link.length for node in Robot.from_data(bent).chain().nodes if isinstance(node.link, Beam)]
    assert lengths == pytest.approx([1.3, 0.5], abs=1e-15)


MODES = "{bending_stiffness: 900.0, damping_time: 0.001}, {bending_stiffness: 400.0, damping_time: 0.001}"


def test_a_link_may_be_of_modes(tmp_path: Path) -> None:
    """Equal ones where no lengths are given; the arm stays where it was, and the URDF's mass lies along them."""
    bent = read_sheet(file_of(tmp_path, f"links: {{upper: {{beam: {{model: modes, modes: [{MODES}]}}}}}}\n"))[0]
    rigid = sheet_frames(read_urdf(tmp_path / "bent.urdf").data, ANGLES)
    np.testing.assert_allclose(chain_frames(bent, ANGLES)["turn"], rigid["hand"], atol=2e-15, rtol=0)
    (link,) = (node.link for node in Robot.from_data(bent).chain().nodes if node.link.kind == "modes")
    assert (len(link.coordinates), link.length) == (4, pytest.approx(1.3, abs=1e-15))
    beam = next(one for one in bent["links"] if one["name"] == "upper")["beam"]
    assert [mode["length"] * mode["mass_per_length"] for mode in beam["modes"]] == pytest.approx([1.2, 1.2])
    wrong = MODES.replace("{bending", "{length: 0.4, bending")
    assert "modes of 0.8 m" in said(tmp_path, f"links: {{upper: {{beam: {{model: modes, modes: [{wrong}]}}}}}}\n")


def test_the_frames_of_the_sheet_are_scipys(tmp_path: Path) -> None:
    """The rotation that a URDF means: fixed axes, roll first."""
    file_of(tmp_path, "")
    frame = sheet_frames(read_urdf(tmp_path / "bent.urdf").data, {})["upper"]
    expected = Rotation.from_rotvec([0, 0, 0.3]) * Rotation.from_rotvec([0, 0.2, 0]) * Rotation.from_rotvec([0.1, 0, 0])
    np.testing.assert_allclose(frame[:3, :3], expected.as_matrix(), atol=1e-15)


@pytest.mark.parametrize("direction", [(1, 0, 0), (0, 0, 1), (0, 0, -2), (0.3, 0.4, 1.2), (-1, 2, 0.1), (0, -1, 0)])
def test_section_axes_are_a_right_handed_frame_along_the_beam(direction: tuple[float, float, float]) -> None:
    axes = section_axes(np.array(direction, float))
    np.testing.assert_allclose(axes.T @ axes, np.eye(3), atol=1e-15)
    assert np.linalg.det(axes) == pytest.approx(1)
    np.testing.assert_allclose(axes[:, 0] * np.linalg.norm(direction), direction, atol=1e-14)
    assert axes[:, 2] @ (np.eye(3)[0] if abs(axes[2, 0]) > 0.9 else np.eye(3)[2]) > 0


def test_the_mass_of_the_urdf_is_spread_over_the_length(tmp_path: Path) -> None:
    chain = arm_of(tmp_path, BOTH).chain()
    upper, fore = (node.link for node in chain.nodes if isinstance(node.link, Beam))
    assert upper.pieces[0].mass == pytest.approx((2.4 / 1.3, 2.4 / 1.3))
    area = np.pi * (0.03**2 - 0.027**2)
    assert fore.pieces[0].mass[0] == pytest.approx(7850 * area, rel=0.01)
    assert upper.bodies == fore.bodies == ()


def test_from_and_to_place_a_beam_anywhere(tmp_path: Path) -> None:
    text = f'links: {{fore: {{beam: {{{BEAM}, {GIVEN}, from: [0.1, 0, "-50 mm"], to: [0.1, 0.2, -0.45]}}}}}}\n'
    data = read_sheet(file_of(tmp_path, text))[0]
    beam = next(link["beam"] for link in data["links"] if link["name"] == "fore")
    assert beam["length"] == pytest.approx(np.hypot(0.2, 0.4))
    root = matrix(beam["root_mount"])
    np.testing.assert_allclose(root @ [beam["length"], 0, 0, 1], [0.1, 0.2, -0.45, 1], atol=1e-15)
    tip = root @ matrix({"position": [beam["length"], 0, 0]}) @ matrix(beam["tip_mount"])
    np.testing.assert_allclose(tip[:3, :3], np.eye(3), atol=1e-15)
    rigid = sheet_frames(read_urdf(tmp_path / "bent.urdf").data, ANGLES)
    np.testing.assert_allclose(chain_frames(data, ANGLES)["turn"], rigid["hand"], atol=2e-15)


@pytest.mark.parametrize("center", ["0.1 0.02 0.2", "0.9 1.2 3.6"], ids=["between the ends", "beyond the tip"])
def test_a_kept_inertial_rides_where_it_was(center: str, tmp_path: Path) -> None:
    """Center of mass and inertia of the riding body, in the link's frame, are the URDF's."""
    text = f"links: {{upper: {{beam: {{{BEAM}, {TUBE}}}, keep_inertial: rigid}}}}\n"
    path = file_of(tmp_path, text, URDF.replace("0.1 0.02 0.2", center))
    data = read_sheet(path)[0]
    link = next(link for link in data["links"] if link["name"] == "upper")
    (body,), beam = link["bodies"], link["beam"]
    station = matrix(beam["root_mount"]) @ matrix({"position": [body["at"] * beam["length"], 0, 0]})
    frame = station @ matrix(beam["tip_mount"]) if body["at"] == 1.0 else station
    np.testing.assert_allclose((frame @ [*body["center"], 1])[:3], np.array(center.split(), float), atol=1e-14)
    inertia = body["inertia"]
    got = np.array([[inertia["".join(sorted(a + b))] for b in "xyz"] for a in "xyz"])
    turn = Rotation.from_euler("xyz", [0.3, -0.4, 0.5]).as_matrix()
    wanted = turn @ [[0.02, 0.001, 0.002], [0.001, 0.03, -0.003], [0.002, -0.003, 0.04]] @ turn.T
    np.testing.assert_allclose(frame[:3, :3] @ got @ frame[:3, :3].T, wanted, atol=1e-15)
    assert 0 < body["at"] <= 1
    assert "rpy" not in body
    sheet_from_data(data)


def test_joints_get_motors_and_gears_and_keep_the_rest(tmp_path: Path) -> None:
    text = """joints:
  pan: {motor: {inertia: 0.2, side: joint}, gear: {stiffness: 5e3, damping: 1.0}, limits: {upper: 0.5}}
  lift: {state: locked, locked_at: "90 deg"}
gravity: [0, 0, -1.62]
tip: {link: hand, position: [0, 0, 0.1]}
assumed: the stiffness
"""
    arm = arm_of(tmp_path, text)
    joints = {joint.name: joint for joint in arm.joints}
    assert (joints["pan"].limits.lower, joints["pan"].limits.upper, joints["pan"].limits.speed) == (-1.0, 0.5, 2.0)
    assert joints["lift"].locked_at == pytest.approx(np.pi / 2)
    assert arm.gravity == (0.0, 0.0, -1.62)
    pan = next(node.joint for node in arm.chain().nodes if node.joint.name == "pan")
    assert (pan.drive, pan.gear.stiffness, pan.motor.inertia) == (drive_kind("elastic"), (5000.0,), 0.2)
    assert (arm.name, arm.assumed) == ("bent", "the stiffness")


def test_a_link_that_the_urdf_does_not_weigh_gets_its_mass_here(tmp_path: Path) -> None:
    urdf = URDF.replace(f'<link name="hand">{INERTIAL}', '<link name="hand">')
    path = file_of(tmp_path, "links: {hand: {bodies: [{name: tool, mass: 0.7}]}}\n", urdf)
    assert read_sheet(path)[0]["links"][-1] == {"name": "hand", "bodies": [{"name": "tool", "mass": 0.7}]}
    with pytest.raises(InputErrors, match="no mass on the moving joint 'turn'"):
        read_sheet(file_of(tmp_path, "gravity: 9.81\n", urdf))


def test_joints_that_are_held_for_a_mimic_can_be_let_go(tmp_path: Path) -> None:
    urdf = URDF.replace('<axis xyz="1 0 0"/>', '<axis xyz="1 0 0"/><mimic joint="lift" offset="0.3"/>')
    held = read_sheet(file_of(tmp_path, "gravity: 9.81\n", urdf))[0]["joints"]
    assert [joint.get("locked_at") for joint in held if "state" in joint] == [0.3]
    free = sheet_from_data(*read_sheet(file_of(tmp_path, "joints: {turn: {state: active}}\n", urdf)))
    assert [joint.name for joint in free.joints if joint.state == "locked"] == []
    (notice,) = free.notices
    assert "turn (follows lift)" in notice
    assert notice == free.assumed
    assert "held" not in notice


def test_a_xacro_is_read_as_well(tmp_path: Path) -> None:
    (tmp_path / "bent.xacro").write_text(URDF.replace("0.3 0.4 1.2", "${0.1*3} ${0.1*4} ${0.1*12}"))
    path = tmp_path / "a.yaml"
    path.write_text(f"urdf: bent.xacro\n{BOTH}")
    beam = next(link["beam"] for link in read_sheet(path)[0]["links"] if link["name"] == "upper")
    assert beam["length"] == pytest.approx(1.3)


UPPER = "links:\n  upper:\n    beam: {{{0}}}\n{1}"
REFUSED = {
    "unknown joint": (
        "joints:\n  pann: {state: locked}\n",
        "bent.yaml:3: joints.pann: unknown name 'pann'",
        "Did you mean `pan`?",
    ),
    "unknown link": ("links:\n  foree: {}\n", "bent.yaml:3: links.foree: unknown name", "Did you mean `fore`?"),
    "unknown key": (
        "joints:\n  pan:\n    gaer: {}\n",
        "bent.yaml:4: joints.pan.gaer: unknown name",
        "Did you mean `gear`?",
    ),
    "urdf's key": (
        "joints:\n  pan: {axis: [1, 0, 0]}\n",
        "joints.pan.axis must be",
        "remove it",
    ),
    "two masses": (
        UPPER.format(f"{BEAM}, {TUBE}", ""),
        "bent.yaml:3: links.upper.keep_inertial must be",
        "keep_inertial: rigid",
    ),
    "no mass": (
        UPPER.format(f"{BEAM}, {GIVEN}", "    keep_inertial: rigid\n"),
        "rides on it as a rigid body",
        "add `mass_per_length",
    ),
    "keep what": (
        UPPER.format(f"{BEAM}, {GIVEN}", "    keep_inertial: maybe\n"),
        "bent.yaml:5: links.upper.keep_inertial must be rigid or replaced, got 'maybe'",
        "write one of the two",
    ),
    "keep without a beam": ("links: {upper: {keep_inertial: rigid}}\n", "got a link without `beam`", "remove it"),
    "no end": (
        f"links: {{hand: {{beam: {{{BEAM}, {GIVEN}}}}}}}\n",
        "links.hand.beam.to must be the point where the beam ends, got a link that carries no joint",
        "write `to",
    ),
    "no direction": (
        UPPER.format(f"{BEAM}, {GIVEN}, to: [0, 0, 0]", ""),
        "bent.yaml:4: links.upper.beam.to",
        "has no direction",
    ),
    "length and to": (
        UPPER.format(f"{BEAM}, {GIVEN}, length: 1, to: [1, 0, 0]", ""),
        "got both `length` and `to`",
        "remove",
    ),
    "length as text": (
        UPPER.format(f"{BEAM}, {GIVEN}, length: long", ""),
        "links.upper.beam.length must be",
        "[m]",
    ),
    "length negative": (UPPER.format(f"{BEAM}, {GIVEN}, length: -1", ""), "links.upper.beam.length must be", "[m]"),
    "to of two": (
        UPPER.format(f"{BEAM}, {GIVEN}, to: [1, 0]", ""),
        "links.upper.beam.to must be",
        "three numbers",
    ),
    "joints as list": (
        "joints: [1]\n",
        "bent.yaml:2: joints must be groups by name, got a list of 1",
        "groups by name",
    ),
    "beam as text": ("links: {upper: {beam: steel}}\n", "links.upper.beam must be a group, got 'steel'", "a group"),
    "kind": ("kind: arm\n", "bent.yaml:2: kind must be elasticity, or no kind, got 'arm'", "remove the line"),
}


@pytest.mark.parametrize(("text", "words", "hint"), REFUSED.values(), ids=REFUSED)
def test_refused_with_line_and_hint(text: str, words: str, hint: str, tmp_path: Path) -> None:
    message = said(tmp_path, text)
    assert words in message
    assert hint in message
    assert message.startswith("bent.yaml:")


@pytest.mark.parametrize(
    "name", ["../bent.urdf", "/etc/passwd", "http://example.com/a.urdf", "nothing.urdf", "bent.yaml", "5"]
)
def test_the_urdf_lies_in_the_folder(name: str, tmp_path: Path) -> None:
    path = file_of(tmp_path, "")
    path.write_text(f"name: a\nurdf: {name}\n")
    with pytest.raises(InputError, match=r"bent\.yaml:2: urdf must be .*, got .*; "):
        read_sheet(path)


def test_what_is_wrong_in_the_sheet_is_reported_with_the_line_of_this_file(tmp_path: Path) -> None:
    text = "joints:\n  lift:\n    motor: {inertia: 0.2, side: joint}\n    gear: {stiffness: -5, damping: 1.0}\n"
    data, positions, source = read_sheet(file_of(tmp_path, text))
    with pytest.raises(TmodesError, match=r"bent\.yaml:5: .*gear\.stiffness"):
        sheet_from_data(data, positions, source)
