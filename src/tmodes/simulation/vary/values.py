"""The numbers of the cases of a sheet, by path, and which of the two robots of a case runs."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.plan import Follow

__all__ = ["RobotVariant", "Whole", "changed_sheet", "changes_of", "checked"]

Array = NDArray[np.float64]


class Whole(NamedTuple):
    """What a batch is a part of: how many ``cases``, and the least and the largest value of each path over them."""

    cases: int
    ends: Mapping[str, tuple[float, float]]


def checked(vary: Mapping[str, ArrayLike]) -> dict[str, Array]:
    """The numbers of each path, (k,)."""
    if not vary:
        raise InputError("vary", "no path", "paths, each with its numbers", 'write vary={"payload.mass": [0.4, 0.5]}')
    values: dict[str, Array] = {}
    for path, given in vary.items():
        try:
            values[path] = np.array(given, dtype=float)
        except (TypeError, ValueError):
            raise InputError(f"vary: {path}", repr(given)[:60], "numbers", "give one number for each lane") from None
        if path.partition(".")[0] == "integration":
            hint = "set it in the sheet"
            raise InputError(f"vary: {path}", "settings that differ", "one integration for all lanes", hint)
    lengths = {path: numbers.shape for path, numbers in values.items()}
    first = next(iter(lengths.values()))
    if any(shape != first or len(shape) != 1 or not shape[0] for shape in lengths.values()):
        raise InputError("vary", f"shapes {lengths}", "lists of the same length", "give one number for each lane")
    return values


def _plain(value: np.float64) -> float | int:
    """A number as a sheet has it; where it is whole, it may also stand for a count."""
    number = float(value)
    return int(number) if number.is_integer() and abs(number) < 2**53 else number


def changes_of(values: Mapping[str, Array], index: int) -> dict[str, float | int]:
    """What differs in the sheet of one case."""
    return {path: _plain(numbers[index]) for path, numbers in values.items()}


class RobotVariant(Enum):
    """Which of the two robots of a case runs, and what its motors do."""

    ACTUAL = "actual"
    NOMINAL = "nominal"
    PLANNED = "planned"  # the nominal robot, its motors where they should be

    def of(self, pair: RobotPair) -> Robot:
        """The robot."""
        return pair.real if self is RobotVariant.ACTUAL else pair.nominal

    @property
    def follow(self) -> Follow:
        """What its motors do."""
        return Follow.WANTED if self is RobotVariant.PLANNED else Follow.SHEET


def changed_sheet(
    sheet: Robot, changes: Mapping[str, Any], lane: int, variant: RobotVariant = RobotVariant.ACTUAL
) -> Robot:
    """The checked sheet of a lane as it really is, or as it is known; errors say which lane they are of."""
    try:
        return variant.of(sheet.with_(changes).pair())
    except InputErrors as wrong:
        raise InputErrors([_placed(error, lane) for error in wrong.errors]) from None
    except InputError as error:
        raise _placed(error, lane) from None


def _placed(error: InputError, lane: int) -> InputError:
    return InputError(error.which, error.got, error.expected, error.hint, f"case {lane} {error.where}".rstrip())
