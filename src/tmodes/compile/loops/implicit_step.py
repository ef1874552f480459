"""One implicit pass of an arm's recursion, for loops whose steps iterate it.

Springs, dampers and servos are taken at the end of the step, through h D + h^2 K inside the recursion; all else where
the caller puts it.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import counted, load, number, store, whole
from tmodes.compile.loops.time_loop import TimeLoop
from tmodes.errors import CompileError

__all__ = ["ImplicitStep", "refuse_explicit_only"]


def refuse_explicit_only(name: str, rate: ScheduleRate) -> None:
    """Raise :class:`CompileError` for a schedule that has no place for a step's length or its start."""
    if rate.step_offset is None or rate.call_from is None:
        raise CompileError(f"{name}: the schedule has no inputs `step` and `start` for implicit steps")


class ImplicitStep:
    """Writes implicit evaluations; the loop has the arrays ``ahead`` (where all but springs is taken) and ``start``."""

    def __init__(self, loop: TimeLoop, rate: ScheduleRate, pairs: int) -> None:
        self.loop, self.rate, self.pairs, self.b = loop, rate, pairs, loop.builder

    def evaluate(self, time: Any, h: Any, into: str) -> None:
        """Rates at ``ahead`` of springs that start from ``start``, with h D + h^2 K added to the masses."""
        loop, b = self.loop, self.b
        store(b, h, loop.held, self.rate.step_offset)
        states = [loop.array["ahead"], loop.array["start"]]
        b.call(self.rate.call_from, [time, *states, loop.row(), loop.held, loop.array[into]])
        store(b, number(0.0), loop.held, self.rate.step_offset)
        loop.add("evaluations", 1.0)

    def advance(self, h: Any, state: str, slope: str) -> None:
        """``state`` moved on by h with its accelerations; coordinates follow the new rates."""
        b, n, x, found = self.b, self.pairs, self.loop.array[state], self.loop.array[slope]
        with counted(b, n, "pair") as i:
            paired = b.add(i, whole(n))
            rate = b.fadd(load(b, x, paired), b.fmul(h, load(b, found, paired)))
            store(b, rate, x, paired)
            store(b, b.fadd(load(b, x, i), b.fmul(h, rate)), x, i)
        with counted(b, self.loop.size - 2 * n, "rest") as i:
            place = b.add(i, whole(2 * n))
            store(b, b.fadd(load(b, x, place), b.fmul(h, load(b, found, place))), x, place)
