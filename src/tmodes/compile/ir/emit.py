"""Small helpers to write LLVM IR: pointers to double, counted loops, stores."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from llvmlite import ir

__all__ = [
    "F64", "I64", "POINTER", "VOID", "at", "counted", "declare", "load", "number", "scratch", "spread", "store",
    "whole",
]  # fmt: skip

F64 = ir.DoubleType()
I64 = ir.IntType(64)
VOID = ir.VoidType()
POINTER = F64.as_pointer()


def number(value: float) -> Any:
    """A constant of type double."""
    return ir.Constant(F64, value)


def whole(value: int) -> Any:
    """A constant of type int64."""
    return ir.Constant(I64, value)


def declare(module: Any, name: str, result: Any, arguments: list[tuple[str, Any]], *, private: bool = False) -> Any:
    """A function whose pointer arguments never overlap."""
    function = ir.Function(module, ir.FunctionType(result, [kind for _, kind in arguments]), name)
    for argument, (label, kind) in zip(function.args, arguments, strict=True):
        argument.name = label
        if isinstance(kind, ir.PointerType):
            argument.add_attribute("noalias")
    if private:
        function.linkage = "internal"
    return function


def at(builder: Any, base: Any, index: Any) -> Any:
    """Address of ``base[index]``; the index may be an int."""
    return builder.gep(base, [whole(index) if isinstance(index, int) else index], source_etype=F64)


def load(builder: Any, base: Any, index: Any) -> Any:
    """``base[index]``."""
    return builder.load(at(builder, base, index), typ=F64)


def store(builder: Any, value: Any, base: Any, index: Any) -> None:
    """``base[index] = value``."""
    builder.store(value, at(builder, base, index))


def scratch(builder: Any, size: int, name: str) -> Any:
    """An array of doubles on the stack of the function; call it in the entry block."""
    return builder.alloca(F64, size=whole(max(size, 1)), name=name)


def spread(builder: Any, value: Any, kind: Any) -> Any:
    """A double in all lanes of a kind of vector."""
    empty, first = ir.Constant(kind, ir.Undefined), ir.IntType(32)
    places = ir.Constant(ir.VectorType(first, kind.count), [0] * kind.count)
    return builder.shuffle_vector(builder.insert_element(empty, value, ir.Constant(first, 0)), empty, places)


@contextmanager
def counted(builder: Any, end: Any, name: str = "i") -> Iterator[Any]:
    """``for i in range(end)``; yields i."""
    end = whole(end) if isinstance(end, int) else end
    before = builder.block
    head = builder.append_basic_block(f"{name}.head")
    body = builder.append_basic_block(f"{name}.body")
    after = builder.append_basic_block(f"{name}.after")
    builder.branch(head)
    builder.position_at_end(head)
    index = builder.phi(I64, name)
    index.add_incoming(whole(0), before)
    builder.cbranch(builder.icmp_signed("<", index, end), body, after)
    builder.position_at_end(body)
    yield index
    index.add_incoming(builder.add(index, whole(1)), builder.block)
    builder.branch(head)
    builder.position_at_end(after)
