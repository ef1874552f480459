"""Numbers of a strain link, computed once: quadrature, integrals of its functions, stiffness.

All positions are s = x/length in 0..1 of the unloaded line.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.links.beam_functions import (
    MODULI,
    function_values,
    interval_integrals,
    is_uniform,
    stiffness_matrix,
)
from tmodes.kinds.links.beam_pieces import BeamNumbers
from tmodes.kinds.links.beam_rule import Rule, beam_rule
from tmodes.kinds.links.strain_shape import StrainShape

__all__ = ["BeamTables", "beam_tables", "section_edges"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class BeamTables:
    """Packed tables of a strain link; ``rule``: where its mass is."""

    shape: StrainShape
    packed: Array
    stiffness: Array
    damping: Array
    rule: Rule

    @property
    def points(self) -> Array:
        """The Gauss points (g,)."""
        return self.rule.points


def _shape(beam: BeamNumbers, rule: Rule, stations: tuple[float, ...]) -> StrainShape:
    before = tuple(int(np.searchsorted(rule.points, s, side="right")) for s in stations)
    inertia = [any(max(piece.inertia[axis]) > 0 for piece in beam.pieces) for axis in range(3)]
    return StrainShape(
        beam.twist, beam.bend_y, beam.bend_z, beam.stretch, len(rule.points), before,
        rotary=3 if inertia[1] or inertia[2] else 1 if inertia[0] else 0,
        curved=bool(np.any(beam.rest_curvature)),
        full=beam.basis != "legendre" or not all(is_uniform(beam, name) for name in MODULI if getattr(beam, name)),
    )  # fmt: skip


def section_edges(shape: StrainShape, points: Array, stations: tuple[float, ...]) -> Array:
    """Root, then every section of the model from root to tip: Gauss points, stations, tip."""
    places = {"point": points, "station": np.array(stations), "tip": np.ones(1)}
    return np.array([0.0, *(places[kind][k] for kind, k in shape.breaks)])


def beam_tables(beam: BeamNumbers, stations: tuple[float, ...] = ()) -> BeamTables:
    """All tables of a beam with the sections at ``stations``."""
    rule = beam_rule(beam)
    shape = _shape(beam, rule, stations)
    edges = section_edges(shape, rule.points, stations)
    to_point = beam.length * rule.integrals(rule.points)
    alpha, beta = interval_integrals(beam, edges[:-1], edges[1:])
    rest = np.diff(edges)[:, None] * beam.length * np.asarray(beam.rest_curvature)
    tables = {
        "alpha": alpha,
        "beta": beta if shape.planar is None else np.empty(0),
        "rest": rest if shape.curved else np.empty(0),
        "root_mass": _root_mass(to_point, rule.masses),
        "first_moment": rule.masses @ to_point,
        "mass": np.array([rule.masses.sum()]),
        "to_tip": beam.length * rule.integrals(np.ones(1)),
        "stretch": function_values(beam, "stretch", rule.points).T,
        "rotary": np.array([rule.rotary(beam, axis) for axis in range(shape.rotary)]).T,
        "to_station": beam.length * rule.integrals(np.array(stations)),
    }
    packed = np.concatenate([tables[name].ravel() for name in shape.tables])
    stiffness = _stiffness(beam, shape)
    return BeamTables(shape, packed, stiffness, beam.damping_time * stiffness, rule)


def _root_mass(to_point: Array, masses: Array) -> Array:
    """Rows of the upper triangle R with R^T R = A^T m A, A the integrals to the points; a massless span is allowed."""
    root = np.linalg.qr(np.sqrt(masses)[:, None] * to_point, mode="r")
    return np.asarray(root, dtype=np.float64)[np.triu_indices(len(masses))]


def _stiffness(beam: BeamNumbers, shape: StrainShape) -> Array:
    """The stiffness matrices by direction: diagonals, or lower triangles row by row [N*m]."""
    matrices = [stiffness_matrix(beam, name) for name in MODULI if getattr(beam, name)]
    entries = [matrix[np.tril_indices(len(matrix))] if shape.full else np.diag(matrix) for matrix in matrices]
    return np.concatenate(entries) if entries else np.empty(0)
