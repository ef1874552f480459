"""Samples of runs side by side: which are due in a step, and where their numbers go."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.emit import I64, at, counted, load, store, whole
from tmodes.compile.lanes.lanes_loop import LanesLoop
from tmodes.compile.native import WIDTH

__all__ = ["due_samples", "write_rows", "write_sample"]


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
    else:
        loop.series.write(loop, due, time)


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
