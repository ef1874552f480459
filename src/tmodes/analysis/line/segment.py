"""Motion of the paper's mode as a link, for many samples, and the cubic line that it stands for."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.strain import Sections
from tmodes.analysis.line.vectors import about, applied, cross
from tmodes.chain.chain import Segment
from tmodes.paper.mode import shape_angle, shape_slope

__all__ = ["planes", "segment_line", "segment_tip"]

Array = NDArray[np.float64]

_Y, _Z = np.eye(3)[1], np.eye(3)[2]


def planes(segment: Segment, q: Array) -> Array:
    """(n, 2): the angles about y and z [rad] of coordinates (or their rates); 0 where it does not bend."""
    angles = np.zeros((len(q), 2))
    free = [k for k, bends in enumerate((segment.bend_y, segment.bend_z)) if bends]
    angles[:, free] = q
    return angles


def segment_tip(segment: Segment, root: tuple[Array, Array, Array], q: Array, v: Array, a: Array) -> Sections:
    """The section at the tip, (n, 1, ...), in the axes of the root; ``root`` as in ``strain_motion``."""
    rates, angles = [planes(segment, part) for part in (v, a)], planes(segment, q)
    chord, chord_rate, chord_turning = _turned(angles, rates[0], rates[1], root)
    rotation, rate, turning = _turned(1.5 * angles, 1.5 * rates[0], 1.5 * rates[1], root)
    place = segment.length * chord[..., 0]
    spin = cross(chord_rate, cross(chord_rate, place))
    moved = root[2] + cross(chord_turning, place) + spin
    return Sections(*(part[:, None] for part in (rotation, place, rate, turning, moved)))


def segment_line(segment: Segment, q: Array, s: Array) -> tuple[Array, Array]:
    """Rotation (n, S, 3, 3) and position (n, S, 3) [m] of the cubic line, in the axes of the root.

    Eq. (3) [derived]: the chord to the point s turns by (3 s - s^2)/2 th, the tangent by (3 s - 3 s^2/2) th, in both
    planes. {test_segment_line}
    """
    angles = planes(segment, q)
    chord = _axes(angles[:, None] * shape_angle(s)[:, None])
    return _axes(angles[:, None] * shape_slope(s)[:, None]), segment.length * s[:, None] * chord[..., 0]


def _axes(angles: Array) -> Array:
    """Rz Ry of (..., 2) angles about y and z."""
    return about(_Z, angles[..., 1]) @ about(_Y, angles[..., 0])


def _turned(angles: Array, rates: Array, gains: Array, root: tuple[Array, Array, Array]) -> tuple[Array, Array, Array]:
    """Axes turned about z, then about the turned y: rotation, rate, angular acceleration."""
    spin, turning, _ = root
    first = applied(about(_Z, angles[:, 1]), _Y)
    about_z, about_y = rates[:, 1:] * _Z, rates[:, :1] * first
    turned = turning + gains[:, 1:] * _Z + cross(spin, about_z) + gains[:, :1] * first + cross(spin + about_z, about_y)
    return _axes(angles), spin + about_z + about_y, turned
