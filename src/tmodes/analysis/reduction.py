"""Linear models with fewer states: minimal realization, balanced and modal truncation; the gain of what is left out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.margins import frequencies, response
from tmodes.errors import InputError
from tmodes.kinds.controllers.loop_shaping import unsampled

__all__ = ["balanced", "largest_gain", "minimal", "modal"]

Array = NDArray[np.float64]
System = tuple[Array, Array, Array, Array]

_LOST = 1e-9
"""Share of the fastest rate below which a state is not moved."""

_SHARP = 1e-6
"""Share by which a norm may be larger than the gain that was found."""

_ROUNDING = 1e-12
"""Real part over the largest eigenvalue that may be none."""

_SAME = 1e-6
"""Sizes of poles that are the same: those of a Schur form differ from the eigenvalues in the last digits."""


def _gramians(A: Array, B: Array, C: Array, period: float | None) -> tuple[Array, Array]:
    from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

    poles = np.linalg.eigvals(A)
    if not ((np.abs(poles) < 1).all() if period else (poles.real < 0).all()):
        hint = "take method='modal' or 'minimal', or close the loop"
        raise InputError("reduce", "a model that is not stable", "a stable one for balanced truncation", hint)
    if period:
        return solve_discrete_lyapunov(A, B @ B.T), solve_discrete_lyapunov(A.T, C.T @ C)
    return solve_continuous_lyapunov(A, -B @ B.T), solve_continuous_lyapunov(A.T, -C.T @ C)


def _root(gramian: Array) -> Array:
    values, vectors = np.linalg.eigh((gramian + gramian.T) / 2)
    return vectors * np.sqrt(np.maximum(values, 0.0))


def balanced(A: Array, B: Array, C: Array, D: Array, order: int, period: float | None) -> tuple[System, System]:
    """Balanced truncation by square roots (M. S. Tombs, I. Postlethwaite, Int. J. Control 46, 1987).

    With it, as of :func:`modal`, the difference of the whole model from the smaller one.
    """
    from scipy.linalg import block_diag

    reach, see = map(_root, _gramians(A, B, C, period))
    left, sizes, right = np.linalg.svd(see.T @ reach)
    share = 1 / np.sqrt(sizes[:order])
    into, out = reach @ right[:order].T * share, see @ left[:, :order] * share
    small = out.T @ A @ into, out.T @ B, C @ into
    whole = np.asarray(block_diag(A, small[0])), np.vstack([B, small[1]]), np.hstack([C, -small[2]]), np.zeros_like(D)
    return (*small, D), whole


def minimal(A: Array, B: Array, C: Array, D: Array) -> System:
    """The part that inputs reach and outputs show (R. E. Kalman, 1963), of unstable models, too.

    States are scaled first; one that inputs, or those before it, move by less than 1e-9 of the fastest is not reached.
    """
    from scipy.linalg import matrix_balance

    A, (scale, _) = matrix_balance(A, permute=False, separate=True)
    B, C = B / scale[:, None], C * scale
    for _ in range(2):  # the second time of the transposed system: what outputs show
        kept = _reached(A, B)
        A, B, C = (kept.T @ A @ kept).T, (C @ kept).T, (kept.T @ B).T
    return A, B, C, D


def _reached(A: Array, B: Array) -> Array:
    """An orthonormal basis of the states that inputs reach: a staircase (P. Van Dooren, IEEE Trans. AC 26, 1981)."""
    basis, size = np.zeros((len(A), 0)), np.linalg.norm(A, 2) if len(A) else 0.0
    found, least = B / np.maximum(np.linalg.norm(B, axis=0), 1e-300), _LOST
    while found.size:
        for _ in range(2):
            found = found - basis @ (basis.T @ found)
        ways, moved, _ = np.linalg.svd(found, full_matrices=False)
        new = ways[:, moved > least]
        basis, found, least = np.hstack([basis, new]), A @ new, _LOST * size
    return basis


def largest_gain(A: Array, B: Array, C: Array, D: Array, period: float | None) -> float:
    """H-infinity norm of a system: its largest singular value over all frequencies; infinite of an unstable one.

    Where the gain is some gamma, a Hamiltonian matrix has imaginary eigenvalues; between these the largest gain is
    looked for, until 1.000001 times it is nowhere reached, and returned (N. A. Bruinsma, M. Steinbuch, Systems &
    Control Letters 14, 1990). A sampled one by Tustin's rule.
    """
    poles = np.linalg.eigvals(A)
    if not ((np.abs(poles) < 1).all() if period else (poles.real < 0).all()):
        return float("inf")
    grid = 2 * np.pi * np.append(frequencies(np.asarray(poles, dtype=np.complex128), period), 0.0)
    A, B, C, D = unsampled((A, B, C, D), period) if period else (A, B, C, D)
    at = response(A, B, C, D)
    rates = 2 / period * np.tan(np.minimum(grid * period, 3.14) / 2) if period else grid

    def highest(rates: Array) -> float:
        return float(np.linalg.norm(at(np.asarray(1j * rates, dtype=np.complex128)), 2, axis=(1, 2)).max(initial=0.0))

    found = max(highest(rates), float(np.linalg.norm(D, 2)) if D.size else 0.0)
    while found:
        gamma = found * (1 + _SHARP)
        R, S = gamma**2 * np.eye(B.shape[1]) - D.T @ D, gamma**2 * np.eye(len(C)) - D @ D.T
        inner = A + B @ np.linalg.solve(R, D.T @ C)
        poles = np.linalg.eigvals(np.block([
            [inner, gamma * B @ np.linalg.solve(R, B.T)], [-gamma * C.T @ np.linalg.solve(S, C), -inner.T]
        ]))  # fmt: skip
        size = np.abs(poles).max(initial=0.0)
        ends = np.unique(poles.imag[np.abs(poles.real) < _SAME * np.abs(poles) + _ROUNDING * size].clip(0))
        better = highest(np.append((ends[1:] + ends[:-1]) / 2, ends))
        if better <= gamma:
            return gamma
        found = better
    return 0.0


def modal(A: Array, B: Array, C: Array, D: Array, order: int, period: float | None) -> tuple[System, System]:
    """The part of the poles that decay or ring slowest, with the static gain of the others kept.

    Pairs stay together: where ``order`` would cut one, it has one state more.
    """
    from scipy.linalg import schur, solve_sylvester

    poles = np.linalg.eigvals(A)
    sizes = -np.log(np.maximum(np.abs(poles), 1e-300)) if period else np.abs(poles)
    limit = np.sort(sizes)[order - 1] * (1 + _SAME) + 1e-12

    def slow(real: float, imaginary: float) -> bool:
        size = -np.log(max(np.hypot(real, imaginary), 1e-300)) if period else np.hypot(real, imaginary)
        return bool(size <= limit)

    form, basis, count = schur(A, sort=slow)  # pyright: ignore[reportAssignmentType]
    mix = solve_sylvester(form[:count, :count], -form[count:, count:], -form[:count, count:])
    B, C = basis.T @ B, C @ basis
    Bs, Cf = B[:count] - mix @ B[count:], C[:, :count] @ mix + C[:, count:]
    point = np.eye(len(A) - count) if period else np.zeros((len(A) - count,) * 2)
    static = Cf @ np.linalg.solve(point - form[count:, count:], B[count:]) if len(A) > count else np.zeros_like(D)
    left = form[count:, count:], B[count:], Cf, -static
    return (form[:count, :count], Bs, C[:, :count], D + static), left
