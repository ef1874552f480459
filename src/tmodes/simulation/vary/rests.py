"""The static equilibria of many robots of one structure, each near a known one: Newton's method over all at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.path import STRAY
from tmodes.analysis.statics.system import ROUNDING, SETTLED
from tmodes.simulation.loop import LoopModel

__all__ = ["inverses", "rests"]

Array = NDArray[np.float64]

_ROUNDS, _STEPS = 4, 8
"""Times that the slope is taken, and steps by each."""

_CONTRACTS = 0.5
"""Step over the one before it up to which the slope is good enough."""

_LITTLE = 1e-3
"""First step [rad, m] too short to leave a branch."""


def rests(loop: LoopModel, numbers: Array, rows: Array, near: Array, free: NDArray[np.intp]) -> Array:
    """Poses (k, nq) in which nothing accelerates, not-a-number where none is found near by, on the same branch.

    ``loop`` holds every drive; ``numbers`` (k, size) and ``rows`` (k, row) are its parameters and signals at rest,
    ``near`` (k, nq) where to begin, ``free`` the coordinates to be found. At rest M a = -r vanishes with
    the forces r of :class:`tmodes.analysis.statics.system.StaticSystem`, to the same tolerance.
    """
    q = near.copy()
    going = np.arange(len(q)) if len(free) else np.zeros(0, dtype=np.intp)
    before, first, corrected = np.full(len(q), np.inf), np.zeros(len(q)), np.zeros(len(q))
    for round_ in range(_ROUNDS):
        if not len(going):
            break
        inverse, left = _inverses(loop, numbers[going], rows[going], q[going], free), going
        for step_ in range(_STEPS):
            if not len(left):
                break
            chosen = inverse[np.searchsorted(going, left)]
            step = (chosen @ _accelerations(loop, numbers[left], rows[left], q[left])[:, free, None])[..., 0]
            q[np.ix_(left, free)] -= step
            size = np.abs(step).max(axis=1)
            if round_ or step_:
                corrected[left] += size
            else:
                first[left] = size
            found = size <= SETTLED * (1 + np.abs(q[left]).max(axis=1))
            found |= (size <= ROUNDING) & (size >= before[left])
            contracts = ~found & (size <= _CONTRACTS * before[left])
            before[left] = np.where(found, 0.0, size)
            left = left[contracts]
        going = going[before[going] > 0]
    strays = (first > _LITTLE) & (corrected > STRAY * first)
    q[strays | (before > 0 if len(free) else False) | ~np.isfinite(q).all(axis=1)] = np.nan
    return q


def _states(loop: LoopModel, q: Array) -> Array:
    states = np.zeros((len(q), loop.layout.size))
    states[:, loop.layout.q] = q
    return states


def _accelerations(loop: LoopModel, numbers: Array, rows: Array, q: Array) -> Array:
    return loop.rate(np.zeros(len(q)), _states(loop, q), rows, numbers)[:, loop.layout.v]


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
