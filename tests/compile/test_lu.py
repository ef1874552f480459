"""Dense LU factors in native code next to NumPy's solver."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from llvmlite import ir

from tmodes.compile.ir.emit import POINTER, VOID, declare
from tmodes.compile.ir.linear_solve import lu_functions
from tmodes.compile.native import Library, to_object


def solved(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """The solution by the native functions, called one after the other."""
    module: Any = ir.Module("lu")
    factor, solve = lu_functions(module, len(right))
    function = declare(module, "run", VOID, [(label, POINTER) for label in ("matrix", "order", "x")])
    builder: Any = ir.IRBuilder(function.append_basic_block("entry"))
    builder.call(factor, function.args[:2])
    builder.call(solve, function.args)
    builder.ret_void()
    library = Library("lu", to_object(module, 1), {"run": 3})
    arrays = (np.array(matrix), np.zeros(len(right)), np.array(right))
    library["run"](*(array.ctypes.data for array in arrays))
    return arrays[2]


@pytest.mark.parametrize("size", [1, 2, 5, 40])
def test_solutions_are_numpys(size: int) -> None:
    rng = np.random.default_rng(size)
    matrix, right = rng.normal(size=(size, size)), rng.normal(size=size)
    matrix[0, 0] = 0.0 if size > 1 else 2.0  # no elimination without exchanging rows
    expected = np.linalg.solve(matrix, right)
    assert np.abs(solved(matrix, right) - expected).max() < 1e-11 * np.linalg.cond(matrix) * np.abs(expected).max()


def test_a_singular_matrix_gives_no_number() -> None:
    assert not np.isfinite(solved(np.ones((2, 2)), np.array([1.0, 2.0]))).all()
