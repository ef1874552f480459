"""Numbers of a strain link for its elastic line: steps from section to section, and the mass outboard of a section.

Between the Gauss points of a span every quantity of the moving line is the polynomial through its values there. So the
mass outboard of s weighs the inertia forces f_k at the points with W_k(s) = int_s^1 rhoA l_k, and their levers r_j with
W_jk(s) = int_s^1 rhoA l_j l_k (l_k: 1 at point k, 0 at the others and in other spans). At s = 0 these are the masses of
the model itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from tmodes.chain.chain import Beam
from tmodes.kinds.links.beam_functions import function_values, interval_integrals, pieces_at
from tmodes.kinds.links.beam_tables import BeamTables, beam_tables, section_edges

__all__ = ["PLANAR_TERMS", "TERMS", "Interval", "LineTables", "info_places", "line_tables", "pieces_at"]

Array = NDArray[np.float64]

TERMS = 8
"""Terms of the series of the rotation in space: those of the compiled model."""

PLANAR_TERMS = 24
"""Terms where the line stays in a plane, where the model turns exactly."""

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


def info_places(asked: Array, stations: tuple[float, ...] = ()) -> Array:
    """All places of a link: root, those asked, stations, tip."""
    return np.concatenate([[0.0], asked, stations, [1.0]])


def line_tables(beam: Beam, stations: tuple[float, ...], s: Array) -> LineTables:
    """Tables of a beam whose model tells ``stations``, for the places ``s`` (S,)."""
    own = beam_tables(beam, stations)
    rule, edges = own.rule, section_edges(own.shape, own.points, stations)
    before = np.maximum(np.searchsorted(edges, s, side="left") - 1, 0)
    outboard, levers, turning = _outboard(beam, own, s)
    turns = [function_values(beam, direction, s) / beam.length for direction in ("twist", "bend_y", "bend_z")]
    return LineTables(
        beam, own, s, edges, _interval(beam, edges[:-1], edges[1:]), before, _interval(beam, edges[before], s),
        to_points=beam.length * rule.integrals(rule.points), to_places=beam.length * rule.integrals(s),
        outboard=outboard, levers=levers, turning=turning,
        functions=np.concatenate([*turns, function_values(beam, "stretch", s)]).T,
        stretch=function_values(beam, "stretch", rule.points).T,
    )  # fmt: skip


def _interval(beam: Beam, start: Array, end: Array) -> Interval:
    rest = (end - start)[:, None] * beam.length * np.asarray(beam.rest_curvature, dtype=float)
    return Interval(*interval_integrals(beam, start, end), rest)


def _outboard(beam: Beam, own: BeamTables, s: Array) -> tuple[Array, Array, Array]:
    """Mass, levers and section inertia outboard of each s."""
    g, axes = len(own.points), own.shape.rotary
    mass, levers, turning = np.zeros((len(s), g)), np.zeros((len(s), g, g)), np.zeros((len(s), axes, g))
    start = 0.0
    for piece in beam.pieces:
        low = np.clip(s, start, piece.end)
        at = low[:, None] + (piece.end - low)[:, None] * (1 + _X) / 2
        weight = (piece.end - low)[:, None] * _W / 2 * beam.length
        cardinal = own.rule.cardinal(at)
        density = weight * pieces_at(beam, "mass", at)
        mass += np.einsum("ksm,sm->sk", cardinal, density)
        levers += np.einsum("jsm,ksm,sm->sjk", cardinal, cardinal, density, optimize=True)
        for axis in range(axes):
            turning[:, axis] += np.einsum("ksm,sm->sk", cardinal, weight * pieces_at(beam, f"inertia{axis}", at))
        start = piece.end
    return mass, levers, turning
