"""How a link bends: deflection, slope, curvature, twist and stretch, and the moments that its material answers with."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.segment import planes
from tmodes.analysis.line.tables import LineTables, pieces_at
from tmodes.chain.chain import Segment
from tmodes.paper.mode import shape_slope

__all__ = ["Shape", "beam_shape", "segment_shape"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Shape:
    """n samples, S places. ``deflection`` (n, S, 2) [m] along y and z of the root, off its tangent; ``slope`` (n, S, 2)
    [rad]: angle of the tangent against the root's, seen in its x-y and x-z planes.

    ``curvature`` (n, S, 2) [1/m] about y and z and ``twist`` (n, S) [rad/m] in section axes, with those of the unloaded
    line; ``stretch`` (n, S) [-]. ``elastic_moment`` (n, S, 3) [N*m]: torsion, about y, about z, as curvature and its
    rate ask of the material, EI (kappa + eta kappa'); ``elastic_force`` (n, S) [N] likewise of the stretch.
    """  # noqa: D205

    deflection: Array
    slope: Array
    curvature: Array
    twist: Array
    stretch: Array
    elastic_moment: Array
    elastic_force: Array


def beam_shape(table: LineTables, info: slice, rotation: Array, position: Array, q: Array, v: Array) -> Shape:
    """Of a strain link, at the places ``told`` of its table."""
    beam, turns = table.beam, table.own.shape.turning
    values = table.functions[info]
    bent, speed = (_by_component(table, values, part) for part in (q, v))
    stretch, lengthening = (part[:, turns:] @ values[:, turns:].T for part in (q, v))
    answered = bent + beam.damping_time * speed
    stiffness = [pieces_at(beam, name, table.s[info]) for name in ("torsion", "bend_y", "bend_z", "axial")]
    rigid = [count == 0 for count in (beam.twist, beam.bend_y, beam.bend_z, beam.stretch)]
    finite = [np.zeros_like(k) if none else k for k, none in zip(stiffness, rigid, strict=True)]
    total = bent + np.asarray(beam.rest_curvature, dtype=float)
    return Shape(
        position[..., 1:], _slopes(rotation), total[..., 1:], total[..., 0], stretch,
        answered * np.stack(finite[:3], axis=-1), (stretch + beam.damping_time * lengthening) * finite[3],
    )  # fmt: skip


def _by_component(table: LineTables, values: Array, part: Array) -> Array:
    """(n, S, 3): twist and curvatures of coordinates (n, size)."""
    turns = table.own.shape.turning
    return np.einsum("nj,sj,jc->nsc", part[:, :turns], values[:, :turns], table.directions)


def _slopes(rotation: Array) -> Array:
    tangent = rotation[..., 0]
    return np.arctan2(tangent[..., 1:], tangent[..., :1])


def segment_shape(segment: Segment, s: Array, position: Array, q: Array, v: Array) -> Shape:
    """Of the paper's mode: the cubic of a tip force, curvature 3 th/l (1 - s), moment (Cs th + Bs th') l^2 (1 - s)."""
    angles, rates = planes(segment, q), planes(segment, v)
    left = (1 - s)[:, None]
    lever = segment.length**2
    stiffness = lever * np.array([segment.stiffness_y, segment.stiffness_z])
    damping = lever * np.array([segment.damping_y, segment.damping_z])
    moment = (stiffness * angles + damping * rates)[:, None] * left
    none = np.zeros((len(q), len(s)))
    return Shape(
        position[..., 1:], _segment_slopes(angles, s), 3 * angles[:, None] / segment.length * left, none, none,
        np.concatenate([none[..., None], moment], axis=-1), none,
    )  # fmt: skip


def _segment_slopes(angles: Array, s: Array) -> Array:
    """In the x-y plane by the angle about z; in the x-z plane against the angle about y."""
    return np.stack([angles[:, 1:] * shape_slope(s), -angles[:, :1] * shape_slope(s)], axis=-1)
