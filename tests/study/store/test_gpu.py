"""Studies on a GPU, for which this machine's processor stands: the same table as by its lanes, and what is refused."""

from __future__ import annotations

import json
import sys

import numpy as np
import pytest

from command import tmodes
from tmodes.compile.gpu.cuda import HostDevice
from tmodes.errors import InputError
from tmodes.study.read import study_from_data
from tmodes.study.runner import run_study

CASES = 200

ROBOTS = {
    "spong1987": {
        "set": {"integration.duration": 0.1},
        "gear": "joints.joint.gear.stiffness",
        "quantities": {
            "swing": {"series": "deformation.joint.gear", "reduce": "rms"},
            "most": {"series": "deformation.joint.gear", "reduce": "percentile:90"},
        },
    },
    "filipovic2010": {
        "set": {"integration.duration": 0.03},
        "gear": "gear.stiffness",
        "quantities": {
            "peak": {"series": "deviation", "reduce": "max", "unit": "mm"},
            "lift": {"series": "tip.z", "reduce": "range", "unit": "mm"},
        },
    },
}
"""The first one writes its series for a percentile, the second one folds them, compared with nominal runs."""


def study_of(name, **settings):
    """A study of 200 cases: a number of the gear within 20 %, and gravity within 1 %."""
    given, uniform = ROBOTS[name], {"type": "uniform", "low": 0.8, "high": 1.2}
    changes = {"integration.output_step": 0.002, **given["set"], **settings}
    sheet = {
        "format": 1, "kind": "study", "name": "gear", "robot": name, "set": changes,
        "parameters": {
            "gear": {"path": given["gear"], "relative": True, "distribution": uniform},
            "gravity": {"path": "gravity.2", "distribution": {"type": "uniform", "low": -9.9, "high": -9.7}},
        },
        "plan": {"type": "monte_carlo", "runs": CASES}, "block": 120,
        "quantities": {"fast": {"series": "tip.speed", "reduce": "max"}, **given["quantities"]},
    }  # fmt: skip
    return study_from_data(sheet)


class Counting(HostDevice):
    """The processor in place of a GPU, which knows how many threads ran at most."""

    most = 0

    def launch(self, loop, rooms, whole):
        self.most = max(self.most, whole["threads"])
        super().launch(loop, rooms, whole)


@pytest.fixture
def gpu(monkeypatch):
    """What stands for the first GPU."""
    device = Counting()
    monkeypatch.setattr("tmodes.compile.gpu.cuda.first_gpu", lambda: device)
    return device


SETTINGS = [
    pytest.param({"integration.method": "rk4"}, 1e-9, id="fixed-step"),
    pytest.param({"integration.relative_tolerance": 1e-7}, 1e-7, id="adaptive"),
]


@pytest.mark.nightly("fixed-step", "filipovic2010-adaptive")
@pytest.mark.parametrize(("settings", "within"), SETTINGS)
@pytest.mark.parametrize("name", list(ROBOTS))
def test_the_table_is_that_of_the_processor(name, settings, within, gpu, tmp_path):
    study = study_of(name, **settings)
    there, here = (run_study(study, tmp_path / on, on).table() for on in ("gpu", "local"))
    assert gpu.most == 120
    assert there.column_names == here.column_names
    assert set(there["status"].to_pylist()) == {"finished"}
    for column in here.column_names:
        found, expected = there[column].to_pylist(), here[column].to_pylist()
        if column in study.sheet.quantities:
            assert len(set(expected)) == CASES
            assert np.abs(np.subtract(found, expected)).max() <= within * np.abs(expected).max(), column
        elif column == "errors" and expected[0] is not None:
            assert found == pytest.approx(expected, rel=1e-3)
        elif column != "seconds":
            assert found == expected


def test_what_is_stored_is_not_computed_again(gpu, tmp_path, monkeypatch):
    """Ctrl-C in the second block: the first one stays, and either place computes the rest."""
    study, launch = study_of("spong1987", **{"integration.method": "rk4"}), Counting.launch

    def stopping(self, loop, rooms, whole):
        if whole["threads"] == 80:
            raise KeyboardInterrupt
        launch(self, loop, rooms, whole)

    monkeypatch.setattr(Counting, "launch", stopping)
    with pytest.raises(KeyboardInterrupt):
        run_study(study, tmp_path / "study", "gpu")
    monkeypatch.setattr(Counting, "launch", launch)
    gpu.most = 0
    resumed = run_study(study, tmp_path / "study", "gpu").table()
    assert gpu.most == 80
    whole = run_study(study, tmp_path / "whole", "gpu").table()
    assert resumed.drop_columns("seconds").equals(whole.drop_columns("seconds"))
    gpu.most = 0
    run_study(study, tmp_path / "whole", "local")
    assert gpu.most == 0


def test_larger_parts_than_on_the_processor(gpu, tmp_path, monkeypatch):
    """A GPU gets all cases of a block, of which the processor takes some at once."""
    monkeypatch.setattr("tmodes.simulation.batch.executor.Executor.longest", 64)
    run_study(study_of("spong1987", **{"integration.method": "rk4"}), tmp_path / "study", "gpu")
    assert gpu.most == 120


SPEED = {"series": "tip.speed", "reduce": "end"}


@pytest.mark.parametrize(("quantity", "settings", "words"), [
    (SPEED, {"integration.method": "extrapolation"}, "200 of 200 runs were on the processor: their method"),
    pytest.param(SPEED, {"integration.energy_stop": True, "integration.method": "rk4"}, "nothing ran on the GPU",
                 marks=pytest.mark.nightly),
    ({"static": "mass"}, {}, "nothing ran on the GPU"),
])  # fmt: skip
def test_what_does_not_run_there_is_said(quantity, settings, words, gpu, tmp_path):
    study = study_of("spong1987", **settings, **{"integration.duration": 0.004})
    sheet = {**study.data["study"], "quantities": {"one": quantity}}
    said = []
    result = run_study(study_from_data(sheet), tmp_path / "study", "gpu", notice=said.append)
    assert [text for text in said if text.startswith(words)]
    assert gpu.most == 0
    assert set(result.rows.status) == {"finished"}


def test_without_a_gpu_nothing_begins(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "cuda", None)
    file = tmp_path / "gear.json"
    file.write_text(json.dumps(study_of("spong1987").data["study"]))
    done = tmodes("study", file, "--on", "gpu", "--out", tmp_path / "out", code=3)
    assert "no GPU can be used: the Python package cuda-core is missing" in done.stderr
    assert "install it: pip install 'tmodes[gpu]'; or run without --on gpu" in done.stderr
    assert not (tmp_path / "out").exists()


def test_an_address_is_refused(gpu, tmp_path):
    with pytest.raises(InputError, match="CUDA_VISIBLE_DEVICES"):
        run_study(study_of("spong1987"), tmp_path / "out", "gpu://1")
    assert not (tmp_path / "out").exists()
    assert gpu.most == 0
