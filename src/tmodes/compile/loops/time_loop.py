"""What every native time loop shares: its arguments, its memory between calls, and its written samples.

A loop runs until all samples are written, the run fails, or ``chunk`` steps are done; called again it resumes from its
memory as if it had never stopped, so progress, interruption and checkpoints change no bit of the result.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager
from enum import IntEnum
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, at, counted, declare, load, number, scratch, store, whole
from tmodes.compile.ir.lower import Lowered
from tmodes.compile.loops.due_samples import due_samples, is_due

__all__ = ["ARGUMENTS", "CELLS", "OPTIONS", "Status", "TimeLoop"]

CELLS = (
    "t", "h", "segment", "index", "sample", "fresh", "old_error", "steps", "rejected", "evaluations", "status",
    "smallest", "stiff", "calm", "stiff_time", "events", "burst", "burst_time", "passes", "sampled",
)  # fmt: skip
"""Memory of a loop between calls, one double each; ``sampled``: segments whose samples of controllers are taken."""

OPTIONS = ("step", "rtol", "atol", "chunk", "bound", "watch", "most_events", "event_time", "looks")
"""Settings of a loop.

``bound``: the largest coordinate or rate that still counts as motion; ``watch``: not 0 ends an explicit loop where the
motion turns out stiff; ``most_events``: how often a contact may change within ``event_time`` [s]; ``looks``: points of
each step that are written to ``seen`` for stop conditions.
"""

ARGUMENTS = (
    "memory", "y", "k1", "p", "knots", "rows", "times", "out", "options", "errors", "errors_out", "seen", "segments",
    "samples",
)  # fmt: skip
"""Arguments of a loop, in order; the last two are int64, the others point to doubles.

``errors`` (size,) holds the sums of the sizes of all local errors, ``errors_out`` (samples, size) those at the samples.
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


class TimeLoop:
    """The frame of a time loop: arguments, mutable cells, scratch arrays, and the blocks ``again`` and ``leave``."""

    def __init__(
        self, module: Any, name: str, lowered: Lowered | ScheduleRate, scratch_arrays: Sequence[str], guarded: int
    ) -> None:
        """``guarded``: how many of the first components of the state are watched for divergence."""
        self.module, self.lowered, self.guarded = module, lowered, guarded
        self.size = lowered.size
        kinds = [(label, I64 if label in ("segments", "samples") else POINTER) for label in ARGUMENTS]
        self.function = declare(module, name, VOID, kinds)
        self.argument: dict[str, Any] = dict(zip(ARGUMENTS, self.function.args, strict=True))
        self.builder = ir.IRBuilder(self.function.append_basic_block("entry"))
        self.cell = {label: self.builder.alloca(F64, name=label) for label in (*CELLS, "done")}
        self.array = {label: scratch(self.builder, self.size, label) for label in scratch_arrays}
        self.array |= {"y": self.argument["y"], "k1": self.argument["k1"], "errors": self.argument["errors"]}
        self.held = scratch(self.builder, lowered.held_size, "held")
        self.builder.call(lowered.prepare, [self.argument["p"], self.held])
        self._sampling = self._prepared()
        for slot, label in enumerate(CELLS):
            self.put(label, load(self.builder, self.argument["memory"], slot))
        self.put("done", number(0.0))
        self.due = self.local("due")
        self.again, self.leave = self.block("again"), self.block("leave")
        self.builder.branch(self.again)
        self._write_leave()
        self.builder.position_at_end(self.again)
        self.stop_if(self.finished(), Status.FINISHED)
        self.stop_if(self.builder.fcmp_ordered(">=", self.get("done"), self.option("chunk")), Status.RUNNING)
        self._sample()

    def _prepared(self) -> Any:
        """The memory of what sampled controllers compute; None without one."""
        if (sampled := self.lowered.sampled) is None:
            return None
        held = scratch(self.builder, sampled.held_size, "sampling")
        self.array["after"] = scratch(self.builder, self.size, "after")
        self.builder.call(sampled.prepare, [self.argument["p"], held])
        return held

    def _sample(self) -> None:
        """At the start of each segment, once: the state after the samples there."""
        b, sampled = self.builder, self.lowered.sampled
        if sampled is None:
            return
        after = b.fadd(self.get("segment"), number(1.0))
        with b.if_then(b.fcmp_ordered(">", after, self.get("sampled")), likely=False):
            b.call(sampled.call, [self.get("t"), self.array["y"], self.row(), self._sampling, self.array["after"]])
            self.copy("y", "after")
            self.put("sampled", after)

    def local(self, name: str) -> Any:
        """A double on the stack of the function."""
        with self.builder.goto_entry_block():
            return self.builder.alloca(F64, name=name)

    def step_until(self, end: Any) -> tuple[Any, Any, Any]:
        """Length of the next step, whether it ends on ``end``, and the time after it; fails where it is too short."""
        b: Any = self.builder
        time, wanted = self.get("t"), self.get("h")
        last = b.fcmp_ordered(">=", b.fadd(time, b.fmul(number(1.0001), wanted)), end)
        h = b.select(last, b.fsub(end, time), wanted)
        smallest = b.fmul(number(4e-15), self.intrinsic("fabs", end))
        self.stop_if(b.not_(b.fcmp_ordered(">", h, smallest)), Status.STEP_TOO_SMALL)
        return h, last, b.select(last, end, b.fadd(time, h))

    def reject(self, h: Any, factor: Any, smallest: float) -> None:
        """Try again with a step of h times a factor; one that is not a number shrinks the step most."""
        b: Any = self.builder
        usable = b.fcmp_ordered(">", factor, number(smallest))
        self.put("h", b.fmul(h, b.select(usable, factor, number(smallest))))
        self.add("rejected", 1.0)
        b.branch(self.again)

    def due_samples(self, until: Any, end: Any = None) -> AbstractContextManager[Any]:
        """For each instant of a step to ``end`` (None: ``until``) that is to be written: yields where."""
        return due_samples(self, until, until if end is None else end)

    def count_step(self, h: Any, cut: Any) -> None:
        """Count a step of length h; the smallest of all that were not ``cut`` short is kept."""
        b: Any = self.builder
        smallest = self.get("smallest")
        first = b.fcmp_ordered("==", smallest, number(0.0))
        least = b.select(first, h, self.intrinsic("minnum", smallest, h))
        self.put("smallest", b.select(cut, smallest, least))
        self.add("steps", 1.0)

    def block(self, name: str) -> Any:
        """A new basic block."""
        return self.function.append_basic_block(name)

    def get(self, label: str) -> Any:
        """Value of a cell."""
        return self.builder.load(self.cell[label], typ=F64)

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

    def finished(self) -> Any:
        """Whether the last segment is behind."""
        return self.builder.icmp_signed(">=", self.integer("segment"), self.argument["segments"])

    def intrinsic(self, name: str, *values: Any) -> Any:
        """Call of an LLVM intrinsic on doubles."""
        kind = ir.FunctionType(F64, [F64] * len(values))
        return self.builder.call(self.module.declare_intrinsic(f"llvm.{name}", [F64], kind), list(values))

    def stop_if(self, condition: Any, status: Status) -> None:
        """Leave the loop with a status where the condition holds."""
        stop, on = self.block(f"stop_{status.name.lower()}"), self.block("on")
        self.builder.cbranch(condition, stop, on)
        self.builder.position_at_end(stop)
        self.put("status", number(float(status)))
        self.builder.branch(self.leave)
        self.builder.position_at_end(on)

    def row(self) -> Any:
        """Address of the reference's row of the current segment."""
        length = self.lowered.row
        return at(self.builder, self.argument["rows"], self.builder.mul(self.integer("segment"), whole(length)))

    def knot(self, ahead: int) -> Any:
        """Time of the current segment's start (0) or end (1)."""
        index = self.builder.add(self.integer("segment"), whole(ahead))
        return load(self.builder, self.argument["knots"], index)

    def evaluate(self, time: Any, state: str, into: str) -> None:
        """Right-hand side at a state array, into an array."""
        row = self.row()
        self.builder.call(self.lowered.call, [time, self.array[state], row, self.held, self.array[into]])
        self.add("evaluations", 1.0)

    def combine(self, into: str, weights: dict[str, Any], base: str = "y") -> None:
        """``into = base + sum weights[a] a`` for whole arrays."""
        b: Any = self.builder
        with counted(b, self.size) as i:
            total = load(b, self.array[base], i)
            for label, weight in weights.items():
                term = b.fmul(weight, load(b, self.array[label], i), flags=("contract",))
                total = b.fadd(total, term, flags=("contract",))
            store(b, total, self.array[into], i)

    def copy(self, into: str, source: str) -> None:
        """``into = source`` for whole arrays."""
        with counted(self.builder, self.size) as i:
            store(self.builder, load(self.builder, self.array[source], i), self.array[into], i)

    def within_bounds(self, label: str) -> Any:
        """Whether every guarded component is finite and below the bound (not-a-number is not)."""
        b = self.builder
        good: Any = ir.Constant(ir.IntType(1), 1)
        bound = self.option("bound")
        for i in range(self.guarded):
            magnitude = self.intrinsic("fabs", load(b, self.array[label], i))
            good = b.and_(good, b.fcmp_ordered("<", magnitude, bound))
        return good

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

    def _write_leave(self) -> None:
        self.builder.position_at_end(self.leave)
        for slot, label in enumerate(CELLS):
            store(self.builder, self.get(label), self.argument["memory"], slot)
        self.builder.ret_void()
