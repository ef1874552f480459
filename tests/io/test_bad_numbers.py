"""Each number of a data sheet in every wrong way: a right robot, or an error that names the path and the line."""

from __future__ import annotations

import math

import pytest

from io_cases import SHEET, Case, bad_numbers, line_of, number_paths, numbers_of, value_of
from tmodes import Model
from tmodes.errors import InputErrors
from tmodes.io.sheet_check import sheet_from_data as robot_from_data
from tmodes.io.yaml_file import parse_yaml
from tmodes.sheet import Robot

CASES = list(bad_numbers())
WRONG_EVERYWHERE = ["nan", "minus infinite", "text", "comma", "empty", "bool", "list", "group", "huge", "overflow"]
WRONG_EVERYWHERE += ["huge whole number", "underflow", "wrong unit"]


def read(text: str) -> Robot:
    return robot_from_data(*parse_yaml(text, "sheet.yaml"), source="sheet.yaml")


def line_of_group(case: Case) -> int:
    """Line where the group begins in which a number is missing."""
    group = "real" if case.path.startswith("real.") else case.path.rpartition(".")[0]
    return parse_yaml(case.text, "sheet.yaml")[1][group]


def test_every_number_of_the_robot_is_tried() -> None:
    assert all(value_of(read(SHEET), path) is not None for path in number_paths())
    assert len(CASES) > 700


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_number_is_taken_or_reported(case: Case) -> None:
    try:
        robot = read(case.text)
    except InputErrors as errors:
        error = next(error for error in errors.errors if error.which in (case.path, f"real.{case.path}"))
        line = line_of(case.path) if case.kind != "absent" else line_of_group(case)
        assert error.where == f"sheet.yaml:{line}"
        assert error.got
        assert error.expected
        assert error.hint
    else:
        assert case.kind not in WRONG_EVERYWHERE
        assert not any(map(math.isnan, numbers_of(robot)))
        assert not any(map(math.isnan, numbers_of(robot.pair().real)))


@pytest.mark.parametrize("case", [case for case in CASES if case.kind == "numeric text"], ids=lambda case: case.id)
def test_number_in_quotes_is_the_number(case: Case) -> None:
    if case.path == "format":
        with pytest.raises(InputErrors, match="must be the number 1"):
            read(case.text)
    else:
        assert read(case.text) == read(SHEET)


STIFFNESSES = ["gear.stiffness", "link.modes.0.bending_stiffness", "link.modes.1.bending_stiffness"]


def test_only_elastic_elements_may_be_infinite_which_makes_them_rigid() -> None:
    taken, left = [], []
    for case in CASES:
        if case.kind == "infinite":
            try:
                robot = read(case.text)
            except InputErrors:
                continue
            taken.append(case.path)
            left.append(len(Model(robot.chain()).coordinates))
    assert taken == STIFFNESSES
    assert left == [5, 4, 4]  # a mode bends in two planes
