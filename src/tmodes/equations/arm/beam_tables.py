"""Numbers of a strain link, computed once: quadrature, integrals of its functions, stiffness.

All positions are s = x/length in 0..1 of the unloaded line.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from tmodes.chain import Beam, BeamPiece
from tmodes.equations.arm.strain_shape import StrainShape

__all__ = ["BeamTables", "basis_values", "beam_tables", "stations_of", "strain_shape"]

Array = NDArray[np.float64]

_FINE = 24
"""Points of the rule with which tables are integrated, per piece: exact to rounding for every function used."""


@dataclass(frozen=True, eq=False)
class BeamTables:
    """Packed tables of a strain link; ``points`` (g,) and ``masses`` (g,) [kg] are its quadrature."""

    shape: StrainShape
    packed: Array
    stiffness: Array
    damping: Array
    points: Array
    masses: Array


def stations_of(beam: Beam, asked: tuple[float, ...] = ()) -> tuple[float, ...]:
    """Where sections must be told besides the tip: bodies and named points at s < 1, rising."""
    found = {s for s, _ in beam.bodies if s < 1.0} | {s for s in asked if s < 1.0}
    return tuple(sorted(found))


def strain_shape(beam: Beam, stations: tuple[float, ...] = ()) -> StrainShape:
    """The structure of a beam's equations."""
    largest = max(beam.twist, beam.bend_y, beam.bend_z, beam.stretch)
    g = beam.points or largest + 2
    points = _quadrature(beam, g)[0]
    before = tuple(int(np.searchsorted(points, s, side="right")) for s in stations)
    uniform = all(_same(piece, beam.pieces[0]) for piece in beam.pieces)
    inertia = [any(max(piece.inertia[axis]) > 0 for piece in beam.pieces) for axis in range(3)]
    return StrainShape(
        beam.twist, beam.bend_y, beam.bend_z, beam.stretch, g, before,
        rotary=3 if inertia[1] or inertia[2] else 1 if inertia[0] else 0,
        curved=bool(np.any(beam.rest_curvature)),
        full=beam.basis != "legendre" or not uniform,
    )  # fmt: skip


def _same(piece: BeamPiece, other: BeamPiece) -> bool:
    ends = [piece.bend_y, piece.bend_z, piece.torsion, piece.axial]
    others = [other.bend_y, other.bend_z, other.torsion, other.axial]
    return all(a == b and a[0] == a[1] for a, b in zip(ends, others, strict=True))


def beam_tables(beam: Beam, stations: tuple[float, ...] = ()) -> BeamTables:
    """All tables of a beam with the sections at ``stations`` told."""
    shape = strain_shape(beam, stations)
    points, masses = _quadrature(beam, shape.points)
    places = {"point": points, "station": np.array(stations), "tip": np.ones(1)}
    edges = np.array([0.0, *(places[kind][k] for kind, k in shape.breaks)])
    to_point = beam.length * _lagrange_integrals(points, points)
    to_tip = beam.length * _lagrange_integrals(points, np.ones(1))[0]
    to_station = beam.length * _lagrange_integrals(points, np.array(stations))
    gram = to_point.T @ (masses[:, None] * to_point)
    root = np.linalg.cholesky(gram).T
    curvature = np.array([_interval_integrals(beam.basis, j, edges) for j in _orders(shape)]).reshape(
        -1, 2, len(edges) - 1
    )
    rest = np.diff(edges)[:, None] * beam.length * np.asarray(beam.rest_curvature)
    stretch = np.array([basis_values(beam.basis, j, points) for j in range(shape.stretch)]).reshape(
        shape.stretch, len(points)
    )
    tables = {
        "alpha": curvature[:, 0].T,
        "beta": curvature[:, 1].T if shape.planar is None else np.empty(0),
        "rest": rest if shape.curved else np.empty(0),
        "root_mass": root[np.triu_indices(shape.points)],
        "first_moment": masses @ to_point,
        "mass": np.array([masses.sum()]),
        "to_tip": to_tip,
        "stretch": stretch.T,
        "stretch_tip": np.empty(0),
        "rotary": _rotary(beam, shape, points, masses),
        "to_station": to_station,
    }
    packed = np.concatenate([tables[name].ravel() for name in shape.tables])
    stiffness = _stiffness(beam, shape)
    return BeamTables(shape, packed, stiffness, beam.damping_time * stiffness, points, masses)


def _orders(shape: StrainShape) -> list[int]:
    return [j for count in (shape.twist, shape.bend_y, shape.bend_z) for j in range(count)]


@cache
def _series(basis: str, order: int) -> tuple[float, ...]:
    """Legendre coefficients in x = 2 s - 1 of the basis function."""
    polynomial = np.zeros(order + 1)
    polynomial[order] = 1.0
    if basis == "tip_weighted":
        polynomial = legendre.legmul(polynomial, np.array([0.5, -0.5]))
    return tuple(polynomial.tolist())


def basis_values(basis: str, order: int, s: Array) -> Array:
    """Values of a basis function: P_j(2 s - 1), or (1 - s) P_j(2 s - 1)."""
    return np.asarray(legendre.legval(2 * np.asarray(s) - 1, _series(basis, order)), dtype=np.float64)


def _integral(basis: str, order: int, s: Array) -> Array:
    """Integral of a basis function from 0 to s."""
    primitive = legendre.legint(np.array(_series(basis, order)), lbnd=-1) / 2
    return np.asarray(legendre.legval(2 * np.asarray(s) - 1, primitive), dtype=np.float64)


def _interval_integrals(basis: str, order: int, edges: Array) -> Array:
    """Of each interval: the integral of the function, and its first moment about the middle over the length."""
    zeroth = np.diff(_integral(basis, order, edges))
    x, w = legendre.leggauss(_FINE)
    length, middle = np.diff(edges), (edges[1:] + edges[:-1]) / 2
    s = middle[:, None] + length[:, None] / 2 * x
    values = basis_values(basis, order, s)
    first = (values * w * (x / 2)).sum(axis=1) * length / 2
    return np.array([zeroth, first])


def _lagrange_integrals(points: Array, until: Array) -> Array:
    """Integral from 0 to each of ``until`` of each polynomial that is 1 at one of the points and 0 at the others."""
    orders = range(len(points))
    values = np.array([basis_values("legendre", j, points) for j in orders])
    integrals = np.array([_integral("legendre", j, until) for j in orders])
    if not len(until):
        return np.empty((0, len(points)))
    return np.asarray(np.linalg.solve(values, integrals).T, dtype=np.float64)


def _between(piece: BeamPiece, start: float, value: tuple[float, float], s: Array) -> Array:
    return value[0] + (value[1] - value[0]) * (s - start) / (piece.end - start)


def _fine_rule(beam: Beam, quantity: str) -> tuple[Array, Array, Array]:
    """Fine quadrature over all pieces: points, weights, values of a quantity (``inertia0``: about x)."""
    x, w = legendre.leggauss(_FINE)
    points, weights, values, start = [], [], [], 0.0
    for piece in beam.pieces:
        half = (piece.end - start) / 2
        s = start + half * (1 + x)
        ends = piece.inertia[int(quantity[-1])] if quantity.startswith("inertia") else getattr(piece, quantity)
        points.append(s)
        weights.append(half * w)
        values.append(_between(piece, start, ends, s))
        start = piece.end
    return np.concatenate(points), np.concatenate(weights), np.concatenate(values)


def _quadrature(beam: Beam, count: int) -> tuple[Array, Array]:
    """Gauss points and masses [kg]: exact for polynomials up to degree 2 g - 1 under the beam's own mass per length.

    A uniform beam has Gauss-Legendre points; of any other the rule comes from the recurrence of the polynomials that
    are orthogonal under its mass (Stieltjes procedure and the eigenvalues of Golub and Welsch).
    """
    s, w, mass = _fine_rule(beam, "mass")
    if np.ptp(mass) == 0.0:
        x, weights = legendre.leggauss(count)
        return (1 + x) / 2, weights / 2 * mass[0] * beam.length
    measure = w * mass
    before, now = np.zeros_like(s), np.full_like(s, 1 / np.sqrt(measure.sum()))
    diagonal, beside = np.zeros(count), np.zeros(count)
    for k in range(count):
        diagonal[k] = np.sum(measure * s * now**2)
        following = (s - diagonal[k]) * now - (beside[k - 1] if k else 0.0) * before
        beside[k] = np.sqrt(np.sum(measure * following**2))
        before, now = now, following / beside[k]
    nodes, vectors = np.linalg.eigh(np.diag(diagonal) + np.diag(beside[:-1], 1) + np.diag(beside[:-1], -1))
    return nodes, measure.sum() * vectors[0] ** 2 * beam.length


def _rotary(beam: Beam, shape: StrainShape, points: Array, masses: Array) -> Array:
    """Section inertia at the Gauss points [kg*m^2], about as many axes as are kept.

    Interpolatory weights; where a jump of the section makes one negative, which no inertia may be, the inertia goes
    with the masses instead, with the right sum.
    """
    orders = range(len(points))
    values = np.array([basis_values("legendre", j, points) for j in orders])
    columns = []
    for axis in range(shape.rotary):
        s, w, inertia = _fine_rule(beam, f"inertia{axis}")
        moments = np.array([np.sum(w * inertia * basis_values("legendre", j, s)) for j in orders])
        weights = np.linalg.solve(values, moments)
        if weights.min(initial=0.0) < 0.0:
            weights = masses * (moments[0] / masses.sum())
        columns.append(weights * beam.length)
    return np.array(columns).T


def _stiffness(beam: Beam, shape: StrainShape) -> Array:
    """K = 1/L int EI b_i b_j ds by direction: diagonals, or lower triangles row by row [N*m]; stretch: L EA [N*m]."""
    packed: list[float] = []
    quantities = (
        ("torsion", shape.twist),
        ("bend_y", shape.bend_y),
        ("bend_z", shape.bend_z),
        ("axial", shape.stretch),
    )
    for quantity, count in quantities:
        s, w, value = _fine_rule(beam, quantity)
        scale = beam.length if quantity == "axial" else 1 / beam.length
        functions = [basis_values(beam.basis if quantity != "axial" else "legendre", j, s) for j in range(count)]
        for i in range(count):
            for j in range(i + 1) if shape.full else (i,):
                if shape.full:
                    packed.append(scale * float(np.sum(w * value * functions[i] * functions[j])))
                else:
                    packed.append(scale * float(value[0]) / (2 * i + 1))
    return np.array(packed)
