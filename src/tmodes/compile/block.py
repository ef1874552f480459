"""A schedule of kernels as native code: each kernel one function on blocks of a workspace, called in order."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from llvmlite import ir

from tmodes.compile.arithmetic import Arithmetic
from tmodes.compile.emit import F64, I64, POINTER, VOID, at, counted, declare, load, store, whole
from tmodes.compile.program import Instruction, block_program
from tmodes.compile.turning import early_angles, order_of_evaluation

__all__ = ["ScheduleRate", "kernel_symbol", "write_kernel", "write_main", "write_rate", "write_samples", "write_values"]


def kernel_symbol(kernel: Any, arithmetic: str) -> str:
    """The name of a kernel's native function: the same for the same structure, everywhere."""
    told = f"{kernel.key} {kernel.inputs} {kernel.outputs} {arithmetic}"
    return f"kernel_{hashlib.sha256(told.encode()).hexdigest()[:32]}"


def write_kernel(module: Any, kernel: Any, arithmetic: Arithmetic) -> None:
    """The exported function of a kernel: pointers to the input blocks, then to the output blocks, never overlapping."""
    program = block_program(kernel.function())
    labels = [f"i{k}" for k in range(program.inputs)] + [f"o{k}" for k in range(program.outputs)]
    name = kernel_symbol(kernel, arithmetic.name)
    function = declare(module, name, VOID, [(label, POINTER) for label in labels])
    b = ir.IRBuilder(function.append_basic_block("entry"))

    def read(argument: int, element: int) -> Any:
        return arithmetic.load(b, function.args[argument], element)

    values = write_values(b, program.values, arithmetic, read)
    for output, element, index in program.results:
        value = arithmetic.constant(0.0) if index is None else values[index]
        arithmetic.store(b, value, function.args[program.inputs + output], element)
    b.ret_void()


def write_values(
    b: Any, program: Sequence[Instruction], arithmetic: Arithmetic, read: Callable[[int, int], Any]
) -> dict[int, Any]:
    """All values of a program by index; ``read`` gives an element of an argument."""
    values: dict[int, Any] = {}
    turned: dict[int, tuple[Any, Any]] = {}

    def write(index: int) -> Any:
        instruction = program[index]
        if instruction.kind == "constant":
            return arithmetic.constant(instruction.value)
        if instruction.kind == "input":
            return read(*instruction.source)
        if instruction.kind not in ("sin", "cos"):
            return arithmetic.operation(b, instruction.kind, *(values[arg] for arg in instruction.args))
        angle = instruction.args[0]
        if angle not in turned:
            turned[angle] = arithmetic.turn(b, values[angle])
        return turned[angle][0 if instruction.kind == "sin" else 1]

    angles = early_angles(program)
    first, rest = order_of_evaluation(program, angles)
    for index in first:
        values[index] = write(index)
    turned.update(zip(angles, arithmetic.turns(b, [values[angle] for angle in angles]), strict=True))
    for index in rest:
        values[index] = write(index)
    return values


def write_main(module: Any, schedule: Any, arithmetic: Arithmetic, name: str) -> Any:
    """The private function ``name(workspace)`` that makes all calls of a schedule, to kernels of other libraries."""
    main = declare(module, name, VOID, [("workspace", POINTER)], private=True)
    main.attributes.add("noinline")  # loops call it from many places, and the time is in the kernels
    b = ir.IRBuilder(main.append_basic_block("entry"))
    for kernel, inputs, outputs in schedule.calls:
        symbol = kernel_symbol(kernel, arithmetic.name)
        slots = (*inputs, *outputs)
        kinds = [(f"b{k}", POINTER) for k in range(len(slots))]
        function = module.globals.get(symbol) or declare(module, symbol, VOID, kinds)
        b.call(function, [at(b, main.args[0], schedule.offset(slot) * arithmetic.stride) for slot in slots])
    b.ret_void()
    return main


def write_samples(module: Any, schedule: Any, arithmetic: Arithmetic, name: str) -> None:
    """The exported ``name(n, each, parameters, workspace, in, out)``: the schedule at n samples, row by row.

    A row holds the inputs, or the outputs, one after the other; ``each`` not zero: every sample has parameters of its
    own. In ``lanes`` four rows go at once, and n counts fours; of ``derivative`` each input row is followed by the row
    of its direction and each output row by that of its derivatives.
    """
    main = write_main(module, schedule, arithmetic, f"{name}.main")
    labels = [("n", I64), ("each", I64), ("p", POINTER), ("workspace", POINTER), ("in", POINTER), ("out", POINTER)]
    function = declare(module, name, VOID, labels)
    count, each, parameters, workspace, source, target = function.args
    b = ir.IRBuilder(function.append_basic_block("entry"))
    width = arithmetic.stride
    taken = [(schedule.offset(slot), slot.size) for slot in schedule.inputs.values()]
    given = [(schedule.offset(slot), slot.size) for slots in schedule.outputs.values() for slot in slots]
    _spread_parameters(b, parameters, workspace, schedule.parameters, width, same=arithmetic.name == "lanes")
    with counted(b, count, "sample") as sample:
        with b.if_then(b.icmp_signed("!=", each, whole(0))):
            rows = width if arithmetic.name == "lanes" else 1
            start = at(b, parameters, b.mul(sample, whole(schedule.parameters * rows)))
            if arithmetic.name == "lanes":
                _copy_rows(b, start, workspace, [(0, schedule.parameters)], width, into=True)
            else:
                _spread_parameters(b, start, workspace, schedule.parameters, width)
        row = b.mul(sample, whole(schedule.input_size * width))
        _copy_rows(b, at(b, source, row), workspace, taken, width, into=True)
        b.call(main, [workspace])
        row = b.mul(sample, whole(schedule.output_size * width))
        _copy_rows(b, at(b, target, row), workspace, given, width, into=False)
    b.ret_void()


def _spread_parameters(b: Any, source: Any, workspace: Any, size: int, width: int, *, same: bool = False) -> None:
    """Parameters at the start of the workspace; beside each, its copies (``same``) or derivatives, which are zero."""
    with counted(b, size, "parameter") as k:
        place, value = b.mul(k, whole(width)), load(b, source, k)
        store(b, value, workspace, place)
        for lane in range(1, width):
            store(b, value if same else ir.Constant(F64, 0.0), workspace, b.add(place, whole(lane)))


def _copy_rows(b: Any, rows: Any, workspace: Any, blocks: list[tuple[int, int]], width: int, *, into: bool) -> None:
    """``width`` rows, one after the other, into or out of blocks of the workspace whose numbers are ``width`` wide."""
    length = sum(size for _, size in blocks)
    first = 0
    for offset, size in blocks:
        with counted(b, size, "block") as k:
            for lane in range(width):
                beside = b.add(k, whole(lane * length + first))
                place = b.add(b.mul(k, whole(width)), whole(offset * width + lane))
                if into:
                    store(b, load(b, rows, beside), workspace, place)
                else:
                    store(b, load(b, workspace, place), rows, beside)
        first += size


@dataclass(frozen=True)
class ScheduleRate:
    """A schedule as the right-hand side of the time loops: what :class:`tmodes.compile.lower.Lowered` is to a program.

    ``step_offset``: where in the held memory the length of an implicit step is put; ``gate_offset``: where two numbers
    stand that are both positive while a force acts that sets in and ends; None where there is none.
    """

    prepare: Any
    call: Any
    held_size: int
    size: int
    row: int
    step_offset: int | None
    gate_offset: int | None = None


def write_rate(module: Any, schedule: Any, arithmetic: Arithmetic, name: str) -> ScheduleRate:
    """Functions ``prepare(parameters, held)`` and ``call(time, state, row, held, out)`` for the time loops.

    The schedule has the inputs ``time`` (1), ``state``, ``row`` and, where its steps may be implicit, ``step`` (1); its
    outputs are the rate of the state. ``held`` is its workspace.
    """
    main = write_main(module, schedule, arithmetic, f"{name}.main")
    prepare = declare(module, f"{name}.prepare", VOID, [("parameters", POINTER), ("held", POINTER)], private=True)
    b = ir.IRBuilder(prepare.append_basic_block("entry"))
    _spread_parameters(b, prepare.args[0], prepare.args[1], schedule.parameters, 1)
    if "step" in schedule.inputs:
        store(b, ir.Constant(F64, 0.0), prepare.args[1], schedule.offset(schedule.inputs["step"]))
    b.ret_void()
    kinds = [("time", F64), ("state", POINTER), ("row", POINTER), ("held", POINTER), ("out", POINTER)]
    call = declare(module, f"{name}.call", VOID, kinds, private=True)
    call.attributes.add("noinline")
    time, state, row, held, out = call.args
    b = ir.IRBuilder(call.append_basic_block("entry"))
    store(b, time, held, schedule.offset(schedule.inputs["time"]))
    for source, label in ((state, "state"), (row, "row")):
        slot = schedule.inputs[label]
        _copy_rows(b, source, held, [(schedule.offset(slot), slot.size)], 1, into=True)
    b.call(main, [held])
    blocks = [(schedule.offset(slot), slot.size) for slots in schedule.outputs.values() for slot in slots]
    _copy_rows(b, out, held, blocks, 1, into=False)
    b.ret_void()
    row, step = schedule.inputs["row"].size, schedule.inputs.get("step")
    offset = schedule.offset(step) if step else None
    gate = schedule.offset(schedule.gate) if schedule.gate else None
    return ScheduleRate(prepare, call, schedule.workspace, schedule.output_size, row, offset, gate)
