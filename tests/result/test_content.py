"""Results whose seal matches and whose content no run wrote are refused by name, whatever it is that is wrong."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.cli.show import show, view
from tmodes.errors import ResultFileError
from tmodes.io.resultfile import write_sealed
from tmodes.result import Result

DATA = tmodes.run(tmodes.load("filipovic2010").with_({"integration.duration": 0.02, "integration.line_points": 3})).data
JSON = ("robot", "robot_real", "statistics", "versions", "frequencies", "warnings", "settling", "errors", "move_end")
SERIES = [str(name) for name, series in DATA.data_vars.items() if "time" in series.dims]
OPTIONAL = ("voltage", "current", "contact", "penetration", "tip_commanded", "tip_error")
"""Series that not every record has."""

LABELS = ["axis", "coordinate", "deformation_kind", "drive", "energy_kind", "link", "bending_link", "work_kind", "s"]


def refused(data: Any, named: str) -> None:
    with pytest.raises(ResultFileError) as error:
        Result.of(data, "run.nc")
    assert "run.nc" in str(error.value)
    assert named in str(error.value)


def test_it_is_accepted_as_the_run_wrote_it(tmp_path: Path) -> None:
    write_sealed(DATA, tmp_path / "run.nc")
    assert Result.load(tmp_path / "run.nc").data.identical(DATA)


@pytest.mark.parametrize("value", ["", "{", "[" * 100_000, "3.5.", '"x"', "[1]", "[[]]", "NaN", "{'a': 1}", 3])
@pytest.mark.parametrize("name", JSON)
def test_attributes_that_no_run_writes(name: str, value: Any) -> None:
    refused(DATA.assign_attrs({name: value}), name)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("frequencies", {"locked": [{}]}), ("frequencies", {"locked": [{"frequency_Hz": "high"}]}),
        ("frequencies", {"locked": None}), ("errors", {"figures": {}}),
        ("errors", {"how": "", "figures": {"tip": None}}),
        ("settling", {"time_s": "late"}), ("settling", {"time_s": 1.0}), ("warnings", [3]), ("move_end", "late"),
        ("versions", {"tmodes": None}),
    ],
)  # fmt: skip
def test_attributes_of_another_shape(name: str, value: Any) -> None:
    refused(DATA.assign_attrs({name: json.dumps(value)}), name)


@pytest.mark.parametrize("name", SERIES)
def test_series_without_finite_numbers(name: str) -> None:
    series = DATA[name]
    one = series.values.copy()
    one.flat[-1] = np.inf
    for values in (np.full(series.shape, np.nan), one):
        refused(DATA.assign({name: (series.dims, values)}), name)


@pytest.mark.parametrize("name", SERIES)
def test_series_of_another_shape_or_kind(name: str) -> None:
    series = DATA[name]
    changed = [series.isel(time=0, drop=True), ((), 1.0), (series.dims, np.full(series.shape, "x"))]
    for value in [*changed, *([series.transpose()] if series.ndim > 1 else [])]:
        refused(DATA.assign({name: value}), name)


@pytest.mark.parametrize("name", [name for name in SERIES if not name.startswith(OPTIONAL)])
def test_series_that_are_missing(name: str) -> None:
    refused(DATA.drop_vars(name), name)


@pytest.mark.parametrize(
    ("change", "why"),
    [(np.zeros_like, "constant"), (lambda t: t[::-1], "backwards"), (lambda t: np.where(t > t[5], t[5], t), "halting"),
     (lambda t: t * np.nan, "nothing"), (lambda t: t.astype("U"), "text")],
)  # fmt: skip
def test_times_that_do_not_increase(change: Any, why: str) -> None:
    refused(DATA.assign_coords(time=("time", change(DATA["time"].values))), "time")
    assert why


@pytest.mark.parametrize("name", LABELS)
def test_names_that_are_missing_or_given_twice(name: str) -> None:
    refused(DATA.drop_vars(name), name)
    if DATA.sizes[name] > 1:
        same = [DATA[name].values[0]] * DATA.sizes[name]
        refused(DATA.assign_coords({name: (name, same)}), name)


@pytest.mark.parametrize("name", ["drive", "link", "bending_link", "axis", "coordinate_unit"])
def test_names_that_the_robot_does_not_have(name: str) -> None:
    labels = [f"x{k}" for k in range(DATA[name].size)]
    refused(DATA.assign_coords({name: (DATA[name].dims, labels)}), name)


@pytest.mark.parametrize("sheet", [{}, {"joints": 3}, {"format": 1, "kind": "arm", "name": "x", "joints": [None]}])
def test_a_robot_that_cannot_be_read_is_the_files_fault(sheet: Any, tmp_path: Path) -> None:
    write_sealed(DATA.assign_attrs(robot_real=json.dumps(sheet)), tmp_path / "run.nc")
    with pytest.raises(ResultFileError, match="robot_real"):
        _ = Result.load(tmp_path / "run.nc").actual


def test_the_commands_end_with_the_error_of_a_file(tmp_path: Path) -> None:
    write_sealed(DATA.assign({"tip": DATA["tip"] * np.nan}), tmp_path / "result.nc")
    for command in (
        lambda: show(tmp_path, False, False),
        lambda: view([tmp_path], tmp_path / "view.html", False, False),
    ):
        with pytest.raises(ResultFileError, match="variable tip") as error:
            command()
        assert error.value.exit_code == 4
