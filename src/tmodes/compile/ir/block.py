"""A schedule of kernels as native code: each kernel one function on blocks of a workspace, called in order."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.calls import Layout, write_calls
from tmodes.compile.ir.emit import I64, POINTER, VOID, Builder, at, counted, declare, whole
from tmodes.compile.ir.program import BlockProgram, Instruction
from tmodes.compile.ir.rows import copy_numbers, give_rows, take_parameters, take_rows
from tmodes.compile.ir.unroll import Unrolled, unrolled
from tmodes.compile.ir.values import write_values
from tmodes.compile.native import kernel_symbol, pays

__all__ = [
    "Main", "ScheduleRate", "write_jumps", "write_main", "write_program", "write_rate",
    "write_samples",
]  # fmt: skip


def write_program(module: Any, name: str, program: BlockProgram, arithmetic: Double) -> None:
    """The exported function of a kernel: pointers to the input blocks, then to the output blocks, never overlapping."""
    labels = [f"i{k}" for k in range(program.inputs)] + [f"o{k}" for k in range(program.outputs)]
    function = declare(module, name, VOID, [(label, POINTER) for label in labels])
    b = Builder(function.append_basic_block("entry"))

    def read(argument: int, element: int) -> Any:
        return arithmetic.load(b, function.args[argument], element)

    values = write_values(b, program.values, arithmetic, read)
    for output, element, index in program.results:
        value = arithmetic.constant(0.0) if index is None else values[index]
        arithmetic.store(b, value, function.args[program.inputs + output], element)
    b.ret_void()


class Main(NamedTuple):
    """The private ``function(workspace)`` of a schedule; ``memory`` says where a block begins, and how large it is."""

    function: Any
    memory: Any

    def prepare(self, b: Any, workspace: Any) -> None:
        """After new parameters: compute what follows from them, where a schedule is unrolled."""
        prepare = b.function.module.globals.get(f"{self.function.name}.prepare")
        if prepare is not None:
            b.call(prepare, [workspace])

    def blocks(self, slots: Iterable[Any]) -> list[tuple[int, int]]:
        """Offsets and sizes of blocks, in numbers."""
        return [(self.memory.offset(slot), slot.size) for slot in slots]


def write_main(module: Any, schedule: Any, numbers: Double, name: str) -> Main:
    """All calls of a schedule, to kernels of other libraries; or none, where it is unrolled."""
    if numbers.unrolls and pays(schedule):
        return Main(_write_unrolled(module, unrolled(schedule), numbers, name), schedule)
    memory = Layout(schedule) if numbers.packs else schedule
    main = declare(module, name, VOID, [("workspace", POINTER)], private=True)
    main.attributes.add("noinline")  # loops call it from many places, and the time is in the kernels
    b = Builder(main.append_basic_block("entry"))
    symbols = partial(kernel_symbol, arithmetic=numbers.name)
    write_calls(b, schedule, numbers, main.args[0], symbols, memory.offset)
    b.ret_void()
    return Main(main, memory)


def _write_unrolled(module: Any, code: Unrolled, arithmetic: Double, name: str) -> Any:
    parts = (f"{name}.prepare", code.prepare, code.prepared), (name, code.main, code.results)
    return [_write_program(module, *part, arithmetic) for part in parts][-1]


def _write_program(
    module: Any, name: str, program: Sequence[Instruction], results: Sequence[tuple[int, int]], arithmetic: Double
) -> Any:
    """The private function ``name(workspace)`` of one program on a workspace."""
    function = declare(module, name, VOID, [("workspace", POINTER)], private=True)
    function.attributes.add("noinline")
    b = Builder(function.append_basic_block("entry"))
    workspace = function.args[0]
    values = write_values(b, program, arithmetic, lambda _, place: arithmetic.load(b, workspace, place))
    for place, index in results:
        arithmetic.store(b, values[index], workspace, place)
    b.ret_void()
    return function


def write_samples(module: Any, schedule: Any, numbers: Double, name: str) -> None:
    """The exported ``name(n, each, parameters, workspace, in, out)``: the schedule at n samples, row by row.

    A row holds the inputs, or the outputs, one after the other; ``each`` not zero: every sample has parameters of its
    own. Of ``derivative`` each input row is followed by the row of its direction and each output row by that of its
    derivatives; of ``second`` each is followed by three, that of parameters too. Of lanes n counts groups of them, and
    a row is followed by those of the other lanes.
    """
    main = write_main(module, schedule, numbers, f"{name}.main")
    labels = [("n", I64), ("each", I64), ("p", POINTER), ("workspace", POINTER), ("in", POINTER), ("out", POINTER)]
    function = declare(module, name, VOID, labels)
    count, each, parameters, workspace, source, target = function.args
    b = Builder(function.append_basic_block("entry"))
    taken = main.blocks(schedule.inputs.values())
    given = main.blocks(slot for slots in schedule.outputs.values() for slot in slots)
    width, own, rows = (
        numbers.stride,
        [(0, schedule.parameters)],
        numbers.stride if numbers.packs or numbers.stride > 2 else 1,
    )

    def take_own(row: Any, count: int) -> None:
        if numbers.stride == 1:
            take_parameters(b, numbers, row, workspace, schedule.parameters)
        else:
            take_rows(b, numbers, row, workspace, own, count)

    has_own = b.icmp_signed("!=", each, whole(0))
    with b.if_then(b.not_(has_own)):
        take_own(parameters, 1)
        main.prepare(b, workspace)
    with counted(b, count, "sample") as sample:
        with b.if_then(has_own):
            start = at(b, parameters, b.mul(sample, whole(schedule.parameters * rows)))
            take_own(start, rows)
            main.prepare(b, workspace)
        row = at(b, source, b.mul(sample, whole(schedule.input_size * width)))
        take_rows(b, numbers, row, workspace, taken, width)
        b.call(main.function, [workspace])
        row = at(b, target, b.mul(sample, whole(schedule.output_size * width)))
        give_rows(b, numbers, row, workspace, given)
    b.ret_void()


@dataclass(frozen=True)
class ScheduleRate:
    """A schedule as the right-hand side of the time loops; sizes count numbers, which may be vectors of lanes.

    ``step_offset``: where in the held memory the length of an implicit step is put; ``gate_offset``: where the
    ``gate_count`` pairs of numbers stand that are both positive while a force acts that starts and ends; None: no pair.
    ``call_from``: as ``call`` with one more pointer after the state, to the coordinates and rates that springs start
    from. ``sampled``: the state after the samples at a knot, as a function of the same kind; None where nothing is
    sampled. ``switches``: where the ``switch_count`` numbers stand that end what sticks or slips; ``switched``: the
    state after such an end. ``narrow``: where the ``narrow_count`` rates of narrow friction stand, and their widths
    behind them. ``jolts``: a sample at the instant of a switch at a knot is of the state after it.
    """

    prepare: Any
    call: Any
    held_size: int
    size: int
    row: int
    step_offset: int | None
    gate_offset: int | None = None
    gate_count: int = 0
    call_from: Any = None
    sampled: ScheduleRate | None = None
    switches: int = 0
    switch_count: int = 0
    switched: ScheduleRate | None = None
    narrow: int = 0
    narrow_count: int = 0
    jolts: bool = False

    @property
    def changes(self) -> bool:
        """Whether forces start or end at instants of their own, on which steps end."""
        return self.gate_offset is not None or self.switch_count > 0


def write_rate(module: Any, schedule: Any, numbers: Double, name: str) -> ScheduleRate:
    """Functions ``prepare(parameters, held)`` and ``call(time, state, row, held, out)`` for the time loops.

    The schedule has the inputs ``time`` (1), ``state``, ``row`` and, where its steps may be implicit, ``step`` (1) and
    ``start``; its outputs are the rate of the state. ``held`` is its workspace.
    """
    main, inputs = write_main(module, schedule, numbers, f"{name}.main"), schedule.inputs
    prepare = declare(module, f"{name}.prepare", VOID, [("parameters", POINTER), ("held", POINTER)], private=True)
    b = Builder(prepare.append_basic_block("entry"))
    take_parameters(b, numbers, prepare.args[0], prepare.args[1], schedule.parameters)
    step = main.memory.offset(inputs["step"]) if "step" in inputs else None
    if step is not None:
        numbers.store(b, numbers.constant(0.0), prepare.args[1], step)
    main.prepare(b, prepare.args[1])
    b.ret_void()
    write = partial(_write_call, module, schedule, main, numbers)
    call = write(f"{name}.call", ("state", "row"))
    call_from = write(f"{name}.call_from", ("state", "start", "row")) if "start" in inputs else None
    gate = (main.memory.offset(schedule.gate), schedule.gate.size // 2) if schedule.gate else (None, 0)
    sampled, switched = write_jumps(module, schedule, numbers, name)
    sizes = (main.memory.workspace, schedule.output_size, inputs["row"].size)
    switches = (main.memory.offset(schedule.switches), schedule.switches.size) if schedule.switches else (0, 0)
    narrow = (main.memory.offset(schedule.narrow), schedule.narrow.size // 2) if schedule.narrow else (0, 0)
    jumps = (sampled, switches[0], switches[1], switched, narrow[0], narrow[1], schedule.jolts)
    return ScheduleRate(prepare, call, *sizes, step, *gate, call_from, *jumps)


def write_jumps(module: Any, schedule: Any, numbers: Double, name: str) -> list[ScheduleRate | None]:
    """What changes a state at an instant: samples, and switches; None for those that there are not."""
    jumps = {"sampled": schedule.sampled, "switched": schedule.switched}
    return [write_rate(module, jump, numbers, f"{name}.{label}") if jump else None for label, jump in jumps.items()]


def _write_call(module: Any, schedule: Any, main: Main, numbers: Double, name: str, taken: tuple[str, ...]) -> Any:
    """The private function ``name(time, taken..., held, out)``; springs start from the state where nothing is given."""
    kinds = [("time", numbers.kind), *((label, POINTER) for label in (*taken, "held", "out"))]
    call = declare(module, name, VOID, kinds, private=True)
    call.attributes.add("noinline")
    time, *pointers, held, out = call.args
    b = Builder(call.append_basic_block("entry"))
    numbers.store(b, time, held, main.memory.offset(schedule.inputs["time"]))
    sources = dict(zip(taken, pointers, strict=True))
    if "start" in schedule.inputs:
        sources.setdefault("start", sources["state"])
    for label, source in sources.items():
        copy_numbers(b, numbers, source, held, main.blocks([schedule.inputs[label]]), into=True)
    b.call(main.function, [held])
    blocks = main.blocks(slot for slots in schedule.outputs.values() for slot in slots)
    copy_numbers(b, numbers, out, held, blocks, into=False)
    b.ret_void()
    return call
