"""A robot is found by its published name or its file, and changed by path on the way."""

from __future__ import annotations

from pathlib import Path

import pytest

from io_cases import SHEET, line_of, value_of
from tmodes.errors import InputError, InputErrors
from tmodes.robots import installed_models, names, text
from tmodes.robots.load import load


def test_published_robots_are_listed_and_read() -> None:
    assert "filipovic2010" in names()
    assert names()[:2] == ["two_link_arm", "filipovic2010"]
    assert names()[2:] == sorted(names()[2:])
    for name in names():
        assert text(name).startswith("# ")
        if "urdf:" in text(name) and not installed_models():  # the URDF comes with the extra `robots`
            with pytest.raises(InputError, match=r"pip install 'tmodes\[robots\]'"):
                load(name)
        else:
            assert load(name).name == name


@pytest.mark.parametrize("wrong", ["filipovic", "Filipovic2010", "filipovic2010.yaml", "no/such/filipovic2010.yml"])
def test_the_nearest_published_name_is_reported(wrong: str) -> None:
    with pytest.raises(InputError, match="Did you mean `filipovic2010`"):
        load(wrong)


@pytest.mark.parametrize("wrong", ["", "zzz", "no such file.yaml", "\0", "x" * 5000, "\udcff", "-"])
def test_neither_name_nor_file(wrong: str) -> None:
    with pytest.raises(InputError, match="or the path of a file that exists") as caught:
        load(wrong)
    str(caught.value).encode()
    with pytest.raises(InputError, match=r"one of .*, filipovic2010, "):
        text(wrong)


def test_a_file_is_read_and_its_lines_are_reported(tmp_path: Path) -> None:
    file = tmp_path / "my.yaml"
    file.write_text(SHEET.replace("gravity: 9.81", "gravity: -9.81"), encoding="utf-8")
    with pytest.raises(InputErrors) as caught:
        load(str(file))
    assert str(caught.value).startswith(
        f"{file}:{line_of('gravity')}: gravity must be a number not less than 0 [m/s^2], got -9.81"
    )
    assert load(file, {"gravity": 9.81}) == load("filipovic2010")


def test_a_changed_value_is_not_blamed_on_a_line_of_the_file() -> None:
    with pytest.raises(InputErrors) as caught:
        load("filipovic2010", {"gear.stiffness": -1.0, "payload": {"mass": 1.0}})
    assert [error.where for error in caught.value.errors] == ["filipovic2010.yaml"] * 2
    assert [error.which for error in caught.value.errors] == ["gear.stiffness", "payload.inertia"]


def test_changes_may_have_units() -> None:
    robot = load("filipovic2010", {"link.modes.0.length": "700 mm", "real.payload.mass": 1.5})
    assert value_of(robot, "link.modes.0.length") == 0.7
    assert value_of(robot.pair().real, "payload.mass") == 0.75
