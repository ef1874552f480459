"""A contender: what is timed, and the accelerations that it finds, so that an error is next to every time."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["CHECKED", "Contender", "Timed", "in_turns"]

CHECKED = 3
"""States at which accelerations are compared."""


@dataclass(frozen=True)
class Contender:
    """``run`` returns seconds per evaluation of forward dynamics; ``found`` (CHECKED, joints) [rad/s^2].

    ``cores``: how many work at once; ``compile_seconds``: what a compiler took that is not ours.
    """

    name: str
    run: Callable[[], float]
    found: Callable[[], NDArray[np.float64]]
    cores: int = 1
    compile_seconds: float | None = None


@dataclass(frozen=True)
class Timed:
    """Median and quartiles of the rounds [s]."""

    median: float
    low: float
    high: float

    @classmethod
    def of(cls, seconds: Sequence[float]) -> Timed:
        """From one time per round."""
        low, high = np.percentile(seconds, [25, 75])
        return cls(statistics.median(seconds), float(low), float(high))


def in_turns(
    contenders: Sequence[Contender], rounds: int, tell: Callable[[float], None] = lambda share: None
) -> dict[str, list[float]]:
    """Every contender once a round, so that a noisy machine troubles all alike; times by name [s].

    One round before is not counted: it fills caches. ``tell`` is given the share of the rounds that is done.
    """
    times: dict[str, list[float]] = {one.name: [] for one in contenders}
    for number in range(rounds + 1):
        for one in contenders:
            seconds = one.run()
            if number:
                times[one.name].append(seconds)
        tell((number + 1) / (rounds + 1))
    return times
