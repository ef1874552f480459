"""Numbers into the blocks of a workspace and out again: rows of samples, parameters, states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.calls import I32, table_of
from tmodes.compile.ir.emit import F64, I64, at, counted, load, store, whole

__all__ = ["copy_numbers", "give_rows", "take_parameters", "take_rows"]

Blocks = Sequence[tuple[int, int]]
"""Offset and size of blocks in the workspace, in numbers."""

_FEW_BLOCKS = 4
_AT_ONCE = 8


def copy_numbers(b: Any, numbers: Double, row: Any, workspace: Any, blocks: Blocks, *, into: bool) -> None:
    """A row of numbers, one after the other, into blocks of the workspace or out of them."""
    merged, first, stride = _merged(blocks), 0, numbers.stride
    if len(merged) > _FEW_BLOCKS:
        with _places(b, numbers, blocks, "in" if into else "out") as (k, place):
            ends = (at(b, row, _times(b, k, stride)), at(b, workspace, place))
            source, target = ends if into else ends[::-1]
            numbers.store(b, numbers.load(b, source, 0), target, 0)
        return
    for offset, size in merged:
        ends = (at(b, row, first * stride), at(b, workspace, offset * stride))
        source, target = ends if into else ends[::-1]
        _copy_block(b, source, target, size * stride)
        first += size


def take_parameters(b: Any, numbers: Double, row: Any, workspace: Any, size: int) -> None:
    """A row of numbers to the start of the workspace, one by one: done so seldom that short code is worth more."""
    with counted(b, size, "parameter") as k:
        place = _times(b, k, numbers.stride)
        numbers.store(b, numbers.load(b, at(b, row, place), 0), at(b, workspace, place), 0)


def take_rows(b: Any, numbers: Any, rows: Any, workspace: Any, blocks: Blocks, count: int) -> None:
    """Blocks of the workspace from ``count`` rows of doubles, one after the other: one for each part of a number.

    Each number is put together before it is stored: one that is loaded soon after its parts were stored is waited for.
    From one row alone, every number is that double in all lanes, or without a derivative.
    """
    if numbers.stride == 1:
        copy_numbers(b, numbers, rows, workspace, blocks, into=True)
        return
    length = sum(size for _, size in blocks)
    with _places(b, numbers, blocks, "in") as (k, place):
        doubles = [load(b, rows, b.add(k, whole(part * length))) for part in range(count)]
        numbers.store(b, numbers.packed(b, doubles), at(b, workspace, place), 0)


def give_rows(b: Any, numbers: Any, rows: Any, workspace: Any, blocks: Blocks) -> None:
    """Blocks of the workspace into rows of doubles, one for each part of a number."""
    if numbers.stride == 1:
        copy_numbers(b, numbers, rows, workspace, blocks, into=False)
        return
    length = sum(size for _, size in blocks)
    with _places(b, numbers, blocks, "out") as (k, place):
        for part, value in enumerate(numbers.parts(b, numbers.load(b, at(b, workspace, place), 0))):
            store(b, value, rows, b.add(k, whole(part * length)))


@contextmanager
def _places(b: Any, numbers: Double, blocks: Blocks, label: str) -> Iterator[tuple[Any, Any]]:
    """Each number's index in a row, and its place in the workspace in doubles: by a table where blocks lie about."""
    merged = _merged(blocks)
    with counted(b, sum(size for _, size in merged), label) as k:
        if len(merged) < 2:
            yield k, _times(b, b.add(k, whole(merged[0][0] if merged else 0)), numbers.stride)
            return
        name = f"{b.function.name}.{label}"
        places = [place * numbers.stride for offset, size in merged for place in range(offset, offset + size)]
        table = b.function.module.globals.get(name)
        table = b.bitcast(table, I32.as_pointer()) if table else table_of(b, name, places)
        yield k, b.sext(b.load(b.gep(table, [k], source_etype=I32), typ=I32), I64)


def _times(b: Any, index: Any, stride: int) -> Any:
    return index if stride == 1 else b.mul(index, whole(stride))


def _copy_block(b: Any, source: Any, target: Any, size: int) -> None:
    """Doubles that stand side by side, some at a time."""
    wide = ir.VectorType(F64, _AT_ONCE)
    with counted(b, size // _AT_ONCE, "some") as k:
        place = b.mul(k, whole(_AT_ONCE))
        taken, put = (b.bitcast(at(b, base, place), wide.as_pointer()) for base in (source, target))
        b.store(b.load(taken, typ=wide, align=8), put, align=8)
    for k in range(size - size % _AT_ONCE, size):
        store(b, load(b, source, k), target, k)


def _merged(blocks: Blocks) -> list[tuple[int, int]]:
    """Blocks that stand side by side as one."""
    merged: list[tuple[int, int]] = []
    for offset, size in blocks:
        if merged and sum(merged[-1]) == offset:
            offset, size = merged[-1][0], merged.pop()[1] + size  # noqa: PLW2901
        merged.append((offset, size))
    return merged
