"""Robots of one's own, sent to the studio: a URDF with its elasticity file, and errors at file, line and field."""

from __future__ import annotations

import base64
from typing import Any

import pytest

URDF = """<robot name="two">
  <link name="base"/>
  <link name="arm">
    <inertial><origin xyz="0.25 0 0"/><mass value="2"/>
      <inertia ixx="0.01" iyy="0.05" izz="0.05" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="hinge" type="revolute">
    <parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
</robot>
"""
ELASTICITY = """format: 1
urdf: two.urdf
name: mine
joints:
  hinge:
    motor: {inertia: 0.01, side: joint}
    gear: {stiffness: 900.0, damping: 1.0}
drives:
  - joint: hinge
    command: position
    signal: {type: quintic, start: 0.0, end: 0.5, duration: 0.2}
    controller: {type: pd, position_gain: 100.0, velocity_gain: 10.0}
integration: {duration: 0.3, output_step: 0.01}
"""


def sent(studio: Any, code: int = 200, **files: str) -> Any:
    content = {name.replace("__", "."): base64.b64encode(text.encode()).decode() for name, text in files.items()}
    info = [{"name": name, "content": text} for name, text in content.items()]
    return studio.post("/api/upload", json={"files": info}, code=code)


def test_a_urdf_with_its_elasticity_file_runs(studio):
    """The elasticity file is meant, whichever comes first; what comes back is a sheet like any other."""
    info = sent(studio, two__urdf=URDF, two__yaml=ELASTICITY)
    assert info["name"] == "mine"
    assert info["sheet"]["joints"][0]["gear"]["stiffness"] == [900.0]
    assert info["units"]["joints.0.gear.stiffness.0"] == "N*m/rad"
    assert studio.ended(studio.begin(info["sheet"]))["state"] == "done"


def test_a_urdf_alone(studio):
    info = sent(studio, two__urdf=URDF)
    assert [joint["name"] for joint in info["sheet"]["joints"]] == ["hinge"]


@pytest.mark.parametrize("name", ["two (1).urdf", "(2) two's.urdf"])
def test_names_as_browsers_give_them(studio, name):
    files: dict[str, Any] = {name: URDF, "two.yaml": ELASTICITY.replace("two.urdf", f'"{name}"')}
    info = sent(studio, **files)
    assert info["name"] == "mine"
    (studio.folder / name).write_text(URDF, encoding="utf-8")
    assert name in studio.get("/api/studies")["studies"]


def test_a_sheet_of_the_paper(studio, sheet):
    text = studio.post("/api/yaml", json={"sheet": sheet})["yaml"]
    assert sent(studio, my__yaml=text)["sheet"] == sheet


@pytest.mark.parametrize(
    ("files", "where", "path"),
    [
        ({"two__urdf": URDF.replace('value="2"', 'value="-2"')}, "two.urdf:4", "mass"),
        ({"two__urdf": URDF, "two__yaml": ELASTICITY.replace("900.0", "-900.0")}, "two.yaml:7", "joints.hinge.gear"),
        ({"two__urdf": URDF, "two__yaml": ELASTICITY.replace("hinge:", "hnge:")}, "two.yaml:5", "joints.hnge"),
        ({"two__yaml": ELASTICITY}, "two.yaml:2", "urdf"),
        ({"two__urdf": URDF.replace("</robot>", "")}, "two.urdf:12", "the file"),
    ],
    ids=["mass", "stiffness", "name", "no urdf", "cut off"],
)  # fmt: skip
def test_errors_tell_file_line_and_field(studio, files, where, path):
    error = sent(studio, code=422, **files)["errors"][0]
    assert error["where"] == where, error
    assert path in error["path"], error
    assert error["hint"]


def test_nothing_of_this_machine_is_reported(studio, tmp_path):
    """Where the files lay for a moment is nobody's business."""
    for files in (
        {"two__yaml": ELASTICITY},
        {"two__urdf": "<robot"},
        {"two__yaml": ELASTICITY.replace("two.urdf", "../x.urdf")},
    ):
        assert "tmodes-upload" not in str(sent(studio, code=422, **files))


@pytest.mark.parametrize(
    "mesh", ["../../secret.stl", "/etc/passwd", "http://127.0.0.1/x.stl", "package://x/../../y.stl"]
)
def test_meshes_outside_are_notices(studio, mesh):
    """They change no motion, and are never opened; where the files lay for a moment is not told."""
    body = f'<visual><geometry><mesh filename="{mesh}"/></geometry></visual></link>\n  <joint'
    info = sent(studio, two__urdf=URDF.replace("</link>\n  <joint", body))
    (notice,) = info["sheet"]["notices"]
    assert mesh.removeprefix("http:") in notice
    assert "tmodes-upload" not in str(info)
