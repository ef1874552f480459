"""A robot written as a data sheet, or as JSON, reads back as the same robot, to the last digit."""

from __future__ import annotations

import json
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import tmodes
from tmodes.io.sheet_check import sheet_data, sheet_from_data
from tmodes.io.sheet_write import robot_to_yaml
from tmodes.io.yaml_file import parse_yaml
from tmodes.robots import names
from tmodes.sheet import Robot

PUBLISHED = tmodes.load("filipovic2010")
PLAIN = [name for name in names() if not name.endswith("_elastic")]  # those stand on models that may not be installed

NUMBERS = {
    "joints.joint.motor.resistance": 0.299, "joints.joint.gear.stiffness.0": 4700.0, "joints.joint.gear.damping": 2.0,
    "links.link.beam.modes.0.bending_stiffness": 1082.0, "links.link.beam.modes.1.length": 0.3,
    "links.link.bodies.payload.mass": 0.5, "contact.stiffness": 1000.0, "drives.0.controller.position_gain": 2000.0,
}  # fmt: skip
MAY_BE_INFINITE = {"joints.joint.gear.stiffness.0", "links.link.beam.modes.0.bending_stiffness"}


def reread(robot: Robot) -> Robot:
    return sheet_from_data(parse_yaml(robot_to_yaml(robot), "written.yaml")[0])


@pytest.mark.parametrize("name", PLAIN)
def test_published_robots_read_back(name: str) -> None:
    assert reread(tmodes.load(name)) == tmodes.load(name)


def values(path: str) -> st.SearchStrategy[float]:
    """Values that a number of the plant may have, also after a factor."""
    finite = st.floats(1e-3, 2.0).map(lambda factor: factor * NUMBERS[path])
    return st.one_of(finite, st.just(math.inf)) if path in MAY_BE_INFINITE else finite


words = st.text(st.characters(exclude_categories=["Cc", "Cf", "Cs", "Co"]), min_size=1, max_size=20)
choices = {
    "name": words,
    "citation": words,
    "equations": st.sampled_from(["printed", "consistent", "recursion"]),
    "drives.0.signal.start": st.floats(-1e3, 1e3),
    "integration.max_steps": st.integers(10**6, 10**12),
    "integration.method": st.just("rk4"),
}
factors = st.dictionaries(st.sampled_from([*NUMBERS]), st.floats(1e-3, 1.9), max_size=5)
somewhere = st.sampled_from([*NUMBERS, *choices])


@settings(max_examples=40)
@given(data=st.data(), paths=st.sets(somewhere, max_size=8), real=factors)
def test_any_robot_reads_back(data: st.DataObject, paths: set[str], real: dict[str, float]) -> None:
    changes = {path: data.draw(choices[path] if path in choices else values(path)) for path in sorted(paths)}
    robot = PUBLISHED.with_({**changes, "real": real})
    assert reread(robot) == robot
    assert sheet_from_data(json.loads(robot.model_dump_json())) == robot
    assert sheet_from_data(sheet_data(robot)) == robot


def test_every_quantity_is_written_with_symbol_unit_and_meaning() -> None:
    text = robot_to_yaml(PUBLISHED)
    assert "resistance: 0.299" in text
    assert "# R [ohm] armature resistance" in text
    whole = False
    for line in text.splitlines():
        key, colon, value = line.partition(": ")
        whole = whole or key.startswith("real")
        if colon and value[:1].isdigit() and not whole and key not in ("format", "equations"):
            assert "[" in line, line


def test_numbers_have_a_point_for_readers_of_older_yaml() -> None:
    assert "relative_tolerance: 1.0e-09" in robot_to_yaml(PUBLISHED)


def test_rigid_elements_are_written_as_infinite() -> None:
    robot = PUBLISHED.with_({"gear.stiffness": math.inf})
    assert "stiffness: [.inf]" in robot_to_yaml(robot)
    (joint,) = reread(robot).joints
    assert joint.gear
    assert joint.gear.stiffness == (math.inf,)
