"""Numbers of many cases of a sheet by one program, which is noted while one of them is lowered."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.kinds.noted.number import Lost, Tape, is_noted
from tmodes.kinds.noted.program import Program, program_of
from tmodes.model.parameters import Structural, noted_pair
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

    ``fixed``: paths that are structure, with the value that the cases of this program have.
    """

    paths: tuple[str, ...]
    fixed: Mapping[str, float]
    program: Program
    places: Mapping[str, Any]

    def holds(self, values: Mapping[str, Array]) -> NDArray[np.bool_]:
        """Which of the cases ``values`` (k,) of all paths have the structure of this program."""
        found = self._guards(self._rows(values))[1]
        for path, value in self.fixed.items():
            found &= values[path] == value
        return found

    @cached_property
    def _guards(self) -> Program:
        return self.program.part(slice(0, 0), guarded=True)

    @cached_property
    def _parts(self) -> dict[str, Program]:
        sizes = {name: int(np.prod(place["shape"])) for name, place in self.places.items()}
        return {
            name: self.program.part(slice(place["start"], place["start"] + sizes[name]))
            for name, place in self.places.items()
        }

    def acting(self, name: str) -> set[str]:
        """The paths that a block depends on."""
        start, size = self.places[name]["start"], int(np.prod(self.places[name]["shape"]))
        return {self.paths[k] for k in self.program.acting(slice(start, start + size))}

    def is_constant(self, name: str) -> bool:
        """Whether a block is the same for all cases."""
        return self._parts[name].is_constant

    def block(self, name: str, values: Mapping[str, Array]) -> Array:
        """A block of numbers of some cases, (m, ...)."""
        found = self._parts[name](self._rows(values))[0]
        return found.reshape(len(found), *self.places[name]["shape"])

    def _rows(self, values: Mapping[str, Array]) -> Array:
        count = len(next(iter(values.values())))
        return np.stack([values[path] for path in self.paths], axis=1) if self.paths else np.zeros((count, 0))


def case_program(
    sheet: Robot, case: Mapping[str, float], robot_of: Callable[[RobotPair], Robot], blocks: Callable[[Robot], Blocks]
) -> CaseProgram:
    """The program of the ``blocks`` of numbers of a robot, noted at one ``case`` of the sheet: its value by path.

    Paths that lowering asks for as plain numbers are structure, too. Raises
    :class:`tmodes.model.parameters.Structural` where the lowering of the robot cannot be followed.
    """
    robot, free = sheet.with_(case), dict(case)
    while free:
        tape = Tape()
        try:
            noted, inputs = noted_pair(robot, free, tape)
            vector, places = whole(blocks(robot_of(noted)))
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
            return CaseProgram(tuple(inputs), fixed, program, places)
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
                program = case_program(sheet, changes_of(values, first), lambda pair: pair.real, lambda robot: {})
            except Structural:
                programs = _MOST
            else:
                left = left[~program.holds({path: own[left] for path, own in values.items()})]
    return messages
