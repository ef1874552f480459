"""A schedule of kernels as the right-hand side of one run at several states at once, each with a step of its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.compile.ir.arithmetic import Double, Lanes
from tmodes.compile.ir.block import ScheduleRate, write_jumps, write_main
from tmodes.compile.ir.builder import Builder
from tmodes.compile.ir.emit import F64, POINTER, VOID, counted, declare, load, store, whole
from tmodes.compile.ir.rows import copy_numbers, take_rows
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
        self.main = write_main(module, schedule, self.lanes, f"{name}.main")
        self.outputs = self.main.blocks(slot for slots in schedule.outputs.values() for slot in slots)

    def written(self) -> RowsRate:
        """All functions."""
        s, memory, double = self.schedule, self.main.memory, Double(self.module)
        prepare, rows = self._prepare(), self._call_rows()
        step, state, start = (self._offset(s.inputs[label]) for label in ("step", "state", "start"))
        end = memory.workspace * self.lanes.stride
        watched = sum(slot.size for slot in s.watched)
        call, sizes = self._call(rows, end), (end + watched, s.output_size, s.inputs["row"].size)
        sampled, switched = write_jumps(self.module, s, double, self.name)
        gate = (end, s.gate.size // 2) if s.gate else (None, 0)
        count = s.switches.size if s.switches else 0
        narrow = (end + 2 * gate[1], s.narrow.size // 2) if s.narrow else (0, 0)
        jumps = (sampled, end + watched - count, count, switched, narrow[0], narrow[1], s.jolts)
        return RowsRate(prepare, call, *sizes, step, *gate, None, *jumps, rows, state, start)

    def _offset(self, slot: Any) -> int:
        return self.main.memory.offset(slot) * self.lanes.stride

    def _function(self, name: str, kinds: list[tuple[str, Any]]) -> tuple[Any, Any]:
        function = declare(self.module, f"{self.name}.{name}", VOID, kinds, private=True)
        function.attributes.add("noinline")
        return function, Builder(function.append_basic_block("entry"))

    def _prepare(self) -> Any:
        prepare, b = self._function("prepare", [("parameters", POINTER), ("held", POINTER)])
        parameters, held = prepare.args
        take_rows(b, self.lanes, parameters, held, [(0, self.schedule.parameters)], 1)
        self.lanes.store(b, self.lanes.constant(0.0), held, self.main.memory.offset(self.schedule.inputs["step"]))
        self.main.prepare(b, held)
        b.ret_void()
        return prepare

    def _call_rows(self) -> Any:
        """``call_rows(times, steps, row, held, out)``."""
        lanes, inputs = self.lanes, self.schedule.inputs
        kinds = [("times", lanes.kind), ("steps", lanes.kind), ("row", POINTER), ("held", POINTER), ("out", POINTER)]
        call, b = self._function("call_rows", kinds)
        times, steps, row, held, out = call.args
        lanes.store(b, times, held, self.main.memory.offset(inputs["time"]))
        lanes.store(b, steps, held, self.main.memory.offset(inputs["step"]))
        take_rows(b, lanes, row, held, self.main.blocks([inputs["row"]]), 1)
        b.call(self.main.function, [held])
        copy_numbers(b, lanes, out, held, self.outputs, into=False)
        b.ret_void()
        return call

    def _call(self, rows: Any, gate: int) -> Any:
        """``call(time, state, row, held, out)``: the same state in all lanes, explicit; the first lane's rates.

        What loops read of its workspace is put at ``gate``, as of one run.
        """
        lanes, inputs = self.lanes, self.schedule.inputs
        kinds = [("time", F64), ("state", POINTER), ("row", POINTER), ("held", POINTER), ("out", POINTER)]
        call, b = self._function("call", kinds)
        time, state, row, held, out = call.args
        found = b.alloca(F64, size=whole(self.schedule.output_size * lanes.stride))
        for label in ("state", "start"):
            take_rows(b, lanes, state, held, self.main.blocks([inputs[label]]), 1)
        b.call(rows, [lanes.spread(b, time), lanes.constant(0.0), row, held, found])
        with counted(b, self.schedule.output_size) as i:
            store(b, load(b, found, b.mul(i, whole(lanes.stride))), out, i)
        watched = [(slot, k) for slot in self.schedule.watched for k in range(slot.size)]
        for place, (slot, k) in enumerate(watched):
            store(b, load(b, held, self._offset(slot) + k * lanes.stride), held, gate + place)
        b.ret_void()
        return call
