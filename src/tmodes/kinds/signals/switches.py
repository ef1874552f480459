"""When functions of time change their sign: there a formula that is made of pieces goes from one to the next."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Switch", "switches"]

Array = NDArray[np.float64]

SAMPLES = 4096
"""Intervals in which a change of sign is looked for; within each also where a function only just touches zero."""

MOST_DIPS = 1000
"""Of those intervals at most so many are searched."""

SAME_TIME = 1e-12
"""Share of the whole time within which changes are one."""

NARROWEST = 1e-9
"""How exactly the time of such a touch is found, as a share of the whole time."""

HALVINGS = 70


class Switch(NamedTuple):
    """One piece holds up to ``before``, the next from ``after`` on [s]; the knot between them is at ``time``."""

    before: float
    time: float
    after: float


def switches(functions: Sequence[Callable[[Array], Array]], until: float) -> list[Switch]:
    """Every change of sign of the functions from 0 to ``until`` [s], in order; those at the same time are one."""
    found = sorted(each for function in functions for each in _changes(function, until))
    merged: list[Switch] = []
    for each in found:
        if merged and each.before - merged[-1].time <= SAME_TIME * until:
            last = merged[-1]
            merged[-1] = Switch(last.before, last.time, max(last.after, each.after))
        else:
            merged.append(each)
    return merged


def _changes(function: Callable[[Array], Array], until: float) -> list[Switch]:
    times = np.linspace(0.0, until, SAMPLES + 1)
    values = function(times)
    times, values = _with_dips(function, times, values, until)
    sides = np.sign(values)
    (places,) = np.nonzero((sides[1:] != sides[:-1]) & np.isfinite(values[1:]) & np.isfinite(values[:-1]))
    low, high = times[places], times[places + 1]
    # A function may stay zero between two signs: both ends of that are changes.
    left = _narrowed(lambda t: np.sign(function(t)) == sides[places], low, high)
    right = _narrowed(lambda t: np.sign(function(t)) != sides[places + 1], low, high)
    return [Switch(float(a), float(b), float(b)) for ends in (left, right) for a, b in zip(*ends, strict=True)]


def _narrowed(holds: Callable[[Array], Any], low: Array, high: Array) -> tuple[Array, Array]:
    """Neighbouring times of which the first holds and the second does not, between ``low`` and ``high``."""
    for _ in range(HALVINGS):
        middle = low + (high - low) / 2
        early = holds(middle)
        low, high = np.where(early, middle, low), np.where(early, high, middle)
    return low, high


def _with_dips(function: Callable[[Array], Array], times: Array, values: Array, until: float) -> tuple[Array, Array]:
    """Samples and the points between them where the function comes closest to zero without a change of sign."""
    from scipy.optimize import minimize_scalar

    size = np.abs(values)
    near = (size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:]) & (size[1:-1] > 0)
    same = (np.sign(values[1:-1]) == np.sign(values[:-2])) & (np.sign(values[1:-1]) == np.sign(values[2:]))
    further = []
    for k in np.flatnonzero(near & same)[:MOST_DIPS] + 1:
        side, bounds = np.sign(values[k]), (times[k - 1], times[k + 1])
        lowest: Any = minimize_scalar(
            lambda t, side=side: float(side * function(np.array([t]))[0]),
            bounds=bounds, method="bounded", options={"xatol": NARROWEST * until},
        )  # fmt: skip
        further.append(float(lowest.x))
    times = np.unique(np.concatenate([times, further]))
    return times, function(times)
