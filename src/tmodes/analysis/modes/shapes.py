"""Shapes of an undamped robot, and which damped motion belongs to each."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.spectrum import RINGS
from tmodes.analysis.statics.stability import mass_root

__all__ = ["LOWEST", "MOST_WHOLE", "NOTHING", "partners", "undamped_shapes"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

NOTHING = 1e-13
"""Share of the largest squared frequency, per coordinate, below which a motion is the whole robot's, free to drift."""


MOST_WHOLE = 120
"""Coordinates up to which all modes are reported."""

LOWEST = 60
"""Modes that are reported of a robot with more: the lowest, their damping by their own motions."""


def undamped_shapes(mass: Array, stiffness: Array) -> tuple[Array, Array]:
    """Squared circular frequencies, rising, and shapes with unit modal mass.

    From 1/w^2 where K is positive definite: the low frequencies then keep all their digits.
    """
    from scipy.linalg import eigh

    mass_root(mass)  # refuses one that is not positive definite, before anything is divided by it
    size = len(mass)
    if np.abs(stiffness - stiffness.T).max() > 1e-9 * np.abs(stiffness).max():
        values, vectors = np.linalg.eig(np.linalg.solve(mass, stiffness))
        squares = np.real(values)
        order = np.argsort(squares)
        shapes = np.real(vectors[:, order])
        return squares[order], shapes / np.sqrt(np.einsum("ik,ij,jk->k", shapes, mass, shapes))
    stiffness = (stiffness + stiffness.T) / 2
    some = size > MOST_WHOLE
    lowest: dict[str, Any] = {"subset_by_index": [0, LOWEST - 1]} if some else {}
    highest: dict[str, Any] = {"subset_by_index": [size - LOWEST, size - 1]} if some else {}
    try:
        inverse, shapes = eigh(mass, stiffness, **highest)
    except np.linalg.LinAlgError:
        return eigh(stiffness, mass, **lowest)
    if inverse.min() <= 0:  # K was singular, and by rounding passed for positive definite
        return eigh(stiffness, mass, **lowest)
    values = 1 / inverse[::-1]
    if values[0] <= NOTHING * size * values[-1]:
        return eigh(stiffness, mass, **lowest)
    return values, shapes[:, ::-1] * np.sqrt(values)


def partners(mass: Array, shapes: Array, values: Complex, damped: Complex) -> NDArray[np.intp]:
    """For each undamped mode the index of the damped motion most like it, each taken once, ringing ones first."""
    from scipy.optimize import linear_sum_assignment

    root = np.linalg.cholesky(mass).T
    ours, theirs = (x / np.linalg.norm(x, axis=0) for x in (root @ shapes, root @ damped))
    rings = values.imag > RINGS * np.abs(values)
    still = np.abs(values.imag) <= RINGS * np.abs(values)
    slow = np.argsort(np.argsort(-values.real)) / (10.0 * len(values))
    worth = np.abs(ours.T @ theirs) ** 2 + 10.0 * rings - slow
    worth[:, ~(rings | still)] = -100.0
    _, chosen = linear_sum_assignment(-worth)
    return chosen
