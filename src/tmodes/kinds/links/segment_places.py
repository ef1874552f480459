"""The line of the paper's mode as a link: the cubic of a tip force, in both planes; its mass is at its tip."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Slot
from tmodes.kinds.kernel.spatial import FORCE, Force
from tmodes.kinds.links.line import POSE, LineOfLink, Moved
from tmodes.kinds.links.line_place import PLACE, Shape, in_section, packed_place
from tmodes.kinds.links.modes_sheet import shape_angle, shape_slope
from tmodes.kinds.links.segment_link import turned_axes

__all__ = ["SegmentLine"]


@dataclass(frozen=True, eq=False, kw_only=True)
class SegmentLine(LineOfLink):
    """Of one segment that bends about y, about z, or both."""

    bend_y: bool
    bend_z: bool

    def places(self, moved: Moved) -> list[Slot]:
        """One kernel for all places."""
        kernel = _place(self.bend_y, self.bend_z)
        common = (moved.tables, moved.stiffness, moved.damping, moved.q, moved.v, moved.pose, moved.outer[-1])
        return [moved.one(kernel, moved.numbers.block([s]), *common) for s in self.s]


def _place(bend_y: bool, bend_z: bool) -> Kernel:
    """(s, length, springs, dampers, q, qd, pose of the root, force on the tip) -> a place.

    Eq. (3) [derived]: the chord to the point s turns by (3 s - s^2)/2 th, the tangent by (3 s - 3 s^2/2) th, in both
    planes; the curvature is 3 th/l (1 - s), the moment (Cs th + Bs th') l^2 (1 - s). {test_segment_line}
    """
    n = int(bend_y) + int(bend_z)

    def planes(values: Any) -> list[Any]:
        return [values[0] if bend_y else 0.0, values[n - 1] if bend_z else 0.0]

    def build(*packed: Any) -> list[list[Any]]:
        row, table, springs, dampers, q, qd, pose, outer = packed
        s, length, th, load = row[0], table[0], planes(q), Force.of(outer)
        rotation = turned_axes(*(shape_slope(s) * angle for angle in th))
        chord = turned_axes(*(shape_angle(s) * angle for angle in th))
        position = v.scale(length * s, [line[0] for line in chord])
        force = v.scale(-1.0, load.linear)
        moment = v.sub(v.scale(-1.0, load.angular), v.cross(position, force))
        left, springs, dampers, rates = 1 - s, planes(springs), planes(dampers), planes(qd)
        answered = [left * (springs[k] * th[k] + dampers[k] * rates[k]) for k in range(2)]
        curvature = [3 * left / length * angle for angle in th]
        slopes = [shape_slope(s) * th[1], -(shape_slope(s) * th[0])]
        shape = Shape(slopes, curvature, 0.0, 0.0, [0.0, *answered], 0.0)
        return [packed_place(pose, rotation, position, *in_section(rotation, moment, force), shape)]

    sizes = (1, 1, n, n, n, n, POSE, FORCE)
    return Kernel(f"line segment {'y' * bend_y}{'z' * bend_z}", sizes, (sum(PLACE.values()),), build)
