"""Linear models with fewer states: balanced and modal truncation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError

__all__ = ["balanced", "hankel_values", "modal"]

Array = NDArray[np.float64]
System = tuple[Array, Array, Array, Array]

_SAME = 1e-6
"""Sizes of poles that are the same: those of a Schur form differ from the eigenvalues in the last digits."""


def _gramians(A: Array, B: Array, C: Array, period: float | None) -> tuple[Array, Array]:
    from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

    poles = np.linalg.eigvals(A)
    if not ((np.abs(poles) < 1).all() if period else (poles.real < 0).all()):
        hint = "take method='modal', or close the loop"
        raise InputError("reduce", "a model that is not stable", "a stable one for balanced truncation", hint)
    if period:
        return solve_discrete_lyapunov(A, B @ B.T), solve_discrete_lyapunov(A.T, C.T @ C)
    return solve_continuous_lyapunov(A, -B @ B.T), solve_continuous_lyapunov(A.T, -C.T @ C)


def hankel_values(A: Array, B: Array, C: Array, period: float | None) -> Array:
    """Hankel singular values, the largest first."""
    reach, see = _gramians(A, B, C, period)
    return np.sqrt(np.maximum(np.sort(np.linalg.eigvals(reach @ see).real)[::-1], 0.0))


def _root(gramian: Array) -> Array:
    values, vectors = np.linalg.eigh((gramian + gramian.T) / 2)
    return vectors * np.sqrt(np.maximum(values, 0.0))


def balanced(A: Array, B: Array, C: Array, D: Array, order: int, period: float | None) -> System:
    """Balanced truncation by square roots (M. S. Tombs, I. Postlethwaite, Int. J. Control 46, 1987)."""
    reach, see = map(_root, _gramians(A, B, C, period))
    left, sizes, right = np.linalg.svd(see.T @ reach)
    share = 1 / np.sqrt(sizes[:order])
    into, out = reach @ right[:order].T * share, see @ left[:, :order] * share
    return out.T @ A @ into, out.T @ B, C @ into, D


def modal(A: Array, B: Array, C: Array, D: Array, order: int, period: float | None) -> System:
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
    return form[:count, :count], Bs, C[:, :count], D + static
