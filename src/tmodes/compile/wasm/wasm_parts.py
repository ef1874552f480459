"""The compiled code of models as parts of a WebAssembly module: time loops, functions over samples, kernels.

A long kernel is a row of functions: LLVM's time for WebAssembly grows with the square of a function's length.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from itertools import pairwise
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.emit import POINTER, VOID, Builder, declare, scratch
from tmodes.compile.ir.kernels import arithmetic_of, kernel_code, schedule_module
from tmodes.compile.ir.program import READ, BlockProgram, Instruction, kernel_program
from tmodes.compile.ir.values import write_values
from tmodes.compile.loops.loops import loop_arithmetic, schedule_loop_module
from tmodes.compile.native import kernel_symbol, pays
from tmodes.compile.wasm.wasm import WasmPart
from tmodes.integrate.method import JACOBIAN
from tmodes.integrate.registry import integrator

__all__ = ["each_once", "kernel_in_pieces", "schedule_loop", "schedule_samples"]

PIECE = 5000
"""Values of a kernel that make one function: shorter ones only make the code of usual beams longer."""


def schedule_loop(symbol: str, schedule: Any, guarded: int, method: str, **more: Any) -> list[WasmPart]:
    """A loop around a schedule with the kernels that it calls; ``more``: pairs and columns, as the method needs."""
    arithmetic = loop_arithmetic(method)
    write = partial(schedule_loop_module, schedule, guarded, method, symbol, **more)
    simd = arithmetic == "lanes"
    loop = WasmPart(f"loop {method} {guarded} {more} {schedule.key}", write, (symbol,), simd=simd, level=1)
    slopes = _kernels(schedule, "derivative") if integrator(method).asks == JACOBIAN else []
    jumps = [*_called(schedule.sampled, "double"), *_called(schedule.switched, "double")]
    return [loop, *_called(schedule, arithmetic), *jumps, *slopes]


def schedule_samples(symbol: str, schedule: Any, arithmetic: str = "double", piece: int = PIECE) -> list[WasmPart]:
    """A schedule over many samples with its kernels, as of :func:`tmodes.compile.ir.kernels.schedule_function`.

    ``piece``: values of a kernel that make one function.
    """
    write = partial(schedule_module, schedule, arithmetic, symbol)
    run = WasmPart(f"schedule {arithmetic} {schedule.key}", write, (symbol,), simd=arithmetic == "lanes")
    return [run, *_called(schedule, arithmetic, piece)]


def each_once(parts: Iterable[WasmPart]) -> list[WasmPart]:
    """The parts without those that came before: kernels are the same wherever they are called from."""
    return list({part.symbols: part for part in parts}.values())


def _called(schedule: Any, arithmetic: str, piece: int = PIECE) -> list[WasmPart]:
    unrolled = not schedule or (arithmetic_of(arithmetic).unrolls and pays(schedule))
    return [] if unrolled else _kernels(schedule, arithmetic, piece)


def _kernels(schedule: Any, arithmetic: str, piece: int = PIECE) -> list[WasmPart]:
    kernels = {kernel_symbol(kernel, arithmetic): kernel for kernel, _, _ in schedule.calls}
    return [
        WasmPart(
            f"{symbol} {piece}", partial(kernel_in_pieces, kernel, arithmetic, piece), (symbol,),
            exported=False, simd=arithmetic == "lanes",
        )
        for symbol, kernel in kernels.items()
    ]  # fmt: skip


def kernel_in_pieces(kernel: Any, arithmetic: str, piece: int) -> Any:
    """The IR of one kernel in functions of ``piece`` values; what one finds for a later one is kept on the stack."""
    program = kernel_program(kernel)
    if len(program.values) <= piece:
        return kernel_code(kernel, arithmetic)
    name = kernel_symbol(kernel, arithmetic)
    module = ir.Module(name)
    _Pieces(module, name, program, arithmetic_of(arithmetic)(module), piece).write()
    return module


class _Pieces:
    """Cuts a program at equal distances; what is merely read is read again in each piece that needs it."""

    def __init__(self, module: Any, name: str, program: BlockProgram, arithmetic: Double, piece: int) -> None:
        self.module, self.name, self.program, self.arithmetic = module, name, program, arithmetic
        values = program.values
        self.cuts = [*range(0, len(values), piece), len(values)]
        crossing = {
            arg for start in self.cuts[1:-1] for value in values[start : start + piece] for arg in value.args
            if arg < start and values[arg].opcode not in READ
        }  # fmt: skip
        self.slots = {index: slot for slot, index in enumerate(sorted(crossing))}
        self.blocks = program.inputs + program.outputs

    def write(self) -> None:
        """The exported function of the kernel, which calls its pieces."""
        kinds = [(f"b{k}", POINTER) for k in range(self.blocks)]
        function = declare(self.module, self.name, VOID, kinds)
        b = Builder(function.append_basic_block("entry"))
        kept = scratch(b, len(self.slots) * self.arithmetic.stride, "kept")
        for start, end in pairwise(self.cuts):
            b.call(self._piece(start, end), [*function.args, kept])
        b.ret_void()

    def _piece(self, start: int, end: int) -> Any:
        kinds = [(f"b{k}", POINTER) for k in range(self.blocks + 1)]
        function = declare(self.module, f"{self.name}.{start}", VOID, kinds, private=True)
        function.attributes.add("noinline")
        b = Builder(function.append_basic_block("entry"))
        places, steps = self._steps(start, end)
        found = write_values(
            b, steps, self.arithmetic, lambda block, k: self.arithmetic.load(b, function.args[block], k)
        )
        for index in range(start, end):
            if index in self.slots:
                self.arithmetic.store(b, found[places[index]], function.args[self.blocks], self.slots[index])
        for output, element, index in self.program.results:
            block = function.args[self.program.inputs + output]
            if index is not None and start <= index < end:
                self.arithmetic.store(b, found[places[index]], block, element)
            elif index is None and start == 0:
                self.arithmetic.store(b, self.arithmetic.constant(0.0), block, element)
        b.ret_void()
        return function

    def _steps(self, start: int, end: int) -> tuple[dict[int, int], list[Instruction]]:
        """A piece as a program of its own, and where the values that it needs stand in it."""
        places: dict[int, int] = {}
        steps: list[Instruction] = []
        values = self.program.values
        for index in range(start, end):
            for arg in values[index].args:
                if arg not in places:
                    places[arg] = len(steps)
                    kept = Instruction("input", source=(self.blocks, self.slots.get(arg, 0)))
                    steps.append(values[arg] if values[arg].opcode in READ else kept)
            places[index] = len(steps)
            steps.append(values[index]._replace(args=tuple(places[arg] for arg in values[index].args)))
        return places, steps
