"""A record says of its series what a Dataset of xarray says of the same ones, and needs no xarray for it."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import numpy as np
import pytest
import xarray as xr

from tmodes.io.labelled import Record

DATASET = xr.Dataset(
    {
        "tip": (("time", "axis"), np.arange(15.0).reshape(5, 3), {"units": "m"}),
        "line": (("time", "link", "s"), np.random.default_rng(1).normal(size=(5, 2, 4)), {"units": "m"}),
        "alone": ((), 2.5),
    },
    coords={
        "time": ("time", np.linspace(0, 1, 5), {"units": "s"}),
        "axis": ("axis", ["x", "y", "z"]),
        "link": ("link", ["upper", "fore"]),
        "parent": ("link", ["base", "upper"], {"long_name": "what it stands on"}),
    },
    attrs={"kind": "arm"},
)

PARTS: dict[str, Any] = {
    "a label": lambda data: data["tip"].sel(axis="y"),
    "labels in another order": lambda data: data["tip"].sel(axis=["z", "x"]),
    "two labels": lambda data: data["line"].sel(link="fore", time=0.25),
    "a place": lambda data: data["line"].isel(s=-1),
    "a slice": lambda data: data["line"].isel(time=slice(1, None)),
    "places of all": lambda data: data.isel(time=np.array([0, 3]), s=[1, 2])["line"],
    "another order": lambda data: data["line"].transpose("s", "time", "link"),
    "one first": lambda data: data["line"].transpose("link", ...),
    "a name of its own": lambda data: data.rename({"tip": "end"})["end"],
    "one more": lambda data: data.assign(more=(("s",), np.ones(4), {"units": "1"}))["more"],
}


@pytest.mark.parametrize("part", PARTS)
def test_a_part_is_that_of_a_dataset(part: str) -> None:
    found, expected = PARTS[part](Record.of(DATASET)), PARTS[part](DATASET)
    assert (found.dims, found.shape, found.sizes) == (expected.dims, expected.shape, expected.sizes)
    assert found.attrs == expected.attrs
    np.testing.assert_array_equal(found.values, expected.values)


def test_the_whole_is_that_of_a_dataset() -> None:
    record = Record.of(DATASET)
    assert record.dataset().identical(DATASET)
    assert record.assign_attrs(kind="x").dataset().identical(DATASET.assign_attrs(kind="x"))
    assert (record.sizes, record.nbytes) == (dict(DATASET.sizes), DATASET.nbytes)
    assert record.coords == set(DATASET.coords)
    assert list(record.data_vars) == list(DATASET.data_vars)
    assert "tip" in record
    assert "top" not in record


def test_a_label_that_is_not_there_is_an_error() -> None:
    with pytest.raises(KeyError, match="w"):
        Record.of(DATASET)["tip"].sel(axis="w")


def test_the_command_that_runs_a_robot_loads_neither_xarray_nor_pandas(tmp_path: Any) -> None:
    code = (
        "import sys, tmodes\n"
        "result = tmodes.run(tmodes.load('spong1987').with_({'integration.duration': 0.05}))\n"
        "result.save(sys.argv[1]); type(result).load(sys.argv[1]).summary()\n"
        "assert not {'xarray', 'pandas', 'pint'} & sys.modules.keys(), sorted(sys.modules)\n"
        "assert result.data['tip'].sel(axis='x').size"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "run.nc")], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
