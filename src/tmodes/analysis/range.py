"""How far the links of an arm bend, and whether the model chosen for each still holds there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.line.line import LinkLine, elastic_line
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
    angles, unbent = link_angles(model, pose), pose.copy()
    unbent[model.deformations] = 0.0
    lines = elastic_line(model, np.stack([pose, unbent]), stations=[0.0, 1.0])
    return [_range(part, lines[part.node.name], float(angles[part.node.name][0])) for part, _ in _bending(model)]


def _bending(model: Model) -> list[tuple[NodePart, LinkPart]]:
    return [(part, part.link) for part in model.parts.nodes if part.link]


def _kind(part: NodePart) -> str:
    return "segments" if isinstance(part.node.link, Segment) else "strain"


def _range(part: NodePart, line: LinkLine, angle: float) -> LinkRange:
    """``line``: bent and unbent, its root and its tip."""
    kind, roots = _kind(part), line.rotation[:, 0].swapaxes(1, 2)
    bent_tip, tip = (roots @ (line.position[:, 1] - line.position[:, 0])[..., None])[..., 0]
    moved = float(np.linalg.norm(bent_tip - tip))
    bent_axes, axes = roots @ line.rotation[:, 1]
    turned = bent_axes @ axes.T
    slope = float(np.arctan2(np.linalg.norm(turned - turned.T) / np.sqrt(8), (np.trace(turned) - 1) / 2))
    good, fair = LIMITS[kind]
    verdict = VERDICTS[int(angle > good) + int(angle > fair)]
    return LinkRange(part.node.name, kind, angle, slope, moved, moved / line.length, verdict)


def _turns(part: NodePart, poses: Array) -> Array:
    """Rotation vectors over the intervals between the points of the line, shape (n, intervals, 3)."""
    link, shape = part.link, part.node.link
    assert link is not None  # noqa: S101
    own = poses[:, link.own]
    if isinstance(shape, Segment):
        angles = np.zeros((len(poses), 1, 3))
        angles[:, 0, [1 + k for k, bends in enumerate((shape.bend_y, shape.bend_z)) if bends]] = own
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
