"""Time at equal error: each contender takes the loosest of its settings that reaches the error asked for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from tmodes.bench.contender import Timed

__all__ = ["Race", "Runner", "at_equal_error"]


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
