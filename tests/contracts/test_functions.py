"""Elementary functions of kernels: one text for CasADi, for native code (traced or not), for floats and for arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel.schedule import Kernel, Schedule
from tmodes.model.passes import evaluate

FUNCTIONS: dict[str, Any] = {
    "sin": f.sin, "cos": f.cos, "tan": f.tan, "fabs": f.fabs, "exp": f.exp, "tanh": f.tanh,
    "sqrt": lambda x: f.sqrt(x * x + 1.0), "fmin": lambda x: f.fmin(x, 0.3), "fmax": lambda x: f.fmax(0.3, x),
    "if_else": lambda x: f.if_else(x > 0.3, x**3, 1 / (x - 2.5)), "atan2": lambda x: f.atan2(x, x * x - 4.0),
}  # fmt: skip
NUMPY: dict[str, Any] = {
    "sqrt": lambda x: np.sqrt(x * x + 1.0), "fmin": lambda x: np.minimum(x, 0.3), "fmax": lambda x: np.maximum(x, 0.3),
    "if_else": lambda x: np.where(x > 0.3, x**3, 1 / (x - 2.5)), "atan2": lambda x: np.arctan2(x, x * x - 4.0),
}  # fmt: skip
PLACES = np.array([[-31.0], [-2.7], [-0.4], [-1e-9], [0.0], [0.2], [0.31], [1.9], [29.0]])


@pytest.mark.parametrize("plain", [True, False], ids=["traced", "by CasADi"])
def test_native_values(plain: bool) -> None:
    kernel = Kernel(
        f"functions {plain}",
        (1,),
        (len(FUNCTIONS),),
        lambda x: [[each(x[0]) for each in FUNCTIONS.values()]],
        plain=plain,
    )
    schedule = Schedule(0)
    schedule.output("values", *schedule.call(kernel, schedule.input("x", 1)))
    found = evaluate(np.zeros(0), schedule, {"x": PLACES}, len(PLACES))["values"]
    for k, (name, each) in enumerate(FUNCTIONS.items()):
        wanted = (NUMPY.get(name) or getattr(np, name))(PLACES[:, 0])
        assert found[:, k] == pytest.approx(wanted, rel=2e-14, abs=1e-300), name
        assert np.asarray(each(PLACES[:, 0])) == pytest.approx(wanted, rel=1e-15), name
        assert [each(float(x)) for x in PLACES[:, 0]] == pytest.approx(list(wanted), rel=1e-14), name
