"""A straight-line program as two native functions: what is computed once per run, and what every call computes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.emit import POINTER, VOID, declare
from tmodes.compile.ir.program import Instruction, Program

__all__ = ["Lowered", "lower"]


@dataclass(frozen=True)
class Lowered:
    """``prepare(p, held)`` and ``call(args…, held, out)``, private functions of a module; sizes in doubles."""

    program: Program
    prepare: Any
    call: Any
    held_size: int
    gate_offset: int | None = None

    @property
    def size(self) -> int:
        """Numbers of the output."""
        return self.program.output_size

    @property
    def row(self) -> int:
        """Numbers of a row of the reference, the third argument of a right-hand side."""
        return self.program.sizes[2]


def lower(module: Any, program: Program, arithmetic: Double | None = None) -> Lowered:
    """Write both functions into the module. An argument of one number is passed by value, a longer one by pointer."""
    held, arithmetic = program.held, arithmetic or Double(module)
    prepare = _function(module, f"{program.name}_prepare", [("parameters", POINTER), ("held", POINTER)])
    _Writer(arithmetic, program, {program.invariant: prepare.args[0]}, prepare).write_held(prepare.args[1], held)
    changing = [k for k in range(len(program.sizes)) if k != program.invariant]
    kinds = [(f"a{k}", arithmetic.kind if program.sizes[k] == 1 else POINTER) for k in changing]
    call = _function(module, f"{program.name}_call", [*kinds, ("held", POINTER), ("out", POINTER)])
    writer = _Writer(arithmetic, program, dict(zip(changing, call.args, strict=False)), call)
    writer.take_held(call.args[-2], held)
    writer.write_outputs(call.args[-1])
    return Lowered(program, prepare, call, len(held))


def _function(module: Any, name: str, arguments: list[tuple[str, Any]]) -> Any:
    return declare(module, name, VOID, arguments, private=True)


class _Writer:
    """Writes values on demand, each once, in program order."""

    def __init__(self, arithmetic: Double, program: Program, arguments: dict[int, Any], function: Any) -> None:
        self.arithmetic, self.program, self.arguments = arithmetic, program, arguments
        self.builder = ir.IRBuilder(function.append_basic_block("entry"))
        self.known: dict[int, Any] = {}
        self.turned: dict[int, Any] = {}

    def write_held(self, into: Any, held: list[int]) -> None:
        self._write_all(fixed=True)
        for slot, index in enumerate(held):
            self.arithmetic.store(self.builder, self.known[index], into, slot)
        self.builder.ret_void()

    def take_held(self, source: Any, held: list[int]) -> None:
        for slot, index in enumerate(held):
            self.known[index] = self.arithmetic.load(self.builder, source, slot)

    def write_outputs(self, into: Any) -> None:
        self._write_all(fixed=False)
        given = {position for position, _ in self.program.outputs}
        for position, index in self.program.outputs:
            self.arithmetic.store(self.builder, self.known[index], into, position)
        for position in set(range(self.program.output_size)) - given:
            self.arithmetic.store(self.builder, self.arithmetic.constant(0.0), into, position)
        self.builder.ret_void()

    def _write_all(self, *, fixed: bool) -> None:
        for index, value in enumerate(self.program.values):
            if value.opcode == "constant":
                self.known[index] = self.arithmetic.constant(value.value)
            elif self.program.fixed[index] == fixed:
                self.known[index] = self._value(value)

    def _value(self, value: Instruction) -> Any:
        if value.opcode == "input":
            argument, element = value.source
            holder = self.arguments[argument]
            pointed = isinstance(holder.type, ir.PointerType)
            return self.arithmetic.load(self.builder, holder, element) if pointed else holder
        if value.opcode in ("sin", "cos"):
            angle = value.args[0]
            if angle not in self.turned:
                self.turned[angle] = self.arithmetic.turn(self.builder, self.known[angle])
            return self.turned[angle][0 if value.opcode == "sin" else 1]
        return self.arithmetic.operation(self.builder, value.opcode, *(self.known[arg] for arg in value.args))
