"""A CasADi function as a straight-line program in single assignment form."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import casadi as ca

from tmodes.errors import CompileError

__all__ = ["READ", "BlockProgram", "Instruction", "block_program", "needed", "with_shared_inverses"]

READ = ("constant", "input")
"""Kinds of values that are not computed."""

_WORTH_AN_INVERSE = 2

_UNARY = {
    ca.OP_NEG: "neg", ca.OP_SQ: "sq", ca.OP_TWICE: "twice", ca.OP_SQRT: "sqrt", ca.OP_INV: "inv",
    ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_FABS: "fabs", ca.OP_SIGN: "sign", ca.OP_NOT: "not", ca.OP_ASSIGN: "copy",
}  # fmt: skip
_BINARY = {
    ca.OP_ADD: "add", ca.OP_SUB: "sub", ca.OP_MUL: "mul", ca.OP_DIV: "div", ca.OP_LT: "lt", ca.OP_LE: "le",
    ca.OP_IF_ELSE_ZERO: "if_else_zero",
}  # fmt: skip


class Instruction(NamedTuple):
    """One value: ``opcode`` is an operation, ``constant`` or ``input``; ``args`` are indices of earlier values.

    ``source`` is (argument, element) of an input, ``value`` the number of a constant.
    """

    opcode: str
    args: tuple[int, ...] = ()
    source: tuple[int, int] = (0, 0)
    value: float = 0.0


def _instruction(function: ca.Function, k: int, registers: dict[int, int]) -> Instruction:
    """Instruction ``k`` of a function, which is no output; ``registers`` says which value each register holds."""
    operation, reads = function.instruction_id(k), function.instruction_input(k)
    if operation == ca.OP_CONST:
        return Instruction("constant", value=function.instruction_constant(k))
    if operation == ca.OP_INPUT:
        return Instruction("input", source=(reads[0], reads[1]))
    kind = _UNARY.get(operation) or _BINARY.get(operation)
    if kind is None:
        raise CompileError(f"{function.name()}: operation {operation} of CasADi has no native form here")
    arity = 1 if operation in _UNARY else 2
    return Instruction(kind, tuple(registers[register] for register in reads[:arity]))


@dataclass
class BlockProgram:
    """Straight-line program of several input and output blocks; ``results``: (output, element, index of value).

    ``codes``: as IR, by the kind of numbers, once it is written.
    """

    inputs: int
    outputs: int
    values: list[Instruction] = field(default_factory=list)
    results: list[tuple[int, int, int | None]] = field(default_factory=list)
    codes: dict[str, str] = field(default_factory=dict, repr=False, compare=False)


def block_program(function: ca.Function) -> BlockProgram:
    """Read a function of several vectors with several dense output vectors; what is not given is zero."""
    program = BlockProgram(function.n_in(), function.n_out())
    registers: dict[int, int] = {}
    given: set[tuple[int, int]] = set()
    for k in range(function.n_instructions()):
        into = function.instruction_output(k)
        if function.instruction_id(k) == ca.OP_OUTPUT:
            program.results.append((into[0], into[1], registers[function.instruction_input(k)[0]]))
            given.add((into[0], into[1]))
            continue
        instruction = _instruction(function, k, registers)
        registers[into[0]] = len(program.values)
        program.values.append(instruction)
    every = {(out, element) for out in range(function.n_out()) for element in range(function.nnz_out(out))}
    program.values, places = with_shared_inverses(program.values)
    program.results = [(out, element, places[index]) for out, element, index in program.results if index is not None]
    program.results += [(out, element, None) for out, element in sorted(every - given)]
    return program


def needed(values: Sequence[Instruction], results: Iterable[int]) -> list[int]:
    """Indices of the values that some of them need, in order."""
    marks = bytearray(len(values))
    for index in results:
        marks[index] = True
    for index in reversed(range(len(values))):
        if marks[index]:
            for arg in values[index].args:
                marks[arg] = True
    return [index for index, is_needed in enumerate(marks) if is_needed]


def with_shared_inverses(values: Sequence[Instruction]) -> tuple[list[Instruction], list[int]]:
    """Quotients with one divisor become products with its inverse; and where each value stands now.

    A division keeps its unit busy for as long as five products.
    """
    divided = Counter(value.args[1] for value in values if value.opcode == "div")
    changed: list[Instruction] = []
    places: list[int] = []
    inverses: dict[int, int] = {}
    for value in values:
        divisor = value.args[1] if value.opcode == "div" else -1
        if divided[divisor] >= _WORTH_AN_INVERSE:
            if divisor not in inverses:
                inverses[divisor] = len(changed)
                changed.append(Instruction("inv", (places[divisor],)))
            changed.append(Instruction("mul", (places[value.args[0]], inverses[divisor])))
        else:
            changed.append(value._replace(args=tuple(places[arg] for arg in value.args)))
        places.append(len(changed) - 1)
    return changed, places
