"""A X = B for many right-hand sides at once, A positive definite and small: elimination of whole rows in native code.

Libraries start threads for this, whose waiting costs more than the whole solution. A = L D L^T without pivots: G. H.
Golub, C. F. Van Loan, Matrix Computations, section 4.1.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from tmodes.compile.ir.builder import Builder
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, at, counted, declare, load, number, spread, store, whole
from tmodes.compile.ir.kernels import native_functions

__all__ = ["BLOCK", "aligned", "eliminate", "padded", "write_elimination"]

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
            _less(b, rows, width, (i, k, share), (b.sdiv(i, whole(BLOCK)), blocks))
    right = b.sdiv(b.add(n, whole(BLOCK - 1)), whole(BLOCK))
    with counted(b, n, "back") as step:
        k = b.sub(b.sub(n, whole(1)), step)
        _scale(b, rows, width, k, (right, blocks))
        with counted(b, k, "above") as i:
            share = load(b, rows, b.add(b.mul(i, width), k))
            _less(b, rows, width, (i, k, share), (right, blocks))
    b.ret_void()
    return function


def _less(b: Any, rows: Any, width: Any, what: tuple[Any, Any, Any], blocks: tuple[Any, Any]) -> None:
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
