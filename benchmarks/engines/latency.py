"""Chains of one operation as native code: how long it takes when each waits for the one before, and when many go on.

From both follows what a program can reach at best on this machine: see ``benchmarks/engines/limit.py``.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, Builder, counted, declare, load, number, store, whole
from tmodes.compile.native import Library, to_object

__all__ = ["BODY", "OPERATIONS", "chains"]

OPERATIONS = ("add", "mul", "div", "sqrt", "sin", "fma")
"""Operations that are measured; ``sin`` gives sine and cosine, ``fma`` a product and a sum at once."""

BODY = 32
"""Operations of each chain in the body of the loop."""


def chains(width: int) -> Library:
    """Functions ``f(n, x)`` by operation: n times BODY operations on each of ``width`` numbers, one after the other.

    The chains of different numbers do not wait for each other. ``cycle``: integer operations that take a cycle each;
    ``mixed``: ``add`` and ``fma`` on one number and the other in turn.
    """
    module = ir.Module("latency")
    for operation in OPERATIONS:
        _write_chain(module, operation, [operation] * width)
    _write_chain(module, "mixed", ["add", "fma"] * (width // 2))
    _write_cycles(module)
    return Library("latency", to_object(module, 2), dict.fromkeys((*OPERATIONS, "mixed", "cycle"), 2))


def _write_chain(module: Any, name: str, operations: list[str]) -> None:
    """The operation of each number."""
    function = declare(module, name, VOID, [("n", I64), ("x", POINTER)])
    b, arithmetic = Builder(function.append_basic_block("entry")), Double(module)
    cells = [b.alloca(F64, name=f"x{k}") for k in range(len(operations))]
    for k, cell in enumerate(cells):
        b.store(load(b, function.args[1], k), cell)
    with counted(b, function.args[0]):
        for _ in range(BODY):
            values = [b.load(cell, typ=F64) for cell in cells]
            if "sin" in operations:
                values = [sine for sine, _ in arithmetic.turns(b, values)]
            else:
                values = [_next(module, b, arithmetic, *pair) for pair in zip(operations, values, strict=True)]
            for cell, value in zip(cells, values, strict=True):
                b.store(value, cell)
    for k, cell in enumerate(cells):
        store(b, b.load(cell, typ=F64), function.args[1], k)
    b.ret_void()


def _next(module: Any, b: Any, arithmetic: Double, operation: str, value: Any) -> Any:
    """The operation on a value, such that the result stays a number of usual size for ever."""
    if operation == "sqrt":
        return arithmetic.operation(b, "sqrt", value)
    if operation == "fma":
        kind = ir.FunctionType(F64, [F64] * 3)
        return b.call(module.declare_intrinsic("llvm.fma", [F64], kind), [value, number(0.999999), number(1e-6)])
    other = {"add": 1e-9, "mul": 1 - 1e-12, "div": 1 + 1e-12}[operation]
    return arithmetic.operation(b, operation, value, number(other))


def _write_cycles(module: Any) -> None:
    """Sum and exclusive or in turn: no compiler can make them fewer, and each takes one cycle on every processor."""
    function = declare(module, "cycle", VOID, [("n", I64), ("x", POINTER)])
    b = Builder(function.append_basic_block("entry"))
    place = b.bitcast(function.args[1], I64.as_pointer())
    cell = b.alloca(I64)
    b.store(b.load(place, typ=I64), cell)
    with counted(b, function.args[0]):
        for k in range(BODY // 2):
            mixed = b.xor(b.load(cell, typ=I64), whole(0x5555 + k))
            b.store(b.add(mixed, whole(12345 + k)), cell)
    b.store(b.load(cell, typ=I64), place)
    b.ret_void()
