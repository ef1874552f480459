"""A contender: what is timed, and the accelerations that it finds, so that an error is next to every time."""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable, Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["CHECKED", "Contender", "PeerMissing", "Timed", "in_turns", "needed", "now"]

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


now = time.perf_counter if sys.platform == "win32" else time.process_time
"""Seconds of this process on processors, all its threads together; on Windows, where that is coarse, by the wall.

Only contenders that work on several cores at once are timed by the wall everywhere.
"""


class PeerMissing(RuntimeError):
    """A peer cannot run on this machine; the message says what to install, or what it lacks."""


def needed(module: str, package: str) -> Any:
    """A module of another engine, which has no types and is often absent: then :class:`PeerMissing`."""
    try:
        with redirect_stdout(sys.stderr):  # some greet, where our own output belongs
            return import_module(module)
    except ImportError as error:
        raise PeerMissing(f"not installed (pip install {package})") from error
