"""A straight-line program as two native functions: what is computed once per run, and what every call computes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from llvmlite import ir

from tmodes.compile.emit import F64, POINTER, VOID, declare, load, number, store
from tmodes.compile.program import Instruction, Program
from tmodes.compile.trigonometry import sine_and_cosine

__all__ = ["Lowered", "lower"]

_FUSE = ("contract",)  # a product and a sum may become one operation with one rounding; nothing else is rearranged


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


def lower(module: Any, program: Program) -> Lowered:
    """Write both functions into the module. An argument of one number is passed by value, a longer one by pointer."""
    held = program.held
    prepare = _function(module, f"{program.name}_prepare", [("parameters", POINTER), ("held", POINTER)])
    _Writer(module, program, {program.invariant: prepare.args[0]}, prepare).write_held(prepare.args[1], held)
    changing = [k for k in range(len(program.sizes)) if k != program.invariant]
    kinds = [(f"a{k}", F64 if program.sizes[k] == 1 else POINTER) for k in changing]
    call = _function(module, f"{program.name}_call", [*kinds, ("held", POINTER), ("out", POINTER)])
    writer = _Writer(module, program, dict(zip(changing, call.args, strict=False)), call)
    writer.take_held(call.args[-2], held)
    writer.write_outputs(call.args[-1])
    return Lowered(program, prepare, call, len(held))


def _function(module: Any, name: str, arguments: list[tuple[str, Any]]) -> Any:
    return declare(module, name, VOID, arguments, private=True)


class _Writer:
    """Writes values on demand, each once, in program order."""

    def __init__(self, module: Any, program: Program, arguments: dict[int, Any], function: Any) -> None:
        self.module, self.program, self.arguments = module, program, arguments
        self.builder = ir.IRBuilder(function.append_basic_block("entry"))
        self.known: dict[int, Any] = {}
        self.turned: dict[int, Any] = {}

    def write_held(self, into: Any, held: list[int]) -> None:
        self._write_all(fixed=True)
        for slot, index in enumerate(held):
            store(self.builder, self.known[index], into, slot)
        self.builder.ret_void()

    def take_held(self, source: Any, held: list[int]) -> None:
        for slot, index in enumerate(held):
            self.known[index] = load(self.builder, source, slot)

    def write_outputs(self, into: Any) -> None:
        self._write_all(fixed=False)
        given = {position for position, _ in self.program.outputs}
        for position, index in self.program.outputs:
            store(self.builder, self.known[index], into, position)
        for position in set(range(self.program.output_size)) - given:
            store(self.builder, number(0.0), into, position)
        self.builder.ret_void()

    def _write_all(self, *, fixed: bool) -> None:
        for index, value in enumerate(self.program.values):
            if value.kind == "constant":
                self.known[index] = number(value.value)
            elif self.program.fixed[index] == fixed:
                self.known[index] = self._value(value)

    def _value(self, value: Instruction) -> Any:
        if value.kind == "input":
            argument, element = value.source
            holder = self.arguments[argument]
            return load(self.builder, holder, element) if isinstance(holder.type, ir.PointerType) else holder
        if value.kind in ("sin", "cos"):
            return self._turn(value)
        return self._operation(value.kind, *(self.known[arg] for arg in value.args))

    def _turn(self, value: Instruction) -> Any:
        """One call for the sine and the cosine of an angle."""
        angle = value.args[0]
        if angle not in self.turned:
            self.turned[angle] = self.builder.call(sine_and_cosine(self.module), [self.known[angle]])
        return self.builder.extract_value(self.turned[angle], 0 if value.kind == "sin" else 1)

    def _operation(self, kind: str, a: Any, c: Any = None) -> Any:
        b: Any = self.builder
        if kind in _INTRINSICS:
            return b.call(self.module.declare_intrinsic(_INTRINSICS[kind], [F64]), [a])
        return _OPERATIONS[kind](b, a, c)


def _truth(b: Any, condition: Any) -> Any:
    """CasADi's truth values are the numbers 1 and 0."""
    return b.uitofp(condition, F64)


_INTRINSICS = {"sqrt": "llvm.sqrt", "fabs": "llvm.fabs"}

_OPERATIONS: dict[str, Callable[[Any, Any, Any], Any]] = {
    "add": lambda b, x, y: b.fadd(x, y, flags=_FUSE),
    "sub": lambda b, x, y: b.fsub(x, y, flags=_FUSE),
    "mul": lambda b, x, y: b.fmul(x, y, flags=_FUSE),
    "sq": lambda b, x, _: b.fmul(x, x, flags=_FUSE),
    "twice": lambda b, x, _: b.fmul(x, number(2.0), flags=_FUSE),
    "div": lambda b, x, y: b.fdiv(x, y),
    "inv": lambda b, x, _: b.fdiv(number(1.0), x),
    "neg": lambda b, x, _: b.fneg(x),
    "copy": lambda b, x, _: x,
    "lt": lambda b, x, y: _truth(b, b.fcmp_ordered("<", x, y)),
    "le": lambda b, x, y: _truth(b, b.fcmp_ordered("<=", x, y)),
    "not": lambda b, x, _: _truth(b, b.fcmp_ordered("==", x, number(0.0))),
    "if_else_zero": lambda b, x, y: b.select(b.fcmp_unordered("!=", x, number(0.0)), y, number(0.0)),
}
