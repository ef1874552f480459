"""A schedule of kernels as native code: each kernel one function on blocks of a workspace, called in order."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.calls import write_calls
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, at, counted, declare, store, whole
from tmodes.compile.ir.ordering import kernel_program
from tmodes.compile.ir.program import BlockProgram, Instruction
from tmodes.compile.ir.unroll import Unrolled, pays, unrolled
from tmodes.compile.ir.values import write_values
from tmodes.compile.loops.rows import copy_rows, spread_parameters

__all__ = [
    "ScheduleRate", "kernel_symbol", "write_kernel", "write_main", "write_program", "write_rate", "write_samples",
]  # fmt: skip


def kernel_symbol(kernel: Any, arithmetic: str) -> str:
    """The name of a kernel's native function: the same for the same structure, everywhere."""
    return _symbol(f"{kernel.key} {kernel.inputs} {kernel.outputs} {arithmetic}")


@lru_cache(maxsize=4096)
def _symbol(info: str) -> str:
    return f"kernel_{hashlib.sha256(info.encode()).hexdigest()[:32]}"


def write_kernel(module: Any, kernel: Any, arithmetic: Double) -> None:
    """The exported function of a kernel: pointers to the input blocks, then to the output blocks, never overlapping."""
    write_program(module, kernel_symbol(kernel, arithmetic.name), kernel_program(kernel), arithmetic)


def write_program(module: Any, name: str, program: BlockProgram, arithmetic: Double) -> None:
    """The same of a kernel's program."""
    labels = [f"i{k}" for k in range(program.inputs)] + [f"o{k}" for k in range(program.outputs)]
    function = declare(module, name, VOID, [(label, POINTER) for label in labels])
    b = ir.IRBuilder(function.append_basic_block("entry"))

    def read(argument: int, element: int) -> Any:
        return arithmetic.load(b, function.args[argument], element)

    values = write_values(b, program.values, arithmetic, read)
    for output, element, index in program.results:
        value = arithmetic.constant(0.0) if index is None else values[index]
        arithmetic.store(b, value, function.args[program.inputs + output], element)
    b.ret_void()


def write_main(
    module: Any, schedule: Any, arithmetic: Double, name: str, offset: Callable[[Any], int] | None = None
) -> Any:
    """The private function ``name(workspace)`` of a schedule: all its calls, to kernels of other libraries, or none.

    ``offset`` says where a block begins; by default it is the schedule's own. Of a schedule that is unrolled, as none
    with other offsets is, :func:`call_prepare` must be called for new parameters.
    """
    if offset is None and arithmetic.unrolls and pays(schedule):
        return _write_unrolled(module, unrolled(schedule), arithmetic, name)
    main = declare(module, name, VOID, [("workspace", POINTER)], private=True)
    main.attributes.add("noinline")  # loops call it from many places, and the time is in the kernels
    b = ir.IRBuilder(main.append_basic_block("entry"))
    symbols = partial(kernel_symbol, arithmetic=arithmetic.name)
    write_calls(b, schedule, arithmetic, main.args[0], symbols, offset or schedule.offset)
    b.ret_void()
    return main


def _write_unrolled(module: Any, code: Unrolled, arithmetic: Double, name: str) -> Any:
    parts = (f"{name}.prepare", code.prepare, code.prepared), (name, code.main, code.results)
    return [_write_program(module, *part, arithmetic) for part in parts][-1]


def _write_program(
    module: Any, name: str, program: Sequence[Instruction], results: Sequence[tuple[int, int]], arithmetic: Double
) -> Any:
    """The private function ``name(workspace)`` of one program on a workspace."""
    function = declare(module, name, VOID, [("workspace", POINTER)], private=True)
    function.attributes.add("noinline")
    b = ir.IRBuilder(function.append_basic_block("entry"))
    workspace = function.args[0]
    values = write_values(b, program, arithmetic, lambda _, place: arithmetic.load(b, workspace, place))
    for place, index in results:
        arithmetic.store(b, values[index], workspace, place)
    b.ret_void()
    return function


def call_prepare(b: Any, main: Any, workspace: Any) -> None:
    """After new parameters: what follows from them, where a schedule is unrolled."""
    prepare = b.function.module.globals.get(f"{main.name}.prepare")
    if prepare is not None:
        b.call(prepare, [workspace])


def write_samples(module: Any, schedule: Any, arithmetic: Double, name: str) -> None:
    """The exported ``name(n, each, parameters, workspace, in, out)``: the schedule at n samples, row by row.

    A row holds the inputs, or the outputs, one after the other; ``each`` not zero: every sample has parameters of its
    own. Of ``derivative`` each input row is followed by the row of its direction and each output row by that of its
    derivatives. Lanes: :func:`tmodes.compile.lanes.lane_rows.write_lane_samples`.
    """
    main = write_main(module, schedule, arithmetic, f"{name}.main")
    labels = [("n", I64), ("each", I64), ("p", POINTER), ("workspace", POINTER), ("in", POINTER), ("out", POINTER)]
    function = declare(module, name, VOID, labels)
    count, each, parameters, workspace, source, target = function.args
    b = ir.IRBuilder(function.append_basic_block("entry"))
    width = arithmetic.stride
    taken = [(schedule.offset(slot), slot.size) for slot in schedule.inputs.values()]
    given = [(schedule.offset(slot), slot.size) for slots in schedule.outputs.values() for slot in slots]
    spread_parameters(b, parameters, workspace, schedule.parameters, width)
    call_prepare(b, main, workspace)
    with counted(b, count, "sample") as sample:
        with b.if_then(b.icmp_signed("!=", each, whole(0))):
            start = at(b, parameters, b.mul(sample, whole(schedule.parameters)))
            spread_parameters(b, start, workspace, schedule.parameters, width)
            call_prepare(b, main, workspace)
        row = b.mul(sample, whole(schedule.input_size * width))
        copy_rows(b, at(b, source, row), workspace, taken, width, into=True)
        b.call(main, [workspace])
        row = b.mul(sample, whole(schedule.output_size * width))
        copy_rows(b, at(b, target, row), workspace, given, width, into=False)
    b.ret_void()


@dataclass(frozen=True)
class ScheduleRate:
    """A schedule as the right-hand side of the time loops: the counterpart of :class:`tmodes.compile.ir.lower.Lowered`.

    ``step_offset``: where in the held memory the length of an implicit step is put; ``gate_offset``: where two numbers
    stand that are both positive while a force acts that starts and ends; None where there is none. ``call_from``: as
    ``call`` with one more pointer after the state, to the coordinates and rates that springs start from.
    """

    prepare: Any
    call: Any
    held_size: int
    size: int
    row: int
    step_offset: int | None
    gate_offset: int | None = None
    call_from: Any = None


def write_rate(module: Any, schedule: Any, arithmetic: Double, name: str) -> ScheduleRate:
    """Functions ``prepare(parameters, held)`` and ``call(time, state, row, held, out)`` for the time loops.

    The schedule has the inputs ``time`` (1), ``state``, ``row`` and, where its steps may be implicit, ``step`` (1) and
    ``start``; its outputs are the rate of the state. ``held`` is its workspace.
    """
    main = write_main(module, schedule, arithmetic, f"{name}.main")
    prepare = declare(module, f"{name}.prepare", VOID, [("parameters", POINTER), ("held", POINTER)], private=True)
    b = ir.IRBuilder(prepare.append_basic_block("entry"))
    spread_parameters(b, prepare.args[0], prepare.args[1], schedule.parameters, 1)
    if "step" in schedule.inputs:
        store(b, ir.Constant(F64, 0.0), prepare.args[1], schedule.offset(schedule.inputs["step"]))
    call_prepare(b, main, prepare.args[1])
    b.ret_void()
    call = _write_call(module, schedule, main, f"{name}.call", ("state", "row"))
    apart = ("state", "start", "row")
    call_from = _write_call(module, schedule, main, f"{name}.call_from", apart) if "start" in schedule.inputs else None
    row, step = schedule.inputs["row"].size, schedule.inputs.get("step")
    offset = schedule.offset(step) if step else None
    gate = schedule.offset(schedule.gate) if schedule.gate else None
    return ScheduleRate(prepare, call, schedule.workspace, schedule.output_size, row, offset, gate, call_from)


def _write_call(module: Any, schedule: Any, main: Any, name: str, taken: tuple[str, ...]) -> Any:
    """The private function ``name(time, taken..., held, out)``; springs start from the state where nothing is given."""
    kinds = [("time", F64), *((label, POINTER) for label in (*taken, "held", "out"))]
    call = declare(module, name, VOID, kinds, private=True)
    call.attributes.add("noinline")
    time, *pointers, held, out = call.args
    b = ir.IRBuilder(call.append_basic_block("entry"))
    store(b, time, held, schedule.offset(schedule.inputs["time"]))
    sources = dict(zip(taken, pointers, strict=True))
    if "start" in schedule.inputs:
        sources.setdefault("start", sources["state"])
    for label, source in sources.items():
        slot = schedule.inputs[label]
        copy_rows(b, source, held, [(schedule.offset(slot), slot.size)], 1, into=True)
    b.call(main, [held])
    blocks = [(schedule.offset(slot), slot.size) for slots in schedule.outputs.values() for slot in slots]
    copy_rows(b, out, held, blocks, 1, into=False)
    b.ret_void()
    return call
