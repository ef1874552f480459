"""The paper's mode as a link: a massless chord that turns, and a tip whose tangent turns half as much again (LMA)."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.spatial import Force
from tmodes.kinds.links.terms import Section

__all__ = ["segment_link", "turned_axes"]


def segment_link(bend_y: bool, bend_z: bool, length: Any, rate: Any, q: Any, qd: Any) -> list[Any]:
    """The packed section at the tip; coordinates: th about y where it bends there, then th about z.

    Eq. (6) [derived]: the chord is Rz(th_z) Ry(th_y) e_x, the tip's axes Rz(3/2 th_z) Ry(3/2 th_y). {test_segments}
    """
    angles = [q[k] for k in range(int(bend_y) + int(bend_z))]
    speeds = [qd[k] for k in range(len(angles))]
    spin = v.vec(rate)
    about_y, rate_y = (angles[0], speeds[0]) if bend_y else (0.0, 0.0)
    about_z, rate_z = (angles[-1], speeds[-1]) if bend_z else (0.0, 0.0)
    chord = _Turned(about_y, about_z, rate_y, rate_z, spin)
    tangent = _Turned(1.5 * about_y, 1.5 * about_z, 1.5 * rate_y, 1.5 * rate_z, spin)
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


class _Turned:
    """Axes turned about z, then about the turned y, with their angular velocity and its bias acceleration."""

    def __init__(self, about_y: Any, about_z: Any, rate_y: Any, rate_z: Any, spin: v.Vector) -> None:
        self.rotation = turned_axes(about_y, about_z)
        self.columns = [[row[1] for row in self.rotation], v.unit(2)]
        after_z = v.add(spin, v.scale(rate_z, v.unit(2)))
        turn_y = v.scale(rate_y, self.columns[0])
        self.rate = v.add(after_z, turn_y)
        self.bias = v.add(v.cross(spin, v.scale(rate_z, v.unit(2))), v.cross(after_z, turn_y))
