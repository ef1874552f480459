"""Whether an equilibrium is stable: the squares of the natural frequencies of the robot about it."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.rank import NOTHING, leading, scale_of, unheld
from tmodes.errors import SimulationError

__all__ = ["NO_MASS", "Growth", "Stability", "backward", "forward", "mass_root", "moving_stability", "stability_of"]

Array = NDArray[np.float64]

SYMMETRIC = 1e-9
"""Asymmetry over size of a stiffness matrix below which it is rounding."""

FLUTTER = 1e-3
"""Imaginary over absolute value of a squared frequency above which two modes have joined to a growing one."""

MOVING = 1e-7
"""Rate of growth about steady motion, over the fastest eigenvalue, below which it is rounding."""

_UNSURE = 1e4
"""Multiple of that share below which the sign of the lowest squared frequency is found another way."""

NO_MASS = (
    "the mass matrix is not positive definite: some coordinate moves no mass; give the parts beyond the last joint a "
    "mass, and twisting beams a rotary inertia"
)


class Growth(NamedTuple):
    """A motion that grows: its rate [1/s], frequency [Hz] (0: it buckles away), and largest free coordinate's index."""

    rate: float
    frequency_Hz: float
    coordinate: int


class Stability(NamedTuple):
    """``margin`` [1/s^2]: the lowest squared circular frequency; not positive: unstable. ``growing``: fastest first.

    About steady motion ``margin`` is not a number where nothing grows.
    """

    margin: float
    growing: tuple[Growth, ...]
    neutral: tuple[int, ...] = ()
    """Where nothing grows, free coordinates that move without a force: one for each motion that nothing holds."""

    @property
    def stable(self) -> bool:
        """True where nothing grows and nothing is free to drift."""
        return not self.growing and not self.neutral and not self.margin <= 0

    @property
    def lowest_frequency_Hz(self) -> float:
        """Lowest natural frequency [Hz]; 0 where not stable, infinite where nothing is free; NaN about motion."""
        return float(np.sqrt(max(self.margin, 0.0)) / (2 * np.pi))


def stability_of(mass: Array, stiffness: Array, reach: Array) -> Stability:
    """Stability of M a + K x = 0 in free coordinates (n, n), undamped; ``reach`` (n,): of rank.py.

    A symmetric K: all eigenvalues of (K, M) positive; without mass they are infinite. Otherwise (following loads,
    moments about world axes) they must also be real: a pair of complex ones is flutter (Bolotin, Nonconservative
    Problems of the Theory of Elastic Stability, 1963). Raises :class:`SimulationError` where a motion has neither mass
    nor stiffness, or K is not symmetric and M not positive definite.
    """
    if not len(mass):
        return Stability(np.inf, ())
    try:
        root = mass_root(mass)
    except SimulationError:
        if not _is_symmetric(stiffness):
            raise
        return _near_zero(mass, (stiffness + stiffness.T) / 2, reach)
    scaled = forward(root, forward(root, stiffness).T).T
    values, shapes = _eigen(scaled)
    largest = max(float(np.abs(values).max()), float((reach / np.diagonal(mass)).max()))
    zero = NOTHING * len(mass) * largest
    fluttering = np.abs(values.imag) > np.maximum(FLUTTER * np.abs(values), zero)
    grows = fluttering | (values.real < -zero)
    margin = float(np.where(fluttering, -np.abs(values.imag), values.real).min())
    moved = np.abs(backward(root, shapes))
    found = [_growth(values[k], int(moved[:, k].argmax())) for k in np.flatnonzero(grows) if values[k].imag >= 0]
    if abs(margin) <= _UNSURE * zero and _is_symmetric(scaled):
        return _near_zero(mass, (stiffness + stiffness.T) / 2, reach)
    zero = zero if abs(margin) <= zero else 0.0
    neutral = leading(unheld(stiffness.T, reach)) if zero and not found else ()
    return Stability(0.0 if zero else margin, tuple(sorted(found, reverse=True)), neutral)


def _near_zero(mass: Array, stiffness: Array, reach: Array) -> Stability:
    """The same of a symmetric K, where the stiffest motions round away the softest: the sign of K needs no M.

    Each coordinate is measured by its own stiffness, and the lowest frequency found as the largest of M x = l K x.
    """
    scale = 1 / scale_of(stiffness, reach)
    stiffness, mass = (matrix * scale * scale[:, None] for matrix in (stiffness, mass))
    values, shapes = np.linalg.eigh(stiffness)
    loose = abs(values) <= NOTHING * len(mass) * max(1.0, abs(values).max())
    if loose[0]:
        if np.diagonal(shapes.T @ mass @ shapes)[loose].min() <= 0:
            raise SimulationError(NO_MASS)
        return Stability(0.0, (), leading(shapes[:, loose]))
    if values[0] > 0:
        root = np.linalg.cholesky(stiffness)
        inner = forward(root, forward(root, mass).T)
        slowest = float(np.linalg.eigvalsh((inner + inner.T) / 2)[-1])
        if slowest <= 0:
            raise SimulationError(NO_MASS)
        return Stability(1 / slowest, ())
    shape = shapes[:, 0]
    square = float(values[0] / max(shape @ mass @ shape, NOTHING * np.trace(mass)))
    return Stability(square, (_growth(complex(square), int(np.abs(shape * scale).argmax())),))


def moving_stability(mass: Array, damping: Array, stiffness: Array, reach: Array) -> Stability:
    """Stability of M a + D v + K x = 0 (n, n) about steady motion: D has gyroscopic forces, which may hold it."""
    n = len(mass)
    if not n:
        return Stability(np.inf, ())
    forces = np.linalg.solve(mass, np.hstack([-stiffness, -damping]))
    values, shapes = np.linalg.eig(np.vstack([np.hstack([np.zeros((n, n)), np.eye(n)]), forces]))
    grows = np.real(values) > MOVING * np.abs(values).max()
    found = [
        Growth(float(values[k].real), abs(float(values[k].imag)) / (2 * np.pi), int(np.abs(shapes[:n, k]).argmax()))
        for k in np.flatnonzero(grows) if values[k].imag >= 0
    ]  # fmt: skip
    neutral = () if found else leading(unheld(stiffness.T, reach))
    return Stability(-1.0 if found else np.nan, tuple(sorted(found, reverse=True)), neutral)


def forward(root: NDArray[Any], right: Any) -> Any:
    """L^-1 B of a lower triangle L (n, n), by substitution: loading a library for it would take longer than a run."""
    found = np.array(right)
    for k, row in enumerate(root):
        found[k] = (found[k] - row[:k] @ found[:k]) / row[k]
    return found


def backward(root: NDArray[Any], right: Any) -> Any:
    """L^-T B, likewise."""
    return forward(root.T[::-1, ::-1], right[::-1])[::-1]


def mass_root(mass: Array) -> Array:
    """The lower triangle L with L L^T = M. Raises :class:`SimulationError` for a mass matrix that has none."""
    try:
        return np.asarray(np.linalg.cholesky(mass), dtype=float)
    except np.linalg.LinAlgError:
        raise SimulationError(NO_MASS) from None


def _is_symmetric(scaled: Array) -> bool:
    return bool(np.abs(scaled - scaled.T).max() <= SYMMETRIC * np.abs(scaled).max())


def _eigen(scaled: Array) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    if _is_symmetric(scaled):
        values, shapes = np.linalg.eigh((scaled + scaled.T) / 2)
    else:
        values, shapes = np.linalg.eig(scaled)
    return values.astype(complex), shapes.astype(complex)


def _growth(square: complex, coordinate: int) -> Growth:
    """The motion exp(s t) with s^2 = -square."""
    root = np.sqrt(-square)
    return Growth(float(abs(root.real)), float(abs(root.imag)) / (2 * np.pi), coordinate)
