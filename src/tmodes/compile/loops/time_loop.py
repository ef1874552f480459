"""What every native time loop shares: its arguments, its memory between calls, and its written samples.

A loop runs until all samples are written, the run fails, or ``chunk`` steps are done; called again it resumes from its
memory as if it had never stopped, so progress, interruption and checkpoints change no bit of the result.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from enum import IntEnum
from typing import Any, NamedTuple

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import F64, I64, POINTER, at, counted, load, number, scratch, store, whole
from tmodes.compile.loops.frame import Frame
from tmodes.compile.loops.switches import switch

__all__ = ["ARGUMENTS", "CELLS", "OPTIONS", "SEEN", "AdaptiveStep", "Status", "TimeLoop", "due_samples", "is_due"]

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


CELLS = (
    "t", "h", "segment", "index", "sample", "fresh", "old_error", "steps", "rejected", "evaluations", "status",
    "smallest", "stiff", "calm", "stiff_time", "events", "burst", "burst_time", "passes", "sampled", "switching",
    "wish", "switches", "cut", "errors", "pause", "met", "few",
)  # fmt: skip
"""Memory of a loop between calls, one double each.

``sampled``: segments whose samples of controllers are taken. ``switching``: a change of a mode was met, ``switches``
counts them, ``wish`` is the length of a step before it was shortened onto one, ``cut`` that of a fixed step after it.
``errors``: sum of the estimated errors of the steps that were taken, over their tolerance. ``pause``: not 0 ends a call
after each instant at which a force starts or ends, or something switches; ``met`` is 2 then, and ``k1`` the state
before the switch. The caller sets ``met`` to 0. ``few``: longest step of few rows, of extrapolation.
"""

OPTIONS = ("step", "rtol", "atol", "chunk", "bound", "watch", "most_events", "event_time", "looks")
"""Settings of a loop.

``bound``: the largest coordinate or rate that still counts as motion; ``watch``: not 0 ends an explicit loop where the
motion turns out stiff; ``most_events``: how often a contact may change within ``event_time`` [s]; ``looks``: points of
each step that are written to ``seen`` for stop conditions.
"""

ARGUMENTS = (
    "memory", "y", "k1", "p", "knots", "rows", "times", "out", "options", "seen", "segments",
    "samples",
)  # fmt: skip
"""Arguments of a loop, in order; the last two are int64, the others point to doubles.

``seen`` (1 + points (2 + size),): how many points of steps were looked at, then of each its time, segment and state.
"""


class Status(IntEnum):
    """How a call of a loop ended."""

    RUNNING = 0
    FINISHED = 1
    DIVERGED = 2
    STEP_TOO_SMALL = 3
    NOT_CONVERGED = 4
    OUT_OF_STEPS = 5
    STIFF = 6
    CHATTERING = 7
    STOPPED_BY_CONDITION = 8


class AdaptiveStep(NamedTuple):
    """A step of length h from ``time`` to ``time_after``; ``wanted``: its length if no knot had cut it (``last``)."""

    time: Any
    wanted: Any
    h: Any
    last: Any
    time_after: Any


class TimeLoop(Frame):
    """The loop of one run: mutable cells, scratch arrays, and the blocks ``again`` and ``leave``."""

    def __init__(self, module: Any, name: str, rate: ScheduleRate, scratch_arrays: Sequence[str], guarded: int) -> None:
        """``guarded``: how many of the first components of the state are watched for divergence."""
        kinds = [(label, I64 if label in ("segments", "samples") else POINTER) for label in ARGUMENTS]
        super().__init__(name, rate, Double(module), kinds, guarded)
        b = self.builder
        self.cell = {label: self.local(label) for label in (*CELLS, "done", "total")}
        self.array |= {label: scratch(b, self.size, label) for label in scratch_arrays}
        self.array["held"] = scratch(b, rate.held_size, "held")
        b.call(rate.prepare, [self.argument["p"], self.array["held"]])
        if rate.sampled is not None:
            self.array["sampling"] = scratch(b, rate.sampled.held_size, "sampling")
            self.array["after"] = scratch(b, self.size, "after")
            b.call(rate.sampled.prepare, [self.argument["p"], self.array["sampling"]])
        self.known = self.local("known")
        b.store(number(0.0), self.known)
        if rate.switched is not None:
            self.array["settling"] = scratch(b, rate.switched.held_size, "settling")
            self.array["after"] = scratch(b, self.size, "after")
            b.call(rate.switched.prepare, [self.argument["p"], self.array["settling"]])
        self.begun = self.local("begun")
        for slot, label in enumerate(CELLS):
            self.put(label, load(b, self.argument["memory"], slot))
        self.put("done", number(0.0))
        self.due = self.local("due")
        self.again, self.leave = self.block("again"), self.block("leave")
        b.branch(self.again)
        b.position_at_end(self.leave)
        for slot, label in enumerate(CELLS):
            store(b, self.get(label), self.argument["memory"], slot)
        b.ret_void()
        b.position_at_end(self.again)
        over = b.icmp_signed(">=", self.integer("segment"), self.argument["segments"])
        self.stop_if(over, Status.FINISHED)
        self.stop_if(b.fcmp_ordered(">=", self.get("done"), self.option("chunk")), Status.RUNNING)
        self._sample()

    def _sample(self) -> None:
        """At the start of each segment, once: the state after the samples there; what the jump of a signal ends."""
        b, sampled, switched = self.builder, self.rate.sampled, self.rate.switched
        if sampled is None and switched is None:
            self._pause()
            return
        if self.rate.jolts:
            b.store(number(0.0), self.begun)
        after = b.fadd(self.get("segment"), number(1.0))
        with b.if_then(b.fcmp_ordered(">", after, self.get("sampled")), likely=False):
            if sampled is not None:
                self.call(sampled, self.get("t"), "y", "after", "sampling")
                self.copy("y", "after")
            self.put("sampled", after)
            self.put("switching", number(1.0))
            if self.rate.jolts:
                b.store(number(1.0), self.begun)
        switch(self, Status.CHATTERING)
        if self.rate.jolts:
            self._show_again()
        self._pause()

    def _show_again(self) -> None:
        """A sample at a knot is of the state after the switches there."""
        b = self.builder
        shown = b.icmp_signed(">", self.integer("sample"), whole(0))
        last = b.sub(b.select(shown, self.integer("sample"), whole(1)), whole(1))
        here = b.fcmp_ordered("==", load(b, self.argument["times"], last), self.get("t"))
        with b.if_then(b.and_(b.and_(shown, here), b.fcmp_ordered(">", b.load(self.begun, typ=F64), number(0.0)))):
            self.array["shown"] = at(b, self.argument["out"], b.mul(last, whole(self.size)))
            self.copy("shown", "y")

    def _pause(self) -> None:
        """Leave after an instant at which something changed, where that is wanted."""
        if not self.rate.changes:
            return
        b = self.builder
        met = b.fcmp_ordered("==", self.get("met"), number(1.0))
        wanted = b.and_(b.fcmp_ordered(">", self.get("pause"), number(0.0)), met)
        with b.if_then(wanted, likely=False):
            self.put("met", number(2.0))
        self.stop_if(wanted, Status.RUNNING)

    def step_until(self, end: Any) -> tuple[Any, Any, Any]:
        """Length of the next step, whether it ends on ``end``, and the time after it; fails where it is too short."""
        b = self.builder
        time, wanted = self.get("t"), self.get("h")
        reach = b.fmul(number(1.0001), wanted)
        if self.rate.switch_count:  # a step that was shortened onto a switch stays short of the end
            reach = b.select(b.fcmp_ordered(">", self.get("wish"), number(0.0)), wanted, reach)
        last = b.fcmp_ordered(">=", b.fadd(time, reach), end)
        h = b.select(last, b.fsub(end, time), wanted)
        smallest = b.fmul(number(4e-15), self.intrinsic("fabs", end))
        self.stop_if(b.not_(b.fcmp_ordered(">", h, smallest)), Status.STEP_TOO_SMALL)
        return h, last, b.select(last, end, b.fadd(time, h))

    def judge(self, error: Any, h: Any, factor: Callable[[], Any], smallest: float, wish: str = "h") -> None:
        """Where the error is beyond 1, or no number, try again with h times the factor, or shrunk the most.

        ``wish``: the cell that keeps that length.
        """
        b = self.builder
        accepted, rejected = self.block("accepted"), self.block("rejected")
        b.cbranch(b.fcmp_ordered("<=", error, number(1.0)), accepted, rejected)
        b.position_at_end(rejected)
        share = factor()
        usable = b.fcmp_ordered(">", share, number(smallest))
        self.put(wish, b.fmul(h, b.select(usable, share, number(smallest))))
        self.add("rejected", 1.0)
        b.branch(self.again)
        b.position_at_end(accepted)

    def take(self, step: AdaptiveStep, grown: Any) -> None:
        """Take a step to ``new``; ``grown``: the length that its error allows the next one."""
        b = self.builder
        # A step cut short by a knot says little about the next: keep the longer wish.
        self.put("h", b.select(step.last, self.intrinsic("maxnum", grown, step.wanted), grown))
        self.copy("y", "new")
        self.put("t", step.time_after)
        self.put("segment", b.fadd(self.get("segment"), b.uitofp(step.last, F64)))
        self.count_step(step.h, step.last)

    def due_samples(self, until: Any, end: Any = None) -> AbstractContextManager[Any]:
        """For each instant of a step to ``end`` (None: ``until``) that is to be written: yields where."""
        return due_samples(self, until, until if end is None else end)

    def count_step(self, h: Any, cut: Any) -> None:
        """Count a step of length h; the smallest of all that were not ``cut`` short is kept."""
        b = self.builder
        smallest = self.get("smallest")
        first = b.fcmp_ordered("==", smallest, number(0.0))
        least = b.select(first, h, self.intrinsic("minnum", smallest, h))
        self.put("smallest", b.select(cut, smallest, least))
        self.add("steps", 1.0)

    def put(self, label: str, value: Any) -> None:
        """Set a cell."""
        self.builder.store(value, self.cell[label])

    def add(self, label: str, amount: float) -> None:
        """Add to a cell."""
        self.put(label, self.builder.fadd(self.get(label), number(amount)))

    def option(self, label: str) -> Any:
        """Value of an option."""
        return load(self.builder, self.argument["options"], OPTIONS.index(label))

    def integer(self, label: str) -> Any:
        """A cell as an int64."""
        return self.builder.fptosi(self.get(label), I64)

    def stop_if(self, condition: Any, status: Status) -> None:
        """Leave the loop with a status where the condition holds."""
        stop, on = self.block(f"stop_{status.name.lower()}"), self.block("on")
        self.builder.cbranch(condition, stop, on)
        self.builder.position_at_end(stop)
        self.put("status", number(float(status)))
        self.builder.branch(self.leave)
        self.builder.position_at_end(on)

    def row(self) -> Any:
        """Address of the signals' row of the current segment."""
        return at(self.builder, self.argument["rows"], self.builder.mul(self.integer("segment"), whole(self.rate.row)))

    def segment(self) -> tuple[Any, Any]:
        """Times at which the present segment of the input starts and ends."""
        b, index = self.builder, self.integer("segment")
        start, end = (load(b, self.argument["knots"], b.add(index, whole(ahead))) for ahead in range(2))
        return start, end

    def evaluate(self, time: Any, state: str, into: str) -> None:
        """Right-hand side at a state array, into an array."""
        self.call(self.rate, time, state, into)
        self.add("evaluations", 1.0)

    def copy(self, into: str, source: str) -> None:
        """``into = source`` for whole arrays."""
        with counted(self.builder, self.size) as i:
            self.store(self.load(source, i), into, i)

    def sample_due(self, until: Any) -> Any:
        """Whether anything is to be written of a step that goes ``until`` then."""
        looks = self.builder.fcmp_ordered(">", self.option("looks"), number(0.0))
        return self.builder.or_(looks, is_due(self, until))

    def sample_time(self) -> Any:
        """Time of the instant that is written."""
        return self.builder.load(self.due, typ=F64)

    def sample_row(self, label: str) -> Any:
        """Where the next sample is written in an array of samples."""
        index = self.builder.mul(self.integer("sample"), whole(self.size))
        return at(self.builder, self.argument[label], index)
