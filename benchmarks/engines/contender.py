"""A contender: what is timed, with an error next to every time; contenders in turns, and runners at equal error."""

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

from tmodes.errors import CompileError
from tmodes.integrate.registry import integrator, integrators

__all__ = [
    "CHECKED", "STEPS", "TOLERANCES", "Contender", "PeerMissing", "Race", "Runner", "Timed", "adaptive_methods",
    "at_equal_error", "in_turns", "needed", "now", "solved", "tolerances_of",
]  # fmt: skip


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


@dataclass(frozen=True)
class Runner:
    """``run(setting)`` returns the time of a run [s] and its error; ``settings`` from loose to tight.

    ``given``: it has but one setting, which is timed whatever its error.
    """

    name: str
    run: Callable[[float], tuple[float, float]]
    settings: Sequence[float]
    info: str
    given: bool = False


@dataclass(frozen=True)
class Race:
    """One runner at its setting: time per simulated second [s], the error, and whether that is what was asked for."""

    name: str
    setting: str
    time: Timed
    error: float
    reached: bool


def at_equal_error(
    runners: Sequence[Runner],
    error: float,
    duration: float,
    rounds: int,
    tell: Callable[[float], None] = lambda share: None,
) -> list[Race]:
    """All runners at their settings in turns; times over the simulated ``duration`` [s]."""
    chosen = []
    for number, one in enumerate(runners):
        chosen.append(_setting(one, error))
        tell(0.5 * (number + 1) / len(runners))
    times: list[list[float]] = [[] for _ in runners]
    for number in range(rounds):
        for one, (setting, _), known in zip(runners, chosen, times, strict=True):
            known.append(one.run(setting)[0] / duration)
        tell(0.5 + 0.5 * (number + 1) / rounds)
    return [
        Race(one.name, one.info.format(setting), Timed.of(known), found, found <= error)
        for one, (setting, found), known in zip(runners, chosen, times, strict=True)
    ]


def _setting(runner: Runner, error: float) -> tuple[float, float]:
    """The loosest setting that reaches the error, else the one that comes nearest, and the error that it has."""
    found = []
    for setting in runner.settings:
        reached = runner.run(setting)[1]
        if reached <= error or runner.given:
            return setting, reached
        found.append((reached, setting))
    nearest = min(found)
    return nearest[1], nearest[0]


Array = NDArray[np.float64]


TOLERANCES = tuple(10.0**-power for power in np.arange(3.0, 12.1, 0.5))
"""Relative tolerances of adaptive methods."""

STEPS = tuple(round(25 * 2.0 ** (k / 2)) for k in range(29))
"""Numbers of equal steps."""


def tolerances_of(method: str) -> tuple[float, ...]:
    """Those that a method takes."""
    least = integrator(method).least_tolerance
    return tuple(max(info, least) for info in TOLERANCES if info > 0.9 * least)


def adaptive_methods(loops: Any) -> list[str]:
    """The methods with a tolerance for which there is a native loop."""

    def there(method: str) -> bool:
        try:
            return loops[method] is not None
        except (KeyError, CompileError):  # none for this kind of robot, or none for one so large
            return False

    return [method for method, one in integrators().items() if one.adaptive and there(method)]


def solved(
    rate: Callable[[float, Array, Array], Any],
    start: Array,
    knots: Sequence[float],
    rows: Sequence[Array],
    method: Any,
    tolerance: float,
    samples: Array,
) -> tuple[float, Array]:
    """Time [s] of ``solve_ivp`` and its states at ``samples`` [s], the last of which is the end.

    It restarts at every knot, so that no step crosses a jump. ``rate(t, state, row)``; the absolute tolerance is a
    thousandth of the relative one.
    """
    from scipy.integrate import solve_ivp

    state, found, began = start, [], now()
    for left, right, row in zip(knots[:-1], knots[1:], rows, strict=True):
        wanted = samples[(samples > left) & (samples <= right)]
        options = {"rtol": tolerance, "atol": tolerance * 1e-3, "args": (row,)}
        states = solve_ivp(rate, (left, right), state, method, np.union1d(wanted, [right]), **options).y.T
        found.append(states[: len(wanted)])
        state = states[-1]
    return now() - began, np.concatenate(found)
