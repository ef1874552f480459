"""`tmodes figures FOLDER` of a sensitivity and of an optimization: what these have found, from what is stored."""

from __future__ import annotations

import json

import numpy as np
import pytest

from command import tmodes
from study.optimize.tubes import EXAMPLES
from tmodes.study.optimize import optimize
from tmodes.study.page import figure_data
from tmodes.study.read import read_study
from tmodes.study.result import load_study
from tmodes.study.sensitivity import sensitivity

DESIGNS = """
format: 1
kind: study
name: designs
parameters:
  z: {distribution: {type: uniform, low: 0, high: 1}}
  b: {choices: [{name: small, set: {}}, {name: large, set: {}}]}
  load: {distribution: {type: normal, mean: 1, deviation: 0.1}}
quantities:
  mass: {expression: "z + b", unit: kg}
  sag: {expression: "load/(0.1 + z + 2*b)", unit: mm}
optimize: {objectives: [{minimize: mass}, {minimize: sag}], limits: ["mass <= 1.8 kg"], design: [z, b], worst_case: 8}
"""


@pytest.mark.parametrize(("method", "samples", "name"), [("sobol", 64, "sobol_y"), ("morris", 16, "morris_y")])
def test_a_sensitivity_has_its_indices(method, samples, name, tmp_path):
    found = sensitivity(read_study(EXAMPLES / "ishigami.yaml"), method, samples=samples, out=tmp_path)
    tmodes("figures", tmp_path)
    assert (tmp_path / "figures" / f"{name}.svg").exists()
    data = figure_data(load_study(tmp_path))
    if method == "sobol":
        (one,) = data["indices"]
        assert [row[0] for row in one["total"]] == found.total[0].tolist()
    else:
        (one,) = data["effects"]
        assert one["spread"] == found.indices["spread"][0].tolist()
        assert one["size"] == np.column_stack([found.indices["size"][0], found.intervals["size"][0]]).tolist()


def test_a_wrong_name_is_reported_before_anything_is_computed(tmp_path, monkeypatch):
    monkeypatch.setattr("tmodes.study.result.load_study", lambda folder: pytest.fail("the study was read"))
    (tmp_path / "study.json").write_text("{}", encoding="utf-8")
    assert "got 'tornad'. Did you mean `tornado`" in tmodes("figures", tmp_path, "tornad", code=2).stderr


DRAWN = """
format: 1
kind: study
name: drawn
parameters:
  z: {distribution: {type: uniform, low: 0, high: 1}}
quantities:
  sag: {expression: "1/(0.1 + z)", unit: mm}
plan: {type: monte_carlo, runs: 40}
"""


def test_a_study_is_shown_as_it_was_reported(tmp_path):
    sheet, folder = tmp_path / "study.yaml", tmp_path / "out"
    sheet.write_text(DRAWN, encoding="utf-8")
    reported = tmodes("study", sheet, "--out", folder).stdout
    assert "40 cases" in reported
    assert str(folder / "study.html") in reported
    assert tmodes("show", folder).stdout == reported
    assert json.loads(tmodes("show", folder, "--json").stdout)["good"] == 40
    (folder / "table.parquet").unlink()
    assert "no table.parquet of these cases" in tmodes("show", folder, code=4).stderr


def test_an_optimization_has_its_front(tmp_path):
    """With what is uncertain: each design is judged by its worst case, as when it was chosen."""
    pytest.importorskip("optuna")
    file, folder = tmp_path / "designs.yaml", tmp_path / "out"
    file.write_text(DESIGNS, encoding="utf-8")
    found = optimize(read_study(file), trials=64, out=folder)
    data = figure_data(load_study(folder))
    assert len(data["status"]) == found.designs
    mass, sag = (column["values"][data["designs"]["front"]] for column in data["quantities"][:2])
    assert sorted(zip(mass, sag, strict=True)) == sorted(one.objectives for one in found.front)
    good = np.array(data["good"])[data["status"]]
    assert int(good.sum()) == found.feasible < found.designs
    tmodes("figures", folder, "pareto")
    assert (folder / "figures" / "pareto.svg").exists()
