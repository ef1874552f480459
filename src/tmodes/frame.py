"""Where a frame is, and which way it looks."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Placement", "along"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Placement:
    """Where a frame is and which way it looks: ``rotation`` (3, 3), columns = its axes; ``position`` (3,) [m]."""

    rotation: Array = field(default_factory=lambda: np.eye(3))
    position: Array = field(default_factory=lambda: np.zeros(3))

    def __matmul__(self, other: Placement) -> Placement:
        """The placement of a frame that is given in this one."""
        return Placement(self.rotation @ other.rotation, self.rotation @ other.position + self.position)

    def inverse(self) -> Placement:
        """The frame that this one is given in, as seen from this one."""
        return Placement(self.rotation.T, -self.rotation.T @ self.position)


def along(parts: ArrayLike) -> Array:
    """Components (..., k) of parts (..., k, 3) along their sum, which add up to its length; 0 where it is zero."""
    parts = np.asarray(parts, dtype=float)
    total = parts.sum(axis=-2)
    size = np.linalg.norm(total, axis=-1, keepdims=True)
    unit = np.divide(total, size, out=np.zeros_like(total), where=size > 0)
    return np.einsum("...ki,...i->...k", parts, unit)
