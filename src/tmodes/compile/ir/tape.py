"""The calls of a schedule as tables of rows, forwards along directions or in reverse, that one small native loop runs.

Tables are data: a chain of a thousand joints costs no more native code than one of six.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.ir.calls import needed_calls, settled_calls
from tmodes.compile.ir.derivative_kernels import ADD, NONE, STORE, Adjoint, Elements, Tangent, reached, turned
from tmodes.compile.loops.tape_loop import RowTable

__all__ = ["Tape"]

Marks = NDArray[np.bool_]


class Tape:
    """The calls of a schedule that lead to the ``outputs`` named (all by default).

    Values and slopes stand as in the schedule's workspace: parameters, inputs, what is computed; behind it the outputs,
    one after the other, and sines and cosines that derivatives need. Every block is assigned once, so the values of a
    run are the tape of its reverse.
    ``settled`` calls follow from the parameters alone.
    """

    def __init__(self, schedule: Any, outputs: Sequence[str] | None = None) -> None:
        self.schedule = schedule
        names = list(schedule.outputs) if outputs is None else list(outputs)
        self.outputs = [slot for name in names for slot in schedule.outputs[name]]
        self.output_size = sum(slot.size for slot in self.outputs)
        self.end = schedule.workspace
        self.calls = needed_calls(schedule, self.outputs)
        self._angles, self.size = {}, self.end + self.output_size
        for call in self.calls:
            self._angles[id(call)] = self.size
            self.size += 2 * len(turned(call[0]))
        self.settled = settled_calls(schedule, self.calls)

    def marked(self, ranges: Sequence[tuple[int, int]]) -> Marks:
        """Marks of the workspace, set in ranges (start, size)."""
        marks = np.zeros(self.end, dtype=bool)
        for start, size in ranges:
            marks[start : start + size] = True
        return marks

    def span(self, name: str) -> tuple[int, int]:
        """Start and size of an input."""
        slot = self.schedule.inputs[name]
        return self.schedule.offset(slot), slot.size

    def values(self, *, settled: bool | None = None) -> RowTable:
        """Compute the calls, and gather the outputs; ``settled``: True, only calls that are, False, those that are not.

        The first alone gather no outputs.
        """
        table = RowTable()
        for call in self._chosen(settled):
            self._value(table, call)
        if settled is not True:
            for place, slot in self._gathered():
                table.operation("move_values", place, self.schedule.offset(slot), slot.size)
        return table

    def along(
        self,
        marks: Marks,
        lanes: int,
        *,
        valued: bool = False,
        target: int | None = None,
        seldom: bool = False,
        settled: bool | None = None,
    ) -> RowTable:
        """Slopes of the outputs, ``lanes`` side by side, along slopes of what is marked.

        ``valued``: compute the values as well. ``target``: where among the slopes the outputs' go, by default behind
        the workspace. ``seldom``: few calls are expected. ``settled`` as in :meth:`values`.
        """
        table, marks, straight = RowTable(), marks.copy(), {} if valued else self._last(lanes, target)
        before = self._dependence(marks, settled=True) if settled is False else marks
        marks |= before
        for call in self._chosen(settled):
            kernel, inputs, outputs = call
            active = tuple(self._elements(slot, marks) for slot in inputs)
            if not any(active):
                if valued:
                    self._value(table, call)
                continue
            info = reached(kernel, active)
            sloped = [lanes * self.schedule.offset(slot) for slot, own in zip(inputs, active, strict=True) if own]
            given = [lanes * self.schedule.offset(slot) for slot, own in zip(outputs, info, strict=True) if own]
            plain = [*inputs, *outputs] if valued else [*inputs]
            row = [*map(self.schedule.offset, plain), *sloped, *(straight.get(place, place) for place in given)]
            table.add(*Tangent(kernel, active, lanes, valued, seldom).library(), [*row, *self._turned(call)])
            for slot, elements in zip(outputs, info, strict=True):
                marks[self.schedule.offset(slot) + np.array(elements, dtype=int)] = True
        if settled is not True:
            self._gather(table, marks, lanes, target, valued=valued, done=straight)
        return table

    def _last(self, lanes: int, target: int | None) -> dict[int, int]:
        """Where slopes of outputs of one number that no call reads may be written at once, by where they belong."""
        moved = 0 if target is None else target - lanes * self.end
        places = {lanes * self.schedule.offset(slot): moved + lanes * place for place, slot in self._gathered()}
        return {start: places[start] for start in places if start // lanes in self._unread}

    def back(self, wanted: Marks, kept: Marks, *, settled: bool | None = None) -> RowTable:
        """Carry weights of the outputs to what is ``wanted``; where ``kept`` is set they add to what stands there.

        The outputs' weights stand behind the workspace, all others at the places of their values. ``settled``: True,
        the weights of what settled calls gave are carried on; False, they are gathered, with those ``kept``.
        """
        table, depends = RowTable(), self._dependence(wanted)
        known = kept | (self._given(settled=True) if settled is not None else False)
        for place, slot in self._gathered() if settled is not True else ():
            block = self.schedule.span(slot)
            start = block.start
            if depends[block].any():
                self._fill(table, known, block)
                table.operation("gain" if known[block].any() else "move", start, place, slot.size)
                known[block] = True
        for call in reversed(self._chosen(settled)):
            self._call_back(table, call, depends, known)
        for start in np.flatnonzero(wanted & ~known).tolist():
            table.operation("clear", start, 1)
        return table

    def _call_back(self, table: RowTable, call: Any, depends: Marks, known: Marks) -> None:
        kernel, inputs, outputs = call
        blocks = [self.schedule.span(slot) for slot in outputs]
        seeded = tuple(bool((known & depends)[block].any()) for block in blocks)
        used = [bool(depends[self.schedule.span(slot)].any()) for slot in inputs]
        if not any(seeded) or not any(used):
            return
        for block, seed in zip(blocks, seeded, strict=True):
            if seed:
                self._fill(table, known, block, whole=True)
        modes = []
        for slot, use in zip(inputs, used, strict=True):
            block = self.schedule.span(slot)
            modes.append(NONE if not use else ADD if known[block].any() else STORE)
            if use:
                self._fill(table, known, block)
                known[block] = True
        slots = [slot for slot, seed in zip(outputs, seeded, strict=True) if seed]
        slots += [slot for slot, use in zip(inputs, used, strict=True) if use]
        row = [*(self.schedule.offset(slot) for slot in (*inputs, *slots)), *self._turned(call)]
        table.add(*Adjoint(kernel, seeded, tuple(modes)).library(), row)

    def _fill(self, table: RowTable, known: Marks, block: slice, *, whole: bool = False) -> None:
        """Zero where a block is known in part: what is added to it, or read from it, finds a number everywhere."""
        if known[block].any() or whole:
            for start in np.flatnonzero(~known[block]).tolist():
                table.operation("clear", block.start + start, 1)
            known[block] = True

    def _chosen(self, settled: bool | None) -> list[Any]:
        return [call for call in self.calls if settled is None or settled == (id(call) in self.settled)]

    def _given(self, *, settled: bool) -> Marks:
        """What calls give."""
        slots = [slot for _, _, outputs in self._chosen(settled) for slot in outputs]
        return self.marked([(self.schedule.offset(slot), slot.size) for slot in slots])

    def _dependence(self, marks: Marks, *, settled: bool | None = None) -> Marks:
        """What depends on what is marked."""
        marks = marks.copy()
        for call in self._chosen(settled):
            self._mark(call, marks)
        return marks

    def _mark(self, call: Any, marks: Marks) -> bool:
        """Mark what depends on marks in a call; whether anything does."""
        kernel, inputs, outputs = call
        active = tuple(self._elements(slot, marks) for slot in inputs)
        if not any(active):
            return False
        for slot, elements in zip(outputs, reached(kernel, active), strict=True):
            marks[self.schedule.offset(slot) + np.array(elements, dtype=int)] = True
        return True

    def _gather(
        self, table: RowTable, marks: Marks, lanes: int, target: int | None, *, valued: bool, done: dict[int, int]
    ) -> None:
        moved = 0 if target is None else target - lanes * self.end
        for place, slot in self._gathered():
            start, block = self.schedule.offset(slot), self.schedule.span(slot)
            if valued:
                table.operation("move_values", place, start, slot.size)
            if marks[block].all() and lanes * start in done:
                continue
            if marks[block].all():
                table.operation("move", moved + lanes * place, lanes * start, lanes * slot.size)
            else:
                table.operation("clear", moved + lanes * place, lanes * slot.size)
                for k in np.flatnonzero(marks[block]).tolist():
                    table.operation("move", moved + lanes * (place + k), lanes * (start + k), lanes)

    @cached_property
    def _unread(self) -> set[int]:
        """Where outputs of one number begin that a call gives, alone, and no other call reads."""
        taken = [slot for _, inputs, _ in self.calls for slot in inputs]
        read = self.marked([(self.schedule.offset(slot), slot.size) for slot in taken])
        starts = [self.schedule.offset(slot) for slot in self.outputs if slot.size == 1]
        given = {self.schedule.offset(slot) for _, _, outputs in self.calls for slot in outputs if slot.size == 1}
        return {start for start in starts if start in given and not read[start] and starts.count(start) == 1}

    def _gathered(self) -> Iterator[tuple[int, Any]]:
        place = self.end
        for slot in self.outputs:
            yield place, slot
            place += slot.size

    def _value(self, table: RowTable, call: Any) -> None:
        kernel, inputs, outputs = call
        variant = Tangent(kernel, tuple(() for _ in inputs), 1, valued=True)
        row = [*(self.schedule.offset(slot) for slot in (*inputs, *outputs)), *self._turned(call)]
        table.add(*variant.library(), row)

    def _turned(self, call: Any) -> list[int]:
        """Where the sines and cosines of a call stand, if it has any."""
        return [self._angles[id(call)]] if turned(call[0]) else []

    def _elements(self, slot: Any, marks: Marks) -> Elements:
        return tuple(np.flatnonzero(marks[self.schedule.span(slot)]).tolist())
