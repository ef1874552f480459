"""From a data sheet with some numbers changed to a lane of a batch, and where its state stands among all."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.plan import Follow
from tmodes.simulation.start import RunSetup

__all__ = ["Columns", "Side", "changed_sheet", "structure_of"]

Array = NDArray[np.float64]


def structure_of(lane: RunSetup) -> Hashable:
    """The structure of a lane's rates, its coordinates and its method: those of one structure run on the same code."""
    return lane.model.loop.rate.key, lane.model.coordinates, lane.robot.integration.method


def _further(lane: RunSetup) -> int:
    """Numbers of a state that are neither coordinates nor rates."""
    return len(lane.start) - 2 * len(lane.model.coordinates)


@dataclass(frozen=True)
class Columns:
    """Columns of the states of a batch: all coordinates that any lane has, their rates, and ``further`` numbers."""

    coordinates: tuple[str, ...]
    further: int

    @classmethod
    def of_all(cls, lanes: Sequence[RunSetup], index: int) -> Columns:
        """Those of these lanes, of which the last one is lane ``index`` of the batch.

        Raises :class:`tmodes.errors.InputError` where something else than coordinates differs.
        """
        names: list[str] = []
        for lane in lanes:
            place = 0
            for name in lane.model.coordinates:
                if name not in names:
                    names.insert(place, name)
                place = names.index(name) + 1
        first, last = _further(lanes[0]), _further(lanes[-1])
        if first != last:
            got = f"{last} numbers in the state of case {index} next to its coordinates, {first} in others"
            hint = "vary what keeps them: no inductance of zero next to others"
            raise InputError("vary", got, "the same currents and controllers in all cases", hint)
        return cls(tuple(names), first)

    @property
    def width(self) -> int:
        """Numbers of a state."""
        return 2 * len(self.coordinates) + self.further

    def have(self, lane: RunSetup) -> bool:
        """Whether a lane has no other coordinate."""
        return set(lane.model.coordinates) <= set(self.coordinates) and _further(lane) == self.further

    def of(self, names: Sequence[str]) -> list[int]:
        """Where the state of a lane with these coordinates is."""
        count, own = len(self.coordinates), [self.coordinates.index(name) for name in names]
        return [*own, *(count + k for k in own), *range(2 * count, self.width)]

    def filled(self, states: Array, names: Sequence[str]) -> Array:
        """States (..., own) of lanes with these coordinates, in the columns of the batch (..., width)."""
        found = np.where(np.isnan(states[..., :1]), np.nan, np.zeros(self.width))
        found[..., self.of(names)] = states
        for k, name in enumerate(self.coordinates):
            joint = name.removesuffix(".motor")
            if name not in names and joint in names:
                for start in (0, len(self.coordinates)):
                    found[..., start + k] = found[..., start + self.coordinates.index(joint)]
        return found


class Side(Enum):
    """Which of the two robots of a case runs, and what its motors do."""

    ACTUAL = "actual"
    NOMINAL = "nominal"
    PLANNED = "planned"  # the nominal robot, its motors where they should be

    def of(self, pair: RobotPair) -> Robot:
        """The robot."""
        return pair.real if self is Side.ACTUAL else pair.nominal

    @property
    def follow(self) -> Follow:
        """What its motors do."""
        return Follow.WANTED if self is Side.PLANNED else Follow.SHEET


def changed_sheet(sheet: Robot, changes: Mapping[str, Any], lane: int, side: Side = Side.ACTUAL) -> Robot:
    """The checked sheet of a lane as it really is, or as it is known; errors say which lane they are of."""
    try:
        return side.of(sheet.with_(changes).pair())
    except InputErrors as wrong:
        raise InputErrors([_placed(error, lane) for error in wrong.errors]) from None
    except InputError as error:
        raise _placed(error, lane) from None


def _placed(error: InputError, lane: int) -> InputError:
    return InputError(error.which, error.got, error.expected, error.hint, f"case {lane} {error.where}".rstrip())
