"""From a name or a file to a checked robot, and the schema of the data sheet."""

from __future__ import annotations

from pathlib import Path

import pytest

from sheet.cases import sheet
from tmodes.errors import InputError, InputErrors
from tmodes.io.forms import json_schema
from tmodes.io.sheet_write import robot_to_yaml
from tmodes.robots import text
from tmodes.robots.load import load, sheet_names, sheet_text
from tmodes.sheet import Robot


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "two.yaml"
    path.write_text(robot_to_yaml(Robot.from_data(sheet())), encoding="utf-8")
    return path


def test_an_arm_from_its_file(file: Path) -> None:
    assert load(file) == Robot.from_data(sheet())
    assert load(str(file), {"joints.shoulder.gear.damping": 7}).joints[0].gear.damping == 7  # pyright: ignore


def test_the_robot_of_the_paper() -> None:
    found = load("filipovic2010", {"gear.stiffness": 900.0})
    assert isinstance(found, Robot)
    assert found.imported == "filipovic2010"
    assert found.joints[0].gear.stiffness == (900.0,)  # pyright: ignore
    assert "filipovic2010" in sheet_names()


def test_an_unknown_name() -> None:
    with pytest.raises(InputError, match="Did you mean `filipovic2010`"):
        load("filipovic2011")


def test_another_kind(tmp_path: Path) -> None:
    path = tmp_path / "x.yaml"
    path.write_text("format: 1\nkind: car\n")
    with pytest.raises(InputError, match=r"x\.yaml:2: kind must be arm, got 'car'"):
        load(path)


def test_a_wrong_change_has_no_line_and_a_wrong_file_has_one(file: Path) -> None:
    with pytest.raises(InputErrors) as caught:
        load(file, {"links.upper.beam.length": -1})
    assert caught.value.errors[0].where == str(file)
    file.write_text(file.read_text().replace("mass: 1.0 ", "mass: -1.0"))
    with pytest.raises(InputErrors) as caught:
        load(file)
    line = next(k for k, text in enumerate(file.read_text().splitlines(), 1) if "mass: -1.0" in text)
    assert caught.value.errors[0].where == f"{file}:{line}"


def test_a_change_stands_on_the_changes_before_it() -> None:
    """The next change may name what only the new type has, and none of them has a line of the file."""
    changes = {"drives.0.signal.type": "trapezoid", "drives.0.signal.ramp_fraction": 0.25}
    plain, changed = load("spong1987"), load("spong1987", changes)
    assert isinstance(plain, Robot)
    assert changed == plain.with_(changes) != plain
    with pytest.raises(InputErrors) as caught:
        load("spong1987", {**changes, "drives.0.signal.ramp_fraction": -1})
    assert [(error.which, error.where) for error in caught.value.errors] == [
        ("drives.0.signal.ramp_fraction", "spong1987.yaml")
    ]
    with pytest.raises(InputError, match=r"unknown key `drives\.0\.signal\.ramp_fraction`, expected one of type, "):
        load("spong1987", dict(reversed(changes.items())))


@pytest.mark.parametrize("content", ["kind: dh\nrows: []\n", "urdf: ur5.urdf\n"])
def test_a_table_and_an_elasticity_file_want_the_ending_of_a_robot(tmp_path: Path, content: str) -> None:
    path = tmp_path / "x.txt"
    path.write_text(content)
    with pytest.raises(InputError, match=r"a file with the ending '\.txt'"):
        load(path)


def test_the_text_of_a_sheet() -> None:
    assert sheet_text("filipovic2010") == text("filipovic2010")
    assert "\nkind: arm\n" in sheet_text("spong1987")
    with pytest.raises(InputError, match="Did you mean `spong1987`"):
        sheet_text("spong1988")


@pytest.mark.parametrize("content", [b"", b"\x00\xff\xfe", b"[1, 2]", b"b: *unknown", b"{" * 5000, b"a: 1\na: 2"])
def test_files_that_are_none(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "bad.yaml"
    path.write_bytes(content)
    with pytest.raises(InputError, match=r"bad\.yaml"):
        load(path)


def test_a_folder(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="a directory"):
        load(tmp_path)


def test_the_schema_knows_units_and_shorthands() -> None:
    schema = json_schema()
    assert schema["properties"]["gravity"]["unit"] == "m/s^2"
    assert {"type": "number"} in schema["properties"]["gravity"]["anyOf"]
    gear = schema["$defs"]["GearSheet"]["properties"]
    assert {"type": "number"} in gear["stiffness"]["anyOf"]
    assert any(choice.get("type") == "string" for choice in gear["damping"]["anyOf"])
    assert "from" in schema["$defs"]["JointSheet"]["properties"]
    assert "smallest" not in str(schema)
