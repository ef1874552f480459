"""Samples of runs side by side: which are due in a step, written, or reduced at once."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import I64, at, counted, load, store, whole
from tmodes.compile.lanes.lanes_loop import LanesLoop
from tmodes.compile.native import WIDTH

__all__ = ["SUMS", "due_samples", "fold", "write_rows", "write_sample"]


@contextmanager
def due_samples(loop: LanesLoop, who: Any, until: Any) -> Iterator[tuple[Any, Any]]:
    """As long as samples of the lanes ``who`` are due: yields in which lanes, and their times."""
    b: Any = loop.builder
    check, write, done = loop.block("sample_check"), loop.block("sample_write"), loop.block("sample_done")
    b.branch(check)
    b.position_at_end(check)
    left, time = _next_samples(loop)
    due = b.and_(b.and_(who, left), b.fcmp_ordered("<=", time, until))
    if loop.series is not None:  # at a knot the next row is that of the sample
        due = b.and_(due, b.or_(b.fcmp_ordered("<", time, loop.get("end")), loop.in_last_segment()))
    b.cbranch(loop.any(due), write, done)
    b.position_at_end(write)
    yield due, time
    loop.count("sample", due)
    b.branch(check)
    b.position_at_end(done)


def _next_samples(loop: LanesLoop) -> tuple[Any, Any]:
    """In which lanes a sample is left, and its time; the last time where none is."""
    b: Any = loop.builder
    time = left = None
    for lane in range(WIDTH):
        index = b.fptosi(b.extract_element(loop.get("sample"), whole(lane)), I64)
        some = b.icmp_signed("<", index, loop.argument["samples"])
        value = load(b, loop.argument["times"], b.select(some, index, whole(0)))
        time = b.insert_element(loop.constant(0.0) if time is None else time, value, whole(lane))
        none = ir.Constant(ir.VectorType(ir.IntType(1), WIDTH), [0] * WIDTH)
        left = b.insert_element(none if left is None else left, some, whole(lane))
    return left, time


def write_sample(loop: LanesLoop, due: Any, time: Any, value_of: Any) -> None:
    """Write ``value_of(i)`` of all components, or the series of that state, as the next sample of the lanes ``due``."""
    with counted(loop.builder, loop.size) as i:
        loop.store(value_of(i), "shown", i)
    if loop.series is None:
        write_rows(loop, due, "shown", loop.size)
        return
    _show(loop, loop.series.rate, loop.series.given, time)
    if not loop.series.folds:
        write_rows(loop, due, "series", loop.series.rate.size)
        return
    weight = _of_sample(loop, lambda lane, sample: at(loop.builder, loop.argument["weights"], sample))
    loop.array["sums"] = loop.argument["sums"]
    with counted(loop.builder, loop.series.rate.size, "series") as i:
        fold(loop, i, due, time, weight)


def write_rows(loop: LanesLoop, due: Any, label: str, size: int) -> None:
    """Write the numbers of an array into the next samples of the lanes ``due``."""
    b: Any = loop.builder
    for lane in range(WIDTH):
        with b.if_then(b.extract_element(due, whole(lane))):
            index = b.fptosi(b.extract_element(loop.get("sample"), whole(lane)), I64)
            place = b.fptosi(load(b, loop.argument["places"], lane), I64)
            index = b.add(index, b.mul(loop.argument["samples"], place))
            target = at(b, loop.argument["out"], b.mul(index, whole(size)))
            with counted(b, size) as i:
                store(b, load(b, loop.array[label], b.add(b.mul(i, whole(WIDTH)), whole(lane))), target, i)


SUMS = ("largest", "least", "sum", "squares", "end", "time")
"""What a series is reduced to: its largest and least value, the sums of its values and of their squares by the weights
of the samples, its last value, and the time of the largest. For each series a vector of each of them."""


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
