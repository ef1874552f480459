"""The line of the paper's mode as a link: the cubic of a tip force, in both planes; its mass is at its tip."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Segment
from tmodes.equations.line.link import LineOfLink, Moved
from tmodes.equations.line.place import PLACE, Shape, packed_place
from tmodes.equations.recursion.segment_link import turned_axes
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Slot
from tmodes.kinds.kernel.spatial import FORCE, Force

__all__ = ["SegmentLine"]

_POSE = 15


@dataclass(frozen=True, eq=False)
class SegmentLine(LineOfLink):
    """Of one segment at the places ``s`` (S,)."""

    link: Segment
    s: NDArray[np.float64]

    kind = "segment"

    @property
    def length(self) -> float:  # pyright: ignore[reportIncompatibleVariableOverride]
        """Length of the chord [m]."""
        return self.link.length

    def places(self, moved: Moved) -> list[Slot]:
        """One kernel for all places."""
        link, square = self.link, self.link.length**2
        springs = (link.stiffness_y, link.stiffness_z, link.damping_y, link.damping_z)
        own = moved.numbers.block([link.length, *(square * spring for spring in springs)])
        kernel = _place(link.bend_y, link.bend_z)
        rows = [moved.numbers.block([s]) for s in self.s]
        return [moved.one(kernel, row, own, moved.q, moved.v, moved.pose, moved.outer[-1]) for row in rows]


def _place(bend_y: bool, bend_z: bool) -> Kernel:
    """(s, [length, springs and dampers about y and z], q, qd, pose of the root, force on the tip) -> a place.

    Eq. (3) [derived]: the chord to the point s turns by (3 s - s^2)/2 th, the tangent by (3 s - 3 s^2/2) th, in both
    planes; the curvature is 3 th/l (1 - s), the moment (Cs th + Bs th') l^2 (1 - s). {test_segment_line}
    """
    n = int(bend_y) + int(bend_z)

    def angles(values: Any) -> list[Any]:
        return [values[0] if bend_y else 0.0, values[n - 1] if bend_z else 0.0]

    def build(row: Any, own: Any, q: Any, qd: Any, pose: Any, outer: Any) -> list[list[Any]]:
        s, th, rates = row[0], angles(q), angles(qd)
        length, springs, dampers = own[0], [own[1], own[2]], [own[3], own[4]]
        chord, slope = s * (3 - s) / 2, 3 * s * (2 - s) / 2
        rotation = turned_axes(slope * th[0], slope * th[1])
        reached = turned_axes(chord * th[0], chord * th[1])
        position = v.scale(length * s, [line[0] for line in reached])
        load = Force.of(outer)
        force = v.scale(-1.0, load.linear)
        moment = v.sub(v.scale(-1.0, load.angular), v.cross(position, force))
        left = 1 - s
        answered = [left * (springs[k] * th[k] + dampers[k] * rates[k]) for k in range(2)]
        curvature = [3 * left / length * angle for angle in th]
        shape = Shape([slope * th[1], -slope * th[0]], curvature, 0.0, 0.0, [0.0, *answered], 0.0)
        return [packed_place(pose, rotation, position, force, moment, shape)]

    sizes = (1, 5, n, n, _POSE, FORCE)
    return Kernel(f"line segment {'y' * bend_y}{'z' * bend_z}", sizes, (sum(PLACE.values()),), build)
