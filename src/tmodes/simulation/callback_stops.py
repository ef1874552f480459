"""Stop conditions of a run in Python: looked at where its intervals end, and located by taking parts of one again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.simulation.stops import Instants, Stops

__all__ = ["SetIn"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class SetIn:
    """Finds where a condition triggers; ``row`` gives that of the input at a time and state, ``duration`` [s]."""

    stops: Stops
    row: Callable[[float, Array], Array]
    duration: float

    def within(
        self, ends: tuple[float, float], states: tuple[Array, Array], moved: Callable[[float], Array]
    ) -> tuple[float, Array, str] | None:
        """Time, state and words, or None where no condition holds at either end; ``moved`` gives a state between."""
        from scipy.optimize import brentq

        known = dict(zip(ends, states, strict=True))

        def beyond(time: float) -> float:
            if time not in known:
                known[time] = moved(time)
            return float(self.stops.beyond(self._instant(time, known[time])).max())

        if beyond(ends[0]) <= 0 and beyond(ends[1]) <= 0:
            return None
        close = 4 * float(np.spacing(self.duration))
        root: Any = ends[0] if beyond(ends[0]) > 0 else brentq(beyond, *ends, xtol=close)
        time = float(root)
        state = known[time] if time in known else moved(time)
        return time, state, self._info(time, state)

    def _instant(self, time: float, state: Array) -> Instants:
        return Instants(np.array([time]), state[None, :], self.row(time, state)[None, :])

    def _info(self, time: float, state: Array) -> str:
        there = self._instant(time, state)
        stop = self.stops.stops[int(self.stops.beyond(there)[0].argmax())]
        value = float(stop.values(there)[0])
        return stop.info(time, value, value)
