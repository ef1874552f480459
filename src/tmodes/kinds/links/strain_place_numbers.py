"""Numbers of a strain link for its elastic line: steps from section to section, and the mass outboard of a section.

Between the Gauss points of a span every quantity of the moving line is the polynomial through its values there. So the
mass outboard of s weighs the inertia forces f_k at the points with W_k(s) = int_s^1 rhoA l_k, and their levers r_j with
W_jk(s) = int_s^1 rhoA l_j l_k (l_k: 1 at point k, 0 at the others and in other spans). At s = 0 these are the masses of
the model itself.
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from tmodes.kinds.links.beam_functions import function_values, interval_integrals, pieces_at
from tmodes.kinds.links.beam_numbers import BeamNumbers
from tmodes.kinds.links.beam_tables import BeamTables

__all__ = ["STIFFNESS", "is_ring", "mass_outboard", "place_tables", "stress_numbers"]

Array = NDArray[np.float64]

STIFFNESS = {"torsion": "twist", "bend_y": "bend_y", "bend_z": "bend_z", "axial": "stretch"}
"""Stiffnesses of a section, and the functions of a beam that work against each."""

_X, _W = legendre.leggauss(24)
"""A rule that is exact for every product of polynomials that is met here."""

_ROUND = 1e-9
"""Relative difference of GJ/G and (EI_y + EI_z)/E below which a section is a circle or a ring: no other has it."""


def place_tables(
    beam: BeamNumbers, own: BeamTables, edges: Array, before: NDArray[np.intp], s: Array
) -> dict[str, Array]:
    """Tables of the places ``s`` (S,), each (S, numbers) by the name that the kernel has for it.

    ``edges``: the sections of the model, ``before`` (S,) which of them is next before each place.
    """
    alpha, beta = interval_integrals(beam, edges[before], s)
    rest = (s - edges[before])[:, None] * beam.length * np.asarray(beam.rest_curvature, dtype=float)
    mass, levers, turning = mass_outboard(beam, own, s)
    turns = [function_values(beam, direction, s) / beam.length for direction in ("twist", "bend_y", "bend_z")]
    stiffness = [pieces_at(beam, name, s) for name, count in STIFFNESS.items() if getattr(beam, count)]
    return {
        "alpha": alpha, "beta": beta, "rest": rest, "reach": beam.length * own.rule.integrals(s), "outboard": mass,
        "levers": levers[:, *np.triu_indices(len(own.points))], "turning": turning.reshape(len(s), -1),
        "functions": np.concatenate([*turns, function_values(beam, "stretch", s)]).T,
        "stiffness": _finite(np.array(stiffness).reshape(-1, len(s)).T), "stress": stress_numbers(beam, s),
    }  # fmt: skip


def _finite(stiffness: Array) -> Array:
    """Zero where a stiffness is infinite: nothing bends there, and no moment follows from it."""
    return np.where(np.isfinite(stiffness), stiffness, 0.0)


def mass_outboard(beam: BeamNumbers, own: BeamTables, s: Array) -> tuple[Array, Array, Array]:
    """Mass (S, g) [kg], levers (S, g, g) [kg] and section inertia (S, axes, g) [kg*m^2] outboard of each s."""
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


def is_ring(beam: BeamNumbers) -> bool:
    """Whether the outer fibre of every section is a circle."""
    if beam.outer[0] != beam.outer[1] or not beam.shear > 0:
        return False
    torsion, bend_y, bend_z = (np.array([getattr(piece, name) for piece in beam.pieces]) for name in (
        "torsion", "bend_y", "bend_z"))  # fmt: skip
    return bool(np.allclose(torsion / beam.shear, (bend_y + bend_z) / beam.young, rtol=_ROUND, atol=0))


def stress_numbers(beam: BeamNumbers, s: Array) -> Array:
    """(S, 8) of :class:`tmodes.kinds.links.line_place.Stressed`; (S, 0) where section or material are not known."""
    if not (beam.young > 0 and min(beam.outer) > 0):
        return np.zeros((len(s), 0))
    same = np.tile([beam.young, beam.shear, *beam.outer], (len(s), 1))
    stiffness = np.array([pieces_at(beam, name, s) for name in STIFFNESS]).T
    return np.concatenate([same, _finite(stiffness)], axis=1)
