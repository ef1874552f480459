"""The frame of a native time loop over runs side by side, each with a time, a step and an end of its own.

A run that is over, or failed, idles: its step is zero, and nothing of it changes any more. All is done lane by lane, so
no bit of a run depends on its neighbours.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, at, counted, declare, load, number, store, whole
from tmodes.compile.ir.lower import Lowered
from tmodes.compile.lanes.wide import Wide
from tmodes.compile.loops.time_loop import CELLS, Status

__all__ = ["LANE_ARGUMENTS", "LANE_CELLS", "LANE_OPTIONS", "WIDTH", "LanesLoop"]

WIDTH = Wide.stride
"""Runs side by side."""

LANE_CELLS = (*CELLS, "gate_known", "gate0", "gate1")
"""Memory of a loop between calls, one double for each lane of each."""

LANE_OPTIONS = ("step", "rtol", "atol", "chunk", "bound", "most", "most_events", "event_time")
"""Settings of a loop, the same for all lanes; ``most``: attempted steps of a run after which it is given up."""

LANE_ARGUMENTS = (
    "memory", "y", "k1", "p", "work", "knots", "rows", "segments", "times", "out", "places", "options",
    "knot_stride", "row_stride", "samples",
)  # fmt: skip
"""Arguments of a loop, in order; the last three are int64, the others point to doubles.

Of ``memory``, ``y``, ``k1``, ``p`` and ``segments`` the numbers of the lanes stand side by side; ``knots`` and ``rows``
of a lane begin a stride after those of the lane before; ``out`` is (runs, samples, size), where ``places`` says which
run is whose.
"""

_INTEGERS = ("knot_stride", "row_stride", "samples")


class LanesLoop:
    """Arguments, a vector for each cell, scratch arrays in ``work``, and the blocks ``again`` and ``leave``."""

    def __init__(
        self, module: Any, name: str, rate: Lowered | ScheduleRate, scratch_arrays: Sequence[str], guarded: int
    ) -> None:
        """``guarded``: how many of the first components of the state are watched for divergence."""
        self.module, self.rate, self.guarded, self.size = module, rate, guarded, rate.size
        self.lanes = Wide(module)
        kinds = [(label, I64 if label in _INTEGERS else POINTER) for label in LANE_ARGUMENTS]
        self.function = declare(module, name, VOID, kinds)
        self.argument = dict(zip(LANE_ARGUMENTS, self.function.args, strict=True))
        self.builder = ir.IRBuilder(self.function.append_basic_block("entry"))
        self.cell = {label: self._vector(label) for label in (*LANE_CELLS, "start", "end", "total")}
        self.done = self.builder.alloca(F64, name="done")
        self._lay_out(scratch_arrays)
        self.builder.call(rate.prepare, [self.argument["p"], self.array["held"]])
        for slot, label in enumerate(LANE_CELLS):
            self.put(label, self.lanes.load(self.builder, self.argument["memory"], slot))
        if rate.sampled is not None:
            self.builder.call(rate.sampled.prepare, [self.argument["p"], self.array["sampling"]])
        self.builder.store(number(0.0), self.done)
        self.enter_segments()
        self.again, self.leave = self.block("again"), self.block("leave")
        self.builder.branch(self.again)
        self._write_leave()
        self.builder.position_at_end(self.again)
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
            arrays = (self.array[label] for label in ("y", "row", "sampling", "after"))
            b.call(sampled.call, [self.get("t"), *arrays])
            self.copy_where(new, "y", "after")
            self.put("sampled", after, new)

    def _vector(self, label: str) -> Any:
        return self.builder.alloca(self.lanes.kind, name=label)

    def _lay_out(self, scratch_arrays: Sequence[str]) -> None:
        """The arrays inside ``work``; an exported function ``NAME.work`` says how many numbers they need."""
        sizes = {"held": self.rate.held_size, "row": self.rate.row, "shown": self.size}
        sizes |= dict.fromkeys(scratch_arrays, self.size)
        if self.rate.sampled is not None:
            sizes |= {"sampling": self.rate.sampled.held_size, "after": self.size}
        self.array, start = {"y": self.argument["y"], "k1": self.argument["k1"]}, 0
        for label, size in sizes.items():
            self.array[label] = at(self.builder, self.argument["work"], start * WIDTH)
            start += size
        info = declare(self.module, f"{self.function.name}.work", VOID, [("size", POINTER)])
        b = ir.IRBuilder(info.append_basic_block("entry"))
        store(b, number(float(start * WIDTH)), info.args[0], 0)
        b.ret_void()

    def _end_runs(self) -> None:
        """Lanes whose last segment is behind are finished; leave when none may go on."""
        b: Any = self.builder
        segments = self.lanes.load(b, self.argument["segments"], 0)
        over = b.and_(self._unended(), b.fcmp_ordered(">=", self.get("segment"), segments))
        self.put("status", self.constant(float(Status.FINISHED)), over)
        enough = b.fcmp_ordered(">=", b.load(self.done, typ=F64), self.single_option("chunk"))
        on = self.block("on")
        b.cbranch(b.or_(enough, b.not_(self.any(self.running()))), self.leave, on)
        b.position_at_end(on)
        b.store(b.fadd(b.load(self.done, typ=F64), number(1.0)), self.done)

    def block(self, name: str) -> Any:
        """A new basic block."""
        return self.function.append_basic_block(name)

    def constant(self, value: float) -> Any:
        """The same number in all lanes."""
        return self.lanes.constant(value)

    def get(self, label: str) -> Any:
        """Values of a cell."""
        return self.builder.load(self.cell[label], typ=self.lanes.kind)

    def put(self, label: str, value: Any, where: Any = None) -> None:
        """Set a cell, or only the lanes ``where``."""
        value = value if where is None else self.builder.select(where, value, self.get(label))
        self.builder.store(value, self.cell[label])

    def count(self, label: str, where: Any, amount: float = 1.0) -> None:
        """Add to the lanes ``where`` of a cell."""
        self.put(label, self.builder.fadd(self.get(label), self.constant(amount)), where)

    def single_option(self, label: str) -> Any:
        """Value of an option."""
        return load(self.builder, self.argument["options"], LANE_OPTIONS.index(label))

    def option(self, label: str) -> Any:
        """Value of an option in all lanes."""
        value, b = self.single_option(label), self.builder
        places = [whole(lane) for lane in range(WIDTH)]
        return reduce(lambda vector, place: b.insert_element(vector, value, place), places, self.constant(0.0))

    def call(self, kind: str, *values: Any) -> Any:
        """Call of an LLVM intrinsic on lanes."""
        name = f"llvm.{kind}.v{WIDTH}f64"  # llvmlite names the intrinsics of single numbers only
        function = self.module.globals.get(name)
        if function is None:
            info = ir.FunctionType(self.lanes.kind, [self.lanes.kind] * len(values))
            function = ir.Function(self.module, info, name)
        return self.builder.call(function, list(values))

    def any(self, condition: Any) -> Any:
        """Whether a condition holds in any lane."""
        bits = self.builder.bitcast(condition, ir.IntType(WIDTH))
        return self.builder.icmp_unsigned("!=", bits, ir.Constant(ir.IntType(WIDTH), 0))

    def _unended(self) -> Any:
        """Lanes that are neither over nor failed."""
        return self.builder.fcmp_ordered("==", self.get("status"), self.constant(float(Status.RUNNING)))

    def running(self) -> Any:
        """Lanes that are neither over nor failed nor out of steps."""
        b: Any = self.builder
        tried = b.fadd(self.get("steps"), self.get("rejected"))
        return b.and_(self._unended(), b.fcmp_ordered("<", tried, self.option("most")))

    def end_where(self, condition: Any, status: Status) -> None:
        """Give running lanes a status where the condition holds."""
        self.put("status", self.constant(float(status)), self.builder.and_(self.running(), condition))

    def load(self, label: str, i: Any) -> Any:
        """Component i of an array of lanes."""
        return self.lanes.load(self.builder, self._component(label, i), 0)

    def store(self, value: Any, label: str, i: Any) -> None:
        """Set component i of an array of lanes."""
        self.lanes.store(self.builder, value, self._component(label, i), 0)

    def _component(self, label: str, i: Any) -> Any:
        return at(self.builder, self.array[label], self.builder.mul(i, whole(WIDTH)))

    def enter_segments(self) -> None:
        """Bring the row and the knots of each lane's segment; a run that is over keeps its last one."""
        b: Any = self.builder
        segments = self.lanes.load(b, self.argument["segments"], 0)
        last = b.fsub(segments, self.constant(1.0))
        index = self.call("minnum", self.get("segment"), last)
        for lane in range(WIDTH):
            piece = b.fptosi(b.extract_element(index, whole(lane)), I64)
            self._enter_segment(lane, piece)

    def _enter_segment(self, lane: int, piece: Any) -> None:
        b: Any = self.builder
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
        arrays = (self.array[label] for label in (state, "row", "held", into))
        self.builder.call(self.rate.call, [time, *arrays])

    def combine(self, into: str, weights: dict[str, Any], base: str = "y") -> None:
        """``into = base + sum weights[a] a`` for whole arrays."""
        b: Any = self.builder
        with counted(b, self.size) as i:
            total = self.load(base, i)
            for label, weight in weights.items():
                term = b.fmul(weight, self.load(label, i), flags=("contract",))
                total = b.fadd(total, term, flags=("contract",))
            self.store(total, into, i)

    def copy_where(self, condition: Any, into: str, source: str) -> None:
        """``into = source`` in the lanes where the condition holds."""
        with counted(self.builder, self.size) as i:
            self.store(self.builder.select(condition, self.load(source, i), self.load(into, i)), into, i)

    def within_bounds(self, label: str) -> Any:
        """Where every guarded component is finite and below the bound (not-a-number is not)."""
        b: Any = self.builder
        good: Any = ir.Constant(ir.VectorType(ir.IntType(1), WIDTH), [1] * WIDTH)
        bound = self.option("bound")
        for i in range(self.guarded):
            good = b.and_(good, b.fcmp_ordered("<", self.call("fabs", self.load(label, whole(i))), bound))
        return good

    def _write_leave(self) -> None:
        b = self.builder
        b.position_at_end(self.leave)
        for slot, label in enumerate(LANE_CELLS):
            self.lanes.store(b, self.get(label), self.argument["memory"], slot)
        b.ret_void()
