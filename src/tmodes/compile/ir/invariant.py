"""A function parted by what changes in a run: what follows from one argument alone, and the rest."""

from __future__ import annotations

from typing import Any

import casadi as ca

from tmodes.compile.ir.program import Instruction, straight_line

__all__ = ["parted"]

_APPLIED: dict[str, Any] = {
    "neg": lambda x: -x, "sq": lambda x: x * x, "twice": lambda x: 2 * x, "sqrt": ca.sqrt, "inv": lambda x: 1 / x,
    "sin": ca.sin, "cos": ca.cos, "fabs": ca.fabs, "sign": ca.sign, "not": ca.logic_not, "copy": lambda x: x,
    "add": lambda x, y: x + y, "sub": lambda x, y: x - y, "mul": lambda x, y: x * y, "div": lambda x, y: x / y,
    "lt": lambda x, y: x < y, "le": lambda x, y: x <= y,
    "if_else_zero": lambda x, y: ca.SX.binary(ca.OP_IF_ELSE_ZERO, x, y),
}  # fmt: skip


def parted(function: ca.Function, invariant: int) -> tuple[ca.Function, ca.Function]:
    """``held(invariant argument)``, and ``rest(other arguments, held)``, which gives the output.

    The function has several vectors and one dense output; together both do what it does, operation by operation.
    """
    program = straight_line(function, invariant)
    arguments = [ca.SX.sym(f"a{k}", size) for k, size in enumerate(program.sizes)]
    held, slots = program.held, ca.SX.sym("held", len(program.held))
    before = _values(program.values, arguments, {}, only=program.fixed)
    after = _values(program.values, arguments, {index: slots[slot] for slot, index in enumerate(held)})
    out = ca.SX(program.output_size, 1)
    for position, index in program.outputs:
        out[position] = after[index]
    first = ca.Function("held", [arguments[invariant]], [ca.vertcat(*(before[index] for index in held))])
    others = [argument for k, argument in enumerate(arguments) if k != invariant]
    return first, ca.Function("rest", [*others, slots], [ca.densify(out)])


def _values(
    values: list[Instruction], arguments: list[Any], known: dict[int, Any], only: list[bool] | None = None
) -> dict[int, Any]:
    """Expressions of all values, or of those marked; what is known stays as it is."""
    found = dict(known)
    for index, value in enumerate(values):
        if index in found or (only and not only[index]):
            continue
        if value.opcode == "constant":
            found[index] = ca.SX(value.value)
        elif value.opcode == "input":
            found[index] = arguments[value.source[0]][value.source[1]]
        elif all(arg in found for arg in value.args):
            found[index] = _APPLIED[value.opcode](*(found[arg] for arg in value.args))
    return found
