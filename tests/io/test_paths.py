"""Values are changed by dotted path; paths that do not exist are told with those that were meant."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from io_cases import SHEET
from tmodes.errors import InputError
from tmodes.io.fields import number_paths
from tmodes.io.paths import parse_assignment, set_paths
from tmodes.io.yaml_file import parse_yaml
from tmodes.robots import load_robot


def sheet() -> dict[str, Any]:
    return parse_yaml(SHEET, "sheet")[0]


@pytest.mark.parametrize(
    ("path", "keys"),
    [
        ("gravity", ["gravity"]),
        ("gear.stiffness", ["gear", "stiffness"]),
        ("link.modes.1.length", ["link", "modes", 1, "length"]),
        ("real.gear.stiffness", ["real", "gear.stiffness"]),
        ("real.payload.mass", ["real", "payload.mass"]),
        ("integration.max_steps", ["integration", "max_steps"]),
    ],
)
def test_value_lands_at_its_path(path: str, keys: list[Any]) -> None:
    before = sheet()
    value: Any = set_paths(before, {path: 7.0})
    for key in keys:
        value = value[key]
    assert value == 7.0
    assert before == sheet()


def test_groups_that_the_sheet_leaves_out_are_made() -> None:
    data = sheet()
    del data["integration"], data["real"]
    changed = set_paths(data, {"integration.step": 1.0, "real.gear.damping": 2.0})
    assert (changed["integration"], changed["real"]) == ({"step": 1.0}, {"gear.damping": 2.0})


def test_each_number_of_the_robot_has_its_path() -> None:
    robot = load_robot("filipovic2010")
    assert tuple(path for path, _ in robot.numbers()) == number_paths()
    for path, value in robot.numbers():
        assert dict(robot.with_({path: 1.25 * value}).numbers())[path] == 1.25 * value


@pytest.mark.parametrize(
    ("path", "meant"),
    [
        ("gear.stifness", "`gear.stiffness`"),
        ("stiffness", "`gear.stiffness`"),
        ("Gear.Damping", "`gear.damping`"),
        ("link.modes.2.length", "`link.modes.1.length`"),
        ("real.gear.stif", "`real.gear.stiffness`"),
        ("", "look the path up"),
        ("gear.stiffness.value", "`gear.stiffness`"),
        ("__class__", "look the path up"),
    ],
)
def test_an_unknown_path_is_reported_with_the_nearest(path: str, meant: str) -> None:
    with pytest.raises(InputError, match="unknown key") as caught:
        set_paths(sheet(), {path: 1.0})
    assert meant in caught.value.hint


@pytest.mark.parametrize("data", [{"link": 3.0}, {"link": {"modes": []}}, {"link": {"modes": 5}}, {"link": None}])
def test_a_path_through_something_else_is_reported(data: dict[str, Any]) -> None:
    with pytest.raises(InputError, match=r"link\.modes\.0\.length: got "):
        set_paths(data, {"link.modes.0.length": 1.0})


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("gear.stiffness=900", 900),
        ("gear.stiffness = 9e2", 900.0),
        ("gear.stiffness=.inf", math.inf),
        ("gear.stiffness=5 kN*m/rad", "5 kN*m/rad"),
        ("contact=false", False),
        ("name='a=b'", "a=b"),
        ('name="7"', "7"),
        ("title=~", None),
        ("gravity=1e400", "1e400"),
        ("name=[1, *a, &b !!x]", "[1, *a, &b !!x]"),
    ],
)
def test_assignment(text: str, value: Any) -> None:
    path, read = parse_assignment(text)
    assert path == text.partition("=")[0].strip()
    assert read == value
    assert type(read) is type(value)


@pytest.mark.parametrize("text", ["", "gear.stiffness", "=3", "gear.stiffness=", "a=" + "9" * 3000])
def test_no_assignment(text: str) -> None:
    with pytest.raises(InputError, match="expected path=value"):
        parse_assignment(text)


@given(st.text())
def test_any_assignment_is_read_or_refused(text: str) -> None:
    try:
        path, _ = parse_assignment(text)
    except InputError as error:
        path = error.hint
    assert path
