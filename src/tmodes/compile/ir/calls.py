"""The calls of a schedule: one by one, or, where they are many, as data and a loop.

The data tell which kernel, and where its blocks begin in the workspace. So the code is as long as there are kinds of
kernels, and not calls: a thousand joints take no longer to compile than two hundred.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from llvmlite import ir

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.emit import I64, POINTER, VOID, at, declare, whole

__all__ = ["DIRECT", "I32", "table_of", "write_calls"]

Symbols = Callable[[Any], str]
_I8, I32 = ir.IntType(8), ir.IntType(32)


DIRECT = 700
"""Calls up to which each has its own code (200 rigid joints): a twentieth quicker, and compiled in a second."""


def write_calls(
    b: Any, schedule: Any, arithmetic: Double, workspace: Any, symbols: Symbols, offset: Callable[[Any], int]
) -> None:
    """Make all calls, in order; ``symbols``: the name of a kernel's function, ``offset``: where a block begins."""
    calls = [
        (symbols(kernel), [offset(slot) * arithmetic.stride for slot in (*inputs, *outputs)])
        for kernel, inputs, outputs in schedule.calls
    ]
    if len(calls) > DIRECT:
        _write_loop(b, calls, workspace)
        return
    for name, places in calls:
        b.call(_declared(b, name, len(places)), [at(b, workspace, place) for place in places])


def _declared(b: Any, name: str, blocks: int) -> Any:
    module = b.function.module
    return module.globals.get(name) or declare(module, name, VOID, [(f"b{k}", POINTER) for k in range(blocks)])


def table_of(b: Any, name: str, numbers: list[int]) -> Any:
    """The address of constant whole numbers of four bytes; the name serves once in a module."""
    content, module = np.array(numbers, dtype=np.int32), b.function.module
    kind = ir.ArrayType(_I8, content.nbytes)
    table: Any = ir.GlobalVariable(module, kind, name)
    table.global_constant, table.linkage, table.align = True, "internal", 8
    table.initializer = ir.Constant(kind, bytearray(content.tobytes()))
    return b.bitcast(table, I32.as_pointer())


def _write_loop(b: Any, calls: list[tuple[str, list[int]]], workspace: Any) -> None:
    kinds: dict[str, tuple[int, int]] = {}  # name -> its number and how many blocks it takes
    info: list[int] = []
    for name, places in calls:
        info += [kinds.setdefault(name, (len(kinds), len(places)))[0], *places]
    table = table_of(b, f"{b.function.name}.calls", [*info, len(kinds)])
    before, function = b.block, b.function
    head, done = function.append_basic_block("call"), function.append_basic_block("called")
    b.branch(head)
    b.position_at_end(head)
    place = b.phi(I32.as_pointer(), "place")
    place.add_incoming(table, before)
    choice = b.switch(b.load(place, typ=I32), done)
    for name, (number, blocks) in kinds.items():
        case = function.append_basic_block("kernel")
        choice.add_case(ir.Constant(I32, number), case)
        b.position_at_end(case)
        offsets = [b.load(_next(b, place, 1 + k), typ=I32) for k in range(blocks)]
        b.call(_declared(b, name, blocks), [at(b, workspace, b.sext(offset, I64)) for offset in offsets])
        place.add_incoming(_next(b, place, 1 + blocks), case)
        b.branch(head)
    b.position_at_end(done)


def _next(b: Any, place: Any, count: int) -> Any:
    return b.gep(place, [whole(count)], source_etype=I32)
