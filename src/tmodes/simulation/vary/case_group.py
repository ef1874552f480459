"""Case groups: cases of a batch that run on the same code, with their numbers; prepared one by one, or as arrays."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.loop.layout import WORKS
from tmodes.equations.loop.outputs import station_numbers
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.output_request import OutputRequest
from tmodes.simulation.problem import Problem, problem_of

__all__ = ["CaseGroup", "CaseNumbers", "Indices", "StateColumns", "grouped"]

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


def structure_of(lane: RunSetup) -> Hashable:
    """The structure of a lane's rates, its coordinates and its method: those of one structure run on the same code."""
    return lane.model.loop.rate.key, lane.model.coordinates, lane.robot.integration.method


def _further(lane: RunSetup) -> tuple[str, ...]:
    """Names of the numbers of a state that are neither coordinates nor rates."""
    named = *lane.model.plan.further_states, *WORKS
    modes = len(lane.start) - 2 * len(lane.model.coordinates) - len(named)
    return *named, *(f"mode {k}" for k in range(modes))


def _merged(names: list[str], others: Sequence[str]) -> None:
    """Add what is not in it, each behind the one before."""
    place = 0
    for name in others:
        if name not in names:
            names.insert(place, name)
        place = names.index(name) + 1


@dataclass(frozen=True)
class StateColumns:
    """Columns of the states of a batch: all coordinates that any lane has, their rates, and all ``further`` numbers."""

    coordinates: tuple[str, ...]
    further: tuple[str, ...]

    @classmethod
    def of_all(cls, lanes: Sequence[RunSetup]) -> StateColumns:
        """Those of these lanes."""
        names: list[str] = []
        further: list[str] = []
        for lane in lanes:
            _merged(names, lane.model.coordinates)
            _merged(further, _further(lane))
        return cls(tuple(names), tuple(further))

    @property
    def width(self) -> int:
        """Numbers of a state."""
        return 2 * len(self.coordinates) + len(self.further)

    def have(self, lane: RunSetup) -> bool:
        """Whether a lane has nothing else."""
        return set(lane.model.coordinates) <= set(self.coordinates) and set(_further(lane)) <= set(self.further)

    def of(self, lane: RunSetup) -> list[int]:
        """Where the state of a lane is."""
        count, own = len(self.coordinates), [self.coordinates.index(name) for name in lane.model.coordinates]
        return [*own, *(count + k for k in own), *(2 * count + self.further.index(name) for name in _further(lane))]

    def filled(self, states: Array, lane: RunSetup) -> Array:
        """States (..., own) of lanes like this one, in the columns of the batch (..., width)."""
        rest, names = np.repeat([0.0, np.nan], [2 * len(self.coordinates), len(self.further)]), lane.model.coordinates
        found = np.where(np.isnan(states[..., :1]), np.nan, rest)
        found[..., self.of(lane)] = states
        for k, name in enumerate(self.coordinates):
            joint = name.removesuffix(".motor")
            if name not in names and joint in names:
                for start in (0, len(self.coordinates)):
                    found[..., start + k] = found[..., start + self.coordinates.index(joint)]
        return found


class CaseNumbers(NamedTuple):
    """Of m lanes: ``parameters`` (m, size) of their loops and of outputs at stations, those of their ``chain`` alone.

    ``base`` (m, 24): at rest.

    ``schedules``: one for all, or m.
    """

    parameters: Array
    chain: Array
    base: Array
    schedules: tuple[SignalPieces, ...]


@dataclass(frozen=True, eq=False)
class CaseGroup:
    """Lanes of one structure: ``places`` (k,) in the batch, ``starts`` (k, nx), their first states.

    ``like``: a lane of the same structure and method; ``numbers`` of some of the lanes, by their indices.
    """

    like: RunSetup
    places: Indices
    starts: Array
    numbers: Callable[[Indices], CaseNumbers]

    def part(self, first: int, stop: int) -> CaseGroup:
        """The lanes of these places of the batch, as those of a batch of their own."""
        start, end = np.searchsorted(self.places, (first, stop)).tolist()
        places, starts = self.places[start:end] - first, self.starts[start:end]
        return CaseGroup(self.like, places, starts, lambda which: self.numbers(start + which))

    def work(self, room: Array, wanted: OutputRequest | None = None) -> Problem:
        """What is to run, its samples in a ``room`` (all, n, nx); or outputs that are ``wanted`` in their place."""
        found, settings = self.numbers(np.arange(len(self.places))), self.like.robot.integration
        numbers = found.parameters, found.schedules, self.starts
        return problem_of(self.like.model, *numbers, settings, room, self.places, wanted)

    def tips(self, which: Indices, times: Array, states: Sequence[Array]) -> Array:
        """Where the tips of m lanes are in the world, (m, n, 3) [m], in ``states`` (n, nx) of this structure each."""
        model, found = self.like.model, self.numbers(which)
        base: Sequence[Array] = [*found.base]
        if self.like.planned.plan.base:
            rows = [schedule.rows_at(times) for schedule in found.schedules]
            base = [
                model.observe(times, samples, rows[lane % len(rows)], found.parameters[lane])["base"]
                for lane, samples in enumerate(states)
            ]
        return self.like.mechanics.passes.tips([one[:, model.layout.q] for one in states], base, found.chain)


def grouped(lanes: Mapping[int, RunSetup], shown: Sequence[str] = ()) -> list[CaseGroup]:
    """Lanes that were prepared one by one, by their places: those of one structure together."""
    groups: dict[object, list[int]] = {}
    for index, lane in lanes.items():
        groups.setdefault(structure_of(lane), []).append(index)
    return [_stacked({index: lanes[index] for index in members}, shown) for members in groups.values()]


def _stacked(lanes: Mapping[int, RunSetup], shown: Sequence[str]) -> CaseGroup:
    setups = list(lanes.values())

    def numbers(which: Indices) -> CaseNumbers:
        chosen = [setups[k] for k in which]
        return CaseNumbers(
            np.stack([np.append(one.model.numbers, station_numbers(one.model.loop, shown)) for one in chosen]),
            np.stack([one.mechanics.parameters for one in chosen]),
            np.stack([one.mechanics.at_rest(gravity=0.0) for one in chosen]),
            tuple(one.planned.schedule for one in chosen),
        )

    return CaseGroup(setups[0], np.array([*lanes]), np.stack([one.start for one in setups]), numbers)
