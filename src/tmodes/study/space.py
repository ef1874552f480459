"""The space of a study's parameters: each with its distribution or its choices, its nominal value, and correlations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tmodes.study.distributions import Distribution

__all__ = ["Dimension", "ParameterSpace", "correlation_matrix", "nearest_correlation"]

Array = NDArray[np.float64]

_INSIDE = float(np.nextafter(0.0, 1.0)), float(np.nextafter(1.0, 0.0))
"""Shares that are neither 0 nor 1, where a quantile may be infinite."""


@dataclass(frozen=True, eq=False)
class Dimension:
    """One parameter: its ``distribution``, or so many ``choices``, each as likely as any other."""

    name: str
    nominal: float
    distribution: Distribution | None = None
    choices: int = 0

    def at(self, shares: Array) -> Array:
        """Values (k,) at shares (k,) of all."""
        if self.distribution is None:
            return self._chosen(shares)
        return np.asarray(self.distribution.at(np.clip(shares, *_INSIDE)), dtype=float)

    def between(self, shares: Array) -> Array:
        """Values (k,) at shares (k,) of the way from the least to the largest."""
        if self.distribution is None:
            return self._chosen(shares)
        if listed := self.distribution.listed:
            return np.array(listed)[np.minimum((shares * len(listed)).astype(int), len(listed) - 1)]
        low, high = self.distribution.ends
        return np.clip(low + (high - low) * shares, low, high)

    def levels(self, points: int) -> Array:
        """Evenly spaced values, the ends included; of a list of values all of them."""
        if self.distribution is None:
            return np.arange(float(self.choices))
        if listed := self.distribution.listed:
            return np.array(listed)
        return np.linspace(*self.distribution.ends, points) if points > 1 else np.array([self.nominal])

    def _chosen(self, shares: Array) -> Array:
        return np.minimum(np.floor(shares * self.choices), self.choices - 1)


@dataclass(frozen=True, eq=False)
class ParameterSpace:
    """All parameters, as plans see them. ``correlation`` (d, d): of the underlying normals (Gaussian copula)."""

    dimensions: Sequence[Dimension]
    correlation: Array | None = field(default=None)

    @property
    def names(self) -> tuple[str, ...]:
        """Their names, in order."""
        return tuple(one.name for one in self.dimensions)

    @property
    def chosen(self) -> frozenset[str]:
        """Names of those that are chosen from a list."""
        return frozenset(one.name for one in self.dimensions if one.distribution is None)

    @property
    def nominal(self) -> Array:
        """Their nominal values, (d,)."""
        return np.array([one.nominal for one in self.dimensions])

    def drawn(self, shares: Array) -> Array:
        """Values (k, d) of independent uniform ``shares`` (k, d): by each distribution, and correlated as asked.

        Correlations are those of normals of which each value is at the same share (Gaussian copula; Nelsen, An
        Introduction to Copulas, 2006): ranks stay those of the normals.
        """
        if self.correlation is not None:
            from scipy.special import ndtr, ndtri

            lower = np.linalg.cholesky(self.correlation)
            mixed = [k for k, row in enumerate(lower) if row[:k].any()]  # all others stay to the last digit
            normals = ndtri(np.clip(shares, *_INSIDE))
            shares = shares.copy()
            shares[:, mixed] = ndtr(normals @ lower[mixed].T)
        return np.column_stack([one.at(shares[:, k]) for k, one in enumerate(self.dimensions)])

    def between(self, shares: Array) -> Array:
        """Values (k, d) at shares (k, d) of the way from the least to the largest value of each; no correlation."""
        return np.column_stack([one.between(shares[:, k]) for k, one in enumerate(self.dimensions)])

    def levels(self, name: str, points: int) -> Array:
        """Evenly spaced values of a parameter, its ends included; of one with a list of values, all of them."""
        return next(one for one in self.dimensions if one.name == name).levels(points)


def correlation_matrix(names: Sequence[str], pairs: Sequence[tuple[str, str, float]]) -> Array:
    """The matrix (d, d) of pairs of names with their correlation."""
    matrix = np.eye(len(names))
    for one, other, value in pairs:
        i, j = names.index(one), names.index(other)
        matrix[i, j] = matrix[j, i] = value
    return matrix


def nearest_correlation(matrix: Array, least: float = 1e-6) -> Array:
    """A positive definite correlation matrix (d, d) near a symmetric one.

    By alternating projections on matrices with eigenvalues of at least ``least`` and on those with ones on the diagonal
    (Higham, IMA Journal of Numerical Analysis 22, 2002), then a step towards the unit matrix.
    """
    found, correction = matrix.copy(), np.zeros_like(matrix)
    for _ in range(200):
        shifted = found - correction
        values, vectors = np.linalg.eigh(shifted)
        positive = vectors * np.maximum(values, least) @ vectors.T
        correction = positive - shifted
        found = positive.copy()
        np.fill_diagonal(found, 1.0)
    lowest = float(np.linalg.eigvalsh(found)[0])
    share = max(0.0, (least - lowest) / (1 - lowest))
    return (1 - share) * found + share * np.eye(len(found))
