"""A motion along a path that is slowed where its limits are, by linear programs one after the other.

The motion has a steady jerk in each of some pieces. Around a motion all quantities of the joints that are limited are
linear in changes of these jerks and of the duration; the least duration within a trust region is a linear program (J.
Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., 2006, 18.5, with an l-infinity penalty).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Steps", "quicker"]

Array = NDArray[np.float64]
Shares = Callable[[Array, Array, Array, Array], Array]

_ROUNDS, _NEAR, _LITTLE = 60, 0.2, 1e-4
"""Programs at most; first and least change, as a share of the largest jerk and of the duration."""

_PENALTY, _SMALL = 20.0, 1e-6
"""Durations for a limit that is passed by all of it; step for slopes, as a share of the largest value."""


class Steps(NamedTuple):
    """A motion from rest to rest: pieces of these ``shares`` (n,) of the ``duration`` [s] with these ``jerks`` (n,)."""

    duration: float
    shares: Array
    jerks: Array

    def states(self, places: Array) -> tuple[Array, Array, Array]:
        """By the jerks for a duration of 1 s: way, speed, acceleration (m, n) each at shares (m,) of the duration."""
        begin = np.append(0.0, np.cumsum(self.shares)[:-1])
        since = places[:, None] - begin
        within, after = np.clip(since, 0.0, self.shares), np.maximum(since - self.shares, 0.0)
        return (
            within**3 / 6 + within**2 * after / 2 + within * after**2 / 2, within**2 / 2 + within * after, within
        )  # fmt: skip

    def within(self, each: int) -> tuple[Array, NDArray[np.intp]]:
        """Shares of the duration at ``each`` places of each piece, both its ends among them; which piece that is."""
        begin = np.append(0.0, np.cumsum(self.shares)[:-1])
        places = begin[:, None] + self.shares[:, None] * np.linspace(0.0, 1.0, each)
        return places.ravel(), np.repeat(np.arange(len(begin)), each)

    def motion(self, each: int) -> tuple[Array, Array, Array, Array]:
        """Way and its three derivatives at these places."""
        places, piece = self.within(each)
        way, speed, gain = (matrix @ self.jerks for matrix in self.states(places))
        time = self.duration
        return time**3 * way, time**2 * speed, time * gain, self.jerks[piece]

    def slower(self, factor: float) -> Steps:
        """The same way in more time."""
        return Steps(self.duration * factor, self.shares, self.jerks / factor**3)


def quicker(first: Steps, shares: Shares) -> Steps:
    """A motion near the ``first`` that takes less time, with hardly a share of a limit beyond 1, by a local search.

    ``shares`` (m, limits): of way, speed, acceleration and jerk (m,), with their signs; looked at three times a piece.
    """
    length, best, near = float(first.motion(2)[0][-1]), first, _NEAR
    merit = _merit(first, shares)
    for _ in range(_ROUNDS):
        found = _step(best, shares, near, length)
        after = np.inf if found is None else _merit(found, shares)
        if found is not None and after < merit:
            gained, best, merit, near = merit - after, found, after, min(1.5 * near, _NEAR)
            if gained < _LITTLE * _LITTLE * merit:
                break
        elif (near := near / 3) < _LITTLE:
            break
    return best


def _merit(steps: Steps, shares: Shares) -> float:
    over = float(np.abs(shares(*steps.motion(3))).max()) - 1.0
    return steps.duration * (1 + _PENALTY * max(over, 0.0))


def _step(steps: Steps, shares: Shares, near: float, length: float) -> Steps | None:
    """The best motion within a trust region of the linear problem; None where its program has no solution."""
    from scipy.optimize import linprog

    time, n = steps.duration, len(steps.jerks)
    places, piece = steps.within(3)
    matrices = *steps.states(places), np.eye(n)[piece]
    motion, most = steps.motion(3), np.abs(steps.jerks).max()
    here = shares(*motion)
    found = np.zeros((*here.shape, n + 1))
    for order, (matrix, values) in enumerate(zip(matrices, motion, strict=True)):
        power, size = 3 - order, _SMALL * max(float(np.abs(values).max()), 1e-12)
        moved = [values + size if k == order else one for k, one in enumerate(motion)]
        slope = (shares(*moved) - here) / size
        along = np.hstack([time**power * matrix, (power * values / time)[:, None]])
        found += slope[..., None] * along[:, None]
    rows, level = found.reshape(-1, n + 1) * [*[most] * n, time], here.ravel()
    ends = np.stack([matrix[-1] for matrix in matrices[:3]])
    forwards = -matrices[1] * most
    scaled = np.vstack([np.hstack([rows, -np.ones((len(rows), 1))]), np.hstack([-rows, -np.ones((len(rows), 1))]),
                        np.hstack([forwards, np.zeros((len(forwards), 2))])])  # fmt: skip
    kept = np.hstack([ends * most, [[3 * float(ends[0] @ steps.jerks)], [0.0], [0.0]], np.zeros((3, 1))])
    program = linprog(
        [*[0.0] * n, 1.0, _PENALTY], scaled, np.concatenate([1 - level, 1 + level, matrices[1] @ steps.jerks]),
        kept, [0.0, *(-ends[1:] @ steps.jerks)], [*[(-near, near)] * (n + 1), (0.0, None)],
    )  # fmt: skip
    if program.x is None:
        return None
    jerks, time = steps.jerks + most * program.x[:n], time * (1 + program.x[n])
    return Steps(time, steps.shares, jerks * length / (time**3 * float(ends[0] @ jerks)))
