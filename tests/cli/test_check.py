"""``tmodes check`` and ``tmodes schema`` of arms."""

from __future__ import annotations

import json

from command import tmodes


def test_right():
    done = tmodes("check", "spong1987")
    assert "spong1987: valid" in done.stdout
    info = json.loads(tmodes("check", "spong1987", "--json").stdout)
    assert info["ok"] is True
    assert info["kind"] == "arm"
    assert info["coordinates"] == ["joint.motor", "joint"]
    assert info["drives"] == ["joint"]


def test_all_that_is_wrong_in_one_go():
    wrong = ["--set", "links.link.bodies.bob.mass=-1", "--set", "joints.joint.axis=[0,0,0]"]
    done = tmodes("check", "spong1987", *wrong, "--json", code=2)
    info = json.loads(done.stdout)
    assert info["ok"] is False
    assert len(info["errors"]) == 2
    assert all(error["hint"] for error in info["errors"])


def test_a_doubtful_unit():
    done = tmodes("check", "quanser_2dsfl", "--set", "links.strip.beam.length=202")
    assert "warning" in done.stdout


def test_schema():
    schema = json.loads(tmodes("schema", "--arm").stdout)
    assert {"joints", "links", "drives"} <= set(schema["properties"])
    assert "link" in json.loads(tmodes("schema").stdout)["properties"]


URDF = """<robot name="one"><link name="ground"/>
<link name="arm"><inertial><origin xyz="0.2 0 0"/><mass value="1"/>
<inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="j" type="revolute"><parent link="ground"/><child link="arm"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="10" velocity="2"/></joint></robot>"""


def test_a_file_in_another_folder_is_let_in_by_its_flags(tmp_path):
    """One URDF outside of the sheet's folder: refused with the flags that allow it, which every command knows."""
    (tmp_path / "models").mkdir()
    (tmp_path / "mine").mkdir()
    (tmp_path / "models" / "robot.urdf").write_text(URDF, encoding="utf-8")
    sheet = tmp_path / "mine" / "sheet.yaml"
    sheet.write_text("urdf: ../models/robot.urdf\n", encoding="utf-8")
    for command in ("check", "static"):
        info = tmodes(command, sheet, code=2).stderr
        assert "--root DIR" in info
        assert "--trust-paths" in info
    allowed = ["--root", tmp_path / "models"]
    for command, flags in (
        ("check", allowed),
        ("describe", allowed),
        ("static", ["--trust-paths"]),
        ("modes", allowed),
    ):
        tmodes(command, sheet, *flags)
    assert "--trust-paths" in tmodes("hierarchy", "--help").stdout


def test_a_list_on_the_command_line():
    info = tmodes("check", "spong1987", "--set", "gravity=[0, 0, -40]")
    assert "gravity = 40 m/s^2" in info.stdout


def test_parameters_without_end_are_listed() -> None:
    """A stiffness of infinity has no number in JSON."""
    listed = {one["path"]: one for one in json.loads(tmodes("parameters", "flexarm1990", "--json").stdout)}
    assert None in {one["value"] for one in listed.values()}
    assert listed["gravity.0"]["unit"] == "m/s^2"


def test_a_study_is_no_robot(tmp_path):
    (tmp_path / "one.yaml").write_text("format: 1\nkind: study\nname: one\nrobot: spong1987\n", encoding="utf-8")
    ended = tmodes("check", "one.yaml", cwd=tmp_path, code=2)
    assert "kind must be arm, got 'study'; a study is checked and run by `tmodes study FILE`" in ended.stderr
