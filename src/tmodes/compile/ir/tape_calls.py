"""Which calls of a schedule are needed for some outputs, and which of them follow from the parameters alone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["needed_calls", "settled_calls"]

Call = tuple[Any, tuple[Any, ...], tuple[Any, ...]]


def needed_calls(schedule: Any, slots: Sequence[Any]) -> list[Call]:
    """The calls that one of the blocks depends on, in their order."""
    wanted, calls = _Blocks(schedule, slots), []
    for call in reversed(schedule.calls):
        _, inputs, outputs = call
        if wanted.holds(outputs):
            calls.append(call)
            wanted.add(inputs)
    return calls[::-1]


def settled_calls(schedule: Any, calls: Sequence[Call]) -> set[int]:
    """Identities of calls whose inputs are parameters, or come from such calls.

    An output that depends on parameters alone is not known before its call, which may need more.
    """
    changing, settled = _Blocks(schedule, schedule.inputs.values()), set()
    for call in calls:
        _, inputs, outputs = call
        if changing.holds(inputs):
            changing.add(outputs)
        else:
            settled.add(id(call))
    return settled


class _Blocks:
    """Marked numbers of a schedule's workspace."""

    def __init__(self, schedule: Any, slots: Iterable[Any]) -> None:
        self.schedule = schedule
        self.marks: NDArray[np.bool_] = np.zeros(schedule.workspace, dtype=bool)
        self.add(slots)

    def add(self, slots: Iterable[Any]) -> None:
        """Mark blocks."""
        for slot in slots:
            self.marks[self._block(slot)] = True

    def holds(self, slots: Iterable[Any]) -> bool:
        """Whether a number of one of the blocks is marked."""
        return any(self.marks[self._block(slot)].any() for slot in slots)

    def _block(self, slot: Any) -> slice:
        start = self.schedule.offset(slot)
        return slice(start, start + slot.size)
