"""A turn about one axis of the frame, applied to vectors, forces and inertias: four numbers, no matrix."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.spatial import Force, Inertia

__all__ = ["Spin"]


@dataclass(frozen=True)
class Spin:
    """Rotation about ``axis`` (0, 1 or 2) by an angle of which cosine, sine, sin^2 and sin cos are given.

    A vector given in the turned axes is ``vector`` in those before; ``back`` goes the other way.
    """

    axis: int
    cosine: Any
    sine: Any
    square: Any
    product: Any

    @classmethod
    def of(cls, axis: int, cosine: Any, sine: Any) -> Spin:
        """From cosine and sine alone."""
        return cls(axis, cosine, sine, sine * sine, sine * cosine)

    @property
    def _plane(self) -> tuple[int, int]:
        return (self.axis + 1) % 3, (self.axis + 2) % 3

    def vector(self, a: v.Vector) -> v.Vector:
        """R a."""
        (i, j), turned = self._plane, list(a)
        turned[i], turned[j] = self.cosine * a[i] - self.sine * a[j], self.sine * a[i] + self.cosine * a[j]
        return turned

    def back(self, a: v.Vector) -> v.Vector:
        """R^T a."""
        (i, j), turned = self._plane, list(a)
        turned[i], turned[j] = self.cosine * a[i] + self.sine * a[j], self.cosine * a[j] - self.sine * a[i]
        return turned

    def back_onto(self, a: v.Vector, sum_: v.Vector) -> v.Vector:
        """R^T a + sum: the sum is taken in at the beginning, and nothing waits for it."""
        (i, j), turned = self._plane, v.add(a, sum_)
        turned[i] = self.sine * a[j] + (self.cosine * a[i] + sum_[i])
        turned[j] = self.cosine * a[j] - (self.sine * a[i] - sum_[j])
        return turned

    def force(self, a: Force) -> Force:
        """Both vectors turned."""
        return Force(self.vector(a.angular), self.vector(a.linear))

    def force_back(self, a: Force) -> Force:
        """Both vectors turned back."""
        return Force(self.back(a.angular), self.back(a.linear))

    def matrix(self, a: v.Matrix, *, is_symmetric: bool = False) -> v.Matrix:
        """R A R^T with the double angle: what leaves one entry of the diagonal enters the other."""
        (i, j), k = self._plane, self.axis
        turned = [list(row) for row in a]
        across, both = a[i][i] - a[j][j], a[i][j] + a[j][i]
        passed = self.square * across + self.product * both
        mixed = self.product * across - self.square * both
        turned[i][i], turned[j][j] = a[i][i] - passed, a[j][j] + passed
        turned[i][j], turned[j][i] = a[i][j] + mixed, a[j][i] + mixed
        turned[i][k] = self.cosine * a[i][k] - self.sine * a[j][k]
        turned[j][k] = self.sine * a[i][k] + self.cosine * a[j][k]
        if is_symmetric:
            turned[k][i], turned[k][j] = turned[i][k], turned[j][k]
        else:
            turned[k][i] = self.cosine * a[k][i] - self.sine * a[k][j]
            turned[k][j] = self.sine * a[k][i] + self.cosine * a[k][j]
        return turned

    def inertia(self, a: Inertia) -> Inertia:
        """All blocks turned."""
        return Inertia(
            self.matrix(a.angular, is_symmetric=True), self.matrix(a.coupling), self.matrix(a.linear, is_symmetric=True)
        )
