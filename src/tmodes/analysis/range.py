"""How far the links of an arm bend, and whether the model chosen for each still holds there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.line.segment import planes, segment_line
from tmodes.chain.chain import Beam, Segment
from tmodes.equations.recursion.parts import LinkPart, NodePart
from tmodes.kinds.links.beam_functions import interval_integrals
from tmodes.kinds.links.beam_rule import beam_rule
from tmodes.model.model import Model

__all__ = ["LIMITS", "LinkRange", "bent", "link_angles", "link_ranges"]

Array = NDArray[np.float64]

LIMITS = {"segments": (0.1, 0.3), "strain": (1.0, 1.6)}
"""Angles [rad] up to which a model holds, and up to which it is a fair guess.

Segments: the chord's angle, whose sine is off by 0.2 % and 1.5 %. Strain: the angle between two points of the line,
where the series of the rotation are exact to 1e-15 and 1e-12.
"""

VERDICTS = ("good", "fair", "beyond the model")


@dataclass(frozen=True)
class LinkRange:
    """A flexible link in one pose.

    ``angle_rad``: the one that limits its ``model``; ``slope_rad``: by which its end has turned from the unbent link;
    ``deflection_m``: by which its end has moved, ``deflection_over_length``; ``verdict``: good, fair, beyond the model.
    """

    link: str
    model: str
    angle_rad: float
    slope_rad: float
    deflection_m: float
    deflection_over_length: float
    verdict: str


def link_angles(model: Model, q: ArrayLike) -> dict[str, Array]:
    """For each flexible link the angle [rad] that limits its model, at poses q (n, nq): arrays (n,)."""
    poses = np.atleast_2d(np.asarray(q, dtype=float))
    return {part.node.name: np.linalg.norm(_turns(part, poses), axis=2).max(axis=1) for part, _ in _bending(model)}


def link_ranges(model: Model, q: ArrayLike) -> list[LinkRange]:
    """The flexible links in the pose q (nq,)."""
    pose = np.asarray(q, dtype=float)
    angles = link_angles(model, pose)
    return [_range(part, pose, float(angles[part.node.name][0])) for part, _ in _bending(model)]


def _bending(model: Model) -> list[tuple[NodePart, LinkPart]]:
    return [(part, part.link) for part in model.parts.nodes if part.link]


def _kind(part: NodePart) -> str:
    return "segments" if isinstance(part.node.link, Segment) else "strain"


def _range(part: NodePart, pose: Array, angle: float) -> LinkRange:
    kind = _kind(part)
    ends = _end(part, pose), _end(part, np.zeros_like(pose))
    moved = float(np.linalg.norm(ends[0][1] - ends[1][1]))
    turned = ends[0][0] @ ends[1][0].T
    slope = float(np.arctan2(np.linalg.norm(turned - turned.T) / np.sqrt(8), (np.trace(turned) - 1) / 2))
    good, fair = LIMITS[kind]
    verdict = VERDICTS[int(angle > good) + int(angle > fair)]
    length = part.node.link.length  # pyright: ignore[reportAttributeAccessIssue]: a bending link has one
    return LinkRange(part.node.name, kind, angle, slope, moved, moved / length, verdict)


def _turns(part: NodePart, poses: Array) -> Array:
    """Rotation vectors over the intervals between the points of the line, shape (n, intervals, 3)."""
    link, shape = part.link, part.node.link
    assert link is not None  # noqa: S101
    own = poses[:, link.own]
    if isinstance(shape, Segment):
        angles = np.zeros((len(poses), 1, 3))
        angles[:, 0, 1:] = planes(shape, own)
        return angles
    assert isinstance(shape, Beam)  # noqa: S101
    return bent(shape, own, np.array([0.0, *beam_rule(shape).points, 1.0]))


def bent(beam: Beam, own: Array, edges: Array) -> Array:
    """Integral of twist and curvature about y and z [rad] over each interval, shape (n, intervals, 3).

    ``own``: the coordinates (n, names) of the link; ``edges`` (intervals + 1,): places along it in 0..1.
    """
    directions = np.repeat(np.arange(3), (beam.twist, beam.bend_y, beam.bend_z))
    alpha = interval_integrals(beam, edges[:-1], edges[1:])[0]
    turned = np.einsum("nj,ij,jc->nic", own[:, : len(directions)], alpha, np.eye(3)[directions])
    return turned + np.diff(edges)[:, None] * beam.length * np.asarray(beam.rest_curvature, dtype=float)


_PIECES = 200
"""Arcs of which the shape of a link is put together; only for what is told of its deflection."""


def _end(part: NodePart, pose: Array) -> tuple[Array, Array]:
    """Rotation (3, 3) and position (3,) of a link's end in its root's axes, by arcs of constant curvature."""
    from scipy.spatial.transform import Rotation

    link, shape = part.link, part.node.link
    assert link is not None  # noqa: S101
    own = pose[None, link.own]
    if isinstance(shape, Segment):
        turned, moved = segment_line(shape, own, np.ones(1))
        return turned[0, 0], moved[0, 0]
    assert isinstance(shape, Beam)  # noqa: S101
    turns = bent(shape, own, np.linspace(0.0, 1.0, _PIECES + 1))[0]
    steps, halves = (Rotation.from_rotvec(share * turns).as_matrix() for share in (1.0, 0.5))
    rotation, position = np.eye(3), np.zeros(3)
    for step, half in zip(steps, halves, strict=True):
        position = position + (rotation @ half)[:, 0] * shape.length / _PIECES
        rotation = rotation @ step
    return rotation, position
