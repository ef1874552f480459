"""Frequencies of a bare clamped beam, of any section along it, by the method of Ritz: what a link is by itself."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from tmodes.chain import Beam

__all__ = ["BareBeam", "bare_beam"]

Array = NDArray[np.float64]

FUNCTIONS = 10
"""Legendre functions of curvature or twist: the first frequency of a uniform beam is exact to 1e-12."""

_RULE = 24


class BareBeam(NamedTuple):
    """First frequencies [Hz] of a beam clamped at its root, nothing at its end; None where it is rigid or massless.

    ``mass`` [kg]; ``compliance``: integral (1 - s)^2/EI ds times L^3 of bending about y and z [m/N], tip force at tip.
    """

    mass: float
    bend_y_Hz: float | None
    bend_z_Hz: float | None
    twist_Hz: float | None
    compliance: tuple[float, float]


def bare_beam(beam: Beam) -> BareBeam:
    """The beam by itself, without section inertia in bending (Euler and Bernoulli)."""
    s, weight, numbers = _rule(beam)
    mass, polar = numbers["mass"], numbers["inertia"]
    about_y, about_z = (_bending(beam.length, s, weight, numbers[name], mass) for name in ("bend_y", "bend_z"))
    give_y, give_z = (
        float(np.sum(weight * (1 - s) ** 2 / numbers[name])) * beam.length**3 for name in ("bend_y", "bend_z")
    )
    twist = _twisting(beam.length, s, weight, numbers["torsion"], polar)
    return BareBeam(float(np.sum(weight * mass)) * beam.length, about_y, about_z, twist, (give_y, give_z))


def _rule(beam: Beam) -> tuple[Array, Array, dict[str, Array]]:
    """Quadrature over all pieces, and the numbers of the section there."""
    x, w = legendre.leggauss(_RULE)
    places, weights, rows, start = [], [], [], 0.0
    for piece in beam.pieces:
        share, width = (1 + x) / 2, piece.end - start
        ends = {name: getattr(piece, name) for name in ("bend_y", "bend_z", "torsion", "mass")}
        ends["inertia"] = piece.inertia[0]
        rows.append({name: a + (b - a) * share if a != b else np.full(_RULE, a) for name, (a, b) in ends.items()})
        places.append(start + width * share)
        weights.append(width * w / 2)
        start = piece.end
    numbers = {name: np.concatenate([row[name] for row in rows]) for name in rows[0]}
    return np.concatenate(places), np.concatenate(weights), numbers


def _integrals(s: Array) -> tuple[list[Array], list[Array], list[Array]]:
    """Legendre functions of 2 s - 1 at s, their integrals from 0, and the integrals of those."""
    tables: tuple[list[Array], list[Array], list[Array]] = ([], [], [])
    for order in range(FUNCTIONS):
        own = legendre.Legendre.basis(order, domain=[0, 1])
        once = own.integ(lbnd=0)
        for table, function in zip(tables, (own, once, once.integ(lbnd=0)), strict=True):
            table.append(np.asarray(function(s)))
    return tables


def _first(stiffness: Array, mass: Array) -> float | None:
    from scipy.linalg import eigh

    if not mass.any():
        return None
    largest = float(eigh(mass, stiffness, eigvals_only=True)[-1])
    return float(1 / np.sqrt(largest)) / (2 * np.pi)


def _bending(length: float, s: Array, weight: Array, stiffness: Array, mass: Array) -> float | None:
    if not np.isfinite(stiffness).all():
        return None
    curvature, _, deflection = (np.array(table) for table in _integrals(s))
    return _first(
        (curvature * weight * stiffness) @ curvature.T / length**4, (deflection * weight * mass) @ deflection.T
    )


def _twisting(length: float, s: Array, weight: Array, stiffness: Array, inertia: Array) -> float | None:
    if not (np.isfinite(stiffness) & (stiffness > 0)).all():
        return None
    twist, turn, _ = (np.array(table) for table in _integrals(s))
    return _first((twist * weight * stiffness) @ twist.T / length**2, (turn * weight * inertia) @ turn.T)
