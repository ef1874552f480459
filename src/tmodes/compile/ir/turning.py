"""Sines and cosines of a program, several at a time: angles that wait for no other sine go first, side by side."""

from __future__ import annotations

from collections.abc import Sequence

from tmodes.compile.ir.program import Instruction

__all__ = ["early_angles", "order_of_evaluation"]

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
