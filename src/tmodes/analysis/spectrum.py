"""Eigenvalues of linearised equations of motion: how fast a system rings, decays or grows, and in which coordinate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["GROWING", "RINGS", "MotorState", "Spectrum", "damped_motions", "spectrum_of"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

GROWING = 1e-7
"""Real over absolute value of an eigenvalue above which its motion grows, and is not just undamped."""

RINGS = 1e-9
"""Imaginary over absolute value of an eigenvalue above which its motion rings."""

_UNDAMPED = 1e-9
"""Real over absolute value of an eigenvalue below which it is taken as undamped."""

_MOST_WHOLE = 500
"""Size of a state up to which all its eigenvalues are found; of a larger one only the largest."""


class MotorState(StrEnum):
    """What the motors do while the arm vibrates: they stand still, turn without current, or are controlled."""

    LOCKED = "locked"
    FREE = "free"
    CONTROLLED = "controlled"


@dataclass(frozen=True)
class Spectrum:
    """Eigenvalues [1/s] of the linearised equations, and the ``dominant`` coordinate of each."""

    eigenvalues: Complex
    dominant: tuple[str, ...]

    @property
    def highest(self) -> float:
        """The largest absolute value of all [1/s]; 0 where nothing moves."""
        return float(np.abs(self.eigenvalues).max(initial=0.0))

    @property
    def ringing(self) -> Complex:
        """The eigenvalues whose motion rings, both of each pair."""
        return self.eigenvalues[np.abs(self.eigenvalues.imag) > RINGS * np.abs(self.eigenvalues)]

    @property
    def slowest_decay(self) -> float | None:
        """The smallest decay rate [1/s] of the motions that ring; None where nothing rings."""
        return min((-float(value.real) for value in self.ringing), default=None)


def spectrum_of(matrix: Array, coordinates: Sequence[str], currents: Sequence[str] = ()) -> Spectrum:
    """The spectrum of a state matrix (m, m) in coordinates, their rates, then motor currents.

    Of more than 500 states only the six largest eigenvalues are found. The dominant coordinate is the one whose rate
    (or current) is largest: a fast motion is large in the rates.
    """
    if not len(matrix) or not np.isfinite(matrix).all():
        return Spectrum(np.zeros(0, dtype=complex), ())
    if len(matrix) <= _MOST_WHOLE:
        values, shapes = np.linalg.eig(matrix)
    else:
        from scipy.sparse.linalg import eigs

        found: Any = eigs(matrix, k=6, which="LM", v0=np.ones(len(matrix)))
        values, shapes = found
    # Rounding must not make what rings without damping look as if it grew.
    rising, turning = np.real(values), np.imag(values)
    values = np.where(np.abs(rising) <= _UNDAMPED * np.abs(values), 0.0, rising) + 1j * turning
    n = len(coordinates)
    names = [*coordinates, *coordinates, *currents]
    largest = np.abs(shapes[n:]).argmax(axis=0) + n if n else np.zeros(0, dtype=int)
    return Spectrum(values.astype(complex), tuple(names[int(k)] for k in largest))


def damped_motions(mass: Array, damping: Array, stiffness: Array) -> tuple[Complex, Complex]:
    """Eigenvalues [1/s] and the coordinates' part of the eigenvectors of M q'' + D q' + K q = 0."""
    size = len(mass)
    dynamics = np.block(
        [[np.zeros((size, size)), np.eye(size)], [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)]]
    )
    eigenvalues, vectors = np.linalg.eig(dynamics)
    return eigenvalues.astype(complex), vectors[:size].astype(complex)
