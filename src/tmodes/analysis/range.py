"""How far the links of an arm bend, and whether the model chosen for each still holds there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.line.line import LinkLine, elastic_line
from tmodes.equations.recursion.parts import LinkPart, NodePart
from tmodes.model.model import Model

__all__ = ["LinkRange", "link_angles", "link_ranges"]

Array = NDArray[np.float64]

VERDICTS = ("good", "fair", "beyond the model")


@dataclass(frozen=True)
class LinkRange:
    """A flexible link in one pose.

    ``angle_rad``: the one that limits its ``model``; ``slope_rad``: by which its end has turned from the unbent link;
    ``deflection_m``: by which its end has moved, ``deflection_over_length``;
    ``verdict``: good, fair, beyond the model; ``cure``: what would help.
    """

    link: str
    model: str
    angle_rad: float
    slope_rad: float
    deflection_m: float
    deflection_over_length: float
    verdict: str
    cure: str = ""


def link_angles(model: Model, q: ArrayLike) -> dict[str, Array]:
    """For each flexible link the angle [rad] that limits its model, at poses q (n, nq): arrays (n,)."""
    poses = np.atleast_2d(np.asarray(q, dtype=float))
    return {part.node.name: part.node.link.limiting_angles(poses[:, link.own]) for part, link in _bending(model)}


def link_ranges(model: Model, q: ArrayLike) -> list[LinkRange]:
    """The flexible links in the pose q (nq,)."""
    pose = np.asarray(q, dtype=float)
    angles, unbent = link_angles(model, pose), pose.copy()
    unbent[model.deformations] = 0.0
    lines = elastic_line(model, np.stack([pose, unbent]), stations=[0.0, 1.0])
    of = {
        index: [line for line in lines.links.values() if line.node == index] for index in range(len(model.chain.nodes))
    }
    found = [(index, part) for index, part in enumerate(model.parts.nodes) if part.link]
    return [_range(part, of[index], float(angles[part.node.name][0])) for index, part in found]


def _bending(model: Model) -> list[tuple[NodePart, LinkPart]]:
    return [(part, part.link) for part in model.parts.nodes if part.link]


def _range(part: NodePart, lines: list[LinkLine], angle: float) -> LinkRange:
    """``lines`` of the link from root to tip: bent and unbent, the ends of each."""
    link, first, last = part.node.link, lines[0], lines[-1]
    roots = first.rotation[:, 0].swapaxes(1, 2)
    bent_tip, tip = (roots @ (last.position[:, 1] - first.position[:, 0])[..., None])[..., 0]
    moved = float(np.linalg.norm(bent_tip - tip))
    bent_axes, axes = roots @ last.rotation[:, 1]
    turned = bent_axes @ axes.T
    slope = float(np.arctan2(np.linalg.norm(turned - turned.T) / np.sqrt(8), (np.trace(turned) - 1) / 2))
    limit = link.angle_limit
    verdict = VERDICTS[int(angle > limit.good) + int(angle > limit.fair)]
    share = moved / link.length
    return LinkRange(part.node.name, link.kind, angle, slope, moved, share, verdict, limit.cure)
