"""The functions of a strain link: polynomials of the moment, over the stiffness of the section.

A function is b_j(s) = (EI_ref/EI(s)) p_j(s), with p_j = P_j(2 s - 1) or, of bending only and where asked, (1 - s) P_j.
So EI times the curvature is a polynomial whatever the section does: a force or moment at the tip bends a stepped or
tapered link exactly. 1/EI_ref is the mean of 1/EI; of a uniform link the functions are the polynomials themselves.
A piece of infinite stiffness has functions of value 0. Positions are s = x/length in 0..1 of the unloaded line.
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.links.beam_pieces import BeamNumbers

__all__ = [
    "MODULI",
    "fine_rule",
    "function_values",
    "interval_integrals",
    "is_uniform",
    "pieces_at",
    "stiffness_matrix",
]

Array = NDArray[np.float64]

MODULI = {"twist": "torsion", "bend_y": "bend_y", "bend_z": "bend_z", "stretch": "axial"}
"""Directions in which a link deforms, in the order of its coordinates, and the stiffness of a piece against each."""

_TURNING = ("twist", "bend_y", "bend_z")

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
    """K = 1/L int EI b_i b_j ds [N*m] of a direction that turns sections; of stretch L int EA b_i b_j ds [N*m]."""
    s, w = fine_rule(beam)
    values, stiffness = function_values(beam, direction, s), pieces_at(beam, MODULI[direction], s)
    stiffness = np.where(np.isinf(stiffness) & (values[0] == 0.0), 0.0, stiffness)
    scale = beam.length if direction == "stretch" else 1 / beam.length
    return np.asarray(scale * (values * w * stiffness) @ values.T, dtype=np.float64)
