"""An elastic surface that a point of an arm at rest presses: a plane, a ball or a vertical wall."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.loads import Act, Pose, point_index
from tmodes.equations.loop.contact_law import LawAt, contact_law
from tmodes.kinds.contacts.registry import Contact, Surface
from tmodes.model.model import Model

__all__ = ["Touch", "surface_act"]

Array = NDArray[np.float64]


class Touch(NamedTuple):
    """Distance of a point from a surface [m], positive in the free; the normal towards the free; its curvature [1/m].

    ``curvature`` is the derivative of the normal by the position, shape (3, 3).
    """

    gap: float
    normal: Array
    curvature: Array


def touch(shape: Surface, position: Array) -> Touch:
    """Where a position (3,) [m] is with regard to a surface."""
    numbers, place = shape.numbers(), [float(x) for x in position]
    still = shape.meet(numbers, place, [0.0, 0.0, 0.0])
    # The second derivative of the penetration along a velocity is a quadratic form of it: the surface's curvature.
    along = [[float(shape.meet(numbers, place, list(a + b)).curving) for b in np.eye(3)] for a in np.eye(3)]
    own = [along[i][i] / 4 for i in range(3)]
    bent = np.array([[(along[i][j] - own[i] - own[j]) / 2 for j in range(3)] for i in range(3)])
    return Touch(-float(still.depth), -np.array(still.direction, dtype=float), -bent)


@dataclass(frozen=True, eq=False)
class _Surface:
    """Normal force of the law at rest; friction holds nothing there.

    Where it acts, the surface moves with the point along the normal: its mass and its damper are then the robot's too.
    """

    point: int
    sheet: Contact

    @cached_property
    def _law(self) -> Callable[[float, float], LawAt]:
        return contact_law(self.sheet)

    def wrench(self, pose: Pose) -> Array:
        found = touch(self.sheet.shape, pose.position)
        return np.concatenate([self._law(-found.gap, 0.0).force * found.normal, np.zeros(3)])

    def stiffness(self, pose: Pose) -> Array:
        found = touch(self.sheet.shape, pose.position)
        law = self._law(-found.gap, 0.0)
        block = law.stiffness * np.outer(found.normal, found.normal) - law.force * found.curvature
        return pose.jacobian[:3].T @ block @ pose.jacobian[:3]

    def carried(self, pose: Pose) -> tuple[Array, Array] | None:
        found = touch(self.sheet.shape, pose.position)
        law = self._law(-found.gap, 0.0)
        if self.sheet.unilateral and not law.force:
            return None
        along = found.normal @ pose.jacobian[:3]
        moved = np.outer(along, along)
        return self.sheet.moving_mass * moved, law.damping * moved


def surface_act(model: Model, sheet: Contact) -> Act:
    """The surface as an act on its point. Raises :class:`tmodes.errors.InputError` for an unknown point."""
    return _Surface(point_index(model, sheet.point), sheet)
