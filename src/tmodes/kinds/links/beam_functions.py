"""The functions of a strain link: polynomials of the moment, over the stiffness of the section.

A function is b_j(s) = (EI_ref/EI(s)) p_j(s), with p_j = P_j(2 s - 1) or, of bending only and where asked, (1 - s) P_j.
So EI times the curvature is a polynomial whatever the section does: a force or moment at the tip bends a stepped or
tapered link exactly. 1/EI_ref is the mean of 1/EI; of a uniform link the functions are the polynomials themselves.
A body inside takes a force and a moment out of the beam, so the moment of bending has a kink and a jump at its place a:
further functions have (1 - s/a) and 1 in place of p_j inboard of a, and 0 outboard of it, less what the others have.
A piece of infinite stiffness has functions of value 0. Positions are s = x/length in 0..1 of the unloaded line.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import starmap
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.links.beam_breaks import TURNING, breaks_of, broken_pieces
from tmodes.kinds.links.beam_pieces import BeamNumbers
from tmodes.kinds.noted.functions import (
    array,
    clip,
    inverse_cholesky,
    isfinite,
    isinf,
    legendre_values,
    norm,
    number,
    place,
    same,
    solve,
    sqrt,
    zeros,
)
from tmodes.kinds.noted.number import is_noted

__all__ = [
    "MODULI", "SHIFTING", "BareBeam", "bare_beam", "beam_mass", "fine_rule", "function_names", "function_order",
    "function_values", "interval_integrals", "is_uniform", "last_functions", "piece_rule", "pieces_at", "softened",
    "stiffness_matrix",
]  # fmt: skip

Array = NDArray[np.float64]

MODULI = {"twist": "torsion", "bend_y": "bend_y", "bend_z": "bend_z", "stretch": "axial",
          "shear_y": "shear_y", "shear_z": "shear_z"}  # fmt: skip
"""Directions in which a link deforms, in the order of its coordinates, and the stiffness of a piece against each."""

SHIFTING = ("stretch", "shear_y", "shear_z")
"""Directions that only shift sections."""

_QUANTITIES = (*MODULI.values(), "mass")

_NEW = 1e-4
"""Share of a function of a body inside that the others must lack for it to be one more."""

_X, _W = legendre.leggauss(24)
"""Rule within a piece: exact to rounding for polynomials, to 1e-10 where stiffness falls to a sixteenth in it."""


def pieces_at(beam: BeamNumbers, name: str, s: ArrayLike) -> Array:
    """A quantity of a beam's pieces at s, shape of s; where two pieces meet, that of the inner one.

    ``name``: a field of :class:`tmodes.kinds.links.beam_pieces.BeamPiece`;
    ``inertia0``, ``inertia1``, ``inertia2`` about x, y, z.
    """
    s = array(s)
    starts, ends = _bounds(beam)
    k = np.minimum(place(ends, s - 1e-12), len(ends) - 1)
    values = _ends(beam, name)
    rise = np.array([last - first if first != last else 0.0 for first, last in values])  # infinite ones are equal
    return values[k, 0] + rise[k] * (s - starts[k]) / (ends - starts)[k]


def _bounds(beam: BeamNumbers) -> tuple[Array, Array]:
    """Where each piece starts and where it ends."""
    ends = array([piece.end for piece in broken_pieces(beam)])
    return np.concatenate([[0.0], ends[:-1]]), ends


def _ends(beam: BeamNumbers, name: str) -> Array:
    """(pieces, 2): a quantity at the start and the end of each piece."""
    if name.startswith("inertia"):
        return array([piece.inertia[int(name[-1])] for piece in broken_pieces(beam)])
    return array([getattr(piece, name) for piece in broken_pieces(beam)])


def is_uniform(beam: BeamNumbers, direction: str) -> bool:
    """True where a direction has one stiffness all along the link."""
    ends = _ends(beam, MODULI[direction])
    return bool((ends == ends[0, 0]).all()) if _weighted(beam, direction) else True


def _weighted(beam: BeamNumbers, direction: str) -> bool:
    """Whether 1/EI is a number everywhere and not 0 everywhere; of links without any stiffness it is not."""
    values = _ends(beam, MODULI[direction])
    return bool((values > 0.0).all() and isfinite(values).any())


@lru_cache(maxsize=64)
def piece_rule(beam: BeamNumbers) -> tuple[Array, Array]:
    """Rule within a piece; of noted numbers, pieces of one section each, the shortest that is exact: polynomials."""
    pieces = broken_pieces(beam)
    pairs = [pair for piece in pieces for pair in (*piece.inertia, *(getattr(piece, name) for name in _QUANTITIES))]
    noted = is_noted([(piece.end, piece.mass) for piece in pieces]) or is_noted(pairs)
    if not noted or not all(starmap(same, pairs)):
        return _X, _W
    return legendre.leggauss(2 + max(beam.points, 2 + max(getattr(beam, name) for name in MODULI)))


def fine_rule(beam: BeamNumbers) -> tuple[Array, Array]:
    """Points and weights (sum 1) of a fine quadrature over all pieces."""
    (starts, ends), (x, w) = _bounds(beam), piece_rule(beam)
    half = (ends - starts)[:, None] / 2
    return (starts[:, None] + half * (1 + x)).ravel(), (half * w).ravel()


def _shares(beam: BeamNumbers, direction: str, s: Array) -> Array:
    """EI_ref/EI at s."""
    if not _weighted(beam, direction) or is_uniform(beam, direction):
        return np.ones(s.shape)
    places, weights = fine_rule(beam)
    mean = np.sum(weights / pieces_at(beam, MODULI[direction], places))
    return array(1 / (mean * pieces_at(beam, MODULI[direction], s)))


def function_values(beam: BeamNumbers, direction: str, s: ArrayLike) -> Array:
    """Values (functions, *s) of the functions of a direction, those of bodies inside last; at a break the inner one."""
    s = array(s)
    if not getattr(beam, direction):
        return np.zeros((0, *s.shape))
    values, broken = _moments(beam, direction, s), _broken(beam, direction)
    if broken is not None:
        raw = [one.values(s) for one in breaks_of(beam, direction)]
        values = np.concatenate([values, np.tensordot(broken, np.array([*values, *raw]), 1)])
    return array(values * _shares(beam, direction, s))


def _moments(beam: BeamNumbers, direction: str, s: Array) -> Array:
    """The polynomials p_j (functions, *s) of a direction."""
    polynomials = np.moveaxis(legendre_values(2 * s - 1, getattr(beam, direction) - 1), -1, 0)
    window = 1 - s if direction.startswith("bend") and beam.basis == "tip_weighted" else np.ones(s.shape)
    return polynomials * window


@lru_cache(maxsize=256)
def _broken(beam: BeamNumbers, direction: str) -> Array | None:
    """Each function of bodies inside (functions, polynomials + breaks) as a sum of polynomials and broken ones.

    Orthonormal to all before it under the elastic energy (Gram and Schmidt, twice), so that matrices of mass keep their
    condition; one that the others already have, such as where the beam is rigid, is left out. None where there is none.
    """
    breaks = breaks_of(beam, direction)
    if not breaks:
        return None
    s, w = fine_rule(beam)
    root, values = sqrt(w * _shares(beam, direction, s)), _moments(beam, direction, s)
    columns = np.array([*values, *(one.values(s) for one in breaks)]) * root
    known = inverse_cholesky(columns[: len(values)] @ columns[: len(values)].T)
    sums = [np.pad(row, (0, len(breaks))) for row in known]
    for k in range(len(values), len(columns)):
        own = np.eye(len(columns))[k]
        for _ in range(2):
            own = own - sum(((row @ columns) @ (own @ columns)) * row for row in sums)
        size = norm(own @ columns)
        if size > _NEW * norm(columns[k]):
            sums.append(own / size)
    return np.array(sums[len(values) :]) if len(sums) > len(values) else None


def function_names(beam: BeamNumbers, direction: str) -> list[str]:
    """``bend_y1``, ``bend_y2``, ..., then of bodies inside ``bend_y101``, ``bend_y102``, ..."""
    broken = _broken(beam, direction) if getattr(beam, direction) else None
    numbers = [*range(1, getattr(beam, direction) + 1), *range(101, 101 + (0 if broken is None else len(broken)))]
    return [f"{direction}{number}" for number in numbers]


def interval_integrals(beam: BeamNumbers, start: Array, end: Array) -> tuple[Array, Array]:
    """Of each interval (n,) and each function that turns sections: two arrays (n, turning).

    The integral, and the first moment about the interval's middle over its length; broken at the ends of the pieces.
    """
    middle, length = (start + end) / 2, end - start
    starts, ends = _bounds(beam)
    (low, high), (x, w) = (clip(at, starts[:, None], ends[:, None]) for at in (start, end)), piece_rule(beam)
    s = low[..., None] + (high - low)[..., None] * (1 + x) / 2
    some = low != high if is_noted(s) else np.ones(low.shape, dtype=bool)
    values = np.concatenate([function_values(beam, direction, s[some]) for direction in TURNING])
    if is_noted(values) or is_noted(s):
        spread = zeros((len(values), *s.shape), values)
        spread[:, some] = values
        return _noted_integrals(spread, (x, w), low, high, middle, length)
    values = values.reshape(len(values), *s.shape)
    per_length = np.divide(1.0, length, out=np.zeros_like(length), where=length > 0)
    weighed = values * ((high - low)[..., None] * w / 2)
    moments = weighed * (s - middle[:, None]) * per_length[:, None]
    alpha, beta = (part.sum(axis=-1).sum(axis=1).T for part in (weighed, moments))
    return alpha, beta


def _noted_integrals(
    values: Array, rule: tuple[Array, Array], low: Array, high: Array, middle: Array, length: Array
) -> tuple[Array, Array]:
    """The same of noted numbers: what is a constant of the rule first, then the lengths of the intervals."""
    x, w = rule
    share = np.frompyfunc(lambda own, whole: own / whole if whole > 0 else 0.0, 2, 1)(high - low, length)
    aside = np.frompyfunc(lambda own, whole: own / whole if whole > 0 else 0.0, 2, 1)((low + high) / 2 - middle, length)
    sums, first = values @ (w / 2), values @ (w * x / 4)
    alpha = (high - low) * sums
    return alpha.sum(axis=1).T, (alpha * aside + (high - low) * (share * first)).sum(axis=1).T


def stiffness_matrix(beam: BeamNumbers, direction: str) -> Array:
    """K = 1/L int EI b_i b_j ds [N*m] of a direction that turns sections; else L int EA b_i b_j ds or kGA [N*m]."""
    s, w = fine_rule(beam)
    values, stiffness = function_values(beam, direction, s), pieces_at(beam, MODULI[direction], s)
    stiffness = np.where(isinf(stiffness) & (values == 0.0).all(axis=0), 0.0, stiffness)
    scale = beam.length if direction in SHIFTING else 1 / beam.length
    if is_noted(stiffness) and is_uniform(beam, direction):  # constants of the functions first
        matrix = (scale * stiffness[0]) * ((values * w) @ values.T)
    else:
        matrix = array(scale * (values * w * stiffness) @ values.T)
    if not beam.softened:
        return matrix
    order = function_order(beam, direction)
    changed, found = softened(matrix[np.ix_(order, order)], last_functions(beam, direction)), np.empty_like(matrix)
    found[np.ix_(order, order)] = changed
    return found


def function_order(beam: BeamNumbers, direction: str) -> NDArray[np.intp]:
    """Indices of the functions of a direction, the polynomials with those of :func:`last_functions` at the end."""
    polynomials = np.arange(getattr(beam, direction))
    first = len(polynomials) - last_functions(beam, direction)
    broken = np.arange(len(polynomials), len(function_names(beam, direction)))
    return np.concatenate([polynomials[:first], broken, polynomials[first:]])


def last_functions(beam: BeamNumbers, direction: str) -> int:
    """How many polynomials of a direction are softened to see what they do.

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
    changed[first:, first:] -= (stiffness[first:, first:] - coupled.T @ solve(others, coupled)) / 2
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


class _FunctionValues(NamedTuple):
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
    return BareBeam(beam_mass(beam), about_y, about_z, twist, (give_y, give_z))


def beam_mass(beam: BeamNumbers) -> float:
    """Mass of the beam alone [kg]."""
    s, weight = fine_rule(beam)
    return number(np.sum(weight * pieces_at(beam, "mass", s))) * beam.length


def _integrals(s: Array) -> _FunctionValues:
    """Legendre functions of 2 s - 1 at s, their integrals from 0, and the integrals of those."""
    own = [legendre.Legendre.basis(order, domain=[0, 1]) for order in range(FUNCTIONS)]
    once = [function.integ(lbnd=0) for function in own]
    twice = [function.integ(lbnd=0) for function in once]
    return _FunctionValues(*(np.array([function(s) for function in kind]) for kind in (own, once, twice)))


def _first(stiffness: Array, mass: Array) -> float | None:
    from scipy.linalg import eigh

    if not mass.any():
        return None
    largest = float(eigh(mass, stiffness, eigvals_only=True)[-1])
    return float(1 / np.sqrt(largest)) / (2 * np.pi)


def _bending(length: float, functions: _FunctionValues, weight: Array, stiffness: Array, mass: Array) -> float | None:
    if not np.isfinite(stiffness).all():
        return None
    curvature, _, deflection = functions
    return _first(
        (curvature * weight * stiffness) @ curvature.T / length**4, (deflection * weight * mass) @ deflection.T
    )


def _twisting(
    length: float, functions: _FunctionValues, weight: Array, stiffness: Array, inertia: Array
) -> float | None:
    if not (np.isfinite(stiffness) & (stiffness > 0)).all():
        return None
    twist, turn, _ = functions
    return _first((twist * weight * stiffness) @ twist.T / length**2, (turn * weight * inertia) @ turn.T)
