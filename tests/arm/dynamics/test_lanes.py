"""Four robots side by side move as each of them alone, to the bit; each may have numbers of its own."""

from __future__ import annotations

import numpy as np

from arm.oracle.robots import arms
from tmodes.arm_model import ArmModel
from tmodes.compile import kernels


def test_lanes_equal_single_robots() -> None:
    model = ArmModel(arms()["twist_and_bend"])
    schedule = model.passes.schedule("forward")
    rng = np.random.default_rng(0)
    rows = 0.1 * rng.normal(size=(8, schedule.input_size))
    rows[:, -schedule.inputs["step"].size :] = 0.0  # the last input: explicit
    assert list(schedule.inputs)[-1] == "step"
    parameters = np.tile(model.parameters, (8, 1))
    out = {}
    for arithmetic, width in (("double", 1), ("lanes", 4)):
        found, workspace = np.empty((8, schedule.output_size)), np.zeros(width * schedule.workspace)
        library = kernels.schedule_function("arm", schedule, arithmetic)
        for each, numbers in ((0, model.parameters), (1, parameters)):
            library["run"](8 // width, each, *(a.ctypes.data for a in (numbers, workspace, rows, found)))
            out[arithmetic, each] = found.copy()
    assert np.isfinite(out["double", 0]).all()
    assert np.abs(out["double", 0]).max() > 1.0
    for found in out.values():
        assert np.array_equal(found, out["double", 0])
