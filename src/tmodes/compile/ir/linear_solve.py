"""Dense linear systems as native code: elimination for many right-hand sides, and LU factors with row exchanges."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from tmodes.compile.ir.emit import (
    F64,
    I64,
    POINTER,
    VOID,
    Builder,
    at,
    counted,
    declare,
    load,
    number,
    spread,
    store,
    whole,
)
from tmodes.compile.ir.kernels import native_functions

__all__ = ["BLOCK", "aligned", "eliminate", "lu_functions", "padded", "write_elimination"]

BLOCK = 8
"""Rows are as many numbers long as a multiple of this."""

_WIDE = ir.VectorType(F64, BLOCK)


def padded(count: int) -> int:
    """The next multiple of the block's length."""
    return -(-count // BLOCK) * BLOCK


def aligned(*shape: int) -> NDArray[np.float64]:
    """Zeros whose first stands at the start of a line of the processor's cache: wide loads then touch one line each."""
    size = math.prod(shape)
    room = np.zeros(size + BLOCK)
    skipped = -room.ctypes.data % (8 * BLOCK) // 8
    return room[skipped : skipped + size].reshape(shape)


def eliminate(rows: NDArray[np.float64]) -> int:
    """Put the solutions in the place of B in ``rows`` (n, padded(n) + columns of B, padded), C-ordered.

    The first n columns hold A, of which the upper triangle is read, and are lost. Returns 0, or the number, from 1, of
    the first row in which A is not positive definite.
    """
    failed = np.zeros(1)
    solve = native_functions("elimination", _write, {"solve": 4})["solve"]
    solve(len(rows), rows.shape[1] // BLOCK, rows.ctypes.data, failed.ctypes.data)
    return int(failed[0])


def _write() -> Any:
    module = ir.Module("elimination")
    write_elimination(module, "solve")
    return module


def write_elimination(module: Any, name: str, *, private: bool = False) -> Any:
    """The function ``name(n, blocks of a row, rows, failed)``."""
    arguments = [("n", I64), ("blocks", I64), ("rows", POINTER), ("failed", POINTER)]
    function = declare(module, name, VOID, arguments, private=private)
    n, blocks, rows, failed = function.args
    b: Any = Builder(function.append_basic_block("entry"))
    width = b.mul(blocks, whole(BLOCK))
    with counted(b, n, "pivot") as k:
        pivot = load(b, rows, b.add(b.mul(k, width), k))
        bad = b.not_(b.fcmp_ordered(">", pivot, number(0.0)))
        first = b.fcmp_ordered("==", load(b, failed, 0), number(0.0))
        with b.if_then(b.and_(bad, first), likely=False):
            store(b, b.sitofp(b.add(k, whole(1)), F64), failed, 0)
        inverse = b.fdiv(number(1.0), pivot)
        ahead = b.sub(b.sub(n, k), whole(1))
        with counted(b, ahead, "below") as step:
            i = b.add(b.add(k, whole(1)), step)
            share = b.fmul(load(b, rows, b.add(b.mul(k, width), i)), inverse)
            _subtract_row(b, rows, width, (i, k, share), (b.sdiv(i, whole(BLOCK)), blocks))
    right = b.sdiv(b.add(n, whole(BLOCK - 1)), whole(BLOCK))
    with counted(b, n, "back") as step:
        k = b.sub(b.sub(n, whole(1)), step)
        _scale(b, rows, width, k, (right, blocks))
        with counted(b, k, "above") as i:
            share = load(b, rows, b.add(b.mul(i, width), k))
            _subtract_row(b, rows, width, (i, k, share), (right, blocks))
    b.ret_void()
    return function


def _subtract_row(b: Any, rows: Any, width: Any, what: tuple[Any, Any, Any], blocks: tuple[Any, Any]) -> None:
    """Row i less a share of row k, from one block to another."""
    i, k, share = what
    wide = spread(b, share, _WIDE)
    with counted(b, b.sub(blocks[1], blocks[0]), "block") as step:
        block = b.add(blocks[0], step)
        here, there = _place(b, rows, width, i, block), _place(b, rows, width, k, block)
        term = b.fmul(wide, b.load(there, align=8, typ=_WIDE), flags=("contract",))
        b.store(b.fsub(b.load(here, align=8, typ=_WIDE), term, flags=("contract",)), here, align=8)


def _scale(b: Any, rows: Any, width: Any, k: Any, blocks: tuple[Any, Any]) -> None:
    """Row k over its pivot."""
    inverse = spread(b, b.fdiv(number(1.0), load(b, rows, b.add(b.mul(k, width), k))), _WIDE)
    with counted(b, b.sub(blocks[1], blocks[0]), "block") as step:
        here = _place(b, rows, width, k, b.add(blocks[0], step))
        b.store(b.fmul(b.load(here, align=8, typ=_WIDE), inverse), here, align=8)


def _place(b: Any, rows: Any, width: Any, row: Any, block: Any) -> Any:
    return b.bitcast(at(b, rows, b.add(b.mul(row, width), b.mul(block, whole(BLOCK)))), _WIDE.as_pointer())


def lu_functions(module: Any, size: int) -> tuple[Any, Any]:
    """``factor(matrix, order)`` and ``solve(matrix, order, right side)``, both in place, for size x size, row by row.

    ``order`` holds the rows that were exchanged, as doubles. A singular matrix gives numbers that are not finite.
    Gaussian elimination with partial pivoting: G. H. Golub, C. F. Van Loan, Matrix Computations, algorithm 3.4.1.
    """
    return _factor(module, size), _solve(module, size)


def _start(module: Any, name: str, labels: tuple[str, ...]) -> tuple[Any, Any]:
    function = declare(module, name, VOID, [(label, POINTER) for label in labels], private=True)
    function.attributes.add("noinline")
    return function, Builder(function.append_basic_block("entry"))


def _factor(module: Any, n: int) -> Any:
    function, b = _start(module, f"lu.factor.{n}", ("matrix", "order"))
    matrix, order = function.args
    best, largest = b.alloca(I64), b.alloca(F64)
    with counted(b, n, "column") as k:
        _find_pivot(module, b, matrix, k, n, best, largest)
        pivot = b.load(best, typ=I64)
        store(b, b.sitofp(pivot, F64), order, k)
        here, there = at(b, matrix, b.mul(k, whole(n))), at(b, matrix, b.mul(pivot, whole(n)))
        _exchange(b, here, there, n)
        inverse = b.fdiv(number(1.0), load(b, here, k))
        with counted(b, b.sub(whole(n - 1), k), "row") as below:
            row = at(b, matrix, b.mul(b.add(b.add(k, below), whole(1)), whole(n)))
            share = b.fmul(load(b, row, k), inverse)
            store(b, share, row, k)
            _subtract_multiple(b, row, here, share, b.add(k, whole(1)), n)
    b.ret_void()
    return function


def _find_pivot(module: Any, b: Any, matrix: Any, k: Any, n: int, best: Any, largest: Any) -> None:
    """The row from k on whose entry in column k is largest."""
    magnitude = module.declare_intrinsic("llvm.fabs", [F64])
    b.store(k, best)
    b.store(number(-1.0), largest)
    with counted(b, b.sub(whole(n), k), "candidate") as i:
        row = b.add(k, i)
        size = b.call(magnitude, [load(b, matrix, b.add(b.mul(row, whole(n)), k))])
        with b.if_then(b.fcmp_ordered(">", size, b.load(largest, typ=F64))):
            b.store(size, largest)
            b.store(row, best)


def _exchange(b: Any, one: Any, other: Any, n: int) -> None:
    with counted(b, n, "exchange") as j:
        kept = load(b, one, j)
        store(b, load(b, other, j), one, j)
        store(b, kept, other, j)


def _subtract_multiple(b: Any, row: Any, by: Any, share: Any, first: Any, n: int) -> None:
    """``row -= share * by`` from column ``first`` on."""
    with counted(b, b.sub(whole(n), first), "entry") as j:
        place = b.add(first, j)
        product = b.fmul(share, load(b, by, place), flags=("contract",))
        store(b, b.fsub(load(b, row, place), product, flags=("contract",)), row, place)


def _solve(module: Any, n: int) -> Any:
    function, b = _start(module, f"lu.solve.{n}", ("matrix", "order", "x"))
    matrix, order, x = function.args
    with counted(b, n, "exchange") as k:
        pivot = b.fptosi(load(b, order, k), I64)
        kept = load(b, x, k)
        store(b, load(b, x, pivot), x, k)
        store(b, kept, x, pivot)
    with counted(b, n, "forward") as i, counted(b, i, "known") as j:
        _take(b, matrix, x, i, j, n)
    with counted(b, n, "backward") as up:
        i = b.sub(whole(n - 1), up)
        with counted(b, up, "later") as j:
            _take(b, matrix, x, i, b.sub(whole(n - 1), j), n)
        store(b, b.fdiv(load(b, x, i), load(b, matrix, b.add(b.mul(i, whole(n)), i))), x, i)
    b.ret_void()
    return function


def _take(b: Any, matrix: Any, x: Any, i: Any, j: Any, n: int) -> None:
    """``x[i] -= matrix[i][j] x[j]``."""
    entry = load(b, matrix, b.add(b.mul(i, whole(n)), j))
    store(b, b.fsub(load(b, x, i), b.fmul(entry, load(b, x, j))), x, i)
