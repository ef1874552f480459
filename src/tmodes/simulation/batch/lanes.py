"""A span of a batch's lanes on the native loops: side by side where the method has such a loop, else one by one."""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.lanes.lane_kernels import goes_side_by_side
from tmodes.compile.lanes.lanes_loop import WIDTH
from tmodes.simulation.batch.alone import Alone
from tmodes.simulation.batch.side_by_side import Room, SideBySide
from tmodes.simulation.batch.work import Work
from tmodes.simulation.trajectory import Trajectory

__all__ = ["run_lanes", "spans"]

Array = NDArray[np.float64]

_PIECE_SECONDS = 0.05
_FIRST_PIECE = 500

_SPANS, _LONGEST = 8, 64
"""Spans that each thread gets, so that none waits long for the last; groups of lanes in the longest."""


class _Advancing(Protocol):
    """Lanes that go on piece by piece."""

    def advance(self, steps: int) -> None:
        """Do at most so many steps."""
        ...

    @property
    def going(self) -> bool:
        """Whether any may go on."""
        ...

    @property
    def times(self) -> Any:
        """How far each came [s]."""
        ...

    def ended(self, seconds: float) -> list[Trajectory]:
        """Each run as it stands, after so much time of computing [s]."""
        ...


def spans(work: Work, threads: int) -> list[range]:
    """Lanes that a thread takes at once: many, so that threads seldom ask for more; whole groups side by side."""
    side, lanes = _side(work), work.inputs.size
    groups = -(-lanes // side)
    size = side * min(max(1, groups // (threads * _SPANS)), _LONGEST)
    return [range(first, min(first + size, lanes)) for first in range(0, lanes, size)]


def _side(work: Work) -> int:
    """Lanes that go at once."""
    return WIDTH if goes_side_by_side(work.settings.method) else 1


def run_lanes(work: Work, lanes: range, wish: Callable[[], bool], reached: Array) -> list[Trajectory]:
    """Run a span of lanes to their ends, or until ``wish`` to stop; ``reached`` (all,) gets their times [s].

    How spans and pieces are cut, and what else the machine does, changes no bit of the samples, unless a limit on time
    ends the run.
    """
    side = _side(work)
    room = Room(work) if goes_side_by_side(work.settings.method) else None
    runs: list[Trajectory] = []
    for first in range(lanes.start, lanes.stop, side):
        group = range(first, min(first + side, lanes.stop))
        running = SideBySide(room, group) if room else Alone(work, first)
        runs += _run_group(running, work.settings.max_wall_time, wish, reached, work.places[group.start : group.stop])
    return runs


def _run_group(
    group: _Advancing, limit: float, wish: Callable[[], bool], reached: Array, places: NDArray[np.int64]
) -> list[Trajectory]:
    """Pieces that take about the same time, so that a wish is soon heard."""
    began, piece, going = clock.monotonic(), _FIRST_PIECE, True
    while going and not wish() and clock.monotonic() - began < limit:
        started = clock.monotonic()
        group.advance(piece)
        spent = clock.monotonic() - started
        piece = max(1, int(piece * min(4.0, _PIECE_SECONDS / max(spent, 1e-6))))
        going, reached[places] = group.going, group.times
    return group.ended(clock.monotonic() - began)
