"""A closed loop without the works, for runs of which only some numbers are wanted; and series of such numbers.

The state is the first part of the whole one: coordinates, rates, currents, own states of controllers and of a surface.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

from tmodes.equations.loop.closed_loop import ClosedLoop, Powers
from tmodes.equations.loop.friction import contact_fold
from tmodes.equations.loop.instant import Instant
from tmodes.equations.loop.layout import StateLayout
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Schedule, Slot, kernel

__all__ = ["LeanLoop", "Shown", "series_schedule"]


class Shown(NamedTuple):
    """A series by its place in the structure: what kind of number, and which ones of that kind.

    ``state`` (column), ``drive`` (drive, column), ``gear`` (drive), ``control`` (column), ``point`` (point, column of
    position and velocity), ``speed`` (point), ``contact`` (column), ``fold``, ``bent`` (coordinates of a gear's output
    and input), ``apart`` (first of three given numbers: how far the tip is from there).
    """

    kind: str
    places: tuple[int, ...] = ()


class LeanLoop(ClosedLoop):
    """The rates of a plan in which nothing sticks, without works."""

    keeps_works = False

    @property
    def layout(self) -> StateLayout:
        """Where the state holds what; works and modes have no room."""
        whole = super().layout
        end = slice(whole.works.start, whole.works.start)
        return whole._replace(works=end, modes=end)


@kernel("length", (3,), (1,))
def _length(a: Any) -> list[list[Any]]:
    """Vector -> its length."""
    return [[f.sqrt(v.dot(v.vec(a), v.vec(a)))]]


@kernel("distance", (3, 3), (1,))
def _distance(a: Any, b: Any) -> list[list[Any]]:
    """(place, place) -> their distance."""
    apart = v.sub(v.vec(a), v.vec(b))
    return [[f.sqrt(v.dot(apart, apart))]]


@kernel("bent", (1, 1), (1,))
def _bent(output: Any, given: Any) -> list[list[Any]]:
    """(output of a gear, its input) -> their difference."""
    return [[output[0] - given[0]]]


class _Series:
    """The slot of each kind of series at one instant."""

    def __init__(self, instant: Instant) -> None:
        self.instant = instant

    @cached_property
    def _powers(self) -> Powers:
        return Powers(self.instant)

    def slot(self, shown: Shown) -> Slot:
        """Where a series stands, one number."""
        return getattr(self, f"_{shown.kind}")(*shown.places)

    def _state(self, column: int) -> Slot:
        return self.instant.state.part(column, 1)

    def _drive(self, drive: int, column: int) -> Slot:
        return self._powers.info[drive].part(column, 1)

    def _gear(self, drive: int) -> Slot:
        return self._powers.gear[drive]

    def _control(self, column: int) -> Slot:
        own = [self.instant.own[k] for k in sorted(self.instant.own) if self.instant.own[k].size]
        return self.instant.pack(*own).part(column, 1)

    def _point(self, point: int, column: int) -> Slot:
        return self.instant.way.pose(point)[0].part(9 + column, 1)

    def _speed(self, point: int) -> Slot:
        return self.instant.call(_length(), self.instant.way.pose(point)[0].part(12, 3))[0]

    def _contact(self, column: int) -> Slot:
        return self._powers.contact.part(column, 1)

    def _fold(self) -> Slot:
        return contact_fold(self.instant.solution, self.instant.begin)

    def _bent(self, output: int, motor: int) -> Slot:
        q = self.instant.way.q
        return self.instant.call(_bent(), q.part(output, 1), q.part(motor, 1))[0]

    def _apart(self, first: int) -> Slot:
        place, given = self.instant.way.pose(0)[0].part(9, 3), self.instant.given.part(first, 3)
        return self.instant.call(_distance(), place, given)[0]


def series_schedule(loop: LeanLoop, wanted: Sequence[Shown], given: int, *, after: bool = False) -> Schedule:
    """(time, state and ``given`` numbers, row, step) -> ``series``, one number each.

    ``after``: controllers are shown after the samples with which the row begins; without, the state is after them.
    """
    instant = Instant(loop, after=after, posed=True, given=given)
    series = _Series(instant)
    instant.schedule.output("series", *(series.slot(shown) for shown in wanted))
    chosen = instant.schedule.only(("series",))
    chosen.often, chosen.gate, chosen.narrow, chosen.switches = True, None, None, None
    return chosen
