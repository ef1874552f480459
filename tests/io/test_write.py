"""A robot written as a data sheet, or as JSON, reads back as the same robot, to the last digit."""

from __future__ import annotations

import json
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmodes.io.check import robot_from_data
from tmodes.io.fields import number_paths, place_at
from tmodes.io.write import robot_to_yaml
from tmodes.io.yaml_file import parse_yaml
from tmodes.paper.sheet import PaperRobot
from tmodes.robots import load_robot, names

PUBLISHED = load_robot("filipovic2010")


def reread(robot: PaperRobot) -> PaperRobot:
    return robot_from_data(*parse_yaml(robot_to_yaml(robot), "written.yaml"), source="written.yaml")


@pytest.mark.parametrize("name", names())
def test_published_robot_reads_back(name: str) -> None:
    assert reread(load_robot(name)) == load_robot(name)


def values(path: str) -> st.SearchStrategy[float]:
    """Values that a number of the plant may have, also after a factor."""
    place = place_at(path)
    finite = st.floats(1e-8, 5.0)
    return st.one_of(finite, st.just(math.inf)) if place and place.may_be_infinite else finite


words = st.text(st.characters(exclude_categories=["Cc", "Cf", "Cs", "Co"]), min_size=1, max_size=20)
choices = {
    "name": words,
    "citation": words,
    "contact": st.booleans(),
    "reading": st.sampled_from(["printed", "consistent"]),
    "reference.start": st.floats(-1e3, 1e3),
    "integration.max_steps": st.integers(10**6, 10**12),
    "integration.method": st.just("rk4"),
}
factors = st.dictionaries(st.sampled_from(number_paths()), st.floats(1e-3, 1.9), max_size=5)
somewhere = st.sampled_from([*number_paths(), *choices])


@settings(max_examples=100)
@given(data=st.data(), paths=st.sets(somewhere, max_size=8), real=factors)
def test_any_robot_reads_back(data: st.DataObject, paths: set[str], real: dict[str, float]) -> None:
    changes = {path: data.draw(choices[path] if path in choices else values(path)) for path in sorted(paths)}
    robot = PUBLISHED.with_({**changes, "real": real})
    assert reread(robot) == robot
    assert robot_from_data(json.loads(robot.model_dump_json())) == robot
    assert robot_from_data(robot.model_dump(mode="json")) == robot


def test_every_quantity_is_written_with_symbol_unit_and_meaning() -> None:
    text = robot_to_yaml(PUBLISHED)
    assert "  stiffness: 4700.0                      # Cxi [N*m/rad] torsional stiffness of the gear" in text
    for line in text.splitlines():
        _, colon, value = line.partition(": ")
        if colon and value[:1].isdigit() and "format" not in line and not line.startswith(("  gear.", "  link.")):
            assert "[" in line, line


def test_numbers_have_a_point_for_readers_of_older_yaml() -> None:
    assert "relative_tolerance: 1.0e-09" in robot_to_yaml(PUBLISHED)


def test_rigid_elements_are_written_as_infinite() -> None:
    robot = PUBLISHED.with_({"gear.stiffness": math.inf})
    assert "stiffness: .inf" in robot_to_yaml(robot)
    assert reread(robot).rigid_elements() == {"gear"}
