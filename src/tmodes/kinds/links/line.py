"""The elastic line of a bending link: the calls that compute its places in the schedule of all lines.

A link kind gives its lines by :meth:`tmodes.kinds.links.contract.Link.lines`. One that has none of its own has the line
here: a cubic from root to tip.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import atan2, sqrt
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Numbers, Slot
from tmodes.kinds.kernel.spatial import FORCE, Force
from tmodes.kinds.links.line_place import PLACE, Shape, packed_place

__all__ = ["POSE", "CubicLine", "LineOfLink", "Moved"]

Array = NDArray[np.float64]

POSE = 15
"""Numbers of a pose in the world: rotation (9), position (3), velocity of the origin (3)."""


@dataclass(frozen=True)
class Moved:
    """A link in the schedule: its coordinates with rates and accelerations, how its root moves and what it carries.

    ``tables``, ``stiffness`` and ``damping``: the numbers that the recursion has of it. ``pose`` of the root in the
    world, ``rate`` (3) and ``acceleration`` (6: angular, linear less gravity) of the root, ``tip`` (rotation,
    position). ``outer``: of each station and of the tip the force (6: moment, force) that all single bodies and points
    from there on need; ``force``: what the root needs, both about the root. All but the pose in the axes of the root.
    """

    call: Callable[..., tuple[Slot, ...]]
    numbers: Numbers
    tables: Slot
    stiffness: Slot
    damping: Slot
    q: Slot
    v: Slot
    a: Slot
    pose: Slot
    rate: Slot
    acceleration: Slot
    tip: Slot
    outer: Sequence[Slot]
    force: Slot

    def one(self, kernel: Kernel, *inputs: Slot) -> Slot:
        """Call a kernel of one output."""
        return self.call(kernel, *inputs)[0]


@dataclass(frozen=True, eq=False)
class LineOfLink(ABC):
    """A line at places s in 0..1 (0 its root, 1 its tip); a link may have several, one after the other.

    ``suffix``: what follows the link's name in that of the line; ``stations``: places of the model besides the tip.
    """

    length: float
    stations: tuple[float, ...]
    s: Array
    suffix: str = ""

    @property
    def stressed(self) -> bool:
        """Whether section and material are known."""
        return False

    def borne(self) -> NDArray[np.intp]:
        """For each place, which of ``Moved.outer`` it bears: a place bears what is fixed to it."""
        return np.searchsorted(self.stations, self.s, side="left")

    @abstractmethod
    def places(self, moved: Moved) -> list[Slot]:
        """Add the numbers and the calls; one block for each place, see :func:`tmodes.kinds.links.line_place.layout`."""


class CubicLine(LineOfLink):
    """From root to tip with their tangents; its own inertia is counted as spread evenly, with the right sum."""

    def places(self, moved: Moved) -> list[Slot]:
        """One kernel for all places."""
        length = moved.numbers.block([self.length])
        common = (length, moved.pose, moved.tip.part(0, 12), moved.outer[0], moved.force)
        rows = [moved.numbers.block([s]) for s in self.s]
        return [
            moved.one(_cubic(), row, *common, moved.outer[first]) for row, first in zip(rows, self.borne(), strict=True)
        ]


def _cubic() -> Kernel:
    """(s, length, pose of the root, tip, force of single bodies, of all, and of those from the place on) -> a place."""

    def build(row: Any, own: Any, pose: Any, tip: Any, single: Any, whole: Any, outer: Any) -> list[list[Any]]:
        s, length, end, last = row[0], own[0], v.vec(tip, 9), v.tri(tip)
        tangents = v.scale(length, v.unit(0)), v.scale(length, [line[0] for line in last])

        def mixed(start: Any, first: Any, last: Any) -> v.Vector:
            return v.add(v.scale(start, end), v.scale(first, tangents[0]), v.scale(last, tangents[1]))

        position = mixed(s * s * (3 - 2 * s), s * (1 - s) * (1 - s), s * s * (s - 1))
        slope = mixed(6 * s * (1 - s), (1 - s) * (1 - 3 * s), s * (3 * s - 2))
        bend = mixed(6 - 12 * s, 6 * s - 4, 6 * s - 2)
        speed = sqrt(v.dot(slope, slope))
        along = v.scale(1 / speed, slope)
        side = v.add(v.scale(1 - s, v.unit(1)), v.scale(s, [line[1] for line in last]))
        side = v.sub(side, v.scale(v.dot(side, along), along))
        side = v.scale(1 / sqrt(v.dot(side, side)), side)
        up = v.cross(along, side)
        axes = [along, side, up]
        load = Force.of(outer) + (Force.of(whole) - Force.of(single)).scaled(1 - s)
        force = v.scale(-1.0, load.linear)
        moment = v.sub(v.scale(-1.0, load.angular), v.cross(position, force))
        turned = v.scale(1 / (speed * speed), v.cross(along, bend))
        curvature = [v.dot(turned, side), v.dot(turned, up)]
        answered = [0.0, v.dot(moment, side), v.dot(moment, up)]
        shape = Shape([atan2(slope[k], slope[0]) for k in (1, 2)], curvature, 0.0, 0.0, answered, 0.0)
        return [packed_place(pose, v.transpose(axes), position, v.matvec(axes, moment), v.matvec(axes, force), shape)]

    return Kernel("line cubic", (1, 1, POSE, 12, FORCE, FORCE, FORCE), (sum(PLACE.values()),), build)
