"""Spatial inertias and forces as lists: [angular; linear] pairs, an inertia in three blocks.

A force or acceleration is a pair of vectors. An inertia maps [angular; linear] acceleration to [moment; force] and is
kept as (A, H, B): [[A, H], [H^T, B]], A and B symmetric. Accelerations are classical: of the point, not of the frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.kinds.kernel import vectors as v

__all__ = ["FORCE", "INERTIA", "Force", "Inertia", "body_bias", "body_inertia", "factor", "forward_substitution"]

INERTIA = 21
"""Numbers of a packed inertia."""

FORCE = 6
"""Numbers of a packed force or acceleration."""


@dataclass
class Force:
    """A moment and a force, or an angular and a linear acceleration."""

    angular: v.Vector
    linear: v.Vector

    @classmethod
    def of(cls, packed: Any, start: int = 0) -> Force:
        """From six numbers."""
        return cls(v.vec(packed, start), v.vec(packed, start + 3))

    @classmethod
    def zero(cls) -> Force:
        """Nothing."""
        return cls(v.zero(), v.zero())

    def packed(self) -> list[Any]:
        """Six numbers."""
        return [*self.angular, *self.linear]

    def __add__(self, other: Force) -> Force:
        return Force(v.add(self.angular, other.angular), v.add(self.linear, other.linear))

    def __sub__(self, other: Force) -> Force:
        return Force(v.sub(self.angular, other.angular), v.sub(self.linear, other.linear))

    def scaled(self, factor: Any) -> Force:
        """Times a number."""
        return Force(v.scale(factor, self.angular), v.scale(factor, self.linear))

    def dot(self, other: Force) -> Any:
        """Power of a force on a motion."""
        return v.dot(self.angular, other.angular) + v.dot(self.linear, other.linear)

    def turned(self, rotation: v.Matrix) -> Force:
        """In other axes."""
        return Force(v.matvec(rotation, self.angular), v.matvec(rotation, self.linear))

    def force_at(self, arm: v.Vector) -> Force:
        """A force that acts at ``arm``, expressed about the origin."""
        return Force(v.add(self.angular, v.cross(arm, self.linear)), self.linear)

    def motion_at(self, arm: v.Vector) -> Force:
        """The acceleration of the point ``arm`` of a body whose origin moves so, centripetal terms aside."""
        return Force(self.angular, v.add(self.linear, v.cross(self.angular, arm)))


@dataclass
class Inertia:
    """[[A, H], [H^T, B]]."""

    angular: v.Matrix
    coupling: v.Matrix
    linear: v.Matrix

    @classmethod
    def of(cls, packed: Any, start: int = 0) -> Inertia:
        """From 21 numbers."""
        return cls(v.symmetric(packed, start), v.tri(packed, start + 6), v.symmetric(packed, start + 15))

    def packed(self) -> list[Any]:
        """The 21 numbers."""
        return [*v.six(self.angular), *v.flat(self.coupling), *v.six(self.linear)]

    def __add__(self, other: Inertia) -> Inertia:
        return Inertia(
            _sum(self.angular, other.angular), _sum(self.coupling, other.coupling), _sum(self.linear, other.linear)
        )

    def times(self, motion: Force) -> Force:
        """The force that a motion needs."""
        return Force(
            v.add(v.matvec(self.angular, motion.angular), v.matvec(self.coupling, motion.linear)),
            v.add(v.matvec(v.transpose(self.coupling), motion.angular), v.matvec(self.linear, motion.linear)),
        )

    def turned(self, rotation: v.Matrix) -> Inertia:
        """In other axes."""
        return Inertia(
            v.turn(rotation, self.angular, is_symmetric=True),
            v.turn(rotation, self.coupling),
            v.turn(rotation, self.linear, is_symmetric=True),
        )

    def at(self, arm: v.Vector) -> Inertia:
        """X^T I X: the inertia of what hangs at ``arm``, expressed about the origin."""
        lever = v.skew(arm)
        coupling = _sum(self.coupling, v.matmul(lever, self.linear))
        # A + r^ H^T - (H + r^ B) r^ = A + r^ H^T + (r^ (H + r^ B)^T)^T, symmetric: only its upper half is needed.
        first = v.matmul(lever, v.transpose(self.coupling))
        second = v.matmul(lever, v.transpose(coupling))
        upper = {(i, j): self.angular[i][j] + first[i][j] + second[j][i] for i in range(3) for j in range(i, 3)}
        angular = [[upper[min(i, j), max(i, j)] for j in range(3)] for i in range(3)]
        return Inertia(angular, coupling, self.linear)

    def less(self, columns: list[Force], divided: list[Force]) -> Inertia:
        """Less the sum of ``columns[k] divided[k]^T``, where that sum is symmetric."""

        def block(matrix: v.Matrix, left: str, right: str, *, half: bool) -> v.Matrix:
            entries = {}
            for i in range(3):
                for j in range(i if half else 0, 3):
                    value = matrix[i][j]
                    for a, b in zip(columns, divided, strict=True):
                        value = value - getattr(a, left)[i] * getattr(b, right)[j]
                    entries[i, j] = value
            return [[entries.get((i, j), entries.get((j, i))) for j in range(3)] for i in range(3)]

        return Inertia(
            block(self.angular, "angular", "angular", half=True),
            block(self.coupling, "angular", "linear", half=False),
            block(self.linear, "linear", "linear", half=True),
        )


def body_inertia(mass: Any, moment: v.Vector, inertia: v.Matrix) -> Inertia:
    """Of a rigid body: mass, first moment m c [kg*m], and inertia about the frame's origin."""
    return Inertia(inertia, v.skew(moment), [[mass if i == j else 0.0 for j in range(3)] for i in range(3)])


def body_bias(moment: v.Vector, inertia: v.Matrix, rate: v.Vector) -> Force:
    """Force [moment; force] that turning at ``rate`` needs without acceleration of the origin.

    W x (I_o W) about the origin, and W x (W x m c).
    """
    return Force(v.cross(rate, v.matvec(inertia, rate)), v.cross(rate, v.cross(rate, moment)))


def _sum(a: v.Matrix, b: v.Matrix) -> v.Matrix:
    return [[a[i][j] + b[i][j] for j in range(3)] for i in range(3)]


def factor(matrix: list[list[Any]]) -> tuple[list[list[Any]], list[Any]]:
    """L (rows below its unit diagonal) and 1/d of a matrix given by its lower triangle: L diag(d) L^T."""
    n = len(matrix)
    lower: list[list[Any]] = [[0.0] * i for i in range(n)]
    share: list[Any] = []
    for i in range(n):
        scaled: list[Any] = []
        for j in range(i):
            value = matrix[i][j]
            for k in range(j):
                value = value - scaled[k] * lower[j][k]
            scaled.append(value)
        lower[i] = [value * share[j] for j, value in enumerate(scaled)]
        pivot = matrix[i][i]
        for j, value in enumerate(scaled):
            pivot = pivot - value * lower[i][j]
        share.append(1 / pivot)
    return lower, share


def forward_substitution(lower: list[list[Any]], right: list[list[Any]]) -> list[list[Any]]:
    """L^-1 times the rows of a right-hand side."""
    result: list[list[Any]] = []
    for i, row in enumerate(right):
        values = list(row)
        for j, factor in enumerate(lower[i]):
            values = [value - factor * other for value, other in zip(values, result[j], strict=True)]
        result.append(values)
    return result
