"""The calls of a schedule: one by one, or, where they are many, as data and a loop.

The data say which kernel, and where its blocks begin in the workspace. So the code is as long as there are kinds of
kernels, and not calls: a thousand joints take no longer to compile than two hundred.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.emit import I64, POINTER, VOID, at, declare, whole

__all__ = ["DIRECT", "I32", "Layout", "needed_calls", "settled_calls", "table_of", "write_calls"]

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


class Layout:
    """Places of the blocks: parameters first, then what changes, packed by first fit over the calls."""

    def __init__(self, schedule: Any) -> None:
        self._parameters = schedule.parameters
        self._starts: list[int] = []
        self._sizes: dict[int, int] = {}
        for slot in [*schedule.inputs.values(), *(out for _, _, outs in schedule.calls for out in outs)]:
            if slot.size:
                self._starts.append(slot.start)
                self._sizes[slot.start] = slot.size
        self._starts.sort()
        self._places: dict[int, int] = {}
        self._free: list[tuple[int, int]] = []
        self._end = 0
        self._pack(schedule)

    @property
    def workspace(self) -> int:
        """Numbers of the whole workspace."""
        return self._parameters + self._end

    def offset(self, slot: Any) -> int:
        """Where a block, or a part of one, begins."""
        if slot.region == "parameters" or not slot.size:
            return slot.start if slot.region == "parameters" else 0
        block = self._block(slot)
        return self._parameters + self._places[block] + slot.start - block

    def _block(self, slot: Any) -> int:
        """Start, in the schedule, of the block that holds a slot."""
        block = self._starts[bisect_right(self._starts, slot.start) - 1]
        assert slot.start + slot.size <= block + self._sizes[block], f"{slot} in two blocks"  # noqa: S101
        return block

    def _blocks(self, slots: Iterable[Any]) -> list[int]:
        return [self._block(slot) for slot in slots if slot.region == "changing" and slot.size]

    def _pack(self, schedule: Any) -> None:
        """Room for each block from the call that writes it to the last that reads it; outputs stay to the end."""
        last: dict[int, int] = {}
        for index, (_, inputs, outputs) in enumerate(schedule.calls):
            last |= dict.fromkeys(self._blocks((*inputs, *outputs)), index)
        kept = [slot for slots in schedule.outputs.values() for slot in slots]
        kept += schedule.watched
        kept += [schedule.inputs["step"]] if "step" in schedule.inputs else []  # set once, before all calls
        last |= dict.fromkeys(self._blocks(kept), len(schedule.calls))
        for block in self._blocks(schedule.inputs.values()):
            self._take(block)
        for index, (_, inputs, outputs) in enumerate(schedule.calls):
            for block in self._blocks(outputs):
                self._take(block)
            for block in {*self._blocks((*inputs, *outputs))}:
                if last[block] == index:
                    self._give_back(block)

    def _take(self, block: int) -> None:
        size = self._sizes[block]
        for index, (start, room) in enumerate(self._free):
            if room >= size:
                self._places[block] = start
                self._free[index : index + 1] = [(start + size, room - size)] if room > size else []
                return
        self._places[block] = self._end
        self._end += size

    def _give_back(self, block: int) -> None:
        """Free the room of a block, joined with the free room next to it."""
        self._free = sorted([*self._free, (self._places[block], self._sizes[block])])
        joined = self._free[:1]
        for start, room in self._free[1:]:
            before, length = joined[-1]
            if before + length == start:
                joined[-1] = (before, length + room)
            else:
                joined.append((start, room))
        self._free = joined


Call = tuple[Any, tuple[Any, ...], tuple[Any, ...]]


def needed_calls(schedule: Any, slots: Sequence[Any]) -> list[Call]:
    """The calls that one of the blocks depends on, in their order."""
    wanted, calls = _marked(schedule, slots), []
    for call in reversed(schedule.calls):
        _, inputs, outputs = call
        if any(wanted[schedule.span(slot)].any() for slot in outputs):
            calls.append(call)
            for slot in inputs:
                wanted[schedule.span(slot)] = True
    return calls[::-1]


def settled_calls(schedule: Any, calls: Sequence[Call]) -> set[int]:
    """Identities of calls whose inputs are parameters, or come from such calls.

    An output that depends on parameters alone is not known before its call, which may need more.
    """
    changing, settled = _marked(schedule, schedule.inputs.values()), set()
    for call in calls:
        _, inputs, outputs = call
        if any(changing[schedule.span(slot)].any() for slot in inputs):
            for slot in outputs:
                changing[schedule.span(slot)] = True
        else:
            settled.add(id(call))
    return settled


def _marked(schedule: Any, slots: Iterable[Any]) -> NDArray[np.bool_]:
    """Marks of a schedule's workspace, set in some blocks."""
    marks = np.zeros(schedule.workspace, dtype=bool)
    for slot in slots:
        marks[schedule.span(slot)] = True
    return marks
