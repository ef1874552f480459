"""The functions of a strain link: polynomials of the moment, over the stiffness of the section.

A function is b_j(s) = (EI_ref/EI(s)) p_j(s), with p_j = P_j(2 s - 1) or, of bending only and where asked, (1 - s) P_j.
So EI times the curvature is a polynomial whatever the section does: a force or moment at the tip bends a stepped or
tapered link exactly. 1/EI_ref is the mean of 1/EI; of a uniform link the functions are the polynomials themselves.
A piece of infinite stiffness has functions of value 0. Positions are s = x/length in 0..1 of the unloaded line.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.links.beam_pieces import BeamNumbers

__all__ = [
    "MODULI", "SHIFTING", "BareBeam", "bare_beam", "fine_rule", "function_values", "interval_integrals",
    "is_uniform", "last_functions", "pieces_at", "softened", "stiffness_matrix",
]  # fmt: skip

Array = NDArray[np.float64]

MODULI = {"twist": "torsion", "bend_y": "bend_y", "bend_z": "bend_z", "stretch": "axial",
          "shear_y": "shear_y", "shear_z": "shear_z"}  # fmt: skip
"""Directions in which a link deforms, in the order of its coordinates, and the stiffness of a piece against each."""

_TURNING = ("twist", "bend_y", "bend_z")
SHIFTING = ("stretch", "shear_y", "shear_z")
"""Directions that turn sections, and those that only shift them."""

_X, _W = legendre.leggauss(24)
"""Rule within a piece: exact to rounding for polynomials, to 1e-10 where stiffness falls to a sixteenth in it."""


def pieces_at(beam: BeamNumbers, name: str, s: ArrayLike) -> Array:
    """A quantity of a beam's pieces at s, shape of s; where two pieces meet, that of the inner one.

    ``name``: a field of :class:`tmodes.kinds.links.beam_pieces.BeamPiece`;
    ``inertia0``, ``inertia1``, ``inertia2`` about x, y, z.
    """
    s = np.asarray(s, dtype=float)
    starts, ends = _bounds(beam)
    k = np.minimum(np.searchsorted(ends, s - 1e-12), len(ends) - 1)
    values = _ends(beam, name)
    rise = np.zeros(len(values))
    np.subtract(values[:, 1], values[:, 0], out=rise, where=values[:, 1] != values[:, 0])  # infinite ones are equal
    return values[k, 0] + rise[k] * (s - starts[k]) / (ends - starts)[k]


def _bounds(beam: BeamNumbers) -> tuple[Array, Array]:
    """Where each piece starts and where it ends."""
    ends = np.array([piece.end for piece in beam.pieces])
    return np.concatenate([[0.0], ends[:-1]]), ends


def _ends(beam: BeamNumbers, name: str) -> Array:
    """(pieces, 2): a quantity at the start and the end of each piece."""
    if name.startswith("inertia"):
        return np.array([piece.inertia[int(name[-1])] for piece in beam.pieces], dtype=float)
    return np.array([getattr(piece, name) for piece in beam.pieces], dtype=float)


def is_uniform(beam: BeamNumbers, direction: str) -> bool:
    """True where a direction has one stiffness all along the link."""
    return bool(np.ptp(_ends(beam, MODULI[direction])) == 0.0) if _weighted(beam, direction) else True


def _weighted(beam: BeamNumbers, direction: str) -> bool:
    """Whether 1/EI is a number everywhere and not 0 everywhere; of links without any stiffness it is not."""
    values = _ends(beam, MODULI[direction])
    return bool(values.min() > 0.0 and np.isfinite(values).any())


def fine_rule(beam: BeamNumbers) -> tuple[Array, Array]:
    """Points and weights (sum 1) of a fine quadrature over all pieces."""
    starts, ends = _bounds(beam)
    half = (ends - starts)[:, None] / 2
    return (starts[:, None] + half * (1 + _X)).ravel(), (half * _W).ravel()


def _shares(beam: BeamNumbers, direction: str, s: Array) -> Array:
    """EI_ref/EI at s."""
    if not _weighted(beam, direction) or is_uniform(beam, direction):
        return np.ones_like(s)
    places, weights = fine_rule(beam)
    mean = np.sum(weights / pieces_at(beam, MODULI[direction], places))
    return np.asarray(1 / (mean * pieces_at(beam, MODULI[direction], s)), dtype=np.float64)


def function_values(beam: BeamNumbers, direction: str, s: ArrayLike) -> Array:
    """Values (functions, *s) of the functions of a direction; where two pieces meet, of the inner one."""
    s = np.asarray(s, dtype=float)
    count = getattr(beam, direction)
    if not count:
        return np.zeros((0, *s.shape))
    polynomials = np.moveaxis(legendre.legvander(2 * s - 1, count - 1), -1, 0)
    window = 1 - s if direction.startswith("bend") and beam.basis == "tip_weighted" else np.ones_like(s)
    return np.asarray(polynomials * (window * _shares(beam, direction, s)), dtype=np.float64)


def interval_integrals(beam: BeamNumbers, start: Array, end: Array) -> tuple[Array, Array]:
    """Of each interval (n,) and each function that turns sections: two arrays (n, turning).

    The integral, and the first moment about the interval's middle over its length; broken at the ends of the pieces.
    """
    middle, length = (start + end) / 2, end - start
    per_length = np.divide(1.0, length, out=np.zeros_like(length), where=length > 0)
    starts, ends = _bounds(beam)
    low, high = (np.clip(place, starts[:, None], ends[:, None]) for place in (start, end))
    s = low[..., None] + (high - low)[..., None] * (1 + _X) / 2
    weights = (high - low)[..., None] * _W / 2
    values = np.concatenate([function_values(beam, direction, s) for direction in _TURNING]) * weights
    moments = values * (s - middle[:, None]) * per_length[:, None]
    alpha, beta = (part.sum(axis=-1).sum(axis=1).T for part in (values, moments))
    return alpha, beta


def stiffness_matrix(beam: BeamNumbers, direction: str) -> Array:
    """K = 1/L int EI b_i b_j ds [N*m] of a direction that turns sections; else L int EA b_i b_j ds or kGA [N*m]."""
    s, w = fine_rule(beam)
    values, stiffness = function_values(beam, direction, s), pieces_at(beam, MODULI[direction], s)
    stiffness = np.where(np.isinf(stiffness) & (values[0] == 0.0), 0.0, stiffness)
    scale = beam.length if direction in SHIFTING else 1 / beam.length
    matrix = np.asarray(scale * (values * w * stiffness) @ values.T, dtype=np.float64)
    return softened(matrix, last_functions(beam, direction)) if beam.softened else matrix


def last_functions(beam: BeamNumbers, direction: str) -> int:
    """How many functions of a direction are softened to see what they do.

    An even and an odd one, of which a motion may ask for one. The first functions move or turn the tip of a link whose
    load is given, as no missing function does: they are softened only where there are no others.
    """
    count = getattr(beam, direction)
    moving = 2 if direction.startswith("bend") and beam.basis == "legendre" else 1
    return min(count - moving, 2) if count > moving else count


def softened(stiffness: Array, last: int) -> Array:
    """The matrix (n, n) with half the stiffness of its ``last`` functions, of what these have beyond the others.

    Half the stiffness doubles what they do.
    """
    first = len(stiffness) - last
    others, coupled = stiffness[:first, :first], stiffness[:first, first:]
    changed = stiffness.copy()
    changed[first:, first:] -= (stiffness[first:, first:] - coupled.T @ np.linalg.solve(others, coupled)) / 2
    return changed


FUNCTIONS = 10
"""Legendre functions of curvature or twist: the first frequency of a uniform beam is exact to 1e-12."""


class BareBeam(NamedTuple):
    """First frequencies [Hz] of a beam clamped at its root, nothing at its end; None where it is rigid or massless.

    ``mass`` [kg]; ``compliance``: integral (1 - s)^2/EI ds times L^3 of bending about y and z [m/N], tip force at tip.
    """

    mass: float
    bend_y_Hz: float | None
    bend_z_Hz: float | None
    twist_Hz: float | None
    compliance: tuple[float, float]


class _Functions(NamedTuple):
    """Functions of curvature or twist at the points of a rule, and their first and second integrals from the root."""

    own: Array
    once: Array
    twice: Array


def bare_beam(beam: BeamNumbers) -> BareBeam:
    """The beam by itself, without section inertia in bending (Euler and Bernoulli)."""
    s, weight = fine_rule(beam)
    numbers = {name: pieces_at(beam, name, s) for name in ("bend_y", "bend_z", "torsion", "mass", "inertia0")}
    mass, functions = numbers["mass"], _integrals(s)
    about_y, about_z = (_bending(beam.length, functions, weight, numbers[name], mass) for name in ("bend_y", "bend_z"))
    give_y, give_z = (
        float(np.sum(weight * (1 - s) ** 2 / numbers[name])) * beam.length**3 for name in ("bend_y", "bend_z")
    )
    twist = _twisting(beam.length, functions, weight, numbers["torsion"], numbers["inertia0"])
    return BareBeam(float(np.sum(weight * mass)) * beam.length, about_y, about_z, twist, (give_y, give_z))


def _integrals(s: Array) -> _Functions:
    """Legendre functions of 2 s - 1 at s, their integrals from 0, and the integrals of those."""
    own = [legendre.Legendre.basis(order, domain=[0, 1]) for order in range(FUNCTIONS)]
    once = [function.integ(lbnd=0) for function in own]
    twice = [function.integ(lbnd=0) for function in once]
    return _Functions(*(np.array([function(s) for function in kind]) for kind in (own, once, twice)))


def _first(stiffness: Array, mass: Array) -> float | None:
    from scipy.linalg import eigh

    if not mass.any():
        return None
    largest = float(eigh(mass, stiffness, eigvals_only=True)[-1])
    return float(1 / np.sqrt(largest)) / (2 * np.pi)


def _bending(length: float, functions: _Functions, weight: Array, stiffness: Array, mass: Array) -> float | None:
    if not np.isfinite(stiffness).all():
        return None
    curvature, _, deflection = functions
    return _first(
        (curvature * weight * stiffness) @ curvature.T / length**4, (deflection * weight * mass) @ deflection.T
    )


def _twisting(length: float, functions: _Functions, weight: Array, stiffness: Array, inertia: Array) -> float | None:
    if not (np.isfinite(stiffness) & (stiffness > 0)).all():
        return None
    twist, turn, _ = functions
    return _first((twist * weight * stiffness) @ twist.T / length**2, (turn * weight * inertia) @ turn.T)
