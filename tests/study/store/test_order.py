"""Parameters keep their order: it is that of the columns of all cases, in a folder and on another machine."""

from __future__ import annotations

import numpy as np

from study.core.studies import UNIFORM, study
from tmodes.study.blocks import unpack
from tmodes.study.remote import compute, compute_block, order
from tmodes.study.result import load_study
from tmodes.study.runner import run_study
from tmodes.study.task import Task

PARAMETERS = {"z": {"distribution": UNIFORM}, "a": {"distribution": {"type": "uniform", "low": 5.0, "high": 6.0}}}
QUANTITIES = {"y": {"expression": "z + 10*a"}, "b": {"expression": "z"}}


def test_a_folder_is_read_in_the_order_in_which_it_was_written(tmp_path):
    asked = study(PARAMETERS, QUANTITIES, plan={"type": "grid", "levels": 3})
    done, again = run_study(asked, tmp_path), load_study(tmp_path)
    assert again.study.names == ("z", "a")
    assert again.design.values.tolist() == done.design.values.tolist()
    assert again.table().column_names == done.table().column_names
    assert again.rows.quantities["y"].tolist() == done.rows.quantities["y"].tolist()


def test_another_machine_has_the_same_columns():
    asked = study(PARAMETERS, QUANTITIES)
    task = Task(0, asked.design().values, ("y", "b"))
    there, here = unpack(compute_block(order(asked, task, 1)), "a block"), compute(asked, task, 1)
    assert there.label.address == here.label.address
    assert there.label.base == here.label.base
    assert np.array_equal(there.rows.quantities["y"], here.rows.quantities["y"])
