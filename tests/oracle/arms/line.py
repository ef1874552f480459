"""The elastic line of a Beam, discrete: Gauss points, fourth-order Magnus steps, tangents integrated spectrally.

Curvature (twist, y, z) = rest + (1/L) sum_j b_j(s) q_j, stretch or shear = sum_j b_j(s) q_j, s in 0..1; each b_j is a
polynomial over the relative stiffness of the section, or the part of 1 or of (1 - s/a) inboard of a body at a: in
bending the second, and the first too where the body resists turning; in twist the first of such a body; in stretch and
shear the first. The beam is divided where a stiffness jumps by more than 5 % and at bodies inside; in
each span the Gauss points are those of the beam's own mass per length, and the tangents' polynomial is one of its own.
A section at a body or a named point ends a Magnus step too. Written from that definition: every number comes from
NumPy's polynomials, none from the package.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import casadi as ca
import numpy as np
from numpy.polynomial import Legendre, Polynomial
from numpy.typing import NDArray

from oracle.arms.rotation import exponential
from tmodes.kinds.links.strain import Beam

__all__ = ["DIRECTIONS", "Line", "Station", "basis", "counts", "gauss", "names_of"]

DIRECTIONS = ("twist", "bend_y", "bend_z", "stretch", "shear_y", "shear_z")
MODULI = ("torsion", "bend_y", "bend_z", "axial", "shear_y", "shear_z")

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Station:
    """A section: place (3,) and axes (3, 3) in the link frame, with its mass [kg] and inertia (3,) [kg*m^2]."""

    place: Any
    axes: Any
    mass: float
    inertia: tuple[float, float, float]


def counts(beam: Beam) -> tuple[int, ...]:
    """Numbers of functions of each direction."""
    return tuple(getattr(beam, direction) + len(broken(beam, direction)) for direction in DIRECTIONS)


def names_of(beam: Beam) -> list[str]:
    """Names of its coordinates: polynomials from 1 on, functions of bodies from 101 on."""
    numbers = [
        (direction, number)
        for direction, count in zip(DIRECTIONS, counts(beam), strict=True)
        for number in [*range(1, getattr(beam, direction) + 1), *range(101, 101 + count - getattr(beam, direction))]
    ]
    return [f"{direction}{number}" for direction, number in numbers]


def inside(beam: Beam) -> list[float]:
    """Places of bodies between root and tip."""
    return sorted({s for s, _ in beam.bodies if 0 < s < 1})


def broken(beam: Beam, direction: str) -> list[tuple[float, int]]:
    """Place and degree of the functions that end at a body."""
    found = []
    for place in inside(beam) if getattr(beam, direction) else ():
        turns = any(np.any(body.center) or np.any(body.inertia) for s, body in beam.bodies if s == place)
        found += [(place, 1)] if "bend" in direction else []
        found += [(place, 0)] if turns or direction not in DIRECTIONS[:3] else []
    return found


def basis(beam: Beam, direction: str) -> list[Callable[[Array], Array]]:
    """The functions of a direction, at s in 0..1 of one piece (two pieces meet: the outer one)."""
    window = Polynomial([1.0, -1.0]) if beam.basis == "tip_weighted" and "bend" in direction else Polynomial([1.0])
    number = getattr(beam, direction)
    shifted = [Legendre.basis(j, domain=[0, 1]).convert(kind=Polynomial, domain=[-1, 1]) for j in range(number)]
    own = [lambda s, f=window * function: f(s) for function in shifted]
    own += [
        lambda s, a=a, degree=degree: np.where(s < a, (1 - s / a) ** degree, 0.0)
        for a, degree in broken(beam, direction)
    ]
    sums = orthonormal(beam, direction, own) if len(own) > number else np.eye(number)
    return [
        lambda s, row=row: softness(beam, direction, s) * sum(x * f(s) for x, f in zip(row, own, strict=True))
        for row in sums
    ]


def orthonormal(beam: Beam, direction: str, functions: list[Callable[[Array], Array]]) -> Array:
    """Rows of sums: the polynomials as they are, then what bodies add, orthonormal under the elastic energy."""
    s, w, _ = fine(beam)
    values = np.array([function(s) for function in functions]) * np.sqrt(w * softness(beam, direction, s))
    _, right = np.linalg.qr(values.T)
    sums = np.linalg.inv(right * np.sign(np.diag(right))[:, None]).T
    number = getattr(beam, direction)
    sums[:number] = np.eye(len(sums))[:number]
    return sums


def softness(beam: Beam, direction: str, s: Array) -> Array:
    """1/EI over its mean along the beam; 1 where there is no stiffness to speak of."""
    name = MODULI[DIRECTIONS.index(direction)]
    if min(min(getattr(piece, name)) for piece in beam.pieces) <= 0:
        return np.ones_like(s)
    _, w, _ = fine(beam)
    ends = [0.0, *(piece.end for piece in beam.pieces)]
    own = np.zeros_like(s)
    for piece, start in zip(beam.pieces, ends, strict=False):
        low, high = getattr(piece, name)
        own = np.where(s >= start, low + (high - low) * (s - start) / (piece.end - start), own)
    return 1 / (own * (w @ (1 / along(beam, name))))


def gauss(number: int, start: float = 0.0, end: float = 1.0) -> tuple[Array, Array]:
    """Gauss points and weights on start..end."""
    x, w = np.polynomial.legendre.leggauss(number)
    return start + (x + 1) / 2 * (end - start), w / 2 * (end - start)


def fine(beam: Beam) -> tuple[Array, Array, list[tuple[float, int]]]:
    """A fine rule over all pieces: points, weights (sum 1), and for each point its share of its piece and which."""
    points, weights, where, start = [], [], [], 0.0
    for index, piece in enumerate(beam.pieces):
        cuts = [start, *(place for place in inside(beam) if start < place < piece.end), piece.end]
        for part in pairwise(cuts):
            s, w = gauss(30, *part)
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


def spans(beam: Beam) -> list[tuple[float, float]]:
    """The parts of the beam between bodies and jumps of a stiffness that it answers with."""
    names = [name for name, number in zip(MODULI, counts(beam), strict=True) if number]
    cuts = [0.0]
    for inner, outer in pairwise(beam.pieces):
        steps = [sorted((getattr(inner, name)[1], getattr(outer, name)[0])) for name in names]
        cuts += [inner.end] if any(low < 0.95 * high for low, high in steps) else []
    return list(pairwise(sorted({*cuts, *inside(beam), 1.0})))


def mass_points(beam: Beam) -> list[Array]:
    """Gauss points of each span under the mass per length: eigenvalues of "times s" among the polynomials."""
    parts = spans(beam)
    number = beam.points or max(getattr(beam, direction) for direction in DIRECTIONS) + (2 if len(parts) == 1 else 1)
    s, w, _ = fine(beam)
    found = []
    for start, end in parts:
        root = np.sqrt(w * along(beam, "mass")) * ((start < s) & (s < end))
        orthonormal, _ = np.linalg.qr(root[:, None] * np.polynomial.legendre.legvander(2 * s - 1, number - 1))
        found.append(np.asarray(np.linalg.eigvalsh(orthonormal.T @ (s[:, None] * orthonormal)), np.float64))
    return found


def cardinal(nodes: Array, s: Array) -> Array:
    """Values (nodes, s) of the polynomials that are 1 at one node and 0 at the others."""
    factors = [[(s - other) / (node - other) for other in nodes if other != node] for node in nodes]
    return np.array([np.prod([np.ones_like(s), *factor], axis=0) for factor in factors])


class Line:
    """The line of one beam with coordinates ``q`` (by direction, each in rising order).

    ``asked``: places s < 1 whose sections are given in addition to those of the beam's bodies.
    """

    def __init__(self, beam: Beam, q: Any, asked: tuple[float, ...] = ()):
        self.beam, self.q, self.groups = beam, q, mass_points(beam)
        self.points = np.concatenate(self.groups)
        places = {s for s, _ in beam.bodies} | set(asked) | {1.0}
        self._frames: dict[float, Any] = {0.0: ca.SX.eye(3)}
        for s in sorted({float(s) for s in self.points} | places):
            self._walk(s)
        self._tangents = [self._frames[float(s)] @ self.strain(float(s)) for s in self.points]
        self.stations = self._stations()
        self.tip = self.at(1.0)

    def strain(self, s: float) -> Any:
        """1 + stretch, shear along y and along z at s (3,)."""
        total, first = ca.SX([1, 0, 0]), sum(counts(self.beam)[:3])
        for axis, direction in enumerate(DIRECTIONS[3:]):
            for function in basis(self.beam, direction):
                total[axis] += float(function(np.array(s))) * self.q[first]
                first += 1
        return total

    def _walk(self, s: float) -> None:
        """One Magnus step from the last section to s."""
        last = max(self._frames)
        if s > last:
            self._frames[s] = self._frames[last] @ exponential(self._turn(last, s))

    def _turn(self, start: float, end: float) -> Any:
        """Rotation vector of the interval: a + a x b of the curvature's mean and its first moment."""
        cuts = [start, *(piece.end for piece in self.beam.pieces if start < piece.end < end), end]
        x, w = (np.concatenate(part) for part in zip(*(gauss(20, *part) for part in pairwise(cuts)), strict=True))
        moment = (x - (start + end) / 2) / (end - start)
        a = ca.SX(np.asarray(self.beam.rest_curvature, float) * self.beam.length * (end - start))
        b, first = ca.SX.zeros(3), 0
        for axis, direction in enumerate(DIRECTIONS[:3]):
            for j, function in enumerate(basis(self.beam, direction)):
                a[axis] += float(w @ function(x)) * self.q[first + j]
                b[axis] += float(w @ (function(x) * moment)) * self.q[first + j]
            first += counts(self.beam)[axis]
        return a + ca.cross(a, b)

    def _stations(self) -> list[Station]:
        """The Gauss points' sections: each quantity's integral with the polynomial that is 1 at the point."""
        s, w, _ = fine(self.beam)
        rows = [
            cardinal(group, s) * ((start < s) & (s < end))
            for group, (start, end) in zip(self.groups, spans(self.beam), strict=True)
        ]
        shares = self.beam.length * w * np.concatenate(rows)
        mass = shares @ along(self.beam, "mass")
        inertia = np.array([shares @ along(self.beam, "inertia", axis) for axis in range(3)])
        return [
            Station(*self.at(float(place)), float(mass[i]), (inertia[0, i], inertia[1, i], inertia[2, i]))
            for i, place in enumerate(self.points)
        ]

    def at(self, s: float) -> tuple[Any, Any]:
        """Place (3,) and axes (3, 3) of the section at s: the tangents' polynomials integrated from 0 to s."""
        rows = []
        for group, (start, end) in zip(self.groups, spans(self.beam), strict=True):
            x, w = gauss(len(group) + 1, start, min(max(s, start), end))
            rows.append(self.beam.length * cardinal(group, x) @ w)
        weights = np.concatenate(rows)
        return sum(float(r) * t for r, t in zip(weights, self._tangents, strict=True)), self._frames[s]

    def stiffness(self) -> list[Array]:
        """Stiffness matrices of all directions [N*m], by a fine quadrature."""
        s, w, _ = fine(self.beam)
        matrices = []
        for direction, name in zip(DIRECTIONS, MODULI, strict=True):
            scale = 1 / self.beam.length if direction in DIRECTIONS[:3] else self.beam.length
            values = np.array([f(s) for f in basis(self.beam, direction)]).reshape(-1, len(s))
            matrices.append(scale * (values * w * along(self.beam, name)) @ values.T)
        return matrices
