"""The numbers of a ``strain`` link: its section from root to tip, and how finely it is described."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.links.contract import Body

__all__ = ["BeamNumbers", "BeamPiece"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class BeamPiece:
    """A piece of a beam that ends at s = ``end``; each quantity is (at its start, at its end), linear between.

    Bending stiffness about y and z [N*m^2], torsional GJ [N*m^2], axial EA [N], mass per length [kg/m], and inertia
    per length about x, y and z [kg*m].
    """

    end: float
    bend_y: tuple[float, float]
    bend_z: tuple[float, float]
    torsion: tuple[float, float]
    axial: tuple[float, float]
    mass: tuple[float, float]
    inertia: tuple[tuple[float, float], tuple[float, float], tuple[float, float]] = ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0))


@dataclass(frozen=True, eq=False)
class BeamNumbers:
    """A ``strain`` link: its moments are polynomials, curvature, twist and stretch follow, the line is their integral.

    ``twist``, ``bend_y``, ``bend_z``, ``stretch``: numbers of functions. ``basis`` of bending: ``legendre`` (P_j) or
    ``tip_weighted`` ((1 - s) P_j, for a free end on which no moment acts). ``points``: Gauss points between jumps of
    the section, 0 for the default. ``damping_time`` [s] Kelvin-Voigt. ``rest_curvature`` (3,) [1/m]: twist,
    y, z of the unloaded line. ``bodies``: (s, body) in section axes at s in 0..1. ``outer`` (2,): distance of the
    outer fibre along y and z [m], for stress; ``young`` and ``shear`` modulus [Pa], 0 where not known.
    """

    length: float
    pieces: tuple[BeamPiece, ...]
    twist: int = 0
    bend_y: int = 0
    bend_z: int = 0
    stretch: int = 0
    basis: str = "legendre"
    points: int = 0
    damping_time: float = 0.0
    rest_curvature: Array = field(default_factory=lambda: np.zeros(3))
    bodies: tuple[tuple[float, Body], ...] = ()
    outer: tuple[float, float] = (0.0, 0.0)
    young: float = 0.0
    shear: float = 0.0
