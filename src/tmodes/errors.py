"""Everything tmodes raises on purpose.

TmodesError                    every error of ours; ``exit_code`` is what the command line returns
├── InputError                 one wrong value: which, got, expected, mend
├── InputErrors                all the wrong values of one file, told in one go
├── SimulationError            a run that cannot start or may not go on
├── ResultFileError            a result that cannot be read, or cannot be written
└── CompileError               an equation that could not be made native code
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


class TmodesError(Exception):
    """Base of every error that tmodes raises on purpose."""

    exit_code = 1


@dataclass(eq=False)
class InputError(TmodesError):
    """One wrong value. Errors tell four things: which, got, expected, mend.

    ``where`` is the place as a person finds it (``robot.yaml:12``), empty when there is no file.
    """

    which: str
    got: str
    expected: str
    hint: str
    where: str = ""

    exit_code = 2

    def __str__(self) -> str:
        place = f"{self.where}: " if self.where else ""
        return f"{place}{self.which}: got {self.got}; expected {self.expected}. Mend: {self.hint}"


class InputErrors(TmodesError):
    """All the wrong values of one input, told in one go; ``errors`` keeps each :class:`InputError`."""

    exit_code = 2

    def __init__(self, errors: Sequence[InputError]) -> None:
        self.errors = tuple(errors)
        super().__init__("\n".join(str(error) for error in self.errors))


class SimulationError(TmodesError):
    """A run that cannot start or may not go on; the message names the quantity and the mend."""

    exit_code = 3


class ResultFileError(TmodesError):
    """A result file that is damaged, foreign, newer than this program, or that cannot be written."""

    exit_code = 4


class CompileError(TmodesError):
    """An equation that could not be made native code."""

    exit_code = 5
