"""An elastic surface that a point of an arm at rest presses: a plane, a ball or a vertical wall."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.loads import Act, Pose, point_index
from tmodes.model.model import Model
from tmodes.sheet.contact import Ball, ContactLaw, ContactSheet, Plane, Wall

__all__ = ["Touch", "surface_act"]

Array = NDArray[np.float64]


class Touch(NamedTuple):
    """Distance of a point from a surface [m], positive in the free; the normal towards the free; its curvature [1/m].

    ``curvature`` is the derivative of the normal by the position, shape (3, 3).
    """

    gap: float
    normal: Array
    curvature: Array


def touch(shape: Plane | Ball | Wall, position: Array) -> Touch:
    """Where a position (3,) [m] is with regard to a surface."""
    if isinstance(shape, Ball):
        away = position - np.array(shape.center)
        distance = float(np.linalg.norm(away)) or 1e-300
        outward, side = away / distance, -1.0 if shape.inside else 1.0
        curvature = (np.eye(3) - np.outer(outward, outward)) / distance
        return Touch(side * (distance - shape.radius), side * outward, side * curvature)
    if isinstance(shape, Wall):
        normal = -np.array([np.cos(shape.heading), np.sin(shape.heading), 0.0])
        return Touch(float(normal @ position) + shape.distance, normal, np.zeros((3, 3)))
    normal = np.array(shape.normal) / np.linalg.norm(shape.normal)
    return Touch(float(normal @ (position - np.array(shape.position))), normal, np.zeros((3, 3)))


@dataclass(frozen=True, eq=False)
class _Surface:
    """Force (preload + stiffness * penetration) along the normal; friction holds nothing at rest.

    Where it acts, the surface moves with the point along the normal: its mass and its damper are then the arm's too.
    """

    point: int
    sheet: ContactSheet

    def _push(self, gap: float) -> tuple[float, float]:
        """Force [N] and its stiffness [N/m]."""
        force = self.sheet.preload - self.sheet.stiffness * gap
        pushes = self.sheet.law == ContactLaw.BILATERAL or (gap <= 0 and force > 0)
        return (force, self.sheet.stiffness) if pushes else (0.0, 0.0)

    def wrench(self, pose: Pose) -> Array:
        found = touch(self.sheet.shape, pose.position)
        return np.concatenate([self._push(found.gap)[0] * found.normal, np.zeros(3)])

    def stiffness(self, pose: Pose) -> Array:
        found = touch(self.sheet.shape, pose.position)
        force, stiffness = self._push(found.gap)
        block = stiffness * np.outer(found.normal, found.normal) - force * found.curvature
        return pose.jacobian[:3].T @ block @ pose.jacobian[:3]

    def carried(self, pose: Pose) -> tuple[Array, Array] | None:
        found = touch(self.sheet.shape, pose.position)
        if not self._push(found.gap)[1]:
            return None
        along = found.normal @ pose.jacobian[:3]
        moved = np.outer(along, along)
        return self.sheet.mass * moved, self.sheet.damping * moved


def surface_act(model: Model, sheet: ContactSheet) -> Act:
    """The surface as an act on its point. Raises :class:`tmodes.errors.InputError` for an unknown point."""
    return _Surface(point_index(model, sheet.point), sheet)
