"""The line of each mode of a ``modes`` link: the cubic of a tip force, with the loads of all modes outboard.

Angles add up inside the link, so loads are taken in axes of azimuth: ahead along the chord seen from above, aside, and
up. A couple at the end of a mode is taken in the axes where it acts, as the angles there turn it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin, sqrt
from tmodes.kinds.kernel.schedule import Kernel, Slot
from tmodes.kinds.kernel.spatial import FORCE, Force
from tmodes.kinds.links.line import PLACE, POSE, LineOfLink, Moved, Shape, packed_place
from tmodes.kinds.links.modes_line import TANGENT, ModeAngles, ModesLine
from tmodes.kinds.links.modes_sheet import shape_angle, shape_deflection, shape_slope

__all__ = ["ModePlaces"]

_MASS = 9
"""Numbers of a mass at the end of a mode: place, and the couple and the force that it puts on the link."""


class _Single(NamedTuple):
    """A load at a place: its force, and its couple in axes of azimuth."""

    place: v.Vector
    couple: v.Vector
    force: v.Vector


@dataclass(frozen=True, eq=False, kw_only=True)
class ModePlaces(LineOfLink):
    """Of mode ``mode``, whose root is at ``start`` and whose length is ``share``, both over the length of the link."""

    structure: Any
    mode: int
    start: float
    share: float

    @property
    def along_link(self) -> NDArray[np.float64]:
        """The mode is a part of the link."""
        return self.start + self.share * self.s

    def places(self, moved: Moved) -> list[Slot]:
        """The masses at the ends of the modes before the last, and one kernel for all places."""
        kernels, motion = _Kernels(self.structure, self.mode), (moved.q, moved.v, moved.a)
        masses: tuple[Slot, ...] = ()
        if kernels.inner:
            masses = moved.call(kernels.masses(), moved.tables, *motion, moved.rate, moved.acceleration)
        common = (moved.tables, moved.stiffness, moved.damping, moved.q, moved.v, moved.pose, moved.tip.part(0, 12))
        place, found = kernels.place(), []
        for s, first in zip(self.s, self.borne(), strict=True):
            blocks = (moved.numbers.block([s]), *common, moved.outer[first], moved.outer[-1], *masses)
            found.append(moved.one(place, *blocks))
        return found


@dataclass(frozen=True)
class _Kernels:
    structure: Any
    mode: int

    @property
    def inner(self) -> range:
        """Modes from this one on that end before the tip."""
        return range(self.mode, self.structure.modes - 1)

    @property
    def key(self) -> str:
        """The structure in words."""
        return f"line {self.structure.key} of {self.mode}"

    def masses(self) -> Kernel:
        """(tables, q, qd, qdd, rate and acceleration of the root) -> the mass at the end of each inner mode."""

        def build(tables: Any, q: Any, qd: Any, qdd: Any, rate: Any, root: Any) -> list[list[Any]]:
            azimuth, elevation = self.structure.angles(q, qd)
            line, m = self._line(tables, azimuth, elevation, v.vec(rate)), self.structure.modes
            return [self._mass(line, k, tables[m + k], tables[2 * m + k], Force.of(root), qdd) for k in self.inner]

        n = self.structure.size
        sizes = (self.structure.table_size, n, n, n, 3, FORCE)
        return Kernel(f"{self.key} masses", sizes, (_MASS,) * len(self.inner), build)

    def _line(self, tables: Any, azimuth: ModeAngles, elevation: ModeAngles, rate: v.Vector) -> ModesLine:
        lengths = [tables[k] for k in range(self.structure.modes)]
        return ModesLine(lengths, azimuth, elevation, self.structure.free, rate)

    def _mass(self, line: ModesLine, k: int, mass: Any, inertia: Any, root: Force, qdd: Any) -> list[Any]:
        section = line.section(k, 1.0, 1.0, TANGENT)
        motion = root.motion_at(section.position) + section.bias
        for j, column in enumerate(section.columns):
            motion = motion + column.scaled(qdd[j])
        couple = v.matvec(_axes(section.rotation), v.scale(-inertia, motion.angular))
        return [*section.position, *couple, *v.scale(-mass, motion.linear)]

    def place(self) -> Kernel:
        """(s, tables, springs, dampers, q, qd, pose, tip, forces outboard, of the tip alone, masses) -> a place."""
        structure, n = self.structure, self.structure.size
        springs = (structure.stiffness_size, structure.damping_size)
        sizes = (1, structure.table_size, *springs, n, n, POSE, 12, FORCE, FORCE, *(_MASS,) * len(self.inner))
        return Kernel(f"{self.key} place", sizes, (sum(PLACE.values()),), self._place)

    def _place(self, *packed: Any) -> list[list[Any]]:
        """Of all that moves outboard: weight and inertia of the masses, their rotary inertia, forces on points.

        Eq. (1) [corrected]: M + beta y'' = 0 for one beam alone; here M holds every force of the whole mechanism, and
        beta (y + eta y')'' the damping. {test_line_moments_obey_galerkin}
        Eq. (4) [derived]: M_j + eps_j = 0 for every mode j, with the coupling between modes: the moment at the next
        mode's root is part of M. {test_line_moments_obey_galerkin}
        Eq. (29) [derived]: M(x) of the flexible line of mode 1, horizontal plane.
        {test_root_moment_is_gear_torque, test_line_moments_obey_galerkin}
        Eq. (31) [derived]: M(x) of the flexible line of mode 2, horizontal plane. {test_line_moments_obey_galerkin}
        Eq. (32) [derived]: M(x) of the flexible line of mode 1, vertical plane.
        {test_line_moments_obey_galerkin, test_static_moments_are_levers}
        Eq. (33) [derived]: M(x) of the flexible line of mode 2, vertical plane.
        {test_line_moments_obey_galerkin, test_static_moments_are_levers}
        """
        row, tables, springs, dampers, q, qd, pose, tip, outer, last, *masses = packed
        s, angles = row[0], self.structure.angles(q, qd)
        held = [ModeAngles(part.values, [0.0] * self.structure.modes) for part in angles]
        line = self._line(tables, held[0], held[1], v.zero())
        section = line.section(self.mode, s, shape_angle(s), shape_slope(s))
        axes = self._chord_axes(line)
        singles = [_Single(v.vec(mass), v.vec(mass, 3), v.vec(mass, 6)) for mass in masses]
        total, between = Force.of(last), Force.of(outer) - Force.of(last)
        end = v.vec(tip, 9)
        force = v.scale(-1.0, total.linear)
        couple = v.sub(v.scale(-1.0, total.angular), v.cross(end, force))
        singles.append(_Single(end, v.matvec(_axes(v.tri(tip)), couple), force))
        at_root = v.matvec(axes, v.scale(-1.0, between.angular))
        singles.append(_Single(v.zero(), at_root, v.scale(-1.0, between.linear)))
        moments = [v.add(one.couple, v.matvec(axes, v.cross(v.sub(one.place, section.position), one.force)))
                   for one in singles]  # fmt: skip
        tangent = self._tangent(line, s)
        loads = v.add(*moments), _across(axes, tangent, v.add(*(one.force for one in singles)), tables[self.mode])
        shape = self._shape(s, angles, line, tables[self.mode], springs, dampers)
        return [packed_place(pose, section.rotation, section.position, *loads, shape)]

    def _chord_axes(self, line: ModesLine) -> v.Matrix:
        angle = line.azimuth.direction(self.mode, 1.0)[0]
        return [[cos(angle), sin(angle), 0.0], [-sin(angle), cos(angle), 0.0], v.unit(2)]

    def _tangent(self, line: ModesLine, s: Any) -> v.Vector:
        """Derivative of the place by s."""
        (azimuth, _), (elevation, _) = (
            part.direction(self.mode, shape_angle(s)) for part in (line.azimuth, line.elevation)
        )
        gain = s * (3 - 2 * s) / 2
        flat, up = (gain * part.values[self.mode] for part in (line.azimuth, line.elevation))
        c, w, e, z = cos(azimuth), sin(azimuth), cos(elevation), sin(elevation)
        along = [e * c - flat * e * w - up * z * c, e * w + flat * e * c - up * z * w, z + up * e]
        return v.scale(line.lengths[self.mode], along)

    def _shape(
        self, s: Any, angles: tuple[ModeAngles, ModeAngles], line: ModesLine, length: Any, springs: Any, dampers: Any
    ) -> Shape:
        """Of the angles in azimuth and elevation.

        Eq. (3) [derived]: the curvature is 3 th/l (1 - s), the moment (Cs th + Bs th') lever^2 (1 - s), with the lever
        l cos(elevation of the chord) in azimuth, l in elevation. {test_lines_of_modes_are_those_of_the_paper}
        """
        (flat, slow), (up, rising) = ((part.values[self.mode], part.rates[self.mode]) for part in angles)
        level = cos(line.elevation.direction(self.mode, 1.0)[0])
        moments = [0.0, 0.0]
        if self.structure.free[self.mode]:
            b = sum(self.structure.free[: self.mode])
            moments = [(1 - s) * share * (springs[b] * angle + dampers[b] * rate)
                       for share, angle, rate in ((level * level, flat, slow), (1.0, up, rising))]  # fmt: skip
        bend = 3 * (1 - s) / length
        return Shape(
            [flat * shape_slope(s), up * shape_slope(s)], [-(bend * up), bend * flat], 0.0, 0.0,
            [0.0, -moments[1], moments[0]], 0.0,
            deflection=[length * level * flat * shape_deflection(s), length * up * shape_deflection(s)],
        )  # fmt: skip


def _axes(rotation: v.Matrix) -> v.Matrix:
    """Ahead, aside and up of a section, as rows: its side is level."""
    side = [row[1] for row in rotation]
    return [[side[1], -side[0], 0.0], side, v.unit(2)]


def _across(axes: v.Matrix, tangent: v.Vector, force: v.Vector, length: Any) -> v.Vector:
    """Axial force, and shear sideways and upwards: less the derivatives of the moments by x."""
    lever = v.matvec(axes, v.cross(tangent, force))
    return [v.dot(tangent, force) / sqrt(v.dot(tangent, tangent)), lever[2] / length, -(lever[1] / length)]
