"""The static equilibria of many robots of one structure, each near a known one: Newton's method over all at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.path import STRAY
from tmodes.analysis.statics.system import ROUNDING, SETTLED
from tmodes.simulation.loop import LoopModel

__all__ = ["inverse_at", "inverses", "rests"]

Array = NDArray[np.float64]

_ROUNDS, _STEPS = 4, 8
"""Times that the slope is taken, and steps by each."""

_SHARED_STEPS = 40
"""Steps by the slope of a robot near by, which costs nothing."""

_CONTRACTS = 0.5
"""Step over the one before it up to which the slope is good enough."""

_LITTLE = 1e-3
"""First step [rad, m] too short to leave a branch."""


def rests(loop: LoopModel, numbers: Array, rows: Array, near: Array, free: NDArray[np.intp], inverse: Array) -> Array:
    """Poses (k, nq) in which nothing accelerates, not-a-number where none is found near by, on the same branch.

    ``loop`` holds every drive; ``numbers`` (k, size) and ``rows`` (k, row) are its parameters and signals at rest,
    ``near`` (k, nq) where to begin, ``free`` the coordinates to be found. At rest M a = -r vanishes with
    the forces r of :class:`tmodes.analysis.statics.system.StaticSystem`, to the same tolerance. ``inverse``
    (free, free): :func:`inverse_at` a robot near by, tried first for all: its steps are many and cheap.
    """
    search = _Search(loop, numbers, rows, free, near.copy())
    going = search.left
    search.steps(going, np.broadcast_to(inverse, (len(going), *inverse.shape)), _SHARED_STEPS, SETTLED * 1e-3)
    search.again(np.flatnonzero(~search.settled | search.strays), near)
    for _ in range(_ROUNDS):
        going = search.left
        if not len(going):
            break
        search.steps(going, _inverses(loop, numbers[going], rows[going], search.q[going], free), _STEPS, SETTLED)
    search.q[~search.settled | search.strays | ~np.isfinite(search.q).all(axis=1)] = np.nan
    return search.q


class _Search:
    """Where the search for each rest stands."""

    def __init__(self, loop: LoopModel, numbers: Array, rows: Array, free: NDArray[np.intp], q: Array) -> None:
        self.loop, self.numbers, self.rows, self.free, self.q = loop, numbers, rows, free, q
        self.settled = np.full(len(q), not len(free))
        self.before, self.first, self.corrected = np.full(len(q), np.inf), np.zeros(len(q)), np.zeros(len(q))

    @property
    def left(self) -> NDArray[np.intp]:
        """Those not found yet."""
        return np.flatnonzero(~self.settled)

    @property
    def strays(self) -> NDArray[np.bool_]:
        """Those whose corrections are so large that they may have left their branch."""
        return (self.first > _LITTLE) & (self.corrected > STRAY * self.first)

    def again(self, which: NDArray[np.intp], near: Array) -> None:
        """Start again with some of them."""
        self.q[which], self.before[which] = near[which], np.inf
        self.first[which] = self.corrected[which] = 0.0
        self.settled[which] = False

    def steps(self, left: NDArray[np.intp], inverse: Array, most: int, tolerance: float) -> None:
        """At most so many steps of each by its ``inverse``, as long as they become shorter quickly."""
        for _ in range(most):
            if not len(left):
                break
            accelerations = _accelerations(self.loop, self.numbers[left], self.rows[left], self.q[left])
            step = (inverse @ accelerations[:, self.free, None])[..., 0]
            self.q[np.ix_(left, self.free)] -= step
            size, before = np.abs(step).max(axis=1), self.before[left]
            begins = np.isinf(before)
            self.first[left[begins]] = size[begins]
            self.corrected[left[~begins]] += size[~begins]
            found = size <= tolerance * (1 + np.abs(self.q[left]).max(axis=1))
            found |= (size <= ROUNDING) & (size >= before)
            self.settled[left], self.before[left] = found, size
            contracts = ~found & (size <= _CONTRACTS * before)
            left, inverse = left[contracts], inverse[contracts]


def _states(loop: LoopModel, q: Array) -> Array:
    states = np.zeros((len(q), loop.layout.size))
    states[:, loop.layout.q] = q
    return states


def _accelerations(loop: LoopModel, numbers: Array, rows: Array, q: Array) -> Array:
    return loop.rate(np.zeros(len(q)), _states(loop, q), rows, numbers)[:, loop.layout.v]


def inverse_at(loop: LoopModel, numbers: Array, row: Array, q: Array, free: NDArray[np.intp]) -> Array:
    """What :func:`rests` tries first, (free, free): of the slope of one robot at its rest ``q`` (nq,)."""
    return _inverses(loop, numbers[None], row[None], q[None], free)[0]


def _inverses(loop: LoopModel, numbers: Array, rows: Array, q: Array, free: NDArray[np.intp]) -> Array:
    """Of the derivatives of the accelerations of the free coordinates by them, (k, free, free)."""
    return inverses(loop.slopes(0.0, _states(loop, q), rows, numbers, free)[:, loop.layout.v][:, free])


def inverses(slopes: Array) -> Array:
    """Of matrices (k, n, n), which are overwritten; not-a-number where there is none."""
    unit = np.eye(slopes.shape[1])
    bad = ~np.isfinite(slopes).all(axis=(1, 2))
    slopes[bad] = unit
    singular = np.linalg.det(slopes) == 0.0
    slopes[singular] = unit
    found = np.asarray(np.linalg.inv(slopes), dtype=float)
    found[bad | singular] = np.nan
    return found
