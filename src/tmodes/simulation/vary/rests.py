"""The equilibria of many robots of one structure, each near a known one: Newton's method over all at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.path import STRAY
from tmodes.analysis.statics.system import ROUNDING, SETTLED
from tmodes.simulation.balance import LITTLE, Balance, BalanceSlope

__all__ = ["inverses", "rests"]

Array = NDArray[np.float64]

_ROUNDS, _STEPS = 4, 8
"""Times that the slope is taken, and steps by each."""

_SHARED_STEPS = 40
"""Steps from the slope of a robot near by, which costs nothing."""

_SMALL = 1e-7
"""Difference over 1 + |q| for slopes, which cost a tenth of exact ones; what they miss the steps find."""

_CURVED = 0.1
"""Share of a step, along it, that its change of rates must explain to correct the slope."""

_CONTRACTS = 0.5
"""Step over the one before it up to which the slope is good enough."""


def rests(
    balance: Balance, numbers: Array, rows: Array, near: Array, tangent: BalanceSlope, stands: float = 0.0
) -> Array:
    """States (k, size) in which nothing accelerates, not-a-number where none is found near by, on the same branch.

    ``numbers`` (k, size) and ``rows`` (k, row) are the parameters and signals at rest, ``near`` (k, size) states of the
    equations where to begin; one whose first step is not longer than ``stands`` (1 + |q|) stays as it is. At rest
    M a = -r vanishes with the forces r of :class:`tmodes.analysis.statics.system.StaticSystem`, to the same tolerance.
    ``tangent``: of a robot near by, tried first for all; each step corrects the slope of its case.
    """
    search = _Search(balance, numbers, rows, near.copy(), tangent, stands)
    going = search.left
    shared = np.broadcast_to(tangent.inverse, (len(going), *tangent.inverse.shape))
    search.steps(going, shared, _SHARED_STEPS, (SETTLED * 1e-3, SETTLED))
    search.again(np.flatnonzero(~search.settled | search.strays), near)
    for _ in range(_ROUNDS):
        going = search.left
        if not len(going):
            break
        search.steps(going, search.inverses(going), _STEPS, (SETTLED, ROUNDING))
    search.states[~search.settled | search.strays | ~np.isfinite(search.states).all(axis=1)] = np.nan
    return search.states


class _Search:
    """Where the search for each equilibrium stands."""

    def __init__(
        self, balance: Balance, numbers: Array, rows: Array, states: Array, tangent: BalanceSlope, stands: float
    ) -> None:
        self.balance, self.numbers, self.rows, self.states, self.tangent = balance, numbers, rows, states, tangent
        self.stands = stands
        self.settled = np.full(len(states), not len(balance.unknown))
        count = len(states)
        self.before, self.first, self.corrected = np.full(count, np.inf), np.zeros(count), np.zeros(count)

    @property
    def left(self) -> NDArray[np.intp]:
        """Those not found yet."""
        return np.flatnonzero(~self.settled)

    @property
    def strays(self) -> NDArray[np.bool_]:
        """Those whose corrections are so large that they may have left their branch."""
        return (self.first > LITTLE) & (self.corrected > STRAY * self.first)

    def again(self, which: NDArray[np.intp], near: Array) -> None:
        """Start again with some of them."""
        self.states[which], self.before[which] = near[which], np.inf
        self.first[which] = self.corrected[which] = 0.0
        self.settled[which] = False

    def steps(self, left: NDArray[np.intp], inverse: Array, most: int, ends: tuple[float, float]) -> None:
        """At most so many steps of each from its ``inverse``, as long as they become shorter quickly.

        Each step corrects the inverse by what it did to the rates: Broyden, A class of methods for solving nonlinear
        simultaneous equations, Math. Comp. 19, 1965.

        ``ends``: steps up to the first of them end the search, those up to the second if they become no shorter.
        """
        unknown = self.balance.unknown
        step = rates = np.zeros((len(left), 0))
        for k in range(most):
            if not len(left):
                break
            new = self.balance.rates(self.states[left], self.rows[left], self.numbers[left])
            inverse = _corrected(inverse, -step, new - rates) if k else inverse
            rates, step = new, (inverse @ new[..., None])[..., 0]
            size, before = np.abs(step * self.tangent.weighs).max(axis=1), self.before[left]
            begins = np.isinf(before)
            reach = 1 + np.abs(self.states[left][:, self.balance.loop.layout.q]).max(axis=1)
            stands = begins & (size <= self.stands * reach)
            self.states[np.ix_(left, unknown)] -= np.where(stands[:, None], 0.0, step)
            self.first[left[begins]] = size[begins]
            self.corrected[left[~begins]] += size[~begins]
            found = stands | (size <= ends[0] * reach) | ((size <= ends[1]) & (size >= before))
            self.settled[left], self.before[left] = found, size
            contracts = ~found & (size <= _CONTRACTS * before)
            left, inverse, rates, step = left[contracts], inverse[contracts], rates[contracts], step[contracts]

    def inverses(self, which: NDArray[np.intp]) -> Array:
        """Of the slopes of some of them (k, unknown, unknown) by differences, along what counts."""
        states, rows, numbers = self.states[which], self.rows[which], self.numbers[which]
        rates, slopes = self.balance.rates(states, rows, numbers), []
        for place in self.balance.unknown:
            moved = states.copy()
            moved[:, place] += _SMALL * (1 + np.abs(states[:, place]))
            change = self.balance.rates(moved, rows, numbers) - rates
            slopes.append(change / (moved - states)[:, [place]])
        slopes = np.stack(slopes, axis=2)
        found, counts = np.zeros_like(slopes), np.flatnonzero(self.tangent.counts)
        found[:, counts[:, None], counts] = inverses(slopes[:, counts[:, None], counts])
        return found


def _corrected(inverse: Array, moved: Array, change: Array) -> Array:
    """Inverse slopes (k, n, n) that give the ``moved`` (k, n) of the last step for the ``change`` (k, n) of rates."""
    along = (moved[:, None] @ inverse)[:, 0]
    share, size = (along * change).sum(axis=1), (moved * moved).sum(axis=1)
    good = share > _CURVED * size
    wrong = (moved - (inverse @ change[..., None])[..., 0]) * (good / np.where(good, share, 1.0))[:, None]
    return inverse + wrong[..., None] * along[:, None]


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
