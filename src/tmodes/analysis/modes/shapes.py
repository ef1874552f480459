"""Shapes of an undamped robot, and which damped motion belongs to each."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.spectrum import RINGS
from tmodes.analysis.statics.stability import NO_MASS, backward, forward, mass_root
from tmodes.errors import SimulationError

__all__ = ["LOWEST", "MOST_WHOLE", "Undamped", "assigned", "partners", "real_pairs", "undamped_shapes"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

NOTHING = 1e-13
"""Share of the largest squared frequency, per coordinate, below which a motion is the whole robot's, free to drift."""

SURE = 1e-4
"""That share over the lowest square above it, up to which the lowest has digits enough."""

FAR = 1e9
"""Highest square over the lowest from which on damped modes are found by the undamped ones: else it costs digits."""

_SHIFTS = 40
"""Decades by which the square that is added to all others is raised until all are positive."""

MOST_WHOLE = 120
"""Coordinates up to which all modes are reported."""

LOWEST = 60
"""Modes that are reported of a robot with more: the lowest, their damping by their own motions."""


class Undamped(NamedTuple):
    """``squares``: of circular frequencies, rising; ``shapes``: with unit modal mass; ``zero``: a square up to which a
    motion is none. ``spread``: frequencies are so far apart that matrices of coordinates keep no digit of the lowest.
    """  # noqa: D205

    squares: Array
    shapes: Array
    zero: float
    spread: bool = False


def undamped_shapes(mass: Array, stiffness: Array) -> Undamped:
    """Modes of mass and stiffness.

    From 1/w^2 where K is positive definite: the low frequencies then keep all their digits. Coordinates that (almost)
    no mass resists follow the others at once: modes more than some 1e7 times faster than the lowest are left out.
    Raises :class:`SimulationError` where neither mass nor stiffness resists.
    """
    size = len(mass)
    if np.abs(stiffness - stiffness.T).max() > 1e-9 * np.abs(stiffness).max():
        mass_root(mass)  # refuses one that is not positive definite, before anything is divided by it
        values, vectors = np.linalg.eig(np.linalg.solve(mass, stiffness))
        squares = np.real(values)
        order = np.argsort(squares)
        shapes = np.real(vectors[:, order])
        shapes = shapes / np.sqrt(np.einsum("ik,ij,jk->k", shapes, mass, shapes))
        return Undamped(squares[order], shapes, NOTHING * size * float(np.abs(squares).max()))
    stiffness = (stiffness + stiffness.T) / 2
    with suppress(np.linalg.LinAlgError):
        inverse, shapes = _relative(mass, stiffness, slice(-LOWEST, None))
        if inverse[0] > NOTHING * size * inverse[-1]:  # else by rounding a singular K may have passed for definite
            values = 1 / inverse[::-1]
            zero, far = NOTHING * size * float(values[-1]), bool(values[-1] > FAR * values[0])
            return Undamped(values, shapes[:, ::-1] * np.sqrt(values), zero, far)
    with suppress(np.linalg.LinAlgError):
        values, shapes = _relative(stiffness, mass, slice(LOWEST))
        zero, sizes = NOTHING * size * float(np.abs(values).max()), np.abs(values)
        if zero <= SURE * sizes[sizes > zero].min(initial=_slow(mass, stiffness)):
            return Undamped(values, shapes, zero)
    return _spread(mass, stiffness)


def _spread(mass: Array, stiffness: Array) -> Undamped:
    """Modes by 1/(w^2 + a), a that of a slow coordinate by itself: of free, slow and massless motions at once.

    (K + a M) x (1/(w^2 + a)) = M x.
    """
    size, shift = len(mass), _slow(mass, stiffness)
    for _ in range(_SHIFTS):
        with suppress(np.linalg.LinAlgError):
            inverse, shapes = _relative(mass, stiffness + shift * mass, slice(-LOWEST, None))
            kept = inverse > 4 * size * np.finfo(float).eps * inverse[-1]
            values = 1 / inverse[kept][::-1]
            return Undamped(values - shift, shapes[:, kept][:, ::-1] * np.sqrt(values), NOTHING * size * shift, True)
        shift *= 10
    raise SimulationError(NO_MASS)


def _slow(mass: Array, stiffness: Array) -> float:
    """The lowest square of a coordinate by itself that is not rounding: the lowest of all is not higher."""
    with np.errstate(divide="ignore", invalid="ignore"):
        own = np.diagonal(stiffness) / np.diagonal(mass)
    own = own[np.isfinite(own) & (own > 0)]
    return float(own[own > NOTHING * np.median(own)].min()) if len(own) else 1.0


def _relative(one: Array, other: Array, some: slice) -> tuple[Array, Array]:
    """Eigenvalues of A x = l B x, rising, and vectors with x^T B x = 1; of more than MOST_WHOLE only ``some``.

    Raises LinAlgError where B is not positive definite.
    """
    root = np.linalg.cholesky(other)
    inner = forward(root, forward(root, one).T)
    values, vectors = np.linalg.eigh((inner + inner.T) / 2)
    shown = some if len(one) > MOST_WHOLE else slice(None)
    return values[shown], backward(root, vectors[:, shown])


def assigned(worth: Array) -> NDArray[np.intp]:
    """For each row of ``worth`` (m, n) a column, each taken once, of the largest sum; -1 for rows that are too many.

    Kuhn's method with shortest augmenting paths (Jonker & Volgenant, Computing 38, 1987); SciPy has it, in a package
    whose loading takes longer than a run.
    """
    if len(worth) > len(worth.T):
        columns = assigned(worth.T)
        found = np.full(len(worth), -1)
        found[columns] = np.arange(len(columns))
        return found
    cost = np.pad(-worth, ((1, 0), (1, 0)))  # row and column 0 are where a path begins
    rows, columns, taken = np.zeros(len(cost)), np.zeros(len(cost.T)), np.zeros(len(cost.T), dtype=int)
    for row in range(1, len(cost)):
        taken[0], here = row, 0
        least, before, seen = np.full(len(columns), np.inf), np.zeros_like(taken), np.zeros(len(columns), dtype=bool)
        while here == 0 or taken[here]:
            seen[here] = True
            price = cost[taken[here]] - rows[taken[here]] - columns
            shorter = ~seen & (price < least)
            least[shorter], before[shorter] = price[shorter], here
            here = int(np.where(seen, np.inf, least).argmin())
            step = least[here]
            rows[taken[seen]] += step
            columns[seen] -= step
            least[~seen] -= step
        while here:
            taken[here], here = taken[before[here]], before[here]
    found = np.full(len(worth), -1)
    used = np.flatnonzero(taken[1:])
    found[taken[1:][used] - 1] = used
    return found


def _normed(columns: NDArray[Any]) -> NDArray[Any]:
    """Columns of length 1; one in which nothing moves, as of a controller's own state, stays as it is."""
    lengths = np.linalg.norm(columns, axis=0)
    return columns / np.where(lengths > 0, lengths, 1.0)


def partners(mass: Array, shapes: Array, values: Complex, damped: Complex) -> NDArray[np.intp]:
    """For each undamped mode the index of the damped motion most like it, each taken once, ringing ones first."""
    root = np.linalg.cholesky(mass).T
    ours, theirs = (_normed(x) for x in (root @ shapes, root @ damped))
    rings = values.imag > RINGS * np.abs(values)
    still = np.abs(values.imag) <= RINGS * np.abs(values)
    counted = np.where(rings | still, -values.real, np.inf)  # of a pair one: ranks are then the same by any rounding
    slow = np.argsort(np.argsort(counted, kind="stable")) / (10.0 * len(values))
    worth = np.abs(ours.T @ theirs) ** 2 + 10.0 * rings - slow
    worth[:, ~(rings | still)] = -100.0
    return assigned(worth)


def real_pairs(
    mass: Array, values: Complex, damped: Complex, chosen: NDArray[np.intp]
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Over-damped modes, by their place in ``chosen``, and the second real eigenvalue of each, by index: the one whose
    motion is most like that of the first.
    """  # noqa: D205
    decays = (np.abs(values.imag) <= RINGS * np.abs(values)) & (values.real < 0)
    over = np.flatnonzero(decays[chosen])
    left = np.setdiff1d(np.flatnonzero(decays), chosen)
    motions = np.linalg.cholesky(mass).T @ damped
    motions = motions / np.maximum(np.linalg.norm(motions, axis=0), 1e-300)
    other = assigned(np.abs(motions[:, chosen[over]].conj().T @ motions[:, left]) ** 2)
    return over[other >= 0], left[other[other >= 0]]
