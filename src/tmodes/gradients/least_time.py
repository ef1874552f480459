"""The least time of a move from rest to rest: which durations are tried, and when the search ends."""

from __future__ import annotations

from collections.abc import Callable
from time import monotonic

from tmodes.errors import SimulationError
from tmodes.gradients.optimal import Found, RestToRest

__all__ = ["least_time"]

_RATIO, _ENOUGH, _TRIES, _TRIAL_STEPS, _PATIENCE = 1.25, 1.02, 24, 15, 600.0
"""Of times: first ratio, that which is near enough; how many are tried, Gauss-Newton steps for each, and how long that
may take [s]."""


def least_time(
    move: Callable[[float], RestToRest], duration: float, tolerance: float,
    progress: Callable[[float], None] = lambda share: None,
) -> tuple[RestToRest, Found]:  # fmt: skip
    """The shortest of the moves, by its duration [s], of which one is found within tolerance and limits, to a 50th.

    From ``duration`` on the time grows or shrinks by a quarter, then by halves of that; each begins with the torques of
    the last one that was found. Raises :class:`tmodes.errors.SimulationError` where none is found in the longest time,
    and where the search itself takes too long.
    """
    best: tuple[RestToRest, Found] | None = None
    time, ratio, turn, begun = duration, _RATIO, 0, monotonic()

    def tell(share: float) -> None:
        progress((turn + share) / _TRIES)
        if monotonic() - begun > _PATIENCE:
            known = f"one in {best[0].duration:.4g} s keeps the limits" if best else f"none in {time:.4g} s was found"
            raise SimulationError(
                f"the least time was not found in {_PATIENCE:.0f} s of search: {known}; give that duration "
                "without `--least-time`, or model fewer bending functions"
            )

    for turn in range(_TRIES):  # noqa: B007 - `tell` reads it
        tell(0.0)
        trial = move(time)
        begin = None if best is None else trial.begun(*best)
        done = trial.solve(tolerance, begin, steps=_TRIAL_STEPS, progress=tell)
        if done.swing <= tolerance and done.excess == 0:
            best = trial, done
        elif best:
            ratio **= 0.5
        if best and ratio < _ENOUGH:
            return best
        time = best[0].duration / ratio if best else time * ratio
    if best is None:
        raise SimulationError(
            f"no motion in up to {time / ratio:.3g} s leaves a swing of at most {tolerance:.2g} m within the limits; "
            "expected limits that a slow motion keeps: raise them, or the tolerance"
        )
    return best
