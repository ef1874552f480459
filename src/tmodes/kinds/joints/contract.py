"""What a kind of joint says of itself: its coordinates, where it places the link it carries, how it is drawn.

``place`` is all that must be written. The motion that the joint allows and its bias are found by differentiation; a
kind may state both itself. Formulas use sums, products, quotients and :mod:`tmodes.kinds.kernel.functions`, so that
they are the same for numbers and for the compiled recursion.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.jets import Jet, jet
from tmodes.kinds.kernel.spatial import Force
from tmodes.kinds.noted.functions import array
from tmodes.kinds.registry import NamedKind, Registry
from tmodes.kinds.schema.quantity import DataSheet

__all__ = ["JOINTS", "Coordinate", "JointKind"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Coordinate:
    """A coordinate of a joint: ``name`` after the joint's (empty where it is the only one), ``unit`` rad or m."""

    name: str = ""
    unit: str = "rad"

    @property
    def effort_unit(self) -> str:
        """Of the effort along it."""
        return "N" if self.unit == "m" else "N*m"

    @property
    def stiffness_unit(self) -> str:
        """Of a spring along it."""
        return f"{self.effort_unit}/{self.unit}"

    @property
    def slides(self) -> bool:
        """Whether it is a distance."""
        return self.unit == "m"

    def of(self, joint: str) -> str:
        """Its name among the coordinates of a robot."""
        return f"{joint}.{self.name}" if self.name else joint


class JointKind(NamedKind):
    """A kind of joint.

    ``numbers`` of a formula: the joint's axis (3, a unit vector in the joint frame), then the values of ``schema`` in
    the order of its fields.
    """

    summary: ClassVar[str]
    """How it moves, in a few words."""
    coordinates: ClassVar[tuple[Coordinate, ...]] = (Coordinate(),)
    has_axis: ClassVar[bool] = True
    """Whether a data sheet gives its axis."""
    schema: ClassVar[type[DataSheet] | None] = None
    """Further numbers that a data sheet gives under ``parameters``."""
    turns: ClassVar[bool] = False
    """It is nothing but a rotation about its axis."""
    slides: ClassVar[bool] = False
    """It is nothing but a translation along its axis."""
    drawing: ClassVar[str] = "ball"
    """How it is drawn: ``cylinder`` about its axis, ``box`` along its axis, ``ball``, or ``none``."""

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)

    @property
    def moves(self) -> bool:
        """Whether it has a coordinate."""
        return bool(self.coordinates)

    @property
    def is_simple(self) -> bool:
        """Whether it has the kernels of an axis: it turns about it, slides along it, or does not move."""
        return self.turns or self.slides or not self.moves

    @abstractmethod
    def place(self, q: Any, numbers: Any) -> tuple[v.Matrix, v.Vector]:
        """Rotation (rows of a 3 x 3 matrix) and position [m] of the link's frame in the joint's, at coordinates q."""

    def subspace(self, q: Any, numbers: Any) -> list[Force]:
        """Columns of S: angular velocity of the link's frame and velocity of its origin are S q', in link axes."""
        return [self._column(q, numbers, k) for k in range(self.size)]

    def _column(self, q: Any, numbers: Any, k: int) -> Force:
        rotation, position = self._jets([Jet(q[i], 1.0 if i == k else 0.0) for i in range(self.size)], numbers)
        rate = v.matmul(v.transpose(_part(rotation, "value")), _part(rotation, "first"))
        linear = v.matvec(v.transpose(_part(rotation, "value")), [each.first for each in position])
        return Force([rate[2][1], rate[0][2], rate[1][0]], linear)

    def bias(self, q: Any, rates: Any, numbers: Any) -> Force:
        """Angular acceleration of the link's frame and acceleration of its origin at q'' = 0, in link axes."""
        rotation, position = self._jets([Jet(q[i], rates[i]) for i in range(self.size)], numbers)
        back = v.transpose(_part(rotation, "value"))
        turn = v.matmul(back, _part(rotation, "second"))
        angular = [(turn[i][j] - turn[j][i]) / 2 for i, j in ((2, 1), (0, 2), (1, 0))]
        return Force(angular, v.matvec(back, [each.second for each in position]))

    def _jets(self, q: list[Jet], numbers: Any) -> tuple[list[list[Jet]], list[Jet]]:
        rotation, position = self.place(q, numbers)
        return [[jet(x) for x in row] for row in rotation], [jet(x) for x in position]

    def placement(self, q: Sequence[float], numbers: Sequence[float]) -> tuple[Array, Array]:
        """Rotation (3, 3) and position (3,) [m] as arrays."""
        rotation, position = self.place(q, numbers)
        return array(rotation), array(position)

    def commutes(self, axis: Array, rotation: Array, position: Array) -> bool:
        """Whether the joint, seen from a frame placed so in its moved frame, is the same about its axis as seen there.

        True for few kinds; where it is False, a rigid piece without mass takes the offset.
        """
        del axis
        return bool(np.array_equal(rotation, np.eye(3)) and not np.any(position))


def _part(matrix: list[list[Jet]], name: str) -> v.Matrix:
    return [[getattr(x, name) for x in row] for row in matrix]


JOINTS: Registry[JointKind] = Registry("joint", JointKind, made=lambda kind: kind())
"""Those of tmodes, and what a user registers: ``@JOINTS.register``."""
