"""Numbers of a strain link for its elastic line: steps from section to section, and the mass outboard of a section.

Between the Gauss points of a span every quantity of the moving line is the polynomial through its values there. So the
mass outboard of s weighs the inertia forces f_k at the points with W_k(s) = int_s^1 rhoA l_k, and their levers r_j with
W_jk(s) = int_s^1 rhoA l_j l_k (l_k: 1 at point k, 0 at the others and in other spans). At s = 0 these are the masses of
the model itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.kernel.schedule import Slot
from tmodes.kinds.links.beam_breaks import TURNING, broken_pieces
from tmodes.kinds.links.beam_functions import (
    MODULI,
    SHIFTING,
    function_values,
    interval_integrals,
    piece_rule,
    pieces_at,
)
from tmodes.kinds.links.beam_pieces import BeamNumbers
from tmodes.kinds.links.beam_tables import BeamTables, beam_tables, section_edges
from tmodes.kinds.links.line import LineOfLink, Moved
from tmodes.kinds.links.strain_place_kernels import BeamKernels
from tmodes.kinds.noted.functions import array, clip, isfinite, place
from tmodes.kinds.noted.number import is_noted, plain_value

__all__ = ["BeamLine", "is_ring", "mass_outboard", "place_tables", "stress_numbers"]

Array = NDArray[np.float64]

_ROUND = 1e-9
"""Relative difference of GJ/G and (EI_y + EI_z)/E below which a section is a circle or a ring: no other has it."""


def place_tables(
    beam: BeamNumbers, own: BeamTables, edges: Array, before: NDArray[np.intp], s: Array
) -> dict[str, Array]:
    """Tables of the places ``s`` (S,), each (S, numbers) by the name that the kernel has for it.

    ``edges``: the sections of the model, ``before`` (S,) which of them is next before each place.
    """
    alpha, beta = interval_integrals(beam, edges[before], s)
    rest = (s - edges[before])[:, None] * beam.length * array(beam.rest_curvature)
    mass, levers, turning = mass_outboard(beam, own, s)
    beyond = s + 4 * np.spacing([plain_value(x) for x in s]) if is_noted(s) else np.nextafter(s, 2.0)
    side = np.where(np.diff(s, prepend=-1.0) == 0.0, beyond, s)  # just beyond a body
    turns = [function_values(beam, direction, side) / beam.length for direction in TURNING]
    stiffness = [pieces_at(beam, name, s) for direction, name in MODULI.items() if getattr(beam, direction)]
    return {
        "alpha": alpha, "beta": beta, "rest": rest, "reach": beam.length * own.rule.integrals(s), "outboard": mass,
        "levers": levers[:, *np.triu_indices(len(own.points))], "turning": turning.reshape(len(s), -1),
        "functions": np.concatenate([*turns, *(function_values(beam, name, side) for name in SHIFTING)]).T,
        "stiffness": _finite(np.array(stiffness).reshape(-1, len(s)).T), "stress": stress_numbers(beam, s),
    }  # fmt: skip


def _finite(stiffness: Array) -> Array:
    """Zero where a stiffness is infinite: nothing bends there, and no moment follows from it."""
    return np.where(isfinite(stiffness), stiffness, 0.0)


def mass_outboard(beam: BeamNumbers, own: BeamTables, s: Array) -> tuple[Array, Array, Array]:
    """Mass (S, g) [kg], levers (S, g, g) [kg] and section inertia (S, axes, g) [kg*m^2] outboard of each s."""
    g, axes, (x, w) = len(own.points), own.shape.rotary, piece_rule(beam)
    mass, levers, turning = np.zeros((len(s), g)), np.zeros((len(s), g, g)), np.zeros((len(s), axes, g))
    start = 0.0
    for piece in broken_pieces(beam):
        low = clip(s, start, piece.end)
        at = low[:, None] + (piece.end - low)[:, None] * (1 + x) / 2
        whole = _Outboard(beam.length, at - start, piece.end - start, (piece.end - low)[:, None] * w / 2)
        cardinal = own.rule.cardinal(at)
        mass = mass + whole.sums("ksm,sm->sk", piece.mass, cardinal)
        levers = levers + whole.sums("jsm,ksm,sm->sjk", piece.mass, cardinal, cardinal)
        inertia = [whole.sums("ksm,sm->sk", piece.inertia[axis], cardinal) for axis in range(axes)]
        turning = turning + np.array(inertia).reshape(axes, len(s), g).swapaxes(0, 1)
        start = piece.end
    return mass, levers, turning


@dataclass(frozen=True)
class _Outboard:
    """A rule (S, points) outboard of places on a piece: ``along`` it, of its ``span``; ``weights`` over the length."""

    length: Any
    along: Array
    span: Any
    weights: Array

    def sums(self, letters: str, ends: tuple[Any, Any], *functions: Array) -> Array:
        """Integrals of a quantity, which is linear from end to end, with functions at the points of the rule."""
        first, rise = ends[0], ends[1] - ends[0]
        if not any(map(is_noted, (self.length, *ends, self.weights, *functions))):
            density = self.weights * self.length * (first + rise * self.along / self.span)
            return np.einsum(letters, *functions, density, optimize=len(functions) > 1)
        found = first * np.einsum(letters, *functions, self.weights)  # constants of the rule first
        if is_noted(rise) or rise:
            found = found + rise * np.einsum(letters, *functions, self.weights * self.along / self.span)
        return self.length * found


def is_ring(beam: BeamNumbers) -> bool:
    """Whether the outer fibre of every section is a circle."""
    if beam.outer[0] != beam.outer[1] or not beam.shear > 0:
        return False
    torsion, bend_y, bend_z = (array([getattr(piece, name) for piece in beam.pieces]) for name in (
        "torsion", "bend_y", "bend_z"))  # fmt: skip
    polar, bending = torsion / beam.shear, (bend_y + bend_z) / beam.young
    return bool((abs(polar - bending) <= _ROUND * abs(bending)).all())


def stress_numbers(beam: BeamNumbers, s: Array) -> Array:
    """(S, 10) of :class:`tmodes.kinds.links.line.Stressed`; (S, 0) where section or material are not known."""
    if not (beam.young > 0 and min(beam.outer) > 0):
        return np.zeros((len(s), 0))
    same = np.tile(array([beam.young, beam.shear, *beam.outer]), (len(s), 1))
    stiffness = np.array([pieces_at(beam, name, s) for name in ("torsion", "bend_y", "bend_z", "axial")]).T
    across = np.array([pieces_at(beam, name, s) for name in ("across_y", "across_z")]).T
    return np.concatenate([same, _finite(stiffness), across], axis=1)


@dataclass(frozen=True, eq=False, kw_only=True)
class BeamLine(LineOfLink):
    """Of one beam."""

    beam: BeamNumbers

    @property
    def stressed(self) -> bool:
        """Whether section and material are known."""
        return stress_numbers(self.beam, self.s[:1]).size > 0

    @cached_property
    def _tables(self) -> BeamTables:
        return beam_tables(self.beam, self.stations)

    @cached_property
    def _kernels(self) -> BeamKernels:
        fibre = ("ring" if is_ring(self.beam) else "corner") if self.stressed else ""
        return BeamKernels(self._tables.shape, fibre)

    def places(self, moved: Moved) -> list[Slot]:
        """Sections of the model from root to tip, what its points push, then each place from the section before."""
        own, shape, kernels = self._tables, self._tables.shape, self._kernels
        edges = section_edges(shape, own.points, self.stations)
        before = np.maximum(place(edges, self.s) - 1, 0)
        rotations, states = self._sections(moved)
        pushes = moved.one(kernels.points(), *self._point_blocks(moved, states))
        tables = place_tables(self.beam, own, edges, before, self.s)
        rows = np.concatenate([tables[name] for name, size in kernels.row.items() if size], axis=1)
        link = moved.numbers.block([self.beam.damping_time, *self.beam.rest_curvature])
        kernel, found = kernels.place(), []
        for row, section, first in zip(rows, before, self.borne(), strict=True):
            blocks = (moved.numbers.block(row), link, rotations[section], moved.q, moved.v, pushes, moved.pose)
            found.append(moved.one(kernel, *blocks, moved.outer[first]))
        return found

    def _sections(self, moved: Moved) -> tuple[list[Slot], list[Slot]]:
        """Axes of the root and of all sections, and the sections at the Gauss points."""
        shape, kernels = self._tables.shape, self._kernels
        section = (moved.numbers.block(np.eye(3)), moved.rate, moved.acceleration.part(0, 3))
        motion = tuple(block.part(0, shape.turning) for block in (moved.q, moved.v, moved.a)) if shape.turning else ()
        rotations, points = [section[0]], []
        for k, (kind, _) in enumerate(shape.breaks):
            steps = [moved.tables.part(shape.table_starts[name] + k * size, size)
                     for name, size in kernels.interval.items() if size]  # fmt: skip
            state = moved.one(kernels.step(), *steps, *section, *motion)
            section = (state.part(0, 9), state.part(9, 3), state.part(12, 3))
            rotations.append(section[0])
            points += [state] * (kind == "point")
        return rotations, points

    def _point_blocks(self, moved: Moved, states: list[Slot]) -> list[Slot]:
        own, shape = self._tables, self._tables.shape
        to_points = moved.numbers.block(self.beam.length * own.rule.integrals(own.points))
        shifts = moved.tables.part(shape.table_starts["shifts"], shape.tables["shifts"])
        blocks = [to_points, shifts, *states, moved.q, moved.v, moved.a, moved.acceleration]
        return [block for block in blocks if block.size]
