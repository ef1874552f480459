"""Robots side by side move as each of them alone, to the bit; each may have numbers of its own."""

from __future__ import annotations

import numpy as np

from oracle.arms.robots import arms
from tmodes.compile.ir import kernels
from tmodes.compile.ir.arithmetic import Wide
from tmodes.model.model import Model


def test_lanes_equal_single_robots() -> None:
    model = Model(arms()["twist_and_bend"])
    schedule = model.passes.schedule("forward")
    rng = np.random.default_rng(0)
    rows = 0.1 * rng.normal(size=(16, schedule.input_size))
    rows[:, -schedule.inputs["step"].size :] = 0.0  # the last input: explicit
    assert list(schedule.inputs)[-1] == "step"
    parameters = model.parameters * rng.uniform(0.9, 1.1, size=(16, len(model.parameters)))
    out = {}
    for arithmetic, width in (("double", 1), ("lanes", 4), (Wide.name, Wide.stride)):
        found, workspace = np.empty((16, schedule.output_size)), np.zeros(width * schedule.workspace)
        library = kernels.schedule_function("arm", schedule, arithmetic)
        for each, numbers in ((0, model.parameters), (1, parameters)):
            library["run"](16 // width, each, *(a.ctypes.data for a in (numbers, workspace, rows, found)))
            out[arithmetic, each] = found.copy()
    assert np.isfinite(out["double", 0]).all()
    assert np.abs(out["double", 0]).max() > 1.0
    assert not np.array_equal(out["double", 1], out["double", 0])
    for (_, each), found in out.items():
        assert np.array_equal(found, out["double", each])
