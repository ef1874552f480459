"""From a data sheet with some numbers changed to a lane of a batch: its structure, numbers, motion and start."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.spectrum import chosen_settings
from tmodes.errors import InputError, InputErrors
from tmodes.integrate.settings import Integration
from tmodes.sheet import Robot
from tmodes.simulation.start import RunSetup, run_setup

__all__ = ["Columns", "Lane", "changed_sheet", "lane_of"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Lane:
    """One robot that is ready to run. Lanes of the same ``key`` run on the same code, that of any one's model."""

    setup: RunSetup
    settings: Integration

    @property
    def key(self) -> Hashable:
        """The structure of its rates, its coordinates and its method."""
        model = self.setup.model
        return model.loop.rate.key, model.coordinates, self.settings.method

    @property
    def further(self) -> int:
        """Numbers of a state that are neither coordinates nor rates."""
        return len(self.setup.start) - 2 * len(self.setup.model.coordinates)


@dataclass(frozen=True)
class Columns:
    """Columns of the states of a batch: all coordinates that any lane has, their rates, and ``further`` numbers."""

    coordinates: tuple[str, ...]
    further: int

    @classmethod
    def of_all(cls, lanes: Sequence[Lane], index: int) -> Columns:
        """Those of these lanes, of which the last one is lane ``index`` of the batch.

        Raises :class:`tmodes.errors.InputError` where something else than coordinates differs.
        """
        names: list[str] = []
        for lane in lanes:
            place = 0
            for name in lane.setup.model.coordinates:
                if name not in names:
                    names.insert(place, name)
                place = names.index(name) + 1
        first, last = lanes[0].further, lanes[-1].further
        if first != last:
            got = f"{last} numbers in the state of case {index} next to its coordinates, {first} in others"
            hint = "vary what keeps them: no inductance of zero next to others"
            raise InputError("vary", got, "the same currents and controllers in all cases", hint)
        return cls(tuple(names), first)

    @property
    def width(self) -> int:
        """Numbers of a state."""
        return 2 * len(self.coordinates) + self.further

    def have(self, lane: Lane) -> bool:
        """Whether a lane has no other coordinate."""
        return set(lane.setup.model.coordinates) <= set(self.coordinates) and lane.further == self.further

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


def changed_sheet(sheet: Robot, changes: Mapping[str, Any], lane: int) -> Robot:
    """The checked sheet of a lane as it really is; errors say which lane they are of."""
    try:
        return sheet.with_(changes).pair().real
    except InputErrors as wrong:
        raise InputErrors([_placed(error, lane) for error in wrong.errors]) from None
    except InputError as error:
        raise _placed(error, lane) from None


def _placed(error: InputError, lane: int) -> InputError:
    return InputError(error.which, error.got, error.expected, error.hint, f"case {lane} {error.where}".rstrip())


def lane_of(real: Robot) -> Lane:
    """A robot as its sheet says, ready to run.

    Raises :class:`tmodes.errors.SimulationError` where it cannot start, and :class:`tmodes.errors.InputError` for what
    cannot be run.
    """
    setup = run_setup(real)
    return Lane(setup, chosen_settings(real.integration, lambda: setup.spectrum))
