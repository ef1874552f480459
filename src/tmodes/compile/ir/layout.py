"""Where the blocks of a schedule lie in the lanes' workspace: a block takes the room of one that is read no more.

Lanes want many times the memory of one run; what does not fit the processor's nearest cache is waited for.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable
from typing import Any

__all__ = ["Layout"]


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
        kept += [schedule.gate] if schedule.gate else []
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
