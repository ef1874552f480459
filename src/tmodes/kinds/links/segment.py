"""The link kind ``segments``: each segment is one mode of the 2010 paper as a link of its own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.schedule import Kernel, Slot
from tmodes.kinds.kernel.spatial import FORCE, Force
from tmodes.kinds.links.contract import Body, Link, LinkNumbers, QuadraticStructure
from tmodes.kinds.links.facts import DIRECTIONS, LUMPS_OF_BEAM, ends
from tmodes.kinds.links.line import PLACE, POSE, LineOfLink, Moved, Shape, in_section, packed_place
from tmodes.kinds.links.modes_sheet import eased, shape_angle, shape_slope
from tmodes.kinds.links.rigid import rod
from tmodes.kinds.links.terms import Section

__all__ = ["Segment", "SegmentLine", "SegmentStructure", "segment_link", "turned_axes"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class SegmentStructure(QuadraticStructure):
    """A segment of the paper: it bends about y, about z, or both; its inertia sits at its tip, as a body."""

    bend_y: bool
    bend_z: bool

    @property
    def table_size(self) -> int:
        """The length."""
        return 1

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return int(self.bend_y) + int(self.bend_z)

    @property
    def stiffness_sizes(self) -> tuple[int, ...]:
        """One coordinate per direction."""
        return (1,) * self.size

    @property
    def key(self) -> str:
        """The structure in words."""
        return f"segment {'y' * self.bend_y}{'z' * self.bend_z}"

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """No inertia terms of its own, and the section at the tip."""
        return [0.0], [segment_link(self.bend_y, self.bend_z, tables[0], rate, q, qd)]


@dataclass(frozen=True, eq=False)
class Segment(Link):
    """The paper's mode as a link: a chord of fixed length with the mass of Eq. (13) at its tip (LMA).

    The chord turns by th about z, then about y (``bend_y``, ``bend_z``: which are free), the tip's tangent by 3/2 th.
    ``stiffness`` Cs [N/m] and ``damping`` Bs [N*s/m] act on the tip's deflection; ``bodies`` in the tip frame, first
    its own. Of the beam: ``mass`` of its piece [kg], None where not known; ``lever``: lengths beyond this one [-].
    """

    kind: ClassVar[str] = "segments"
    comparison: ClassVar[str] = LUMPS_OF_BEAM

    length: float
    stiffness_y: float
    stiffness_z: float
    damping_y: float = 0.0
    damping_z: float = 0.0
    bend_y: bool = True
    bend_z: bool = True
    bodies: tuple[Body, ...] = ()
    mass: float | None = None
    lever: float = 0.0

    @property
    def coordinates(self) -> tuple[str, ...]:
        """``bend_y`` and ``bend_z``, as far as they are free."""
        return tuple(name for name, free in (("bend_y", self.bend_y), ("bend_z", self.bend_z)) if free)

    @property
    def functions(self) -> Mapping[str, int]:
        """One in each direction that is free."""
        return dict.fromkeys(DIRECTIONS, 0) | {"bend_y": int(self.bend_y), "bend_z": int(self.bend_z)}

    def compared(self) -> Self | None:
        """With its mass as a rod that turns with its tip, and as stiff as the beam is under a force at the link's tip.

        The rod has the inertia of the rigid beam, and 1/4 instead of 33/140 of its mass with the tip's deflection.
        """
        if self.mass is None:
            return None
        names = ("stiffness_y", "stiffness_z", "damping_y", "damping_z")
        springs = {name: getattr(self, name) * eased(self.lever) for name in names}
        return replace(self, bodies=(rod(self.mass, self.length), *self.bodies[1:]), **springs)

    def limiting_angles(self, q: Array, stations: tuple[float, ...] = ()) -> Array:  # noqa: ARG002
        """The angle of the chord."""
        return np.linalg.norm(q, axis=1)

    def stiffness_at(self, direction: str, s: ArrayLike) -> Array:
        """EI from the stiffness 3 EI/l^3 at its tip."""
        tip = getattr(self, f"stiffness_{direction[-1]}") if direction in ("bend_y", "bend_z") else np.inf
        return np.full(np.shape(s), tip * self.length**3 / 3)

    def described(self, row: Sequence[Any]) -> dict[str, Any]:
        """Segments in a row."""
        last = row[-1]
        return {
            "model": f"segments ({len(row)})",
            "length_m": sum(one.length for one in row),
            **{
                f"bending_stiffness_{axis}_Nm2": ends(
                    *(getattr(one, f"stiffness_{axis}") * one.length**3 / 3 for one in (self, last))
                )
                for axis in ("y", "z")
            },
        }

    def lines(self, stations: tuple[float, ...], s: NDArray[np.float64]) -> Sequence[LineOfLink]:
        """One cubic."""
        return [SegmentLine(self.length, stations, s, bend_y=self.bend_y, bend_z=self.bend_z)]

    def numbers(self, stations: tuple[float, ...]) -> LinkNumbers:  # noqa: ARG002
        """Length, and the springs and dampers against the angles."""
        square = self.length**2
        planes = ((self.bend_y, self.stiffness_y, self.damping_y), (self.bend_z, self.stiffness_z, self.damping_z))
        free = [plane for plane in planes if plane[0]]
        springs, dampers = (np.array([plane[k] * square for plane in free]) for k in (1, 2))
        return LinkNumbers(SegmentStructure(self.bend_y, self.bend_z), np.array([self.length]), springs, dampers)


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


def segment_link(bend_y: bool, bend_z: bool, length: Any, rate: Any, q: Any, qd: Any) -> list[Any]:
    """The packed section at the tip; coordinates: th about y where it bends there, then th about z.

    Eq. (6) [derived]: the chord is Rz(th_z) Ry(th_y) e_x, the tip's axes Rz(3/2 th_z) Ry(3/2 th_y). {test_segments}
    """
    angles = [q[k] for k in range(int(bend_y) + int(bend_z))]
    speeds = [qd[k] for k in range(len(angles))]
    spin = v.vec(rate)
    about_y, rate_y = (angles[0], speeds[0]) if bend_y else (0.0, 0.0)
    about_z, rate_z = (angles[-1], speeds[-1]) if bend_z else (0.0, 0.0)
    chord = _TurnedAxes(about_y, about_z, rate_y, rate_z, spin)
    tangent = _TurnedAxes(1.5 * about_y, 1.5 * about_z, 1.5 * rate_y, 1.5 * rate_z, spin)
    place = v.scale(length, [row[0] for row in chord.rotation])
    move = [v.cross(column, place) for column in chord.columns]
    turns = [v.scale(1.5, column) for column in tangent.columns]
    free = [k for k, bends in enumerate((bend_y, bend_z)) if bends]
    columns = [Force(turns[k], move[k]) for k in free]
    bias = Force(tangent.bias, v.add(v.cross(chord.bias, place), v.cross(chord.rate, v.cross(chord.rate, place))))
    return Section(tangent.rotation, place, tangent.rate, columns, bias).packed()


def turned_axes(about_y: Any, about_z: Any) -> v.Matrix:
    """Axes turned about z, then about the turned y: Rz Ry."""
    cy, sy, cz, sz = cos(about_y), sin(about_y), cos(about_z), sin(about_z)
    return [[cz * cy, -sz, cz * sy], [sz * cy, cz, sz * sy], [-sy, 0.0, cy]]


class _TurnedAxes:
    """Axes turned about z, then about the turned y, with their angular velocity and its bias acceleration."""

    def __init__(self, about_y: Any, about_z: Any, rate_y: Any, rate_z: Any, spin: v.Vector) -> None:
        self.rotation = turned_axes(about_y, about_z)
        self.columns = [[row[1] for row in self.rotation], v.unit(2)]
        after_z = v.add(spin, v.scale(rate_z, v.unit(2)))
        turn_y = v.scale(rate_y, self.columns[0])
        self.rate = v.add(after_z, turn_y)
        self.bias = v.add(v.cross(spin, v.scale(rate_z, v.unit(2))), v.cross(after_z, turn_y))
