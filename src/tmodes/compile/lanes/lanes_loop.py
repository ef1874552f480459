"""The frame of a native time loop over runs side by side, each with a time, a step and an end of its own.

A run that is over, or failed, idles: its step is zero, and nothing of it changes any more. All is done lane by lane, so
no bit of a run depends on its neighbours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Wide
from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, Builder, at, counted, declare, load, number, store, whole
from tmodes.compile.loops.frame import Frame
from tmodes.compile.loops.time_loop import CELLS, Status
from tmodes.compile.native import WIDTH

__all__ = ["LANE_ARGUMENTS", "LANE_OPTIONS", "LaneSeries", "LanesLoop"]

LANE_OPTIONS = ("step", "rtol", "atol", "chunk", "bound", "most", "most_events", "event_time")
"""Settings of a loop, the same for all lanes; ``most``: attempted steps of a run after which it is given up."""

LANE_ARGUMENTS = (
    "memory", "y", "k1", "p", "work", "knots", "rows", "segments", "times", "out", "places", "options", "table",
    "weights", "sums", "knot_stride", "row_stride", "table_stride", "samples",
)  # fmt: skip
"""Arguments of a loop, in order; the last four are int64, the others point to doubles.

Of ``memory``, ``y``, ``k1``, ``p`` and ``segments`` the numbers of the lanes stand side by side; ``knots`` and ``rows``
of a lane begin a stride after those of the lane before; ``out`` is (runs, samples, size), where ``places`` says which
run is whose. Where series are wanted, ``table`` has the numbers given for each sample, a stride apart from lane to
lane, ``weights`` those of the samples in a mean over time, and ``sums`` what series are reduced to.
"""

_INTEGERS = ("knot_stride", "row_stride", "table_stride", "samples")


@dataclass(frozen=True)
class LaneSeries:
    """What is wanted of each sample in place of the state: written into the samples, or reduced (``folds``).

    ``rate`` gives the series from the state and so many ``given`` numbers behind it.
    """

    rate: ScheduleRate
    given: int
    folds: bool


class LanesLoop(Frame):
    """A vector for each cell, arrays in ``work``, and the blocks ``again`` and ``leave``."""

    def __init__(
        self,
        module: Any,
        name: str,
        rate: ScheduleRate,
        scratch_arrays: Sequence[str],
        guarded: int,
        series: LaneSeries | None = None,
    ) -> None:
        """``guarded``: how many of the first components of the state are watched for divergence.

        ``series``: what is wanted of each sample in place of the state.
        """
        self.series = series
        kinds = [(label, I64 if label in _INTEGERS else POINTER) for label in LANE_ARGUMENTS]
        self.lanes = Wide(module)
        super().__init__(name, rate, self.lanes, kinds, guarded)
        b = self.builder
        self.gates = [f"gate{k}" for k in range(2 * rate.gate_count)]
        further = ("start", "end", "total", "gate_known", *self.gates)
        self.cell = {label: self.local(label) for label in (*CELLS, *further)}
        self.done = b.alloca(F64, name="done")
        self._lay_out(scratch_arrays)
        b.call(rate.prepare, [self.argument["p"], self.array["held"]])
        for slot, label in enumerate(CELLS):
            self.put(label, self.numbers.load(b, self.argument["memory"], slot))
        if rate.sampled is not None:
            b.call(rate.sampled.prepare, [self.argument["p"], self.array["sampling"]])
        if series is not None:
            b.call(series.rate.prepare, [self.argument["p"], self.array["showing"]])
        b.store(number(0.0), self.done)
        self.put("gate_known", self.constant(0.0))
        self.enter_segments()
        self.again, self.leave = self.block("again"), self.block("leave")
        b.branch(self.again)
        b.position_at_end(self.leave)
        for slot, label in enumerate(CELLS):
            self.numbers.store(b, self.get(label), self.argument["memory"], slot)
        b.ret_void()
        b.position_at_end(self.again)
        self._end_runs()
        self._sample()

    def _sample(self) -> None:
        """At the start of each segment of a lane, once: its state after the samples there."""
        b, sampled = self.builder, self.rate.sampled
        if sampled is None:
            return
        after = b.fadd(self.get("segment"), self.constant(1.0))
        new = b.and_(self.running(), b.fcmp_ordered(">", after, self.get("sampled")))
        with b.if_then(self.any(new), likely=False):
            self.call(sampled, self.get("t"), "y", "after", "sampling")
            self.copy_where(new, "y", "after")
            self.put("sampled", after, new)

    def _lay_out(self, scratch_arrays: Sequence[str]) -> None:
        """The arrays inside ``work``; an exported function ``NAME.work`` says how many numbers they need."""
        sizes = {"held": self.rate.held_size, "row": self.rate.row, "shown": self.size}
        if self.series is not None:
            sizes["shown"] += self.series.given
            sizes |= {"showing": self.series.rate.held_size, "series": self.series.rate.size}
        sizes |= dict.fromkeys(scratch_arrays, self.size)
        if self.rate.sampled is not None:
            sizes |= {"sampling": self.rate.sampled.held_size, "after": self.size}
        start = 0
        for label, size in sizes.items():
            self.array[label] = at(self.builder, self.argument["work"], start * WIDTH)
            start += size
        info = declare(self.module, f"{self.function.name}.work", VOID, [("size", POINTER)])
        b = Builder(info.append_basic_block("entry"))
        store(b, number(float(start * WIDTH)), info.args[0], 0)
        b.ret_void()

    def _end_runs(self) -> None:
        """Lanes whose last segment is behind are finished; leave when none may go on."""
        b = self.builder
        over = b.and_(self._unended(), b.fcmp_ordered(">=", self.get("segment"), self._segments()))
        self.put("status", self.constant(float(Status.FINISHED)), over)
        enough = b.fcmp_ordered(">=", b.load(self.done, typ=F64), self._single_option("chunk"))
        on = self.block("on")
        b.cbranch(b.or_(enough, b.not_(self.any(self.running()))), self.leave, on)
        b.position_at_end(on)
        b.store(b.fadd(b.load(self.done, typ=F64), number(1.0)), self.done)

    def put(self, label: str, value: Any, where: Any = None) -> None:
        """Set a cell, or only the lanes ``where``."""
        value = value if where is None else self.builder.select(where, value, self.get(label))
        self.builder.store(value, self.cell[label])

    def count(self, label: str, where: Any, amount: float = 1.0) -> None:
        """Add to the lanes ``where`` of a cell."""
        self.put(label, self.builder.fadd(self.get(label), self.constant(amount)), where)

    def _single_option(self, label: str) -> Any:
        return load(self.builder, self.argument["options"], LANE_OPTIONS.index(label))

    def option(self, label: str) -> Any:
        """Value of an option in all lanes."""
        return self.lanes.spread(self.builder, self._single_option(label))

    def any(self, condition: Any) -> Any:
        """Whether a condition holds in any lane."""
        bits = self.builder.bitcast(condition, ir.IntType(WIDTH))
        return self.builder.icmp_unsigned("!=", bits, ir.Constant(ir.IntType(WIDTH), 0))

    def _unended(self) -> Any:
        """Lanes that are neither over nor failed."""
        return self.builder.fcmp_ordered("==", self.get("status"), self.constant(float(Status.RUNNING)))

    def running(self) -> Any:
        """Lanes that are neither over nor failed nor out of steps."""
        b = self.builder
        tried = b.fadd(self.get("steps"), self.get("rejected"))
        return b.and_(self._unended(), b.fcmp_ordered("<", tried, self.option("most")))

    def end_where(self, condition: Any, status: Status) -> None:
        """Give running lanes a status where the condition holds."""
        self.put("status", self.constant(float(status)), self.builder.and_(self.running(), condition))

    def row(self) -> Any:
        """The rows of the present segments, side by side."""
        return self.array["row"]

    def segment(self) -> tuple[Any, Any]:
        """Times at which the present segment of each lane's input starts and ends."""
        return self.get("start"), self.get("end")

    def in_last_segment(self) -> Any:
        """Lanes in the last segment of their input."""
        after = self.builder.fadd(self.get("segment"), self.constant(1.0))
        return self.builder.fcmp_ordered(">=", after, self._segments())

    def _segments(self) -> Any:
        return self.numbers.load(self.builder, self.argument["segments"], 0)

    def take(self, where: Any, time_after: Any, last: Any) -> Any:
        """Take the step to ``new`` in the lanes ``where``; those of them that enter a segment (``last``)."""
        b = self.builder
        self.copy_where(where, "y", "new")
        self.put("t", time_after, where)
        self.count("steps", where)
        over = b.and_(where, last)
        self.count("segment", over)
        with b.if_then(self.any(over), likely=False):
            self.enter_segments()
        return over

    def enter_segments(self) -> None:
        """Bring the row and the knots of each lane's segment; a run that is over keeps its last one."""
        b = self.builder
        index = self.intrinsic("minnum", self.get("segment"), b.fsub(self._segments(), self.constant(1.0)))
        for lane in range(WIDTH):
            self._enter_segment(lane, b.fptosi(b.extract_element(index, whole(lane)), I64))

    def _enter_segment(self, lane: int, piece: Any) -> None:
        b = self.builder
        row = at(b, self.argument["rows"], b.mul(self.argument["row_stride"], whole(lane)))
        row = at(b, row, b.mul(piece, whole(self.rate.row)))
        with counted(b, self.rate.row, "row") as j:
            store(b, load(b, row, j), self.array["row"], b.add(b.mul(j, whole(WIDTH)), whole(lane)))
        knots = at(b, self.argument["knots"], b.mul(self.argument["knot_stride"], whole(lane)))
        for ahead, label in enumerate(("start", "end")):
            time = load(b, knots, b.add(piece, whole(ahead)))
            self.put(label, b.insert_element(self.get(label), time, whole(lane)))

    def evaluate(self, time: Any, state: str, into: str) -> None:
        """Right-hand side at a state array, into an array; every lane is computed, whether it runs or not."""
        self.call(self.rate, time, state, into)

    def copy_where(self, condition: Any, into: str, source: str) -> None:
        """``into = source`` in the lanes where the condition holds."""
        with counted(self.builder, self.size) as i:
            self.store(self.builder.select(condition, self.load(source, i), self.load(into, i)), into, i)
