"""Exact frequencies of beams, and those of the Ritz method with given shapes, in 40 digits.

Everything is dimensionless: L = EI = rhoA = 1 (GJ = polar inertia = 1 for torsion). mu: tip mass, j: tip inertia,
hub: inertia at a free root. None of it knows the package.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp
import numpy as np

__all__ = ["bending", "legendre", "ritz", "ritz_errors", "rotating", "torsion"]

DIGITS = 40


def _tip_rows(k: Any, mu: Any, j: Any) -> Any:
    """Rows of shear and moment at the tip in the amplitudes of cos, sin, cosh, sinh of k x."""
    c, s, ch, sh = mp.cos(k), mp.sin(k), mp.cosh(k), mp.sinh(k)
    shear = [s + mu * k * c, -c + mu * k * s, sh + mu * k * ch, ch + mu * k * sh]
    moment = [-c + j * k**3 * s, -s - j * k**3 * c, ch - j * k**3 * sh, sh - j * k**3 * ch]
    return shear, moment


def _determinant(k: Any, mu: Any, j: Any, hub: Any) -> Any:
    """Zero at the roots; the root is clamped for hub None, else free to turn with that inertia."""
    place = [1, 0, 1, 0]
    turn = [0, 1, 0, 1] if hub is None else [-1, hub * k**3, 1, hub * k**3]
    return mp.det(mp.matrix([place, turn, *_tip_rows(k, mu, j)])) / mp.cosh(k)


def _roots(function: Callable[[Any], Any], number: int, step: float = 0.1) -> list[Any]:
    """The first roots on x > 0, bracketed on a grid and polished."""
    found, left = [], mp.mpf(step) / 2
    value = function(left)
    while len(found) < number:
        right = left + step
        after = function(right)
        if value * after < 0:
            found.append(mp.findroot(function, (left, right), solver="anderson"))
        left, value = right, after
    return found


def bending(number: int, mu: float = 0.0, j: float = 0.0, hub: float | None = None) -> list[Any]:
    """Circular frequencies of the first modes; a rigid-body mode is left out."""
    with mp.workdps(DIGITS):
        inertia = None if hub is None else mp.mpf(str(hub))
        values = mp.mpf(str(mu)), mp.mpf(str(j))
        return [k**2 for k in _roots(lambda k: _determinant(k, *values, inertia), number)]


def torsion(number: int, r: float = 0.0) -> list[Any]:
    """Circular frequencies of a bar clamped at one end with the inertia r at the other: cot w = r w."""
    with mp.workdps(DIGITS):
        inertia = mp.mpf(str(r))
        return _roots(lambda w: mp.cos(w) - inertia * w * mp.sin(w), number)


def legendre(number: int, tip_weighted: bool = False) -> list[list[Any]]:
    """Rising coefficients in s of P_j(2 s - 1), times (1 - s) if asked."""
    rows = [
        [mp.mpf((-1) ** (j + k)) * mp.binomial(j, k) * mp.binomial(j + k, k) for k in range(j + 1)]
        for j in range(number)
    ]
    return [_times(row, [1, -1]) for row in rows] if tip_weighted else rows


def _times(a: list[Any], b: list[Any]) -> list[Any]:
    out = [mp.mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def _integral(a: list[Any]) -> list[Any]:
    return [mp.mpf(0), *(x / (i + 1) for i, x in enumerate(a))]


def _over(a: list[Any], b: list[Any], weight: list[Any] | None = None) -> Any:
    """Integral over 0..1 of a b weight."""
    return mp.fsum(_integral(_times(_times(a, b), weight or [1])))


def ritz(
    strains: list[list[Any]], mu: float = 0.0, j: float = 0.0, hub: float | None = None, twist: bool = False
) -> list[Any]:
    """Circular frequencies with the given strain functions: curvature, integrated twice, or twist, once.

    ``hub``: one more coordinate turns the whole beam about its root; its zero frequency is left out.
    """
    with mp.workdps(DIGITS):
        slopes = [_integral(f) for f in strains]
        shapes = slopes if twist else [_integral(f) for f in slopes]
        mass_at_tip, inertia = mp.mpf(str(mu)), mp.mpf(str(j))
        if hub is not None:
            strains, slopes, shapes = [*strains, [0]], [*slopes, [1]], [*shapes, [0, 1]]
        at_tip = [(mp.fsum(y), mp.fsum(s)) for y, s in zip(shapes, slopes, strict=True)]
        size = len(shapes)

        def mass(a: int, b: int) -> Any:
            tip = mass_at_tip * at_tip[a][0] * at_tip[b][0] + inertia * at_tip[a][1] * at_tip[b][1]
            root = mp.mpf(str(hub)) if hub is not None and a == b == size - 1 else 0
            return _over(shapes[a], shapes[b]) + tip + root

        return _frequencies(size, lambda a, b: _over(strains[a], strains[b]), mass, 0 if hub is None else 1)


def _frequencies(size: int, stiffness: Any, mass: Any, rigid: int) -> list[Any]:
    """Square roots of the eigenvalues of M^-1 K, rising, without the ``rigid`` first ones."""
    table = {
        name: mp.matrix([[entry(a, b) for b in range(size)] for a in range(size)])
        for name, entry in (("k", stiffness), ("m", mass))
    }
    lower = mp.cholesky(table["m"])
    inverse = lower**-1
    values = mp.eigsy(inverse * table["k"] * inverse.T, eigvals_only=True)
    return [mp.sqrt(value) for value in sorted(values)[rigid:]]


def ritz_errors(
    number: int,
    *,
    tip_weighted: bool = False,
    mu: float = 0.0,
    j: float = 0.0,
    hub: float | None = None,
    twist: bool = False,
) -> list[float]:
    """Relative errors of all frequencies of ``number`` strain functions."""
    with mp.workdps(DIGITS):
        found = ritz(legendre(number, tip_weighted), mu, j, hub, twist)
        exact = torsion(number, mu) if twist else bending(number, mu, j, hub)
        return [float(a / b - 1) for a, b in zip(found, exact, strict=True)]


def rotating(number: int, speed: float, *, lag: bool, radius: float = 0.0, mu: float = 0.0, order: int = 13) -> Any:
    """Frequencies of an inextensible cantilever on a hub of ``radius`` that turns at ``speed``, by Galerkin's method.

    Centrifugal tension T = w^2 int (r + x); in the plane of turning (lag) the load -w^2 y is taken off. Source: the
    linear equation of the rotating beam, (EI y'')'' - (T y')' - [w^2 y] = -rhoA y_tt.
    """
    with mp.workdps(DIGITS):
        strains = legendre(order)
        slopes = [_integral(f) for f in strains]
        shapes = [_integral(f) for f in slopes]
        square, hub, tip = mp.mpf(speed) ** 2, mp.mpf(str(radius)), mp.mpf(str(mu))
        tension = [hub + mp.mpf(1) / 2 + tip * (hub + 1), -hub, -mp.mpf(1) / 2]
        ends = [mp.fsum(y) for y in shapes]

        def mass(a: int, b: int) -> Any:
            return _over(shapes[a], shapes[b]) + tip * ends[a] * ends[b]

        def stiffness(a: int, b: int) -> Any:
            taut = square * _over(slopes[a], slopes[b], tension)
            return _over(strains[a], strains[b]) + taut - (square * mass(a, b) if lag else 0)

        return np.array([float(w) for w in _frequencies(order, stiffness, mass, 0)[:number]])
