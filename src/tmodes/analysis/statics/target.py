"""Where a point of a robot is wanted, and how turned: the whole turn, a direction, or one angle of roll, pitch, yaw."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.schema.axes import rpy_matrix

__all__ = ["Target"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Target:
    """``position`` (3,) [m] and ``rpy`` (3,) [rad] about axes that stay, as in URDF; not a number: free.

    One free angle leaves a direction: an axis ``b`` of the point is to lie along ``a`` of the world. Two leave one
    number: ``a`` and ``b`` include an angle. Either is met by the least turn.
    """

    position: Array
    rpy: Array | None = None

    @cached_property
    def turns(self) -> bool:
        """Whether any angle is wanted."""
        return self.rpy is not None and bool(np.isfinite(self.rpy).any())

    @cached_property
    def rows(self) -> NDArray[np.bool_]:
        """Which of position and turn (6,) are wanted."""
        return np.concatenate([np.isfinite(self.position), np.full(3, self.turns)])

    @cached_property
    def rotation(self) -> Array | None:
        """The wanted axes (3, 3), where all three angles are wanted."""
        return self._turned(np.asarray(self.rpy)) if self.turns and np.isfinite(np.asarray(self.rpy)).all() else None

    def turn(self, rotations: Array) -> tuple[Array, Array]:
        """How far axes (n, 3, 3) are off (n, 3) [rad], and the turns (n, 3, 3) that matter, as projectors."""
        from scipy.spatial.transform import Rotation

        if self.rotation is not None:
            off = Rotation.from_matrix(rotations @ self.rotation.T).as_rotvec()
            return off, np.broadcast_to(np.eye(3), (len(rotations), 3, 3))
        a, b, angle = self._axes
        lying = rotations @ b
        across = np.cross(a, lying)
        sine = np.linalg.norm(across, axis=1, keepdims=True)
        across = np.where(sine > 1e-12, across / np.maximum(sine, 1e-300), np.linalg.svd(lying[:, None])[2][:, 1])
        apart = np.arctan2(sine[:, 0], lying @ a)
        off = (apart - (angle or 0.0))[:, None] * across
        one = across if angle is not None else lying
        outer = one[:, :, None] * one[:, None, :]
        return off, outer if angle is not None else np.eye(3) - outer

    @cached_property
    def _axes(self) -> tuple[Array, Array, float | None]:
        """Axis of the world, axis of the point, and the angle that they include; None: they are to lie alike."""
        given = np.asarray(self.rpy, dtype=float)
        (roll, pitch, yaw), eye, free = given, np.eye(3), np.flatnonzero(np.isnan(given))
        if len(free) == 1:
            base = self._turned(np.nan_to_num(given))
            axis = [base[:, 0], self._turned([0.0, 0.0, np.nan_to_num(yaw)])[:, 1], eye[2]][free[0]]
            return axis, base.T @ axis, None
        if math.isfinite(pitch):
            return eye[2], eye[0], math.pi / 2 + math.asin(math.sin(pitch))
        if math.isfinite(yaw):
            return self._turned([0.0, 0.0, yaw])[:, 1], eye[0], math.pi / 2
        return eye[2], self._turned([-roll, 0.0, 0.0])[:, 1], math.pi / 2

    @staticmethod
    def _turned(rpy: ArrayLike) -> Array:
        return np.asarray(rpy_matrix(*np.asarray(rpy, dtype=float).tolist()), dtype=float)
