"""Files of other formats, and sheets that do not say what they are of: what was given, and what to do."""

from __future__ import annotations

from pathlib import Path

import pytest

from tmodes.errors import InputError, InputErrors
from tmodes.robots.load import load

SDF = '<sdf version="1.9"><model name="m"><link name="a"/></model></sdf>'
MJCF = "<mujoco><worldbody/></mujoco>"
CASES = {
    "sdf": ({"m.sdf": SDF}, "the root element", ["<sdf>", "Gazebo", "kind: arm"]),
    "sdf as xml": ({"m.xml": SDF}, "the root element", ["<sdf>", "Gazebo"]),
    "sdf under urdf": ({"m.yaml": "urdf: m.sdf\n", "m.sdf": SDF}, "the root element", ["<sdf>", "Gazebo"]),
    "mjcf as urdf": ({"m.urdf": MJCF}, "the root element", ["MJCF", ".xml"]),
    "mjcf under urdf": ({"m.yaml": "urdf: m.xml\n", "m.xml": MJCF}, "the root element", ["MJCF", "by itself"]),
    "mjcf by its name": ({"m.yaml": "mjcf: m.xml\njoints: {}\n"}, "mjcf", ["urdf: FILE"]),
    "elasticity of nothing": ({"m.yaml": "kind: elasticity\njoints: {}\n"}, "urdf", ["urdf: robot.urdf"]),
    "rows without kind": ({"m.yaml": "rows: []\nname: x\n"}, "rows", ["kind: dh"]),
    "no kind": ({"m.yaml": "name: x\ndrives: []\ngravity: 0\n"}, "kind", ["`name`, `drives`", "kind: arm"]),
    "nothing known": ({"m.yaml": "foo: 1\n"}, "kind", ["`foo`", "kind: arm"]),
    "joints without kind": ({"m.yaml": "format: 1\nname: x\njoints: []\n"}, "kind", ["arm"]),
}


@pytest.mark.parametrize("case", CASES)
def test_what_was_given_and_what_to_do(case: str, tmp_path: Path) -> None:
    files, which, words = CASES[case]
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    with pytest.raises((InputError, InputErrors)) as caught:
        load(tmp_path / next(iter(files)))
    errors = getattr(caught.value, "errors", [caught.value])
    (error,) = [one for one in errors if one.which != "joints"]
    assert error.which == which
    assert all(word in str(error) for word in words), str(error)
