"""LU factors of a dense matrix with row exchanges, and solutions with them, as native code of a module."""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.builder import Builder
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, at, counted, declare, load, number, store, whole

__all__ = ["lu_functions"]


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
            _less(b, row, here, share, b.add(k, whole(1)), n)
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


def _less(b: Any, row: Any, by: Any, share: Any, first: Any, n: int) -> None:
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
