"""Frequencies of a bare clamped beam, of any section along it, by the method of Ritz: what a link is by itself."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from tmodes.kinds.links.beam_functions import fine_rule, pieces_at
from tmodes.kinds.links.beam_pieces import BeamNumbers

__all__ = ["BareBeam", "bare_beam"]

Array = NDArray[np.float64]

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


class _Functions(NamedTuple):
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
    return BareBeam(float(np.sum(weight * mass)) * beam.length, about_y, about_z, twist, (give_y, give_z))


def _integrals(s: Array) -> _Functions:
    """Legendre functions of 2 s - 1 at s, their integrals from 0, and the integrals of those."""
    own = [legendre.Legendre.basis(order, domain=[0, 1]) for order in range(FUNCTIONS)]
    once = [function.integ(lbnd=0) for function in own]
    twice = [function.integ(lbnd=0) for function in once]
    return _Functions(*(np.array([function(s) for function in kind]) for kind in (own, once, twice)))


def _first(stiffness: Array, mass: Array) -> float | None:
    from scipy.linalg import eigh

    if not mass.any():
        return None
    largest = float(eigh(mass, stiffness, eigvals_only=True)[-1])
    return float(1 / np.sqrt(largest)) / (2 * np.pi)


def _bending(length: float, functions: _Functions, weight: Array, stiffness: Array, mass: Array) -> float | None:
    if not np.isfinite(stiffness).all():
        return None
    curvature, _, deflection = functions
    return _first(
        (curvature * weight * stiffness) @ curvature.T / length**4, (deflection * weight * mass) @ deflection.T
    )


def _twisting(length: float, functions: _Functions, weight: Array, stiffness: Array, inertia: Array) -> float | None:
    if not (np.isfinite(stiffness) & (stiffness > 0)).all():
        return None
    twist, turn, _ = functions
    return _first((twist * weight * stiffness) @ twist.T / length**2, (turn * weight * inertia) @ turn.T)
