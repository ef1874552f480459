"""A program over many samples: ``map(n, parameters, in_1 [n, …], …, out [n, …])``."""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from tmodes.compile.ir.emit import I64, POINTER, VOID, at, counted, declare, load, scratch, whole
from tmodes.compile.ir.lower import Lowered

__all__ = ["write_sample_loop"]


def write_sample_loop(module: Any, name: str, lowered: Lowered) -> None:
    """Write the exported function that calls ``lowered`` for each of n samples, row by row."""
    program = lowered.program
    changing = [size for k, size in enumerate(program.sizes) if k != program.invariant]
    inputs = [(f"in{k}", POINTER) for k in range(len(changing))]
    function = declare(module, name, VOID, [("n", I64), ("p", POINTER), *inputs, ("out", POINTER)])
    count, parameters, *arrays, out = function.args
    builder = ir.IRBuilder(function.append_basic_block("entry"))
    held = scratch(builder, lowered.held_size, "held")
    builder.call(lowered.prepare, [parameters, held])
    with counted(builder, count, "sample") as sample:
        rows = []
        for array, size in zip(arrays, changing, strict=True):
            start = builder.mul(sample, whole(size))
            rows.append(load(builder, array, start) if size == 1 else at(builder, array, start))
        target = at(builder, out, builder.mul(sample, whole(program.output_size)))
        builder.call(lowered.call, [*rows, held, target])
    builder.ret_void()
