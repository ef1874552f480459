"""Linear systems: sampled ones whose inputs are held, and modes that inputs do not reach or outputs do not see."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from tmodes.kinds.controllers.contract import LinearPlant

__all__ = ["Mode", "arriving", "held_late", "lost_modes", "named_modes", "unreached", "unseen", "zero_order_hold"]

_LOST = 1e-9
"""Share of an input in a mode below which it does not reach it."""

_SAME = 1e-8
"""Difference of poles over the largest one within which they are one."""


def zero_order_hold(A: Any, B: Any, period: float) -> tuple[Any, Any]:
    """The sampled system x_k+1 = Ad x_k + Bd u_k of inputs that are held over a ``period`` [s]."""
    from scipy.linalg import expm

    n, m = B.shape
    whole = np.zeros((n + m, n + m))
    whole[:n, :n], whole[:n, n:] = A, B
    used = np.flatnonzero(whole.any(axis=0) | whole.any(axis=1))  # what waits in a delay neither moves nor is read
    found = np.eye(n + m)
    found[np.ix_(used, used)] = expm(whole[np.ix_(used, used)] * period)
    return found[:n, :n], found[:n, n:]


def held_late(A: Any, B: Any, C: Any, D: Any, period: float, delay: float) -> tuple[Any, Any, Any, Any]:
    """The sampled system of inputs that are held from k T + ``delay`` [s] on, for a ``period``; past inputs are states.

    Exact for any delay: x[k+1] = Ad x[k] + Ga u[k-n-1] + Gb u[k-n] with delay = (n + f) T; states x, u[k-1], ...
    """
    (n, m), (whole, part) = B.shape, _parts(period, delay)
    Ad, _ = zero_order_hold(A, B, period)
    late, early = zero_order_hold(A, B, period - part)
    Ga = late @ zero_order_hold(A, B, part)[1] if part else np.zeros((n, m))
    kept = whole + (part > 0)
    if not kept:
        return Ad, early, C, D
    size = n + kept * m
    found, inputs = np.zeros((size, size)), np.zeros((size, m))
    found[:n, :n] = Ad
    for steps, matrix in ((whole + 1, Ga), (whole, early)):
        if steps == 0:
            inputs[:n] += matrix
        elif steps <= kept:
            found[:n, n + (steps - 1) * m : n + steps * m] += matrix
    inputs[n : n + m] = np.eye(m)
    found[n + m :, n:-m] = np.eye(size - n - m)
    seen = np.hstack([C, np.zeros((len(C), kept * m))])
    seen[:, n + (kept - 1) * m :] = D  # what reaches the outputs at once at a sample is the command in force there
    return found, inputs, seen, np.zeros_like(D)


def arriving(A: Any, B: Any, period: float, delay: float) -> tuple[Any, Any]:
    """E, G of the state E x[k] + G (u[k-1], u[k-2], ...) in which a command finds the system, ``delay`` [s] late."""
    (whole, part), n = _parts(period, delay), len(A)
    E, each = zero_order_hold(A, B, part)
    found = [each] if part else []  # by the oldest command first
    for _ in range(whole):
        Ad, Bd = zero_order_hold(A, B, period)
        E, found = Ad @ E, [*(Ad @ one for one in found), Bd]
    return E, np.hstack([np.zeros((n, 0)), *found[::-1]])


def _parts(period: float, delay: float) -> tuple[int, float]:
    """Whole periods of a delay, and what is left of it [s]."""
    whole = int(np.floor(delay / period + 1e-9))
    part = delay - whole * period
    return whole, 0.0 if part < 1e-9 * period else part


class Mode(NamedTuple):
    """A pole [1/s] and the state that has most of it."""

    pole: complex
    state: str

    def __str__(self) -> str:
        """As messages name it."""
        rings, rate = abs(self.pole.imag) > _SAME * abs(self.pole), self.pole.real
        what = (
            f"of {abs(self.pole) / (2 * np.pi):.4g} Hz" if rings else f"at {rate if abs(rate) > _SAME else 0:.4g} 1/s"
        )
        return f"{what} (mostly `{self.state}`)"


def named_modes(A: Any, states: Sequence[str]) -> list[Mode]:
    """Each pole of x' = A x with the state that takes part most: by left times right eigenvector, whatever its unit.

    A coordinate takes part by itself and by its rate, which has its name and a prime.
    """
    from scipy.linalg import eig

    if not len(A):
        return []
    poles, left, right = eig(A, left=True, right=True)  # pyright: ignore[reportAssignmentType]
    names = [name.removesuffix("'") for name in states]
    shares = {name: np.zeros(len(poles)) for name in names}
    for name, share in zip(names, np.abs(left.conj() * right), strict=True):
        shares[name] += share
    return [Mode(complex(pole), max(shares, key=lambda name: shares[name][k])) for k, pole in enumerate(poles)]


def lost_modes(A: Any, B: Any, states: Sequence[str]) -> list[Mode]:
    """Modes of x' = A x + B u that no input reaches; of (A', C') those that no output sees. One of each pair.

    Poles that are equal are one subspace of left eigenvectors W, of which W' B reaches as many modes as it has rank
    (W. Popov, V. Belevitch, M. Hautus); the states are scaled first.
    """
    from scipy.linalg import eig, matrix_balance

    if not len(A):
        return []
    scaled, (sizes, _) = matrix_balance(A, permute=False, separate=True)
    inputs = np.asarray(B) / sizes[:, None]
    inputs = inputs / np.maximum(np.linalg.norm(inputs, axis=0), 1e-300)
    poles, left, right = eig(scaled, left=True, right=True)  # pyright: ignore[reportAssignmentType]
    found, open_ = [], list(range(len(poles)))
    while open_:
        same = [k for k in open_ if abs(poles[k] - poles[open_[0]]) <= _SAME * np.abs(poles).max()]
        open_ = [k for k in open_ if k not in same]
        ways, weights, _ = np.linalg.svd(left[:, same], full_matrices=False)
        ways = ways[:, weights > 1e-6]
        reached = int(np.sum(np.linalg.svd(ways.conj().T @ inputs, compute_uv=False) > _LOST)) if inputs.size else 0
        if ways.shape[1] > reached and poles[same[0]].imag >= 0:
            share = np.abs(left[:, same] * right[:, same].conj()).sum(axis=1)
            found += [Mode(complex(poles[same[0]]), states[int(share.argmax())])] * (ways.shape[1] - reached)
    return found


def unreached(plant: LinearPlant, states: int | None = None) -> list[str]:
    """The modes of the plant, or of its first ``states``, that no drive reaches, as a message; none without any."""
    own = slice(states)
    return _said("the drives do not reach", lost_modes(plant.A[own, own], plant.B[own], plant.states[own]))


def unseen(plant: LinearPlant) -> list[str]:
    """The same of modes that nothing measured shows."""
    return _said("nothing measured shows", lost_modes(plant.A.T, plant.C.T, plant.states))


def _said(what: str, modes: list[Mode]) -> list[str]:
    return [f"{what} the mode {', '.join(map(str, modes))}: no gain changes its damping"] if modes else []
