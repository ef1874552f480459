"""The lanes' own powers of two and logarithms against the C library's."""

from __future__ import annotations

import numpy as np
import pytest
from llvmlite import ir

from tmodes.compile.ir.arithmetic import Lanes, Wide
from tmodes.compile.ir.emit import POINTER, VOID, declare
from tmodes.compile.lanes.lanes_explicit import exponential, logarithm
from tmodes.compile.native import Library, to_object


@pytest.fixture(scope="module", params=[Lanes, Wide])
def native(request):
    """Functions of as many numbers as there are lanes."""
    module = ir.Module("powers")
    lanes = request.param(module)
    for name, write in (("log", logarithm), ("exp", exponential)):
        function = declare(module, name, VOID, [("x", POINTER), ("y", POINTER)])
        b = ir.IRBuilder(function.append_basic_block("entry"))
        lanes.store(b, write(b, lanes, lanes.load(b, function.args[0], 0)), function.args[1], 0)
        b.ret_void()
    library = Library("powers", to_object(module, 2), {"log": 2, "exp": 2})

    def applied(name, values):
        """Of any count of numbers: the last ones stand next to ones."""
        count = len(values)
        full = np.append(np.asarray(values, dtype=float), np.ones(-count % lanes.stride))
        found = np.empty_like(full)
        for k in range(0, len(full), lanes.stride):
            library[name](full[k:].ctypes.data, found[k:].ctypes.data)
        return found[:count]

    return applied


def test_logarithm(native):
    x = np.concatenate(
        [2.0 ** np.linspace(-1000, 1000, 4000), 1 + np.linspace(-0.5, 1.0, 4000), [1e-10, 1.0, 2.0, 0.5]]
    )
    assert np.abs(native("log", x) - np.log2(x)).max() < 1e-8
    assert native("log", [1.0, 2.0, 0.25, 1024.0]).tolist() == [0.0, 1.0, -2.0, 10.0]


def test_exponential(native):
    x = np.concatenate([np.linspace(-900, 900, 4000), np.linspace(-3, 3, 4000)])
    assert np.abs(native("exp", x) / np.exp2(x) - 1).max() < 1e-9
    assert native("exp", [0.0, 1.0, -3.0, 10.0]).tolist() == [1.0, 2.0, 0.125, 1024.0]


def test_what_is_no_number_stays_a_step_control(native):
    """Errors that are not finite are cut before; even so nothing is raised, and a logarithm is finite."""
    assert np.isfinite(native("log", [np.inf, np.nan, 1e300, 1e-10])).all()
