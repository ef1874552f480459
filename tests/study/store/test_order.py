"""The names of parameters need not be in the order of the alphabet: columns of values follow the study file."""

from __future__ import annotations

import pytest

from tmodes.study.blocks import unpack
from tmodes.study.read import read_study
from tmodes.study.result import load_study
from tmodes.study.runner import run_study
from tmodes.study.tasks import Task, compute_block, order

STUDY = """\
format: 1
kind: study
name: order
parameters:
  wall: {distribution: {type: uniform, low: 0, high: 1}}
  load: {distribution: {type: uniform, low: 10, high: 20}}
  gear: {distribution: {type: uniform, low: 300, high: 400}}
plan: {type: monte_carlo, runs: 100}
quantities:
  weighted: {expression: "wall + 2*load + 3*gear"}
  all: {expression: "wall + load + gear"}
"""


@pytest.fixture
def study(tmp_path):
    file = tmp_path / "order.yaml"
    file.write_text(STUDY)
    return read_study(file)


def test_a_folder_is_read_again(study, tmp_path):
    result = run_study(study, tmp_path / "out")
    again = load_study(tmp_path / "out")
    assert again.study.names == ("wall", "load", "gear")
    assert again.table() == result.table()
    assert again.table().column_names[1:4] == ["wall", "load", "gear"]


def test_a_worker_computes_the_same_cases(study):
    values = study.design().values
    rows = unpack(compute_block(order(study, Task(0, values, ("weighted",)))), "a block").rows
    assert rows.quantities["weighted"] == pytest.approx(values @ [1.0, 2.0, 3.0])
