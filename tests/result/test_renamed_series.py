"""Files that name the series of the nominal run as earlier versions did are read, with a notice."""

from __future__ import annotations

import json

import numpy as np
import pytest

from see.runs import result_of
from tmodes.io.resultfile import write_sealed
from tmodes.result import Result
from tmodes.result.record import RENAMED


@pytest.mark.parametrize("name", ["swinging", "pendulum"])
def test_series_of_an_earlier_name_are_read(name, tmp_path):
    """The same numbers, summary and figures; a run without a nominal one has nothing to rename."""
    data = result_of(name).data
    now = [str(key) for key in data if str(key).endswith("_nominal") and key != "tip_error_nominal"]
    write_sealed(data.rename({key: key.removesuffix("nominal") + "reference" for key in now}), tmp_path / "old.nc")
    back = Result.load(tmp_path / "old.nc")
    assert ("tip_nominal" in now) == (name == "swinging")
    for key in now:
        assert np.array_equal(back.data[key], data[key])
    assert not any(str(key).endswith("_reference") for key in back.data)
    assert (RENAMED in back.warnings) == bool(now)
    assert json.dumps(back.summary()) == json.dumps(result_of(name).summary())
