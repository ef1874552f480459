"""What the loops at fixed step share: each segment is parted into equal steps not longer than the option ``step``."""

from __future__ import annotations

from typing import Any, NamedTuple

from llvmlite import ir

from tmodes.compile.ir.emit import F64, number
from tmodes.compile.loops.time_loop import TimeLoop

__all__ = ["FixedStep", "next_step", "take_step"]


class FixedStep(NamedTuple):
    """A step of length h from ``time`` to ``time_after``; ``count`` of its segment with it, ``last``: it ends it."""

    h: Any
    time: Any
    time_after: Any
    count: Any
    last: Any


def next_step(loop: TimeLoop) -> FixedStep:
    """The step that comes; its length is put into the cell ``h``."""
    b = loop.builder
    start, end = loop.knot(0), loop.knot(1)
    length = b.fsub(end, start)
    ratio = b.fdiv(length, loop.option("step"))
    steps = loop.intrinsic("maxnum", loop.intrinsic("ceil", b.fmul(ratio, number(1 - 1e-12))), number(1.0))
    h = b.fdiv(length, steps)
    time, count = loop.get("t"), b.fadd(loop.get("index"), number(1.0))
    last = b.fcmp_ordered(">=", count, steps)
    time_after = b.select(last, end, b.fadd(start, b.fmul(count, h)))
    loop.put("h", h)
    return FixedStep(h, time, time_after, count, last)


def take_step(loop: TimeLoop, step: FixedStep) -> None:
    """The state ``new`` is where the next step starts; back to the begin of the loop."""
    b = loop.builder
    loop.copy("y", "new")
    loop.put("t", step.time_after)
    loop.count_step(step.h, ir.Constant(ir.IntType(1), 0))
    loop.add("done", 1.0)
    loop.put("index", b.select(step.last, number(0.0), step.count))
    loop.put("segment", b.fadd(loop.get("segment"), b.uitofp(step.last, F64)))
    b.branch(loop.again)
