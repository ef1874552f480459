"""The functions that a GPU has no C library for, against exact values."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from llvmlite import ir

from tmodes.compile.gpu.mathematics import mathematics_module
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, Builder, counted, declare, load, store
from tmodes.compile.ir.kernels import native_functions
from tmodes.compile.native import FAR_COSINE, FAR_SINE, POWER

CALLED = {"sine": (FAR_SINE, 1), "cosine": (FAR_COSINE, 1), "power": (POWER, 2)}


def _module():
    """Functions ``NAME(n, in, out)`` of n rows of arguments."""
    module = mathematics_module()
    for name, (symbol, count) in CALLED.items():
        function = declare(module, name, VOID, [("n", I64), ("in", POINTER), ("out", POINTER)])
        b = Builder(function.append_basic_block("entry"))
        n, given, found = function.args
        with counted(b, n) as i:
            row = b.mul(i, ir.Constant(I64, count))
            values = [load(b, given, b.add(row, ir.Constant(I64, k))) for k in range(count)]
            store(b, b.call(module.globals[symbol], values), found, i)
        b.ret_void()
    text = str(module)
    for symbol, _ in CALLED.values():  # of this module alone: its neighbours have those of the C library
        text = text.replace(f'define double @"{symbol}"', f'define internal double @"{symbol}"')
    assert F64
    return text


def values(name, rows):
    rows = np.ascontiguousarray(rows, dtype=float)
    found = np.zeros(len(rows))
    library = native_functions("mathematics of a GPU", _module, dict.fromkeys(CALLED, 3))
    library[name](len(rows), rows.ctypes.data, found.ctypes.data)
    return found


@pytest.mark.parametrize("name", ["sine", "cosine"])
def test_large_angles(name):
    """To a unit in the last place, from where near angles end to 2^40 rad, and next to multiples of pi/2."""
    rng = np.random.default_rng(5)
    angles = np.concatenate(
        [
            rng.choice([-1, 1], 2000) * 2.0 ** rng.uniform(19, 40, 2000),
            (rng.integers(2**20, 2**38, 500) * mpmath.mpf(1)).astype(float) * float(mpmath.pi / 2),
        ]
    )
    found, exact = values(name, angles), getattr(mpmath, {"sine": "sin", "cosine": "cos"}[name])
    with mpmath.workprec(200):
        wrong = [abs(exact(mpmath.mpf(angle)) - mpmath.mpf(value)) for angle, value in zip(angles, found, strict=True)]
        units = [float(error / mpmath.mpf(np.spacing(abs(value)))) for error, value in zip(wrong, found, strict=True)]
    assert max(units) < 1.0


def test_angles_beyond_have_no_sine():
    assert np.isnan(values("sine", [2.0**40, -1e300, np.inf, np.nan])).all()


def test_powers():
    rng = np.random.default_rng(6)
    base, exponent = 10.0 ** rng.uniform(-12, 290, 2000), rng.uniform(-1, 1, 2000)
    found = values("power", np.column_stack([base, exponent]))
    assert np.abs(found / base**exponent - 1).max() < 1e-9
    near = np.column_stack([10.0 ** rng.uniform(-10, 10, 2000), rng.uniform(-0.3, 0.3, 2000)])
    assert np.abs(values("power", near) / near[:, 0] ** near[:, 1] - 1).max() < 1e-9


@pytest.mark.parametrize("lost", [np.nan, np.inf])
def test_power_of_what_is_lost_shortens_a_step_most(lost):
    """0.9 / power is then below the smallest factor of any method."""
    assert 0.9 / values("power", [[lost, 0.1]])[0] < 1e-25
