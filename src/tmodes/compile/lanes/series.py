"""Series of runs side by side: what is wanted of each sample is written, or reduced at once to a few sums.

Numbers behind the state, given for each sample, are what series compare with: a nominal tip, for one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import I64, at, counted, load, whole
from tmodes.compile.lanes.due import write_rows
from tmodes.compile.lanes.lanes_loop import LanesLoop
from tmodes.compile.native import WIDTH

__all__ = ["SUMS", "Folded", "Written", "fold"]

SUMS = ("largest", "least", "sum", "squares", "end", "time")
"""What a series is reduced to: its largest and least value, the sums of its values and of their squares by the weights
of the samples, its last value, and the time of the largest. For each series a vector of each of them."""


@dataclass(frozen=True)
class Written:
    """Series are written into the samples."""

    rate: ScheduleRate
    given: int

    def write(self, loop: LanesLoop, due: Any, time: Any) -> None:
        """Write those of the state in the array ``shown``."""
        _show(loop, self.rate, self.given, time)
        write_rows(loop, due, "series", self.rate.size)


@dataclass(frozen=True)
class Folded:
    """Series are reduced; no room is needed for samples."""

    rate: ScheduleRate
    given: int

    def write(self, loop: LanesLoop, due: Any, time: Any) -> None:
        """Take those of the state in the array ``shown``."""
        _show(loop, self.rate, self.given, time)
        weight = _of_sample(loop, lambda lane, sample: at(loop.builder, loop.argument["weights"], sample))
        loop.array["sums"] = loop.argument["sums"]
        with counted(loop.builder, self.rate.size, "series") as i:
            fold(loop, i, due, time, weight)


def fold(loop: Any, i: Any, due: Any, time: Any, weight: Any) -> None:
    """Take the value of series ``i`` in the lanes ``due``."""
    b: Any = loop.builder
    value, first = loop.load("series", i), b.mul(i, whole(len(SUMS)))

    def put(name: str, new: Any, where: Any = due) -> None:
        place = b.add(first, whole(SUMS.index(name)))
        loop.store(b.select(where, new, loop.load("sums", place)), "sums", place)

    def now(name: str) -> Any:
        return loop.load("sums", b.add(first, whole(SUMS.index(name))))

    larger = b.and_(due, b.fcmp_ordered(">", value, now("largest")))
    put("time", time, larger)
    put("largest", value, larger)
    put("least", value, b.and_(due, b.fcmp_ordered("<", value, now("least"))))
    weighted = b.fmul(weight, value)
    put("sum", b.fadd(now("sum"), weighted))
    put("squares", b.fadd(now("squares"), b.fmul(weighted, value)))
    put("end", value)


def _show(loop: LanesLoop, rate: ScheduleRate, given: int, time: Any) -> None:
    """The series of the state in ``shown``, with what is given for the sample of each lane behind it."""
    b: Any = loop.builder

    def place(lane: int, sample: Any) -> Any:
        start = b.add(b.mul(loop.argument["table_stride"], whole(lane)), b.mul(sample, whole(given)))
        return at(b, loop.argument["table"], start)

    for k in range(given):
        value = _of_sample(loop, lambda lane, sample, k=k: at(b, place(lane, sample), k))
        loop.store(value, "shown", whole(loop.size + k))
    loop.call(rate, time, "shown", "series", "showing")


def _of_sample(loop: LanesLoop, address: Any) -> Any:
    """Numbers of the next samples, at ``address(lane, sample)``; of the last sample where none is left."""
    b: Any = loop.builder
    value, last = loop.constant(0.0), b.sub(loop.argument["samples"], whole(1))
    for lane in range(WIDTH):
        index = b.fptosi(b.extract_element(loop.get("sample"), whole(lane)), I64)
        index = b.select(b.icmp_signed("<", index, last), index, last)
        value = b.insert_element(value, load(b, address(lane, index), whole(0)), whole(lane))
    return value
