"""Positions, velocities and accelerations at given times, as a planner writes them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.noted.functions import array, number
from tmodes.kinds.schema.quantity import LARGEST, Issue
from tmodes.kinds.signals.contract import SIGNALS, Signal, delayed
from tmodes.kinds.signals.quintic import hermite
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Trajectory"]

MOST_ROWS = 10_000

_Numbers = tuple[Annotated[float, Field(ge=-LARGEST, le=LARGEST)], ...]


def _column(unit: str, symbol: str, meaning: str) -> Any:
    extra: Any = {"unit": unit, "symbol": symbol, "smallest": 0.0, "plausible": None}
    return Field(strict=False, min_length=2, max_length=MOST_ROWS, description=f"{meaning} [{unit}]",
                 json_schema_extra=extra)  # fmt: skip


@SIGNALS.register
class Trajectory(Signal):
    """Joined by polynomials of degree 5; at a time that stands twice the acceleration may jump."""

    type: Literal["trajectory"] = Field(description="kind of signal")
    times: _Numbers = _column("s", "t", "times")
    positions: _Numbers = _column("signal", "u", "values at these times")
    velocities: _Numbers = _column("signal", "v", "rates at these times, per s")
    accelerations: _Numbers = _column("signal", "a", "accelerations at these times, per s^2")

    def _issues(self) -> Iterator[Issue]:
        for name in ("positions", "velocities", "accelerations"):
            if len(getattr(self, name)) != len(self.times):
                expected = f"{len(self.times)} numbers, one for each time"
                yield Issue(name, f"a list of {len(getattr(self, name))}", expected, "write one for each time")
        if self.times[0] < 0:
            yield Issue("times", repr(self.times[0]), "times from 0 on", "a run starts at time 0; there is `delay`")
        for index, (earlier, later) in enumerate(zip(self.times, self.times[1:], strict=False)):
            if later < earlier:
                got = f"{later!r} s after {earlier!r} s"
                yield Issue(f"times.{index + 1}", got, "times that rise", "order the rows by time")
                return
        if self.times[-1] == self.times[0]:
            yield Issue("times", "no time between the rows", "a last time after the first", "give a later time")

    def pieces(self, until: float) -> SignalPieces:
        """A piece between each two rows."""
        times, *columns = (array(one) for one in (self.times, self.positions, self.velocities, self.accelerations))
        last = np.array([number(later) > number(earlier) for earlier, later in pairwise(self.times)])
        powers = hermite(
            tuple(one[:-1][last] for one in columns),
            tuple(one[1:][last] for one in columns),
            (times[1:] - times[:-1])[last],
        )
        knots = array([0.0, *(times[1:][last] - times[0])])
        move = SignalPieces(knots, powers)
        return delayed(move, number(self.times[0]), until)

    def length(self, reach: float = 1.0) -> float:
        """Up to the last time."""
        return reach * self.times[-1]
