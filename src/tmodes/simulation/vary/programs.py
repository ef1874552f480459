"""Numbers of many cases of a sheet by one program, which is noted while one of them is lowered."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.kinds.noted.number import Lost, Noted, NotedTape, is_noted
from tmodes.kinds.noted.program import Program, program_of
from tmodes.model.parameters import Structural, noted_pair
from tmodes.model.passes import evaluate_program
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.loop import Blocks, whole
from tmodes.simulation.vary.values import changes_of

__all__ = ["CaseProgram", "case_program", "refused_cases"]

Array = NDArray[np.float64]


_MOST = 24
"""Programs of checks; cases that hold to none are checked as sheets."""


@dataclass(frozen=True, eq=False)
class CaseProgram:
    """From values of ``paths`` to blocks of numbers, ``places`` in its outputs (start and shape by name).

    ``fixed``: paths that are structure, with the value that the cases of this program have. ``cases``: how many it is
    for, in all, by which it is compiled or not.
    """

    paths: tuple[str, ...]
    fixed: Mapping[str, float]
    program: Program
    places: Mapping[str, Any]
    cases: int = 1

    def holds(self, values: Mapping[str, Array]) -> NDArray[np.bool_]:
        """Which of the cases ``values`` (k,) of all paths have the structure of this program."""
        found = _evaluated(self._guards, self._rows(values), self.cases)[1]
        for path, value in self.fixed.items():
            found &= values[path] == value
        return found

    @cached_property
    def _guards(self) -> Program:
        return self.program.part(np.zeros(0, dtype=np.intp), guarded=True)

    @cached_property
    def _parts(self) -> dict[tuple[str, ...], Program]:
        return {}

    def _part(self, names: tuple[str, ...]) -> Program:
        """The program of some blocks, one after the other."""
        if names not in self._parts:
            self._parts[names] = self.program.part(np.concatenate([self._span(name) for name in names]))
        return self._parts[names]

    def _span(self, name: str) -> NDArray[np.intp]:
        start = self.places[name]["start"]
        return np.arange(start, start + int(np.prod(self.places[name]["shape"])))

    def acting(self, name: str) -> set[str]:
        """The paths that a block depends on."""
        return {self.paths[k] for k in self.program.acting(self._span(name))}

    def is_constant(self, name: str) -> bool:
        """Whether a block is the same for all cases."""
        return self._part((name,)).is_constant

    def blocks(self, names: Sequence[str], values: Mapping[str, Array]) -> list[Array]:
        """Blocks of numbers of some cases, (m, ...) each, all at once."""
        found = _evaluated(self._part(tuple(names)), self._rows(values), self.cases)[0]
        shapes = [self.places[name]["shape"] for name in names]
        ends = np.cumsum([int(np.prod(shape)) for shape in shapes])[:-1]
        return [
            part.reshape(len(found), *shape) for part, shape in zip(np.split(found, ends, axis=1), shapes, strict=True)
        ]

    def slopes(self, names: Sequence[str], values: Mapping[str, Array]) -> list[Array]:
        """Exact derivatives of blocks of one case by all paths of the program, (size, paths) each."""
        found = self._part(tuple(names)).derivative(self._rows(values)[0])
        return np.split(found, np.cumsum([len(self._span(name)) for name in names])[:-1])

    def _rows(self, values: Mapping[str, Array]) -> Array:
        count = len(next(iter(values.values())))
        return np.stack([values[path] for path in self.paths], axis=1) if self.paths else np.zeros((count, 0))


_INTERPRETED, _COMPILED, _BEGUN = 6e-9, 6e-5, 0.1
"""Seconds: of an operation in NumPy for a case, three times (check, start, run); to compile it; to begin with that."""


def _evaluated(program: Program, rows: Array, cases: int) -> tuple[Array, NDArray[np.bool_]]:
    """Of some of all cases, natively where that pays for all; not by how many go at once, for bits may differ."""
    size = len(program.operations)
    if cases * size * _INTERPRETED > _BEGUN + size * _COMPILED and program.compiles:
        return evaluate_program(program, rows)
    return program(rows)


def case_program(
    sheet: Robot, case: Mapping[str, float], robot_of: Callable[[RobotPair], Any], blocks: Callable[[Any], Blocks],
    cases: int = 1, *, designs: Callable[[Any, Mapping[str, Noted]], None] = lambda robot, inputs: None,
) -> CaseProgram:  # fmt: skip
    """The program of the ``blocks`` of numbers of a robot, noted at one ``case`` of the sheet: its value by path.

    ``designs``: gives the noted robot its laws that are designed from it, by the numbers that are noted.
    Paths that lowering asks for as plain numbers are structure, too. Raises
    :class:`tmodes.model.parameters.Structural` where the lowering of the robot cannot be followed.
    """
    robot, free = sheet.with_(case), dict(case)
    while free:
        tape = NotedTape()
        try:
            noted, inputs = noted_pair(robot, free, tape)
            made = robot_of(noted)
            designs(made, inputs)
            vector, places = whole(blocks(made))
            program = program_of(tape, [*inputs.values()], [*vector])
        except Lost as lost:
            acting = tape.inputs_of(lost.number.node) if is_noted(lost.number) else set()
            structural = [path for path, node in tape.names.items() if node in acting]
            if not structural:
                raise Structural(str(lost)) from lost
            free = {path: value for path, value in free.items() if path not in structural}
            continue
        except (TypeError, InputError, InputErrors, SimulationError) as error:
            raise Structural(str(error)) from error
        fixed = {path: float(value) for path, value in case.items() if path not in inputs}
        if inputs:
            return CaseProgram(tuple(inputs), fixed, program, places, cases)
        break
    raise Structural("all paths are structure")


def refused_cases(sheet: Robot, values: Mapping[str, Array]) -> dict[int, str]:
    """Messages of the cases that the sheet refuses, by index; ``values`` (k,) of each path.

    A case is accepted without being made a sheet where all checks decide as those of one that was: by their program.
    """
    messages, programs = dict[int, str](), 0
    left = np.arange(len(next(iter(values.values()))))
    while len(left):
        first, left = int(left[0]), left[1:]
        try:
            sheet.with_(changes_of(values, first)).pair()
        except (InputError, InputErrors) as error:
            messages[first] = str(error)
            continue
        if programs < _MOST and len(left):
            programs += 1
            try:
                program = case_program(
                    sheet, changes_of(values, first), lambda pair: pair.real, lambda robot: {}, len(left)
                )
            except Structural:
                programs = _MOST
            else:
                left = left[~program.holds({path: own[left] for path, own in values.items()})]
    return messages
