"""The values of a straight-line program as IR, each written once: what is read, only where it is needed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.program import READ, Instruction

__all__ = ["early_angles", "order_of_evaluation", "write_values"]


def write_values(
    b: Any, program: Sequence[Instruction], arithmetic: Double, read: Callable[[int, int], Any]
) -> dict[int, Any]:
    """All values of a program by index; ``read`` gives an element of an argument."""
    writer = _ValueWriter(b, program, arithmetic, read)
    angles = early_angles(program)
    first, rest = order_of_evaluation(program, angles)
    writer.compute(first)
    found = arithmetic.turns(b, [writer.needed(angle) for angle in angles])
    writer.turned.update(zip(angles, found, strict=True))
    writer.compute(rest)
    return {index: writer.needed(index) for index in range(len(program))}


class _ValueWriter:
    """Writes values where they are first needed, and so keeps few waiting."""

    def __init__(
        self, b: Any, program: Sequence[Instruction], arithmetic: Double, read: Callable[[int, int], Any]
    ) -> None:
        self.b, self.program, self.arithmetic, self.read = b, program, arithmetic, read
        self.values: dict[int, Any] = {}
        self.turned: dict[int, tuple[Any, Any]] = {}

    def compute(self, chosen: Iterable[int]) -> None:
        """Those of the chosen values that are not merely read, in their order."""
        for index in chosen:
            if self.program[index].opcode not in READ:
                self.needed(index)

    def needed(self, index: int) -> Any:
        """A value of which all that it follows from is known, or read."""
        if index not in self.values:
            self.values[index] = self._written(self.program[index])
        return self.values[index]

    def _written(self, instruction: Instruction) -> Any:
        if instruction.opcode == "constant":
            return self.arithmetic.constant(instruction.value)
        if instruction.opcode == "input":
            return self.read(*instruction.source)
        if instruction.opcode in ("sin", "cos"):
            return self._turn(instruction.args[0])[0 if instruction.opcode == "sin" else 1]
        args = [self.needed(arg) for arg in instruction.args]
        return self.arithmetic.operation(self.b, instruction.opcode, *args)

    def _turn(self, angle: int) -> tuple[Any, Any]:
        if angle not in self.turned:
            self.turned[angle] = self.arithmetic.turn(self.b, self.needed(angle))
        return self.turned[angle]


_TURNS = ("sin", "cos")


def early_angles(values: Sequence[Instruction]) -> list[int]:
    """Indices of the values of which sine or cosine is taken and that follow from no sine or cosine themselves."""
    late: list[bool] = []
    angles: dict[int, None] = {}
    for value in values:
        late.append(value.opcode in _TURNS or any(late[arg] for arg in value.args))
        if value.opcode in _TURNS and not late[value.args[0]]:
            angles[value.args[0]] = None
    return list(angles)


def order_of_evaluation(values: Sequence[Instruction], angles: Sequence[int]) -> tuple[list[int], list[int]]:
    """What the angles need, in order, and all the rest, in order."""
    needed = set(angles)
    for index in reversed(range(len(values))):
        if index in needed:
            needed.update(values[index].args)
    rest = [index for index in range(len(values)) if index not in needed]
    return sorted(needed), rest
