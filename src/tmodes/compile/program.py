"""A CasADi function as a straight-line program in single assignment form, parted by what changes during a run."""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca

from tmodes.errors import CompileError

__all__ = ["Instruction", "Program", "straight_line"]

_UNARY = {
    ca.OP_NEG: "neg", ca.OP_SQ: "sq", ca.OP_TWICE: "twice", ca.OP_SQRT: "sqrt", ca.OP_INV: "inv",
    ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_FABS: "fabs", ca.OP_NOT: "not", ca.OP_ASSIGN: "copy",
}  # fmt: skip
_BINARY = {
    ca.OP_ADD: "add", ca.OP_SUB: "sub", ca.OP_MUL: "mul", ca.OP_DIV: "div", ca.OP_LT: "lt", ca.OP_LE: "le",
    ca.OP_IF_ELSE_ZERO: "if_else_zero",
}  # fmt: skip


@dataclass(frozen=True)
class Instruction:
    """One value: ``kind`` is an operation, ``constant`` or ``input``; ``args`` are indices of earlier values.

    ``source`` is (argument, element) of an input, ``value`` the number of a constant.
    """

    kind: str
    args: tuple[int, ...] = ()
    source: tuple[int, int] = (0, 0)
    value: float = 0.0


@dataclass
class Program:
    """Straight-line program: ``values`` in order of evaluation, ``outputs`` as (position, index of value).

    ``sizes`` holds the length of each argument. The argument ``invariant`` does not change during a run: values that
    follow from it alone are computed once, before the loop (``held``, in the order of their slots).
    """

    name: str
    sizes: tuple[int, ...]
    invariant: int
    output_size: int
    values: list[Instruction] = field(default_factory=list)
    outputs: list[tuple[int, int]] = field(default_factory=list)
    fixed: list[bool] = field(default_factory=list)

    @property
    def held(self) -> list[int]:
        """Invariant values that the changing part reads, constants aside."""
        used = {arg for index, value in enumerate(self.values) if not self.fixed[index] for arg in value.args}
        used |= {index for _, index in self.outputs}
        return sorted(index for index in used if self.fixed[index] and self.values[index].kind != "constant")


def straight_line(function: ca.Function, invariant: int) -> Program:
    """Read a function of several vectors and one output vector; ``invariant`` is the index of the parameters.

    Raises :class:`CompileError` for an operation that has no native form.
    """
    sizes = tuple(function.nnz_in(k) for k in range(function.n_in()))
    program = Program(function.name(), sizes, invariant, function.nnz_out(0))
    registers: dict[int, int] = {}
    for k in range(function.n_instructions()):
        operation = function.instruction_id(k)
        into, reads = function.instruction_output(k), function.instruction_input(k)
        if operation == ca.OP_OUTPUT:
            program.outputs.append((into[1], registers[reads[0]]))
            continue
        if operation == ca.OP_CONST:
            instruction = Instruction("constant", value=function.instruction_constant(k))
        elif operation == ca.OP_INPUT:
            instruction = Instruction("input", source=(reads[0], reads[1]))
        else:
            kind = _UNARY.get(operation) or _BINARY.get(operation)
            if kind is None:
                raise CompileError(f"{function.name()}: operation {operation} of CasADi has no native form here")
            arity = 1 if operation in _UNARY else 2
            instruction = Instruction(kind, tuple(registers[register] for register in reads[:arity]))
        registers[into[0]] = len(program.values)
        program.values.append(instruction)
        program.fixed.append(_is_fixed(program, instruction))
    return program


def _is_fixed(program: Program, instruction: Instruction) -> bool:
    if instruction.kind == "input":
        return instruction.source[0] == program.invariant
    return all(program.fixed[arg] for arg in instruction.args)
