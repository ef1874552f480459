"""Which instants of a step a native loop writes: samples that are due, and points at which conditions are looked at.

Both come from the dense output of the step. Samples are asked for by their time; points that are looked at lie at equal
shares of each step, its end included, so that they are as dense as the motion needs.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from tmodes.compile.ir.emit import F64, I64, POINTER, at, load, number, store, whole

__all__ = ["SEEN", "due_samples", "is_due"]

SEEN = ("time", "segment")
"""What stands before each state in the argument ``seen``; the first number of all is how many of them there are."""


def is_due(loop: Any, until: Any) -> Any:
    """Whether a sample is left and its time is not after ``until``; the time is read only where one is left."""
    b = loop.builder
    left = b.icmp_signed("<", loop.integer("sample"), loop.argument["samples"])
    index = b.select(left, loop.integer("sample"), whole(0))
    return b.and_(left, b.fcmp_ordered("<=", load(b, loop.argument["times"], index), until))


@contextmanager
def due_samples(loop: Any, until: Any, end: Any) -> Iterator[Any]:
    """For each instant to be written of the step that goes to ``end``: yields where; ``loop.sample_time()`` is when.

    ``until``: the last time at which a sample is due in this step.
    """
    b = loop.builder
    due = _Due(loop)
    names = ("check", "sample", "looking", "look", "write", "sampled", "looked", "done")
    block = {name: loop.block(f"due_{name}") for name in names}
    b.branch(block["check"])
    b.position_at_end(block["check"])
    b.cbranch(is_due(loop, until), block["sample"], block["looking"])
    b.position_at_end(block["sample"])
    due.point_at_sample()
    b.branch(block["write"])
    b.position_at_end(block["looking"])
    b.cbranch(due.looks_on(), block["look"], block["done"])
    b.position_at_end(block["look"])
    due.point_at_look(end)
    b.branch(block["write"])
    b.position_at_end(block["write"])
    yield b.load(due.place, typ=POINTER)
    b.cbranch(b.fcmp_ordered(">", due.number(), number(0.0)), block["looked"], block["sampled"])
    b.position_at_end(block["looked"])
    due.count_look()
    b.branch(block["looking"])
    b.position_at_end(block["sampled"])
    due.count_sample()
    b.branch(block["check"])
    b.position_at_end(block["done"])


class _Due:
    """Where the next instant is written; the cell ``look`` counts those that are looked at, 0 while samples are due."""

    def __init__(self, loop: Any) -> None:
        self.loop, self.b = loop, loop.builder
        self.look = loop.local("look")
        with self.b.goto_entry_block():
            self.place = self.b.alloca(POINTER, name="place")
        self.b.store(number(0.0), self.look)

    def number(self) -> Any:
        return self.b.load(self.look, typ=F64)

    def looks_on(self) -> Any:
        """Whether another point of the step is looked at."""
        return self.b.fcmp_ordered("<", self.number(), self.loop.option("looks"))

    def point_at_sample(self) -> None:
        loop, b = self.loop, self.b
        b.store(load(b, loop.argument["times"], loop.integer("sample")), loop.due)
        b.store(loop.sample_row("out"), self.place)

    def point_at_look(self, end: Any) -> None:
        """The next point of the step; its row begins with its time and the segment of the input."""
        loop, b, looks = self.loop, self.b, self.loop.option("looks")
        count = b.fadd(self.number(), number(1.0))
        b.store(count, self.look)
        time = loop.get("t")
        inside = b.fadd(time, b.fmul(b.fdiv(count, looks), b.fsub(end, time)))
        time = b.select(b.fcmp_ordered("<", count, looks), inside, end)
        b.store(time, loop.due)
        row = self._seen_row()
        store(b, time, row, 0)
        store(b, loop.get("segment"), row, 1)
        b.store(at(b, row, len(SEEN)), self.place)

    def _seen_row(self) -> Any:
        loop, b = self.loop, self.b
        index = b.fptosi(load(b, loop.argument["seen"], 0), I64)
        return at(b, loop.argument["seen"], b.add(whole(1), b.mul(index, whole(loop.size + len(SEEN)))))

    def count_look(self) -> None:
        b, seen = self.b, self.loop.argument["seen"]
        store(b, b.fadd(load(b, seen, 0), number(1.0)), seen, 0)

    def count_sample(self) -> None:
        self.loop.add("sample", 1.0)
