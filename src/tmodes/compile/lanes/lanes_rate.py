"""A schedule of kernels as the right-hand side of the time loops over lanes: numbers of runs side by side."""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Wide
from tmodes.compile.ir.block import ScheduleRate, call_prepare, write_main
from tmodes.compile.ir.emit import POINTER, VOID, at, counted, declare, whole
from tmodes.compile.ir.unroll import pays
from tmodes.compile.lanes.lanes_memory import Layout

__all__ = ["write_lanes_rate"]


def write_lanes_rate(module: Any, schedule: Any, name: str) -> ScheduleRate:
    """Functions ``prepare(parameters, held)`` and ``call(time, state, row, held, out)`` for the time loops over lanes.

    As of :func:`tmodes.compile.ir.block.write_rate`; every number is a vector of lanes, and sizes count vectors.
    """
    lanes = Wide(module)
    whole_program = lanes.unrolls and pays(schedule)
    layout = None if whole_program else Layout(schedule)
    offset, size = (layout.offset, layout.size) if layout else (schedule.offset, schedule.workspace)
    main = write_main(module, schedule, lanes, f"{name}.main", layout.offset if layout else None)
    prepare = declare(module, f"{name}.prepare", VOID, [("parameters", POINTER), ("held", POINTER)], private=True)
    b = ir.IRBuilder(prepare.append_basic_block("entry"))
    _copy(b, lanes, prepare.args[0], prepare.args[1], schedule.parameters)
    if "step" in schedule.inputs:
        lanes.store(b, lanes.constant(0.0), prepare.args[1], offset(schedule.inputs["step"]))
    call_prepare(b, main, prepare.args[1])
    b.ret_void()
    kinds = [("time", lanes.kind), ("state", POINTER), ("row", POINTER), ("held", POINTER), ("out", POINTER)]
    call = declare(module, f"{name}.call", VOID, kinds, private=True)
    call.attributes.add("noinline")
    time, state, row, held, out = call.args
    b = ir.IRBuilder(call.append_basic_block("entry"))

    def inside(slot: Any) -> Any:
        return at(b, held, offset(slot) * lanes.stride)

    lanes.store(b, time, held, offset(schedule.inputs["time"]))
    for source, label in ((state, "state"), (row, "row")):
        _copy(b, lanes, source, inside(schedule.inputs[label]), schedule.inputs[label].size)
    b.call(main, [held])
    first = 0
    for slot in (slot for slots in schedule.outputs.values() for slot in slots):
        _copy(b, lanes, inside(slot), at(b, out, first * lanes.stride), slot.size)
        first += slot.size
    b.ret_void()
    gate = offset(schedule.gate) if schedule.gate else None
    row_size = schedule.inputs["row"].size
    return ScheduleRate(prepare, call, size, schedule.output_size, row_size, None, gate)


def _copy(b: Any, lanes: Wide, source: Any, target: Any, size: int) -> None:
    with counted(b, size, "copy") as k:
        start = b.mul(k, whole(lanes.stride))
        lanes.store(b, lanes.load(b, at(b, source, start), 0), at(b, target, start), 0)
