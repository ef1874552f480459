"""Numbers into the blocks of a workspace and out again: rows of samples, and the parameters."""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from tmodes.compile.ir.calls import I32, table_of
from tmodes.compile.ir.emit import F64, I64, at, counted, load, store, whole

__all__ = ["copy_rows", "spread_parameters"]

_FEW_BLOCKS = 4
_AT_ONCE = 8


def spread_parameters(b: Any, source: Any, workspace: Any, size: int, width: int, *, same: bool = False) -> None:
    """Parameters at the start of the workspace; next to each, its copies (``same``) or derivatives, which are zero."""
    with counted(b, size, "parameter") as k:
        place, value = b.mul(k, whole(width)), load(b, source, k)
        store(b, value, workspace, place)
        for lane in range(1, width):
            store(b, value if same else ir.Constant(F64, 0.0), workspace, b.add(place, whole(lane)))


def copy_rows(b: Any, rows: Any, workspace: Any, blocks: list[tuple[int, int]], width: int, *, into: bool) -> None:
    """``width`` rows, one after the other, into or out of blocks of the workspace whose numbers are ``width`` wide."""
    length = sum(size for _, size in blocks)
    blocks = _merged(blocks)
    if len(blocks) > _FEW_BLOCKS:
        _copy_by_table(b, rows, workspace, blocks, width, into=into)
        return
    first = 0
    if width == 1:
        for offset, size in blocks:
            paired, place = at(b, rows, first), at(b, workspace, offset)
            source, target = (paired, place) if into else (place, paired)
            _copy_block(b, source, target, size)
            first += size
        return
    for offset, size in blocks:
        with counted(b, size, "block") as k:
            for lane in range(width):
                paired = b.add(k, whole(lane * length + first))
                place = b.add(b.mul(k, whole(width)), whole(offset * width + lane))
                if into:
                    store(b, load(b, rows, paired), workspace, place)
                else:
                    store(b, load(b, workspace, place), rows, paired)
        first += size


def _copy_block(b: Any, source: Any, target: Any, size: int) -> None:
    """Numbers that stand side by side, some at a time."""
    wide = ir.VectorType(F64, _AT_ONCE)
    with counted(b, size // _AT_ONCE, "some") as k:
        place = b.mul(k, whole(_AT_ONCE))
        taken, put = (b.bitcast(at(b, base, place), wide.as_pointer()) for base in (source, target))
        b.store(b.load(taken, typ=wide, align=8), put, align=8)
    for k in range(size - size % _AT_ONCE, size):
        store(b, load(b, source, k), target, k)


def _merged(blocks: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Blocks that stand side by side as one."""
    merged: list[tuple[int, int]] = []
    for offset, size in blocks:
        if merged and sum(merged[-1]) == offset:
            offset, size = merged[-1][0], merged.pop()[1] + size  # noqa: PLW2901
        merged.append((offset, size))
    return merged


def _copy_by_table(b: Any, rows: Any, workspace: Any, blocks: list[tuple[int, int]], width: int, *, into: bool) -> None:
    """The same number by number, the places in a table: the code does not grow with the number of blocks."""
    places = [place * width for offset, size in blocks for place in range(offset, offset + size)]
    table = table_of(b, f"{b.function.name}.{'in' if into else 'out'}", places)
    with counted(b, len(places), "number") as k:
        place = b.sext(b.load(b.gep(table, [k], source_etype=I32), typ=I32), I64)
        for lane in range(width):
            paired, there = b.add(k, whole(lane * len(places))), b.add(place, whole(lane))
            if into:
                store(b, load(b, rows, paired), workspace, there)
            else:
                store(b, load(b, workspace, there), rows, paired)
