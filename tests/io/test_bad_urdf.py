"""Robots that no physics has, and files that no program should believe: each refused for its own reason."""

from __future__ import annotations

from pathlib import Path

import pytest

from patience import bounded
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_files import read_sheet

GOOD = """<?xml version="1.0"?>
<robot name="two">
  <link name="ground"/>
  <link name="upper">
    <inertial>
      <origin xyz="0.2 0 0" rpy="0 0 0"/>
      <mass value="2.0"/>
      <inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <link name="fore">
    <inertial>
      <mass value="1.0"/>
      <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="ground"/>
    <child link="upper"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
  <joint name="elbow" type="revolute">
    <parent link="upper"/>
    <child link="fore"/>
    <origin xyz="0.5 0 0" rpy="0 0 0.1"/>
    <axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="10" velocity="2"/>
    <dynamics damping="0.3" friction="0.1"/>
  </joint>
</robot>
"""

FORE_MASS = '<mass value="1.0"/>'
FORE_INERTIA = '<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>'
EXTRA_JOINT = '<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/></joint>\n</robot>'


MESH = '<link name="m"><visual><mesh filename="package://x/../../../../etc/passwd"/></visual></link>'


def joint(name: str, parent: str, child: str, kind: str = "fixed") -> str:
    return EXTRA_JOINT.format(name=name, kind=kind, parent=parent, child=child)


def said(text: str, folder: Path) -> str:
    path = folder / "bad.urdf"
    path.write_text(text)
    with pytest.raises((InputError, InputErrors)) as caught:
        read_sheet(path)
    return str(caught.value).replace(f"{folder}/", "")


CASES = {
    "negative mass": (
        FORE_MASS,
        '<mass value="-1"/>',
        "bad.urdf:13: link fore: mass must be a mass greater than 0 [kg], got -1",
    ),
    "zero mass of a moving end": (
        FORE_MASS,
        '<mass value="0"/>',
        "bad.urdf:13: link fore: mass must be a mass greater than 0 [kg], got 0 with moments of inertia",
    ),
    "no mass and no inertia": (
        FORE_MASS + "\n      " + FORE_INERTIA,
        '<mass value="0"/>\n<inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/>',
        "bad.urdf:13: link fore: mass must be a mass greater than 0 [kg], got no mass on the moving joint 'elbow'",
    ),
    "triangle inequality": (
        'izz="0.01" ixy="0" ixz="0"',
        'izz="0.05" ixy="0" ixz="0"',
        "principal moments 0.01, 0.01 and 0.05",
    ),
    "indefinite inertia": (
        'izz="0.01" ixy="0"',
        'izz="0.01" ixy="0.03"',
        "bad.urdf:14: link fore: inertia must be moments of a rigid body: none is negative, got principal",
    ),
    "mass nan": (
        FORE_MASS,
        '<mass value="nan"/>',
        "bad.urdf:13: link fore: mass must be a finite number of at most 1e+12, got 'nan' (not a number)",
    ),
    "mass 1e400": (
        FORE_MASS,
        '<mass value="1e400"/>',
        "bad.urdf:13: link fore: mass must be a finite number of at most 1e+12, got '1e400', which no double can hold",
    ),
    "mass 1e300": (FORE_MASS, '<mass value="1e300"/>', "bad.urdf:13: link fore: mass"),
    "mass inf": (FORE_MASS, '<mass value="inf"/>', "bad.urdf:13: link fore: mass"),
    "mass heavy": (
        FORE_MASS,
        '<mass value="heavy"/>',
        "bad.urdf:13: link fore: mass must be a finite number of at most 1e+12, got the text 'heavy'",
    ),
    "decimal comma": (FORE_MASS, '<mass value="1,5"/>', "write a decimal point instead of the comma: 1.5"),
    "mass as text": (
        FORE_MASS,
        "<mass>1.0</mass>",
        'bad.urdf:13: link fore: mass must be value="a number", got <mass> without the attribute `value`',
    ),
    "no mass element": (FORE_MASS, "", "link fore: mass must be a mass [kg], got <inertial> without <mass>"),
    "no inertia element": (
        FORE_INERTIA,
        "",
        "link fore: inertia must be <inertia ixx=... izz=...>, got <inertial> without <inertia>",
    ),
    "a moment missing": ('izz="0.01" ixy="0"', 'ixy="0"', "link fore: inertia izz"),
    "two masses": (FORE_MASS, FORE_MASS * 2, "a second <mass> (first in line 13)"),
    "duplicate link": (
        '<link name="fore">',
        '<link name="upper">',
        "bad.urdf:11: link upper must be one link of each name, got a second link of this name (first in line 4)",
    ),
    "duplicate joint": (
        'name="elbow"',
        'name="shoulder"',
        "bad.urdf:23: joint shoulder must be one joint of each name, got a second joint of this name (first in line",
    ),
    "nameless link": (
        '<link name="fore">',
        "<link>",
        'bad.urdf:11: a link\'s name must be name="...", got <link> without the attribute `name`',
    ),
    "disconnected link": (
        "</robot>",
        '<link name="lost"/>\n</robot>',
        "bad.urdf:31: the tree of links must be one tree with one root link, got links that hang together",
    ),
    "unknown parent": (
        '<parent link="upper"/>',
        '<parent link="uper"/>',
        "bad.urdf:23: joint elbow: parent: unknown link 'uper'",
    ),
    "two parents": (
        "</robot>",
        joint("second", "ground", "fore"),
        "bad.urdf:31: link fore must be carried by one joint, got two parents, 'upper' by joint elbow and 'ground'",
    ),
    "cycle of all": (
        "</robot>",
        joint("back", "fore", "ground"),
        "the tree of links must be a tree with one root link, got a cycle",
    ),
    "cycle apart from the root": (
        "</robot>",
        '<link name="a"/><link name="b"/>' + joint("ab", "a", "b").removesuffix("</robot>") + joint("ba", "b", "a"),
        "a cycle apart from the root, among 'b', 'a'",
    ),
    "self-loop": (
        '<child link="fore"/>',
        '<child link="upper"/>',
        "joint elbow must be a joint between two links, got 'upper' on itself",
    ),
    "zero axis": (
        '<axis xyz="0 1 0"/>',
        '<axis xyz="0 0 0"/>',
        "bad.urdf:27: joint elbow: axis must be a direction, got a zero axis",
    ),
    "short axis": (
        '<axis xyz="0 1 0"/>',
        '<axis xyz="0 1"/>',
        'bad.urdf:27: joint elbow: axis must be xyz="x y z", got 2 words',
    ),
    "axis nan": (
        '<axis xyz="0 1 0"/>',
        '<axis xyz="0 nan 0"/>',
        "bad.urdf:27: joint elbow: axis must be a finite number of at most 1e+12, got 'nan'",
    ),
    "lower above upper": (
        'lower="-2" upper="2"',
        'lower="2" upper="-2"',
        "bad.urdf:28: joint elbow: limit must be a range from lower to upper, got lower 2 above upper -2",
    ),
    "negative effort": (
        'upper="2" effort="10"',
        'upper="2" effort="-10"',
        "joint elbow: effort must be a limit not less than 0, got -10",
    ),
    "negative dry friction": ('friction="0.1"', 'friction="-0.3"', "joint elbow: friction must be"),
    "floating joint": (
        'name="elbow" type="revolute"',
        'name="elbow" type="floating"',
        "got a floating joint (a free-flying base)",
    ),
    "planar joint": ('name="elbow" type="revolute"', 'name="elbow" type="planar"', "got a planar joint"),
    "misspelt type": ('name="elbow" type="revolute"', 'name="elbow" type="revolut"', "Did you mean `revolute`?"),
    "no child": (
        '<child link="fore"/>',
        "",
        "joint elbow must be a joint with a parent and a child link, got no <child>",
    ),
    "misspelt link": (
        '<link name="ground"/>',
        '<lnk name="ground"/>',
        "bad.urdf:3: robot: unknown element <lnk>",
    ),
    "misspelt inertial": ("<inertial>\n      <mass", "<inertail>\n      <mass", "broken XML"),
    "misspelt limit": (
        '<limit lower="-2"',
        '<limits lower="-2"',
        "bad.urdf:28: joint elbow: unknown element <limits>. Did you mean <limit>",
    ),
    "misspelt attribute": ('lower="-2"', 'lowr="-2"', "Did you mean `lower`?"),
    "misplaced mass": ('<link name="fore">', '<link name="fore"><mass value="3"/>', "put <mass> inside <inertial>"),
    "strange child of inertial": (
        FORE_MASS,
        FORE_MASS + '<weight value="3"/>',
        "link fore: inertial: unknown element <weight>",
    ),
    "quaternion in origin": (
        'xyz="0.5 0 0" rpy="0 0 0.1"',
        'xyz="0.5 0 0" quat="1 0 0 0"',
        "joint elbow: origin must be xyz and rpy, got the attribute 'quat'",
    ),
    "truncated": (
        GOOD[700:],
        "",
        "bad.urdf:25: the file must be well-formed XML, got broken XML (unclosed token inside <joint> of line 23)",
    ),
    "mimic of nothing": (
        "<dynamics",
        '<mimic joint="sholder"/><dynamics',
        "Did you mean `shoulder`?",
    ),
    "mimic of itself": ("<dynamics", '<mimic joint="elbow"/><dynamics', "'elbow', which mimics 'elbow' itself"),
    "xacro in a urdf": ("</robot>", '<xacro:if value="1"/></robot>', "save the file with the ending .xacro"),
    "another root": ("robot", "model", "the root element must be <robot> of a URDF or xacro, got <model>"),
}


@pytest.mark.parametrize(("old", "new", "words"), CASES.values(), ids=CASES)
def test_refused_for_its_own_reason(old: str, new: str, words: str, tmp_path: Path) -> None:
    assert old in GOOD
    message = said(GOOD.replace(old, new), tmp_path)
    assert words in message
    assert message.startswith("bad.urdf:")
    assert all(any(word in line for word in ("got ", "missing", "unknown")) for line in message.splitlines())


def test_the_good_one_is_read(tmp_path: Path) -> None:
    path = tmp_path / "good.urdf"
    path.write_text(GOOD)
    data, positions, source = read_sheet(path)
    assert source == str(path)
    fixed, shoulder, elbow = data["joints"]
    assert fixed == {"name": "base_to_ground", "type": "fixed", "parent": "base", "child": "ground"}
    assert shoulder["limits"] == {"lower": -1.0, "upper": 1.0, "speed": 2.0, "effort": 10.0}
    assert elbow["origin"] == {"position": [0.5, 0.0, 0.0], "rpy": [0.0, 0.0, 0.1]}
    assert elbow["friction"] == {"viscous": 0.3, "coulomb": 0.1}
    assert (elbow["axis"], elbow["from"]) == ([0.0, 1.0, 0.0], "frame")
    assert data["links"][0]["bodies"][0]["center"] == [0.2, 0.0, 0.0]
    assert (positions["joints.2"], positions["links.1"]) == (23, 11)


def test_all_that_is_wrong_is_reported_at_once(tmp_path: Path) -> None:
    text = GOOD.replace(FORE_MASS, '<mass value="-1"/>').replace('<axis xyz="0 1 0"/>', '<axis xyz="0 0 0"/>')
    text = text.replace('<mass value="2.0"/>', '<mass value="nan"/>').replace('type="revolute"', 'type="ball"', 1)
    path = tmp_path / "bad.urdf"
    path.write_text(text)
    with pytest.raises(InputErrors) as caught:
        read_sheet(path)
    assert [error.which for error in caught.value.errors] == [
        "link upper: mass",
        "link fore: mass",
        "joint shoulder: type",
    ]


def test_others_tags_are_passed_over_and_infinite_limits_are_none(tmp_path: Path) -> None:
    extra = '<gazebo reference="fore"><mu1>0.2</mu1></gazebo><transmission name="t"/><ros2_control name="c"/></robot>'
    text = GOOD.replace("</robot>", extra).replace('lower="-2" upper="2"', 'lower="-1e+16" upper="inf"')
    path = tmp_path / "good.urdf"
    path.write_text(text.replace('velocity="2"/>\n    <dyn', 'velocity="0" gear_velocity="10"/>\n    <dyn'))
    data = read_sheet(path)[0]
    assert data["joints"][2]["limits"] == {"speed": 0.0, "effort": 10.0}
    assert any("of 0 in <limit>" in one and "elbow" in one for one in data["notices"])
    assert any("gear_velocity" in one and "elbow" in one for one in data["notices"])
    assert not any("mu1" in one for one in data["notices"])


def test_a_massless_frame_is_fine_between_joints_and_on_a_fixed_one(tmp_path: Path) -> None:
    frame = '<link name="tool"/>' + joint("flange", "fore", "tool")
    text = GOOD.replace("</robot>", frame).replace(
        GOOD[GOOD.index('<link name="upper">') : GOOD.index('<link name="fore">')], '<link name="upper"/>'
    )
    path = tmp_path / "good.urdf"
    path.write_text(text)
    data = read_sheet(path)[0]
    assert [link["name"] for link in data["links"]] == ["fore"]
    assert data["joints"][-1]["child"] == "tool"


def test_a_zero_mass_that_is_said_is_refused_also_in_the_middle(tmp_path: Path) -> None:
    zero = '<mass value="0"/>\n      <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/>'
    start, end = GOOD.index('<mass value="2.0"/>'), GOOD.index("</inertial>")
    message = said(GOOD[:start] + zero + GOOD[end:], tmp_path)
    assert message.startswith("bad.urdf:7: link upper: mass must be a mass greater than 0 [kg], got 0 on a moving link")


def test_a_negative_damping_is_read_and_reported(tmp_path: Path) -> None:
    from tmodes.io.sheet_plausible import implausible_numbers
    from tmodes.robots.load import load
    from tmodes.sheet import Robot

    path = tmp_path / "good.urdf"
    path.write_text(GOOD.replace('damping="0.3"', 'damping="-0.3"'))
    arm = load(path)
    assert isinstance(arm, Robot)
    info = "\n".join(implausible_numbers(arm))
    assert "joints.elbow.friction.viscous = -0.3 N*m*s/rad is negative: it feeds energy" in info


def test_coupled_joints_are_held_where_their_equation_holds(tmp_path: Path) -> None:
    path = tmp_path / "gripper.urdf"
    text = GOOD.replace('lower="-1" upper="1"', 'lower="0.2" upper="1"')
    path.write_text(text.replace("<dynamics", '<mimic joint="shoulder" multiplier="-2" offset="0.1"/><dynamics'))
    data = read_sheet(path)[0]
    assert [joint.get("locked_at") for joint in data["joints"]] == [None, None, pytest.approx(-2 * 0.2 + 0.1)]
    assert "elbow at -0.3 (follows shoulder)" in data["assumed"]


def test_a_mesh_that_may_not_be_read_is_a_notice(tmp_path: Path) -> None:
    path = tmp_path / "good.urdf"
    path.write_text(GOOD.replace("</robot>", MESH + joint("j", "fore", "m")))
    data = read_sheet(path)[0]
    (notice,) = data["notices"]
    assert "m (" in notice
    assert "which climbs" in notice


DIALECTS = {
    "transmission": (
        '<transmission name="t"><joint name="elbow"/><actuator name="m"><mechanicalReduction>50</mechanicalReduction>'
        '<drake:rotor_inertia value="2e-5"/></actuator></transmission>',
        {"motor": {"inertia": 2e-5, "side": "motor", "ratio": 50.0}},
    ),
    "drake": (
        '<transmission name="t"><joint name="elbow"/><actuator name="m"><drake:gear_ratio value="-20"/>'
        '<drake:rotor_inertia value="2e-5"/></actuator></transmission>',
        {"motor": {"inertia": 2e-5, "side": "motor", "ratio": -20.0}},
    ),
    "gazebo": (
        '<gazebo reference="elbow"><springStiffness>12.5</springStiffness>'
        "<springReference>0.3</springReference></gazebo>",
        {"state": "free", "spring": {"stiffness": 12.5, "rest": 0.3}},
    ),
}


@pytest.mark.parametrize("dialect", DIALECTS)
def test_rotors_and_springs_of_a_joint(dialect: str, tmp_path: Path) -> None:
    text, wanted = DIALECTS[dialect]
    path = tmp_path / "good.urdf"
    path.write_text(GOOD.replace("</robot>", f"{text}</robot>"))
    data, positions, source = read_sheet(path)
    elbow = next(joint for joint in data["joints"] if joint["name"] == "elbow")
    assert {key: elbow.get(key) for key in wanted} == wanted
    assert "notices" not in data
    assert sheet_from_data(data, positions, source).joints


def test_rotor_and_spring_in_dynamics(tmp_path: Path) -> None:
    path = tmp_path / "good.urdf"
    path.write_text(GOOD.replace("<dynamics", '<dynamics armature="0.02" stiffness="30" spring_reference="-0.1"'))
    elbow = next(joint for joint in read_sheet(path)[0]["joints"] if joint["name"] == "elbow")
    assert elbow["motor"] == {"inertia": 0.02, "side": "joint"}
    assert elbow["spring"] == {"stiffness": 30.0, "rest": -0.1}
    assert "state" not in elbow


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('<gazebo reference="fore"><turnGravityOff>true</turnGravityOff></gazebo>', ["turnGravityOff", "gazebo fore"]),
        ('<gazebo><plugin name="swim" filename="libhydro.so"/></gazebo>', ["plugin", "swim"]),
        ('<loop_joint name="closing" type="revolute"/>', ["loop_joint"]),
        (
            '<transmission name="t"><joint name="elbow"/><actuator name="m"><mechanicalReduction>50'
            "</mechanicalReduction></actuator></transmission>",
            ["mechanicalReduction", "elbow"],
        ),
    ],
)
def test_what_changes_the_motion_and_is_not_read_is_named(text: str, words: list[str], tmp_path: Path) -> None:
    path = tmp_path / "good.urdf"
    path.write_text(GOOD.replace("</robot>", f"{text}</robot>"))
    (notice,) = read_sheet(path)[0]["notices"]
    assert all(word in notice for word in words), notice


def test_a_link_that_is_called_as_the_ground_is_renamed_and_reported(tmp_path: Path) -> None:
    path = tmp_path / "base.urdf"
    path.write_text(GOOD.replace('"fore"', '"base"'))
    data = read_sheet(path)[0]
    assert data["joints"][2]["child"] == data["links"][1]["name"] == "base_frame"
    assert "called base_frame" in data["assumed"]
    path.write_text(GOOD.replace('"ground"', '"base"'))
    data = read_sheet(path)[0]
    assert (data["joints"][0]["name"], data["joints"][0]["parent"]) == ("shoulder", "base")


def test_a_chain_of_3000_links_takes_bounded_time(tmp_path: Path) -> None:
    unit = '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    link = f'<link name="l{{0}}"><inertial><mass value="1"/>{unit}</inertial></link>'
    bend = '<joint name="j{0}" type="continuous"><parent link="l{1}"/><child link="l{0}"/><axis xyz="0 0 1"/></joint>'
    links = "".join(link.format(i) for i in range(3000))
    path = tmp_path / "long.urdf"
    path.write_text(f'<robot name="r">{links}{"".join(bend.format(i, i - 1) for i in range(1, 3000))}</robot>')
    with bounded(5.0):
        data = read_sheet(path)[0]
    assert len(data["joints"]) == 3000

    with bounded(10.0), pytest.raises(InputErrors, match="500"):
        sheet_from_data(data)


def test_a_number_of_another_language(tmp_path: Path) -> None:
    info = said(GOOD.replace(FORE_MASS, '<mass value="1_0"/>'), tmp_path)
    assert "got '1_0', not a number as URDF writes it" in info
