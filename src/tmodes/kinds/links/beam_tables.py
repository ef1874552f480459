"""Numbers of a strain link, computed once: quadrature of its mass, integrals of its functions, stiffness.

All positions are s = x/length in 0..1 of the unloaded line. Where the stiffness of the section jumps, the curvature
jumps and the tangent has a kink that no polynomial follows: the link is divided there in spans, each with its own Gauss
points, under its own mass per length, and its own polynomials. A taper, also one given in many pieces, is one span.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.links.beam_breaks import break_places
from tmodes.kinds.links.beam_functions import (
    MODULI,
    SHIFTING,
    fine_rule,
    function_names,
    function_values,
    interval_integrals,
    is_uniform,
    pieces_at,
    stiffness_matrix,
)
from tmodes.kinds.links.beam_pieces import BeamNumbers
from tmodes.kinds.links.strain_shape import StrainShape
from tmodes.kinds.noted.functions import (
    array,
    by_size,
    ceil,
    clip,
    distinct,
    full_like,
    golub_welsch,
    kept,
    legendre_series,
    legendre_values,
    number,
    place,
    solve,
    sqrt,
    triangle,
    zeros,
)

__all__ = ["JUMP", "BeamTables", "Quadrature", "beam_rule", "beam_tables", "section_edges"]

Array = NDArray[np.float64]

LEAST = 3
"""Points of a span however short it is."""

JUMP = 0.05
"""Relative step of a stiffness that divides a link; those between the straight pieces of a taper are below 0.03."""


@dataclass(frozen=True, eq=False)
class Quadrature:
    """``edges`` (spans + 1,): ends of the spans; ``points`` (g,), ``counts`` of each span; ``masses`` (g,) [kg]."""

    edges: Array
    points: Array
    masses: Array
    counts: tuple[int, ...]

    def cardinal(self, s: ArrayLike) -> Array:
        """Values (g, *s) of the functions that are 1 at one point and 0 at the others, 0 outside its span."""
        s = array(s)
        where = place(self.edges[1:-1], s, "right")
        found = [np.where(where == k, _cardinal(x, self._local(k, s)), 0.0) for k, x in enumerate(self._places())]
        return np.concatenate(found)

    def integrals(self, until: ArrayLike) -> Array:
        """Integral (u, g) from 0 to each of ``until`` (u,) of each of those functions."""
        until, found = array(until), []
        for k, x in enumerate(self._places()):
            length = self.edges[k + 1] - self.edges[k]
            primitives = [legendre.legint(row, lbnd=-1) * length / 2 for row in np.eye(len(x))]
            reached = self._local(k, clip(until, self.edges[k], self.edges[k + 1]))
            values = legendre_series(reached, primitives)
            found.append(solve(legendre_values(x, len(x) - 1).T, values))
        return array(np.concatenate(found).T)

    def rotary(self, beam: BeamNumbers, axis: int) -> Array:
        """Section inertia at the points [kg*m^2] about an axis of the section.

        Interpolatory weights; where they make one of a span negative, which no inertia may be, the inertia goes with
        the masses of the span instead, with the right sum.
        """
        s, w = fine_rule(beam)
        spread = w * pieces_at(beam, f"inertia{axis}", s) * beam.length
        found, masses = (self._by_span(numbers) for numbers in (self.cardinal(s) @ spread, self.masses))
        for own, mass in zip(found, masses, strict=True):
            if (own < 0.0).any():
                own[:] = mass * (own.sum() / mass.sum())
        return np.concatenate(found)

    def _local(self, k: int, s: Array) -> Array:
        """From s to -1..1 in a span."""
        return 2 * (s - self.edges[k]) / (self.edges[k + 1] - self.edges[k]) - 1

    def _places(self) -> list[Array]:
        """The points of each span, from -1 to 1."""
        return [self._local(k, row) for k, row in enumerate(self._by_span(self.points))]

    def _by_span(self, numbers: Array) -> list[Array]:
        """Numbers of the points (g,) span by span."""
        return np.split(numbers, np.cumsum(self.counts)[:-1])


def _cardinal(points: Array, x: Array) -> Array:
    order = len(points) - 1
    at_points, at_x = legendre_values(points, order).T, np.moveaxis(legendre_values(x, order), -1, 0)
    return array(solve(at_points, at_x.reshape(len(points), -1)).reshape(at_x.shape))


def beam_rule(beam: BeamNumbers) -> Quadrature:
    """The rule of a beam.

    Without ``beam.points`` a link of one span has two points more than functions, which is exact for its mass matrix
    at rest; in each of several spans, which are short, one point more is as good. Of a short span between bodies fewer
    do: a polynomial of degree n is there one of degree about 3/2 n h.
    """
    edges = _edges(beam)
    largest = max(getattr(beam, name) for name in MODULI)
    most = beam.points or largest + (2 if len(edges) == 2 else 1)
    counts = [most] * (len(edges) - 1)
    if break_places(beam) and not beam.points:
        counts = [min(most, ceil(1.5 * largest * length) + LEAST) for length in np.diff(edges)]
    spans = [_gauss(beam, number(a), number(b), count) for (a, b), count in zip(pairwise(edges), counts, strict=True)]
    points, masses = (np.concatenate(part) for part in zip(*spans, strict=True))
    return Quadrature(edges, points, masses, tuple(counts))


def _edges(beam: BeamNumbers) -> Array:
    """Root, every place where a stiffness that matters jumps or a body inside breaks the moment, tip."""
    names = [modulus for direction, modulus in MODULI.items() if getattr(beam, direction)]
    inner = []
    for piece, following in pairwise(beam.pieces):
        pairs = [(getattr(piece, name)[1], getattr(following, name)[0]) for name in names]
        if any(min(pair) < (1 - JUMP) * max(pair) for pair in pairs):
            inner.append(piece.end)
    return array(distinct([0.0, *inner, *(each.place for each in break_places(beam)), 1.0]))


def _gauss(beam: BeamNumbers, start: float, end: float, count: int) -> tuple[Array, Array]:
    """Gauss points and masses [kg] of a span: exact up to degree 2 g - 1 under the beam's own mass per length.

    A span of uniform mass has Gauss-Legendre points; of any other the rule comes from the recurrence of the polynomials
    that are orthogonal under its mass (Stieltjes procedure and the eigenvalues of Golub and Welsch).
    """
    s, w = fine_rule(beam)
    inside = (s > start) & (s < end)
    s, w = s[inside], w[inside]
    mass = pieces_at(beam, "mass", s)
    if (mass == mass[0]).all():
        x, weights = legendre.leggauss(count)
        return start + (end - start) * (1 + x) / 2, weights * (end - start) / 2 * mass[0] * beam.length
    measure = w * mass
    before, now = np.zeros(s.shape), full_like(s, 1 / sqrt(measure.sum()))
    diagonal, off_diagonal = zeros(count, s, measure), zeros(count, s, measure)
    for k in range(count):
        diagonal[k] = np.sum(measure * s * now**2)
        following = (s - diagonal[k]) * now - (off_diagonal[k - 1] if k else 0.0) * before
        off_diagonal[k] = sqrt(np.sum(measure * following**2))
        before, now = now, following / off_diagonal[k]
    nodes, weights = golub_welsch(diagonal, off_diagonal[:-1])
    return nodes, measure.sum() * weights * beam.length


@dataclass(frozen=True, eq=False)
class BeamTables:
    """Packed tables of a strain link; ``rule``: where its mass is."""

    shape: StrainShape
    packed: Array
    stiffness: Array
    damping: Array
    rule: Quadrature

    @property
    def points(self) -> Array:
        """The Gauss points (g,)."""
        return self.rule.points


def _shape(beam: BeamNumbers, rule: Quadrature, stations: tuple[float, ...]) -> StrainShape:
    before = tuple(int(place(rule.points, s, "right")) for s in stations)
    inertia = [any(max(piece.inertia[axis]) > 0 for piece in beam.pieces) for axis in range(3)]
    return StrainShape(
        **{direction: len(function_names(beam, direction)) for direction in MODULI},
        points=len(rule.points), stations=before,
        rotary=3 if inertia[1] or inertia[2] else 1 if inertia[0] else 0,
        curved=any(by_size(beam.rest_curvature)),
        spans=rule.counts if break_places(beam) else (),
        full=beam.basis != "legendre" or not all(is_uniform(beam, name) for name in MODULI if getattr(beam, name)),
    )  # fmt: skip


def section_edges(shape: StrainShape, points: Array, stations: tuple[float, ...]) -> Array:
    """Root, then every section of the model from root to tip: Gauss points, stations, tip."""
    places = {"point": points, "station": np.array(stations), "tip": np.ones(1)}
    return np.array([0.0, *(places[kind][k] for kind, k in shape.breaks)])


@kept
def beam_tables(beam: BeamNumbers, stations: tuple[float, ...] = ()) -> BeamTables:
    """All tables of a beam with the sections at ``stations``; found once for the model, its rest and its lines."""
    rule = beam_rule(beam)
    shape = _shape(beam, rule, stations)
    edges = section_edges(shape, rule.points, stations)
    to_point = beam.length * rule.integrals(rule.points)
    alpha, beta = interval_integrals(beam, edges[:-1], edges[1:])
    rest = np.diff(edges)[:, None] * beam.length * array(beam.rest_curvature)
    tables = {
        "alpha": alpha,
        "beta": beta if shape.planar is None else np.empty(0),
        "rest": rest if shape.curved else np.empty(0),
        "root_mass": _root_mass(to_point, rule.masses, shape),
        "first_moment": rule.masses @ to_point,
        "mass": np.array([rule.masses.sum()]),
        "to_tip": beam.length * rule.integrals(np.ones(1)),
        "shifts": np.concatenate([function_values(beam, name, rule.points) for name in SHIFTING]).T,
        "rotary": np.array([rule.rotary(beam, axis) for axis in range(shape.rotary)]).T,
        "to_station": beam.length * rule.integrals(np.array(stations)),
    }
    packed = np.concatenate([tables[name].ravel() for name in shape.tables])
    stiffness = _stiffness(beam, shape)
    return BeamTables(shape, packed, stiffness, beam.damping_time * stiffness, rule)


def _root_mass(to_point: Array, masses: Array, shape: StrainShape) -> Array:
    """Rows of the upper triangle R with R^T R = A^T m A, A the integrals to the points; a massless span is allowed.

    Of several spans the rows of m^1/2 A itself, of each point m^1/2 for the whole spans before it, then its own span.
    """
    rows = sqrt(masses)[:, None] * to_point
    if shape.spans:
        return np.concatenate(
            [np.concatenate([[sqrt(masses[m])], rows[m, part]]) for part in shape.parts for m in part]
        )
    return array(triangle(rows))[np.triu_indices(len(masses))]


def _stiffness(beam: BeamNumbers, shape: StrainShape) -> Array:
    """The stiffness matrices by direction: diagonals, or lower triangles row by row [N*m]."""
    matrices = [stiffness_matrix(beam, name) for name in MODULI if getattr(beam, name)]
    entries = [matrix[np.tril_indices(len(matrix))] if shape.full else np.diag(matrix) for matrix in matrices]
    return np.concatenate(entries) if entries else np.empty(0)
