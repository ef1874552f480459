"""A schedule of kernels as the right-hand side of one run at several states at once, each with a step of its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Lanes
from tmodes.compile.ir.block import ScheduleRate, call_prepare, write_main
from tmodes.compile.ir.calls import I32, table_of
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, at, counted, declare, load, store, whole
from tmodes.compile.ir.unroll import pays
from tmodes.compile.lanes.lanes_memory import Layout
from tmodes.compile.loops.rows import spread_parameters
from tmodes.errors import CompileError

__all__ = ["RowsRate", "write_rows_rate"]


@dataclass(frozen=True)
class RowsRate(ScheduleRate):
    """``call`` takes one state, as any other; ``call_rows(times, steps, row, held, out)`` takes one in each lane.

    Their coordinates and rates stand in ``held`` at ``state_offset``, what springs start from at ``start_offset``, in
    vectors, and are lost by the call.
    """

    call_rows: Any = None
    state_offset: int = 0
    start_offset: int = 0


def write_rows_rate(module: Any, schedule: Any, name: str) -> RowsRate:
    """The functions of :class:`RowsRate` around a schedule that has the inputs ``step`` and ``start``.

    Raises :class:`CompileError` for one that has not.
    """
    if not {"step", "start"} <= set(schedule.inputs):
        raise CompileError(f"{name}: the schedule has no inputs `step` and `start` for implicit steps")
    return _Writer(module, schedule, name).written()


class _Writer:
    """Offsets are those of doubles in a workspace of vectors."""

    def __init__(self, module: Any, schedule: Any, name: str) -> None:
        self.module, self.schedule, self.name, self.lanes = module, schedule, name, Lanes(module)
        layout = None if pays(schedule) else Layout(schedule)
        self.place, self.size = (layout.offset, layout.size) if layout else (schedule.offset, schedule.workspace)
        self.main = write_main(module, schedule, self.lanes, f"{name}.main", layout.offset if layout else None)
        self.outputs = [slot for slots in schedule.outputs.values() for slot in slots]

    def written(self) -> RowsRate:
        """All functions."""
        s, width = self.schedule, self.lanes.stride
        prepare, rows = self._prepare(), self._call_rows()
        info = {label: self._offset(s.inputs[label]) for label in ("state", "start", "step")}
        end = self.size * width
        gate = end if s.gate else None
        call, sizes = self._call(rows, end), (end + 2, s.output_size, s.inputs["row"].size)
        return RowsRate(prepare, call, *sizes, info["step"], gate, None, rows, info["state"], info["start"])

    def _offset(self, slot: Any) -> int:
        return self.place(slot) * self.lanes.stride

    def _prepare(self) -> Any:
        kinds = [("parameters", POINTER), ("held", POINTER)]
        prepare = declare(self.module, f"{self.name}.prepare", VOID, kinds, private=True)
        b = ir.IRBuilder(prepare.append_basic_block("entry"))
        parameters, held = prepare.args
        spread_parameters(b, parameters, held, self.schedule.parameters, self.lanes.stride, same=True)
        self.lanes.store(b, self.lanes.constant(0.0), held, self.place(self.schedule.inputs["step"]))
        call_prepare(b, self.main, held)
        b.ret_void()
        return prepare

    def _call_rows(self) -> Any:
        """``call_rows(times, steps, row, held, out)``."""
        lanes, inputs = self.lanes, self.schedule.inputs
        kinds = [("times", lanes.kind), ("steps", lanes.kind), ("row", POINTER), ("held", POINTER), ("out", POINTER)]
        call = declare(self.module, f"{self.name}.call_rows", VOID, kinds, private=True)
        call.attributes.add("noinline")
        times, steps, row, held, out = call.args
        b = ir.IRBuilder(call.append_basic_block("entry"))
        lanes.store(b, times, held, self.place(inputs["time"]))
        lanes.store(b, steps, held, self.place(inputs["step"]))
        self._spread(b, row, held, inputs["row"])
        b.call(self.main, [held])
        places = [self.place(slot) + k for slot in self.outputs for k in range(slot.size)]
        table = table_of(b, f"{self.name}.outputs", places)
        with counted(b, len(places), "output") as i:
            place = b.sext(b.load(b.gep(table, [i], source_etype=I32), typ=I32), I64)
            lanes.store(b, lanes.load(b, self._vector(b, held, place), 0), self._vector(b, out, i), 0)
        b.ret_void()
        return call

    def _call(self, rows: Any, gate: int) -> Any:
        """``call(time, state, row, held, out)``: the same state in all lanes, explicit; the first lane's rates.

        Its gate, if any, is put at ``gate``, as of one run.
        """
        lanes, inputs = self.lanes, self.schedule.inputs
        kinds = [("time", F64), ("state", POINTER), ("row", POINTER), ("held", POINTER), ("out", POINTER)]
        call = declare(self.module, f"{self.name}.call", VOID, kinds, private=True)
        call.attributes.add("noinline")
        time, state, row, held, out = call.args
        b = ir.IRBuilder(call.append_basic_block("entry"))
        found = b.alloca(F64, size=whole(self.schedule.output_size * lanes.stride))
        for label in ("state", "start"):
            self._spread(b, state, held, inputs[label])
        b.call(rows, [lanes.spread(b, time), lanes.constant(0.0), row, held, found])
        with counted(b, self.schedule.output_size) as i:
            store(b, load(b, found, b.mul(i, whole(lanes.stride))), out, i)
        for k in range(2 if self.schedule.gate else 0):
            store(b, load(b, held, self._offset(self.schedule.gate) + k * lanes.stride), held, gate + k)
        b.ret_void()
        return call

    def _spread(self, b: Any, source: Any, held: Any, slot: Any) -> None:
        target = at(b, held, self._offset(slot))
        with counted(b, slot.size, "spread") as k:
            vector = self.lanes.spread(b, load(b, source, k))
            self.lanes.store(b, vector, self._vector(b, target, k), 0)

    def _vector(self, b: Any, base: Any, index: Any) -> Any:
        return at(b, base, b.mul(index, whole(self.lanes.stride)))
