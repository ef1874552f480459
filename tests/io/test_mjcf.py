"""MJCF: bodies and joints stand and weigh as MuJoCo says; no file outside the folder; what is no arm is refused."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from io_frames import mass_matrix, sheet_frames
from tmodes.chain.chain import ParallelSpring
from tmodes.errors import InputError
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_files import read_sheet
from tmodes.kinds.drives.registry import drive_kind
from tmodes.model.model import Model

needs_mujoco = pytest.mark.skipif(find_spec("mujoco") is None, reason="needs MuJoCo (`pip install mujoco`)")

MODEL = """<mujoco model="three">
  <compiler angle="radian" autolimits="true"/>
  <option gravity="0 0 -3.7"/>
  <worldbody>
    <body name="stand" pos="0 0 0.1" euler="0.1 0.2 0.3">
      <geom type="box" size=".1 .2 .3"/>
      <body name="upper" pos="0.1 0 0.2" quat="1 0.2 -0.1 0.4">
        <joint name="pan" axis="0 1 0" pos="0 0.05 0.2" ref="0.3" range="-1 1" damping="0.3"
          armature="0.01" frictionloss="0.2"/>
        <joint name="tilt" axis="1 1 0" pos="0.1 0 0" actuatorfrcrange="-5 5"/>
        <geom type="capsule" fromto="0 0 0 0.3 0.1 0.4" size="0.05"/>
        <body name="base" pos="0.3 0.1 0.4" euler="0.3 0 1">
          <joint name="slide" type="slide" axis="0 0 2" ref="0.1"/>
          <joint name="wrist" axis="0 0 1" pos="0.02 0 0"/>
          <inertial pos="0.01 0.02 0.03" mass="0.7" fullinertia="0.01 0.02 0.025 0.001 0.002 -0.003"/>
          <body pos="0 0 0.2"><joint axis="1 0 0"/><geom size="0.04"/></body>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator><motor joint="tilt"/></actuator>
</mujoco>"""

SPRING = """<mujoco><compiler angle="radian"/><worldbody>
<body name="a"><joint name="j" axis="0 0 1" {0}/><geom size="0.1" pos="1 0 0"/></body></worldbody>{1}</mujoco>"""


def written(folder: Path, text: str = MODEL) -> Path:
    path = folder / "model.xml"
    path.write_text(text)
    return path


@pytest.mark.peer
@needs_mujoco
@pytest.mark.parametrize("seed", range(5))
def test_frames_and_masses_are_mujocos(seed: int, tmp_path: Path) -> None:
    mujoco: Any = import_module("mujoco")
    data, positions, _ = read_sheet(written(tmp_path))
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "model.xml"))
    state = mujoco.MjData(model)
    state.qpos[:] = np.random.default_rng(seed).uniform(-1, 1, model.nq)
    mujoco.mj_forward(model, state)
    names = ["pan", "tilt", "slide", "wrist", "joint_5"]
    angles = dict(zip(names, state.qpos, strict=True))
    frames = sheet_frames(data, angles)
    for index, name in enumerate(["stand", "upper", "base_frame", "body_4"], start=1):
        np.testing.assert_allclose(frames[name][:3, :3], state.xmat[index].reshape(3, 3), atol=1e-14)
        (body,) = next(link["bodies"] for link in data["links"] if link["name"] == name)
        np.testing.assert_allclose((frames[name] @ [*body["center"], 1])[:3], state.xipos[index], atol=1e-14)
    ours = mass_matrix(data, angles, names) + np.diag([0.01, 0, 0, 0, 0])
    np.testing.assert_allclose(ours, mujocos_mass_matrix(mujoco, model, state), atol=1e-12)
    assert (positions["joints.1"], positions["joints.3"]) == (8, 13)


def mujocos_mass_matrix(mujoco: Any, model: Any, state: Any) -> np.ndarray:
    """The mass matrix column by column: inverse dynamics of unit accelerations at rest, without gravity."""
    model.opt.gravity[:] = 0
    model.dof_frictionloss[:] = 0
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    columns = []
    for column in np.eye(model.nv):
        state.qvel[:], state.qacc[:] = 0, column
        mujoco.mj_inverse(model, state)
        columns.append(state.qfrc_inverse.copy())
    return np.array(columns)


@needs_mujoco
def test_limits_friction_and_motor(tmp_path: Path) -> None:
    data, positions, source = read_sheet(written(tmp_path))
    joints = {joint["name"]: joint for joint in data["joints"]}
    assert joints["pan"]["limits"] == {"lower": -1.0, "upper": 1.0}
    assert joints["pan"]["friction"] == {"viscous": 0.3, "coulomb": 0.2}
    assert joints["pan"]["motor"] == {"inertia": 0.01, "side": "joint"}
    assert joints["tilt"]["limits"] == {"effort": 5.0}
    assert data["gravity"] == [0.0, 0.0, -3.7]
    assert "base_frame" in data["assumed"]
    assert len(sheet_from_data(data, positions, source).chain().nodes) == 6


@needs_mujoco
def test_a_passive_spring_is_a_free_joint_on_its_spring(tmp_path: Path) -> None:
    path = written(tmp_path, SPRING.format('stiffness="40" springref="0.25" damping="0.5"', ""))
    joint: Any = sheet_from_data(*read_sheet(path)).chain().nodes[0].joint
    assert (joint.drive, joint.spring) == (drive_kind("free"), ParallelSpring(40.0, 0.25))
    assert joint.friction.viscous == 0.5


ACTUATORS = {
    "motor": '<motor joint="j" gear="3" ctrlrange="0.2 1"/>',
    "position": '<position joint="j" kp="50" kv="2" gear="1.5"/>',
    "position and motor": '<position joint="j" kp="50" dampratio="1"/><motor joint="j" gear="2" ctrlrange="0.5 2"/>',
    "velocity": '<velocity joint="j" kv="2" gear="0.5"/>',
    "general": '<general joint="j" gainprm="3" biastype="affine" biasprm="1 -20 -0.5" ctrlrange="0.3 1"/>',
    "none": "",
}
TWO = """<mujoco><compiler angle="radian"/><option gravity="0.5 0 -9"/><worldbody>
<body name="a" gravcomp="1">
<joint name="j" axis="0 1 0" stiffness="7" springref="0.2" damping="0.3" {armature}/>
<inertial pos="0.2 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>
<body name="b" pos="0.4 0 0" gravcomp="0.3"><joint name="k" axis="0 1 0.2" stiffness="3"/>
<inertial pos="0.1 0 0.02" mass="0.5" diaginertia="0.01 0.01 0.01"/></body></body></worldbody>
<actuator>{actuators}</actuator></mujoco>"""


@pytest.mark.peer
@needs_mujoco
@pytest.mark.parametrize("actuator", ACTUATORS)
@pytest.mark.parametrize("armature", ["", 'armature="0.05"'])
def test_accelerations_are_mujocos(actuator: str, armature: str, tmp_path: Path) -> None:
    """Springs, motors, actuators and compensated weight, at a random state with controls of 0."""
    mujoco: Any = import_module("mujoco")
    rng = np.random.default_rng(len(actuator))
    text = TWO.format(armature=armature, actuators=ACTUATORS[actuator])
    robot = sheet_from_data(*read_sheet(written(tmp_path, text)))
    state = mujoco.MjData(compiled := mujoco.MjModel.from_xml_string(text))
    state.qpos[:], state.qvel[:] = rng.uniform(-1, 1, 2), rng.normal(size=2)
    mujoco.mj_forward(compiled, state)
    model, q, v = Model(robot.chain()), state.qpos.copy(), state.qvel.copy()
    efforts = dict.fromkeys(model.efforts, 0.0)
    for drive in robot.drives:
        wanted, k = float(drive.signal.schedule(1.0).at(0.0)), model.coordinates.index(drive.joint)
        servo: Any = drive.controller
        gains = (servo.position_gain, servo.velocity_gain) if servo else (0.0, 0.0)
        efforts[drive.joint] = gains[0] * (wanted - q[k]) - gains[1] * v[k] if servo else wanted
    wrenches = np.zeros((len(model.parts.points), 6))
    names = [point.name for point in model.parts.points]
    for load in robot.loads:
        wrenches[names.index(load.point), :3] = load.force
    found = model.forward_dynamics(q, v, [*efforts.values()], wrenches=wrenches)
    np.testing.assert_allclose(np.squeeze(found), state.qacc, atol=1e-9)


@needs_mujoco
def test_what_changes_the_motion_and_is_not_taken_is_named(tmp_path: Path) -> None:
    text = """<mujoco><compiler angle="radian"/>
    <option density="1000" wind="1 0 0" integrator="RK4"><flag limit="disable"/></option>
    <default><joint solreflimit="0.1 1"/><default class="soft"><joint margin="0.1"/></default></default>
    <worldbody><geom type="plane" size="1 1 1"/>
    <body name="a"><joint name="j" axis="0 1 0" range="-1 1"/><geom size="0.1" rgba="1 0 0 1"/>
    <body name="b" pos="1 0 0"><joint name="k" axis="0 1 0"/><geom size="0.1"/></body></body></worldbody>
    <tendon><fixed name="t"><joint joint="j" coef="1"/><joint joint="k" coef="1"/></fixed></tendon>
    <equality><joint joint1="k" joint2="j" polycoef="0.2 1 0 0 0"/></equality>
    <actuator><motor name="pull" tendon="t"/><muscle name="flesh" joint="j" lengthrange="0 1"/>
    <motor joint="j" forcerange="-1 1"/></actuator></mujoco>"""
    data, _, _ = read_sheet(written(tmp_path, text))
    notices = " ".join(data["notices"])
    for word in (
        "density",
        "wind",
        "limit",
        "solreflimit",
        "margin",
        "tendon",
        "pull",
        "flesh",
        "contact",
        "joint k",
        "stops",
        "clips",
    ):
        assert word in notices, word
    for word in ("rgba", "integrator", "polycoef"):
        assert word not in notices, word
    held = next(joint for joint in data["joints"] if joint["name"] == "k")
    assert (held["state"], held["locked_at"]) == ("locked", 0.2)
    assert sheet_from_data(data).chain().nodes


@needs_mujoco
@pytest.mark.parametrize(
    ("text", "words"),
    [
        (SPRING.format('type="ball"', ""), "joint 'j' must be hinge or slide, got a ball joint"),
        (SPRING.format('type="free"', ""), "joint 'j' must be hinge or slide, got a free joint (a free-flying base)"),
        (SPRING.format("", '<equality><weld body1="a"/></equality>'), "a model with equality constraints"),
        (SPRING.format('axiss="1"', ""), "a model that MuJoCo refuses"),
        ("<mujoco/>", "the model must be bodies and joints, got no body"),
    ],
)
def test_what_is_no_arm_is_refused(text: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read_sheet(written(tmp_path, text))
    assert words in str(caught.value)
    assert str(caught.value).startswith(f"{tmp_path}/model.xml")


@pytest.mark.parametrize(
    "inside",
    [
        '<include file="../other.xml"/>',
        '<include file="/etc/passwd"/>',
        '<include file="absent.xml"/>',
        '<include file="model.xml"/>',
        '<compiler meshdir="/etc"/><asset><hfield name="h" file="h.png" size="1 1 1 1"/></asset>',
        '<asset><hfield name="h" nrow="1000000" ncol="1000000" size="1 1 1 1"/></asset>',
        '<asset><texture name="t" builtin="flat" width="1000000" height="1000000"/></asset>',
        '<size nuser_body="1000000000"/>',
        '<custom><numeric name="n" size="1000000000"/></custom>',
        '<worldbody><replicate count="1000000000"><body/></replicate></worldbody>',
        '<worldbody><composite type="cable"/></worldbody>',
    ],
)
def test_refused_before_mujoco_opens_it(inside: str, tmp_path: Path) -> None:
    (tmp_path / "secret.stl").write_text("solid")
    folder = tmp_path / "home"
    folder.mkdir()
    with pytest.raises(InputError) as caught:
        read_sheet(written(folder, f"<mujoco>\n{inside}</mujoco>"))
    assert str(caught.value).startswith(f"{folder}/model.xml:")
    assert "MuJoCo" not in str(caught.value)


def test_without_mujoco_it_is_said_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "mujoco", None)
    with pytest.raises(InputError, match="got no MuJoCo; install it with"):
        read_sheet(written(tmp_path))


@needs_mujoco
def test_looks_sensors_and_solvers_are_not_named(tmp_path: Path) -> None:
    text = """<mujoco><compiler angle="radian"/><option integrator="implicitfast" cone="elliptic" timestep="0.001"/>
    <default><default class="v"><geom contype="0" conaffinity="0" group="2"/>
    <joint group="1" damping="0.1"/></default></default>
    <statistic center="0 0 1"/><visual><headlight ambient="1 1 1"/></visual>
    <worldbody><light pos="0 0 2"/><body name="a" childclass="v"><joint name="j"/><geom class="v" size="0.1"/>
    <site name="s"/><camera name="c"/></body></worldbody><sensor><jointpos joint="j"/></sensor>
    <actuator><position joint="j" kp="10"/></actuator><keyframe><key name="home" qpos="0.1"/></keyframe></mujoco>"""
    assert "notices" not in read_sheet(written(tmp_path, text))[0]


UNREAD = [
    '<asset><mesh name="m" file="../../secret.stl"/></asset>',
    '<asset><mesh name="m" file="/etc/passwd"/></asset>',
    '<asset><mesh name="m" file="absent.stl"/></asset>',
    '<compiler meshdir="/etc"/><asset><mesh name="m" file="passwd"/></asset>',
    '<compiler meshdir="../meshes"/><asset><mesh name="m" file="secret.stl"/></asset>',
    '<compiler meshdir="sub"/><asset><mesh name="m" file="../../secret.stl"/></asset>',
    '<asset><mesh name="m" file="http://example.com/a.stl"/></asset>',
    '<asset><mesh name="m" file="absent.stl"/><texture name="t" type="2d" file="../t.png"/>'
    '<material name="paint" texture="t"/></asset>',
]


@needs_mujoco
@pytest.mark.parametrize("inside", UNREAD)
def test_a_mesh_that_may_not_be_read_is_a_notice(inside: str, tmp_path: Path) -> None:
    """It is never opened: MuJoCo would refuse what is there."""
    (tmp_path / "secret.stl").write_text("solid")
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes/secret.stl").write_text("solid")
    folder = tmp_path / "home"
    folder.mkdir()
    look = 'material="paint"' if "paint" in inside else ""
    body = (
        '<worldbody><body name="a"><joint name="j"/><inertial pos="0.1 0 0" mass="2" diaginertia="0.1 0.1 0.1"/>'
        f'<geom type="mesh" mesh="m" {look}/></body></worldbody>'
    )
    data, _, _ = read_sheet(written(folder, f"<mujoco>{inside}{body}</mujoco>"))
    assert data["links"][0]["bodies"][0]["mass"] == 2.0
    assert any("left out" in notice for notice in data["notices"])


@needs_mujoco
def test_a_body_that_weighs_what_its_unread_mesh_does_is_an_error(tmp_path: Path) -> None:
    body = '<worldbody><body name="a"><joint/><geom type="mesh" mesh="m"/></body></worldbody>'
    text = f'<mujoco><asset><mesh name="m" file="absent.stl"/></asset>{body}</mujoco>'
    with pytest.raises(InputError, match="body 'a' must be an inertia of its own"):
        read_sheet(written(tmp_path, text))
