"""Numbers of a strain link for its elastic line: steps from section to section, and the mass outboard of a section.

Between the Gauss points every quantity of the moving line is the polynomial through its values there. So the mass
outboard of s weighs the inertia forces f_k at the points with W_k(s) = int_s^1 rhoA l_k, and their levers r_j with
W_jk(s) = int_s^1 rhoA l_j l_k (l_k: 1 at point k, 0 at the others). At s = 0 these are the masses of the model itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from tmodes.chain import Beam
from tmodes.equations.arm.beam_tables import BeamTables, basis_values, beam_tables

__all__ = ["Interval", "LineTables", "line_tables", "pieces_at"]

Array = NDArray[np.float64]

_X, _W = legendre.leggauss(24)
"""A rule that is exact for every product of polynomials that is met here."""


@dataclass(frozen=True, eq=False)
class Interval:
    """Steps along a line, ``count`` of them: integrals of the functions that turn, and their moments about the middle.

    ``alpha`` and ``beta`` (count, turning); ``rest`` (count, 3) [rad]: what the unloaded line turns.
    """

    alpha: Array
    beta: Array
    rest: Array


@dataclass(frozen=True, eq=False)
class LineTables:
    """Tables of a beam for S told places s.

    ``edges`` (B + 1,): the model's own sections; ``march``: steps between them; ``before`` (S,): index of the edge
    before each told place, ``reach``: the step from there; ``to_points`` (g, g) and ``to_places`` (S, g) [m]: integrals
    of the tangents at the points; ``outboard`` (S, g) [kg], ``levers`` (S, g, g) [kg], ``turning`` (S, axes, g)
    [kg*m^2]: mass and section inertia outboard; ``functions`` (S, n): values of all functions over the length, of
    stretch as they are; ``stretch`` (g, count) at the points.
    """

    beam: Beam
    own: BeamTables
    s: Array
    edges: Array
    march: Interval
    before: NDArray[np.intp]
    reach: Interval
    to_points: Array
    to_places: Array
    outboard: Array
    levers: Array
    turning: Array
    functions: Array
    stretch: Array

    @property
    def directions(self) -> Array:
        """(turning, 3): 1 where a function is of that component of curvature."""
        return np.eye(3)[list(self.own.shape.directions)].reshape(-1, 3)


def line_tables(beam: Beam, stations: tuple[float, ...], s: Array) -> LineTables:
    """Tables of a beam whose model tells ``stations``, for the places ``s`` (S,)."""
    own = beam_tables(beam, stations)
    shape, points = own.shape, own.points
    places = {"point": points, "station": np.array(stations), "tip": np.ones(1)}
    edges = np.array([0.0, *(places[kind][k] for kind, k in shape.breaks)])
    before = np.maximum(np.searchsorted(edges, s, side="left") - 1, 0)
    outboard, levers, turning = _outboard(beam, own, s)
    functions = np.array([basis_values(beam.basis, j, s) / beam.length for j in _orders(own)])
    long = np.array([basis_values(beam.basis, j, s) for j in range(shape.stretch)])
    stretch = np.array([basis_values(beam.basis, j, points) for j in range(shape.stretch)])
    return LineTables(
        beam, own, s, edges, _interval(beam, own, edges[:-1], edges[1:]), before,
        _interval(beam, own, edges[before], s),
        to_points=beam.length * _line_integrals(points, points), to_places=beam.length * _line_integrals(points, s),
        outboard=outboard, levers=levers, turning=turning,
        functions=np.concatenate([functions.reshape(-1, len(s)), long.reshape(-1, len(s))]).T,
        stretch=stretch.reshape(-1, len(points)).T,
    )  # fmt: skip


def _orders(own: BeamTables) -> list[int]:
    """Order of each turning function."""
    shape = own.shape
    return [j for count in (shape.twist, shape.bend_y, shape.bend_z) for j in range(count)]


def _interval(beam: Beam, own: BeamTables, start: Array, end: Array) -> Interval:
    length = end - start
    s = start[:, None] + length[:, None] * (1 + _X) / 2
    weights = length[:, None] * _W / 2
    values = np.array([basis_values(beam.basis, j, s) for j in _orders(own)]).reshape(-1, *s.shape)
    alpha, beta = (values * weights).sum(axis=2).T, (values * weights * _X / 2).sum(axis=2).T
    return Interval(alpha, beta, length[:, None] * beam.length * np.asarray(beam.rest_curvature, dtype=float))


def _cardinal(points: Array, s: Array) -> Array:
    """Polynomials that are 1 at one of the points and 0 at the others, at s: shape (points, *s)."""
    orders = range(len(points))
    at_points = np.array([basis_values("legendre", j, points) for j in orders])
    at_s = np.array([basis_values("legendre", j, s) for j in orders])
    found = np.linalg.solve(at_points, at_s.reshape(len(points), -1))
    return np.asarray(found, dtype=float).reshape(at_s.shape)


def _line_integrals(points: Array, until: Array) -> Array:
    """Integral from 0 to each of ``until`` of each of those polynomials, shape (until, points)."""
    s = until[:, None] * (1 + _X) / 2
    return (_cardinal(points, s) * (until[:, None] * _W / 2)).sum(axis=2).T


def _outboard(beam: Beam, own: BeamTables, s: Array) -> tuple[Array, Array, Array]:
    """Mass, levers and section inertia outboard of each s."""
    g, axes = len(own.points), own.shape.rotary
    mass, levers, turning = np.zeros((len(s), g)), np.zeros((len(s), g, g)), np.zeros((len(s), axes, g))
    start = 0.0
    for piece in beam.pieces:
        low = np.clip(s, start, piece.end)
        at = low[:, None] + (piece.end - low)[:, None] * (1 + _X) / 2
        weight = (piece.end - low)[:, None] * _W / 2 * beam.length
        share = (at - start) / (piece.end - start)
        cardinal = _cardinal(own.points, at)
        density = weight * (piece.mass[0] + (piece.mass[1] - piece.mass[0]) * share)
        mass += np.einsum("ksm,sm->sk", cardinal, density)
        levers += np.einsum("jsm,ksm,sm->sjk", cardinal, cardinal, density)
        for axis in range(axes):
            first, last = piece.inertia[axis]
            turning[:, axis] += np.einsum("ksm,sm->sk", cardinal, weight * (first + (last - first) * share))
        start = piece.end
    return mass, levers, turning


def pieces_at(beam: Beam, name: str, s: Array) -> Array:
    """A quantity of a beam's pieces at s, shape of s; where two pieces meet, that of the inner one."""
    ends = np.array([piece.end for piece in beam.pieces])
    starts = np.concatenate([[0.0], ends[:-1]])
    k = np.minimum(np.searchsorted(ends, s - 1e-12), len(ends) - 1)
    values = np.array([getattr(piece, name) for piece in beam.pieces])
    rise = np.zeros(len(values))
    np.subtract(values[:, 1], values[:, 0], out=rise, where=values[:, 1] != values[:, 0])  # infinite ones are equal
    return values[k, 0] + rise[k] * (s - starts[k]) / (ends - starts)[k]
