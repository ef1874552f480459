"""The elastic line of a Beam, discrete: Gauss points, fourth-order Magnus steps, tangents integrated spectrally.

Curvature (twist, y, z) = rest + (1/L) sum_j b_j(s) q_j, stretch = sum_j P_j(s) q_j, s in 0..1. The Gauss points are
those of the beam's own mass per length; a section at a body or a named point ends a Magnus step too. Written from
that definition: every number comes from NumPy's polynomials, none from the package.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.polynomial import Legendre, Polynomial
from numpy.typing import NDArray

from arm.oracle.rotation import exponential
from tmodes.chain import Beam

__all__ = ["DIRECTIONS", "Line", "Station", "basis", "counts", "gauss"]

DIRECTIONS = ("twist", "bend_y", "bend_z", "stretch")
MODULI = ("torsion", "bend_y", "bend_z", "axial")

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Station:
    """A section: place (3,) and axes (3, 3) in the link frame, with its mass [kg] and inertia (3,) [kg*m^2]."""

    place: Any
    axes: Any
    mass: float
    inertia: tuple[float, float, float]


def counts(beam: Beam) -> tuple[int, int, int, int]:
    """Numbers of functions: twist, bending about y, about z, stretch."""
    return beam.twist, beam.bend_y, beam.bend_z, beam.stretch


def basis(beam: Beam, number: int) -> list[Polynomial]:
    """The first functions of a direction as polynomials of s in 0..1."""
    window = Polynomial([1.0, -1.0]) if beam.basis == "tip_weighted" else Polynomial([1.0])
    shifted = [Legendre.basis(j, domain=[0, 1]).convert(kind=Polynomial, domain=[-1, 1]) for j in range(number)]
    return [window * function for function in shifted]


def gauss(number: int, start: float = 0.0, end: float = 1.0) -> tuple[Array, Array]:
    """Gauss points and weights on start..end."""
    x, w = np.polynomial.legendre.leggauss(number)
    return start + (x + 1) / 2 * (end - start), w / 2 * (end - start)


def fine(beam: Beam) -> tuple[Array, Array, list[tuple[float, int]]]:
    """A fine rule over all pieces: points, weights (sum 1), and for each point its share of its piece and which."""
    points, weights, where, start = [], [], [], 0.0
    for index, piece in enumerate(beam.pieces):
        s, w = gauss(30, start, piece.end)
        points.append(s)
        weights.append(w)
        where += [(float(share), index) for share in (s - start) / (piece.end - start)]
        start = piece.end
    return np.concatenate(points), np.concatenate(weights), where


def along(beam: Beam, quantity: str, axis: int | None = None) -> Array:
    """Values of a quantity of the pieces at the points of the fine rule."""

    def at(share: float, index: int) -> float:
        ends = getattr(beam.pieces[index], quantity)
        low, high = ends if axis is None else ends[axis]
        return (1 - share) * low + share * high

    return np.array([at(*place) for place in fine(beam)[2]])


def mass_points(beam: Beam) -> Array:
    """Gauss points (g,) under the mass per length: eigenvalues of "times s" among the polynomials of degree < g."""
    number = beam.points or max(counts(beam)) + 2
    s, w, _ = fine(beam)
    root = np.sqrt(w * along(beam, "mass"))
    orthonormal, _ = np.linalg.qr(root[:, None] * np.polynomial.legendre.legvander(2 * s - 1, number - 1))
    return np.asarray(np.linalg.eigvalsh(orthonormal.T @ (s[:, None] * orthonormal)), np.float64)


def cardinal(nodes: Array, s: Array) -> Array:
    """Values (nodes, s) of the polynomials that are 1 at one node and 0 at the others."""
    factors = [[(s - other) / (node - other) for other in nodes if other != node] for node in nodes]
    return np.array([np.prod([np.ones_like(s), *factor], axis=0) for factor in factors])


class Line:
    """The line of one beam with coordinates ``q`` (twist, bend y, bend z, stretch; each in rising order).

    ``asked``: places s < 1 whose sections are told besides those of the beam's bodies.
    """

    def __init__(self, beam: Beam, q: Any, asked: tuple[float, ...] = ()):
        self.beam, self.q, self.points = beam, q, mass_points(beam)
        places = {s for s, _ in beam.bodies} | set(asked) | {1.0}
        self._frames: dict[float, Any] = {0.0: ca.SX.eye(3)}
        for s in sorted({float(s) for s in self.points} | places):
            self._walk(s)
        self._tangents = [self.strain(float(s)) * self._frames[float(s)][:, 0] for s in self.points]
        self.stations = self._stations()
        self.tip = self.at(1.0)

    def strain(self, s: float) -> float | Any:
        """1 + stretch at s."""
        first = sum(counts(self.beam)[:3])
        functions = [Legendre.basis(j, domain=[0, 1]) for j in range(self.beam.stretch)]
        return 1 + sum(float(f(s)) * self.q[first + j] for j, f in enumerate(functions))

    def _walk(self, s: float) -> None:
        """One Magnus step from the last section to s."""
        last = max(self._frames)
        if s > last:
            self._frames[s] = self._frames[last] @ exponential(self._turn(last, s))

    def _turn(self, start: float, end: float) -> Any:
        """Rotation vector of the interval: a + a x b of the curvature's mean and its first moment."""
        x, w = gauss(12, start, end)
        moment = (x - (start + end) / 2) / (end - start)
        a = ca.SX(np.asarray(self.beam.rest_curvature, float) * self.beam.length * (end - start))
        b, first = ca.SX.zeros(3), 0
        for axis, number in enumerate(counts(self.beam)[:3]):
            for j, function in enumerate(basis(self.beam, number)):
                a[axis] += float(w @ function(x)) * self.q[first + j]
                b[axis] += float(w @ (function(x) * moment)) * self.q[first + j]
            first += number
        return a + ca.cross(a, b)

    def _stations(self) -> list[Station]:
        """The Gauss points' sections: each quantity's integral with the polynomial that is 1 at the point."""
        s, w, _ = fine(self.beam)
        shares = self.beam.length * w * cardinal(self.points, s)
        mass = shares @ along(self.beam, "mass")
        inertia = np.array([shares @ along(self.beam, "inertia", axis) for axis in range(3)])
        return [
            Station(*self.at(float(place)), float(mass[i]), (inertia[0, i], inertia[1, i], inertia[2, i]))
            for i, place in enumerate(self.points)
        ]

    def at(self, s: float) -> tuple[Any, Any]:
        """Place (3,) and axes (3, 3) of the section at s: the tangents' polynomial integrated from 0 to s."""
        x, w = gauss(len(self.points) + 1, 0.0, s)
        row = self.beam.length * cardinal(self.points, x) @ w
        return sum(float(r) * t for r, t in zip(row, self._tangents, strict=True)), self._frames[s]

    def stiffness(self) -> list[Array]:
        """Stiffness matrices of twist, bending about y, about z [N*m] and stretch [N*m], by a fine quadrature."""
        s, w, _ = fine(self.beam)
        matrices = []
        for number, name in zip(counts(self.beam), MODULI, strict=True):
            straight = [Legendre.basis(j, domain=[0, 1]) for j in range(number)]
            functions = straight if name == "axial" else basis(self.beam, number)
            scale = self.beam.length if name == "axial" else 1 / self.beam.length
            values = np.array([f(s) for f in functions]).reshape(number, len(s))
            matrices.append(scale * (values * w * along(self.beam, name)) @ values.T)
        return matrices
