"""Results of the 2010 robot that earlier versions wrote: their states in today's coordinates, their numbers kept."""

from __future__ import annotations

import json

import numpy as np
import pytest
import xarray as xr

import tmodes
from tmodes.errors import ResultFileError
from tmodes.io.filipovic2010.format import Format2010
from tmodes.io.filipovic2010.importer import COORDINATES, to_robot
from tmodes.io.resultfile import write_sealed
from tmodes.io.yaml_file import parse_yaml
from tmodes.result import Result
from tmodes.result.earlier import NOTICE
from tmodes.robots.load import sheet_text

SETTLING = {"time_s": 0.1, "band": 0.05, "limit_m": 1e-3, "reason": ""}
"""By the rule of that version."""


@pytest.fixture(scope="module")
def new() -> Result:
    """A short run of today."""
    return tmodes.run(tmodes.load("filipovic2010").with_({"integration.duration": 0.05}))


def record(new: Result) -> xr.Dataset:
    """The same run as an earlier version wrote it: the paper's coordinates, names and kinds of work."""
    data = new.data
    back = np.linalg.inv(to_robot([str(name) for name in data["coordinate"].values]))
    paper = {
        name: data[name.replace("reference", "nominal")].values @ back.T
        for name in ("q", "v", "q_reference", "v_reference")
    }
    works = {"motor": "motor", "motor_friction": "friction", "gear_damping": "gear_damping",
             "link_damping": "link_damping", "contact": "contact"}  # fmt: skip
    work = np.stack([data["work"].sel(work_kind=kind).values for kind in works.values()], axis=1)
    plain = ("tip", "energy", "energy_balance", "deviation")
    made = xr.Dataset(
        {name: (("time", "coordinate"), values) for name, values in paper.items()}
        | {name: (data[name].dims, data[name].values) for name in plain}
        | {"work": (("time", "work_kind"), work)}
        | {name: (("time",), np.zeros(data.sizes["time"])) for name in ("deformation", "bending_moment", "line")},
        coords={"time": data["time"].values, "coordinate": list(COORDINATES), "work_kind": list(works)},
    )
    sheet = Format2010.model_validate(parse_yaml(sheet_text("filipovic2010"), "sheet")[0])
    sheet = sheet.model_copy(update={"integration": sheet.integration.model_copy(update={"duration": 0.05})})
    numbers = dict(sheet.real)
    actual = json.loads(sheet.model_dump_json())
    for path, factor in numbers.items():
        *groups, last = path.split(".")
        place = actual
        for group in groups:
            place = place[int(group) if group.isdigit() else group]
        place[last] *= factor
    made.attrs = {
        "tmodes_format": 1, "title": "a", "reading": "consistent", "parameters": "{}", "versions": "{}",
        "robot": sheet.model_dump_json(), "robot_real": json.dumps(actual | {"real": {}}),
        "status": "finished", "message": "reached the end", "warnings": json.dumps(["as it was"]),
        "frequencies": json.dumps({"locked": []}), "settling": json.dumps(SETTLING),
        "statistics": json.dumps({"real": {"steps": 7, "method": "dormand_prince"}, "reference": {"steps": 5}}),
    }  # fmt: skip
    return made


def test_an_earlier_record_is_read(new: Result, tmp_path) -> None:
    """Every series as of a run of today, to the rounding of the change of coordinates."""
    write_sealed(record(new), tmp_path / "result.nc", overwrite=False)
    old = Result.load(tmp_path / "result.nc")
    assert old.robot == new.robot
    assert (old.status, old.message) == ("finished", "reached the end")
    assert old.warnings == ("as it was", NOTICE)
    assert old.settling  # by the rule of today
    assert new.settling
    assert old.settling["move_m"] == pytest.approx(new.settling["move_m"], rel=1e-9)
    assert old.settling["reason"] == new.settling["reason"] != ""
    assert old.statistics["real"]["steps"] == 7
    for name, series in new.data.data_vars.items():
        size = max(float(np.abs(series.values).max()), 1e-6)
        assert old.data[name].values == pytest.approx(series.values, abs=1e-7 * size), name


def test_it_is_saved_as_a_result_of_today(new: Result, tmp_path) -> None:
    write_sealed(record(new), tmp_path / "old.nc", overwrite=False)
    Result.load(tmp_path / "old.nc").save(tmp_path / "new.nc")
    back = Result.load(tmp_path / "new.nc")
    assert back.data.attrs["kind"] == "arm"
    assert NOTICE in back.warnings


def test_an_incomplete_one_is_refused(new: Result, tmp_path) -> None:
    data = record(new)
    write_sealed(data.drop_vars("energy"), tmp_path / "result.nc", overwrite=False)
    with pytest.raises(ResultFileError, match="energy"):
        Result.load(tmp_path / "result.nc")
