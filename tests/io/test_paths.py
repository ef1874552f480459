# pyright: reportAttributeAccessIssue=false, reportOptionalMemberAccess=false
"""Values are changed by dotted path; paths that do not exist are reported with those that were meant."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import tmodes
from io_cases import SHEET, number_paths, value_of
from tmodes.errors import InputError, InputErrors
from tmodes.io.assignment import parse_assignment
from tmodes.io.forms import ROBOT
from tmodes.io.sheet_check import sheet_from_data as robot_from_data
from tmodes.io.sheet_fields import keys as field_keys
from tmodes.io.sheet_paths import changed_places
from tmodes.io.yaml_file import parse_yaml
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation.vary.values import changed_sheet


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
    value: Any = changed_places(before, {path: 7.0})[0]
    for key in keys:
        value = value[key]
    assert value == 7.0
    assert before == sheet()


def test_groups_that_the_sheet_leaves_out_are_made() -> None:
    data = sheet()
    del data["integration"], data["real"]
    changed = changed_places(data, {"integration.step": 1.0, "real.gear.damping": 2.0})[0]
    assert (changed["integration"], changed["real"]) == ({"step": 1.0}, {"gear.damping": 2.0})


@pytest.mark.parametrize(
    "path", [path for path in number_paths() if path.split(".")[0] not in ("format", "integration")]
)
def test_each_number_keeps_its_path_in_the_robot(path: str) -> None:
    """``with_`` of a robot that was imported takes the paths of its own format."""
    robot = load("filipovic2010")
    value = value_of(robot, path)
    if isinstance(value, (int, float)):
        larger = value + 1 if isinstance(value, int) else 1.25 * value or 0.25
        assert value_of(robot.with_({path: larger}), path) == larger


ALIKE = {
    "gear.stiffness": ("joints.joint.gear.stiffness", 900.0),
    "motor.friction": ("joints.joint.motor.friction.viscous", 0.3),
    "payload.mass": ("links.link.bodies.payload.mass", 0.7),
    "link.modes.0.damping_time": ("links.link.beam.modes.0.damping_time", 0.01),
    "environment.stiffness": ("contact.stiffness", 50.0),
    "controller.position_gain": ("drives.0.controller.position_gain", 9.0),
    "reference.end": ("drives.0.signal.end", 0.5),
    "reading": ("equations", "printed"),
}
"""Paths of the 2010 sheet, those of the same values in its robot, and another value."""


@pytest.mark.parametrize("own", ALIKE)
def test_paths_of_the_robot_mean_the_same_as_those_of_its_sheet(own: str) -> None:
    """As changes of a file (`--set`), of a robot (`with_`), of the cases of a study, and as factors."""
    general, value = ALIKE[own]
    robot = load("filipovic2010")
    wanted = robot.with_({own: value})
    assert wanted != robot
    assert (
        robot.with_({general: value}) == load(robot.name, {own: value}) == load(robot.name, {general: value}) == wanted
    )
    assert changed_sheet(robot, {general: value}, 0) == changed_sheet(robot, {own: value}, 0) == wanted.pair().real
    if own not in ("reading", "reference.end"):
        factors = [load(robot.name, {f"real.{path}": 0.5}) for path in (own, general)]
        assert factors[0] == factors[1] == robot.with_({f"real.{general}": 0.5})


def test_the_environment_stays_at_the_undeformed_tip() -> None:
    robot = load("filipovic2010")
    longer = robot.with_({"link.modes.0.length": 0.8})
    assert longer.contact is not None
    assert longer.contact.shape.radius == pytest.approx(1.1, rel=1e-15)
    assert load("filipovic2010", {"real.link.modes.0.length": 1.5}).pair().real.contact.shape.radius == pytest.approx(
        1.2
    )


def test_the_contact_is_switched_off_and_on() -> None:
    robot = load("filipovic2010", {"contact": False})
    assert robot.contact is None
    assert robot.with_({"contact": True}) == load("filipovic2010").with_({"contact": True})
    stiffer = robot.with_({"environment.stiffness": 5.0, "contact": True})
    assert stiffer.contact is not None
    assert stiffer.contact.stiffness == 5.0


@pytest.mark.parametrize(
    ("path", "meant"),
    [
        ("gear.stifness", "`gear.stiffness`"),
        ("Gear.Damping", "`gear.damping`"),
        ("link.modes.2.length", "expected one of 0, 1; give the name of an item, or its number from 0"),
        ("real.gear.stif", "`real.gear.stiffness`"),
        ("", "the path of a value of the data sheet"),
        ("gear.stiffness.value", "no key inside `gear.stiffness`; leave out what follows it"),
        ("__class__", "choose one of these keys"),
    ],
)
def test_an_unknown_path_is_reported_with_the_nearest(path: str, meant: str) -> None:
    with pytest.raises((InputError, InputErrors), match="unknown key") as caught:
        robot_from_data(changed_places(sheet(), {path: 1.0})[0])
    assert meant in str(caught.value)


@pytest.mark.parametrize(("path", "meant"), [("gear.stifness", "gear.stiffness"), ("stifness", "stiffness")])
def test_a_misspelt_ending_is_reported_with_the_nearest_ending(path: str, meant: str) -> None:
    with pytest.raises(InputError) as caught:
        load("spong1987").with_({path: 1.0})
    assert caught.value.hint == f"did you mean `{meant}`?"


def test_of_many_keys_the_nearest_are_named_and_where_the_others_are() -> None:
    known = field_keys(ROBOT.root)
    with pytest.raises(InputError) as caught:
        changed_places({"format": 1, "kind": "arm"}, {"qqintegrationqq": 1.0})
    listed = caught.value.expected.removeprefix("one of ").split(", ")
    assert "integration" in listed
    assert f"{len(known) - 20} more: see `tmodes schema --arm`" in listed


@pytest.mark.parametrize("data", [{"link": 3.0}, {"link": {"modes": []}}, {"link": {"modes": 5}}, {"link": None}])
def test_a_path_through_something_else_is_reported(data: dict[str, Any]) -> None:
    with pytest.raises(InputError, match=r"link\.modes\.0\.length"):
        changed_places(data, {"link.modes.0.length": 1.0})


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
        ("s={type: step, end: 45 deg, at: [1, 2 m]}", {"type": "step", "end": "45 deg", "at": [1, "2 m"]}),
        ("b=[{mass: 1}, {mass: 2}]", [{"mass": 1}, {"mass": 2}]),
    ],
)
def test_assignment(text: str, value: Any) -> None:
    path, read = parse_assignment(text)
    assert path == text.partition("=")[0].strip()
    assert read == value
    assert type(read) is type(value)


@pytest.mark.parametrize("text", ["a={b", "a={b: &c 1, d: !!x 2}", "a={b: 1, b: 2}"])
def test_a_group_that_is_none_is_refused(text: str) -> None:
    with pytest.raises(InputError, match="--set a"):
        parse_assignment(text)


@pytest.mark.parametrize("text", ["", "gear.stiffness", "=3", "gear.stiffness=", "a=" + "9" * 3000])
def test_no_assignment(text: str) -> None:
    with pytest.raises(InputError, match="--set must be PATH=VALUE"):
        parse_assignment(text)


@given(st.text())
def test_any_assignment_is_read_or_refused(text: str) -> None:
    try:
        path, _ = parse_assignment(text)
    except InputError as error:
        path = error.hint
    assert path


@pytest.mark.parametrize(
    ("robot", "path", "meant"),
    [
        ("manutec_r3", "payload.mass", "links.b6.bodies.load.mass"),
        ("flexarm1990", "payload.mass", "links.forearm.bodies"),
        ("manutec_r3", "actual.gear.stiffness", "real.gear.stiffness"),
        ("manutec_r3", "integration.dt", "integration.output_step"),
        ("manutec_r3", "links.b2.mass", "links.b2.bodies.b2.mass"),
    ],
)
def test_a_path_of_another_robot_leads_to_one_of_this(robot: str, path: str, meant: str) -> None:
    with pytest.raises(InputError) as caught:
        tmodes.load(robot, {path: 1.0})
    assert caught.value.hint.startswith(f"did you mean `{meant}")


def test_the_key_of_another_program_is_known() -> None:
    data = {
        "format": 1,
        "kind": "arm",
        "name": "x",
        "actual": {},
        "joints": [{"name": "j", "type": "fixed", "child": "l"}],
    }
    with pytest.raises(InputErrors) as caught:
        Robot.from_data(data)
    assert "`real`" in caught.value.errors[0].hint
