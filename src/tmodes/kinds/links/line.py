"""The elastic line of a bending link: the calls that compute its places in the schedule of all lines.

A link kind gives its lines by :meth:`tmodes.kinds.links.contract.Link.lines`. One that has none of its own has the line
here: a cubic from root to tip.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import atan2, fabs, fmax, fmin, if_else, sqrt
from tmodes.kinds.kernel.schedule import Kernel, Numbers, Slot, kernel
from tmodes.kinds.kernel.spatial import FORCE, Force

__all__ = [
    "PLACE", "POSE", "SAME", "STRESS", "STRESS_NUMBERS", "CubicLine", "LineOfLink", "Moved", "Shape", "Stressed",
    "in_section", "layout", "packed_place",
]  # fmt: skip

Array = NDArray[np.float64]

SAME = 1e-9
"""Difference of two places along a link [-] that is rounding."""

POSE = 15
"""Numbers of a pose in the world: rotation (9), position (3), velocity of the origin (3)."""

PLACE = {
    "position": 3, "rotation": 9, "deflection": 2, "slope": 2, "moment": 3, "shear": 2, "axial": 1, "curvature": 2,
    "twist": 1, "stretch": 1, "elastic_moment": 3, "elastic_force": 1,
}  # fmt: skip
"""Quantities of a place with their numbers, in the order in which they are computed.

Position and rotation are in the world, deflection and slope in the axes of the root, the others in section axes.
"""

STRESS = {"strain": 1, "mises_stress": 1, "normal_stress": 1, "shear_stress": 1}
"""Quantities of a place where section and material are known, after those of all places."""

STRESS_NUMBERS = 10
"""Numbers of a section that its stresses depend on."""


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

    @property
    def along_link(self) -> Array:
        """The places over the length of the whole link."""
        return self.s

    def borne(self) -> NDArray[np.intp]:
        """For each place, which of ``Moved.outer`` it bears.

        Inner forces are those in the beam: at the root just beyond a body that is fixed there, at the tip just before
        one. A place bears what is fixed to it; where it is given twice, the second is just beyond.
        """
        first, beyond = (np.searchsorted(self.stations, self.along_link + side) for side in (-SAME, SAME))
        again = np.diff(self.s, prepend=-1.0) < SAME
        return np.where(again | (self.s <= SAME), beyond, first)

    @abstractmethod
    def places(self, moved: Moved) -> list[Slot]:
        """Add the numbers and the calls; one block for each place, see :func:`tmodes.kinds.links.line.layout`."""


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


@kernel("line cubic", (1, 1, POSE, 12, FORCE, FORCE, FORCE), (sum(PLACE.values()),))
def _cubic(row: Any, own: Any, pose: Any, tip: Any, single: Any, whole: Any, outer: Any) -> list[list[Any]]:
    """(s, length, pose of the root, tip, force of single bodies, of all, and of those from the place on) -> a place."""
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


def layout(*, stressed: bool) -> dict[str, slice]:
    """Where each quantity of a place stands."""
    sizes = PLACE | (STRESS if stressed else {})
    ends = list(accumulate(sizes.values()))
    return {name: slice(end - size, end) for (name, size), end in zip(sizes.items(), ends, strict=True)}


@dataclass
class Shape:
    """Curvature about y and z, twist and stretch of a section, with the moment and force of the material against them.

    ``slope``: angle of the tangent against that of the root, in the x-y and the x-z plane of the root.
    """

    slope: list[Any]
    curvature: list[Any]
    twist: Any
    stretch: Any
    elastic_moment: v.Vector
    elastic_force: Any
    deflection: list[Any] | None = None
    """Where it is not the place off the root's x axis."""


@dataclass
class Stressed:
    """Stress of a section by its ``numbers``: Young's and shear modulus, distances of the outer fibre along y and z,
    stiffnesses GJ, EI_y, EI_z, EA (0 where not given or infinite), largest shear stress over a force along y and z.
    ``ring``: the outer fibre is a circle, on which both bending moments add up.

    sigma = |N| E/EA + |M| E r/EI; tau = G r M_x/GJ of a circle, else with r of a bound: Saint-Venant's shear is at most
    that of a strip of the section's thickness, and that of its corner's distance. A shear force Q adds S Q/(I b) in the
    middle, where bending has no stress: von Mises' is the larger of that there and at the outer fibre.
    """  # noqa: D205

    numbers: Any
    ring: bool

    def packed(self, moment: v.Vector, force: v.Vector) -> list[Any]:
        """Strain, von Mises stress, normal and shear stress."""
        young, shear, outer_y, outer_z, *others = (self.numbers[k] for k in range(STRESS_NUMBERS))
        stiffness, peaks = others[:4], others[4:]
        per_torsion, per_y, per_z, per_force = (if_else(k > 0, 1 / k, 0.0) for k in stiffness)
        about_y, about_z = fabs(moment[1]) * outer_z * per_y, fabs(moment[2]) * outer_y * per_z
        bending = sqrt(about_y * about_y + about_z * about_z) if self.ring else about_y + about_z
        pulled = fabs(force[0]) * per_force
        strain = bending + pulled
        corner = fmin(2 * fmin(outer_y, outer_z), sqrt(outer_y * outer_y + outer_z * outer_z))
        lever = outer_y if self.ring else corner
        normal, turned = young * strain, shear * lever * fabs(moment[0]) * per_torsion
        along_y, along_z = peaks[0] * force[1], peaks[1] * force[2]
        across = turned + sqrt(along_y * along_y + along_z * along_z)
        outer = normal * normal + 3 * turned * turned
        middle = young * pulled * young * pulled + 3 * across * across
        return [strain, sqrt(fmax(outer, middle)), normal, across]


def in_section(rotation: v.Matrix, moment: v.Vector, force: v.Vector) -> tuple[v.Vector, v.Vector]:
    """Moment and force in the axes that are the columns of ``rotation``."""
    axes = v.transpose(rotation)
    return v.matvec(axes, moment), v.matvec(axes, force)


def packed_place(
    pose: Any, rotation: v.Matrix, position: v.Vector, moment: v.Vector, force: v.Vector, shape: Shape,
    stressed: Stressed | None = None,
) -> list[Any]:  # fmt: skip
    """All quantities of a place.

    ``pose`` of the root in the world; ``rotation`` and ``position`` of the section in the axes of the root; ``moment``
    and ``force`` by the outboard part on the inboard one, in section axes.
    """
    world = v.tri(pose)
    place = v.add(v.vec(pose, 9), v.matvec(world, position))
    stress = stressed.packed(moment, force) if stressed else []
    return v.flat(
        place, v.matmul(world, rotation), shape.deflection or position[1:], shape.slope, moment, force[1:], force[0],
        shape.curvature, shape.twist, shape.stretch, shape.elastic_moment, shape.elastic_force, stress,
    )  # fmt: skip
