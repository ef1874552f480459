"""The exceptions that tmodes raises on purpose.

TmodesError                    every error of ours; ``exit_code`` is what the command line returns
├── InputError                 one wrong value: which, got, expected, hint
├── InputErrors                all the wrong values of one file, reported together
├── SimulationError            a run that cannot start or cannot continue
├── ResultFileError            a result that cannot be read, or cannot be written
└── CompileError               equations that could not be compiled
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


class TmodesError(Exception):
    """Base of every error that tmodes raises on purpose.

    >>> try:
    ...     tmodes.load("spong")
    ... except tmodes.TmodesError as error:
    ...     print(error.exit_code)
    2
    """

    exit_code = 1


_UNKNOWN = ("an unknown key", "an unknown path")


def sentence(which: str, got: str, expected: str, hint: str) -> str:
    """One wrong value in plain words: ``gear.stiffness must be a number greater than 0, got -5; check sign``.

    An unknown name and a value that is missing have words of their own.
    """
    if got in _UNKNOWN:
        issue = f"unknown key `{which}`" + ("" if "did you mean" in hint else f", expected {expected}")
    elif got.startswith("the unknown "):
        issue = f"{which}: {got.removeprefix('the ')}" + ("" if "did you mean" in hint else f", expected {expected}")
    elif got == "nothing":
        issue = f"{which} is missing, expected {expected}"
    else:
        issue = f"{which} must be {expected}, got {got}"
    if hint.startswith("did you mean"):
        return f"{issue}. D{hint[1:]}"
    return f"{issue}; {hint}" if hint else issue


_LONGEST = 500
"""Characters of a reason."""


def error_words(error: BaseException) -> str:
    """The kind of an error and what it says, in one line that every file and terminal can show."""
    try:
        text = f"{type(error).__name__}: {error}"
    except Exception:
        text = f"{type(error).__name__}, whose own text cannot be made"
    line = " ".join(text[:_LONGEST].split())
    return "".join(one if one.isprintable() else ascii(one)[1:-1] for one in line)


@dataclass(eq=False)
class InputError(TmodesError):
    """One wrong value: which it is, what was given, what is expected, and a hint how to correct it.

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
        return place + sentence(self.which, self.got, self.expected, self.hint)


class InputErrors(TmodesError):
    """All the wrong values of one input, reported together; ``errors`` holds each :class:`InputError`."""

    exit_code = 2

    def __init__(self, errors: Sequence[InputError]) -> None:
        self.errors = tuple(errors)
        super().__init__("\n".join(str(error) for error in self.errors))


class SimulationError(TmodesError):
    """A run that cannot start or cannot continue; the message names the quantity and what helps."""

    exit_code = 3


class ResultFileError(TmodesError):
    """A result file that is damaged, foreign, newer than this program, or that cannot be written."""

    exit_code = 4


class CompileError(TmodesError):
    """Equations that could not be compiled."""

    exit_code = 5
