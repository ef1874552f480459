"""Link frames that make the way from joint to joint short: z along the own axis, x across to the next axis.

Denavit-Hartenberg frames as in W. Khalil and J. Kleinfinger, "A new geometric notation for open and closed-loop
robots", IEEE ICRA 1986. Where a frame stands is a choice that no result shows; a way of two turns about one axis
each costs half of a general one: S. McMillan and D. Orin, "Efficient computation of articulated-body inertias using
successive axial screws", IEEE Trans. Robotics and Automation 11 (1995) 606-611.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, Node
from tmodes.frame import Placement
from tmodes.kinds.links.contract import Body
from tmodes.kinds.noted.functions import array, highest, hypot, largest, norm, number

__all__ = ["STRAIGHT", "Framing", "ScrewWay", "moved_body"]

Array = NDArray[np.float64]

_OBLIQUE = 0.2
"""Sine of the angle between two axes from which on the foot of their common normal is near enough to stand on it."""

_ROUNDING = 4e-15

STRAIGHT = (1.0, 0.0)
"""Cosine and sine of no turn."""


@dataclass(frozen=True)
class ScrewWay:
    """From the parent's tip to a joint: Rz(beta) T(lever) Rx(alpha) Tz(along) Rz(phase), and the joint turns about z.

    Angles as (cosine, sine), so that quarter turns are exact; ``lever`` (3,) and ``along`` [m]. What is zero is
    exactly zero.
    """

    beta: tuple[float, float]
    lever: tuple[float, float, float]
    alpha: tuple[float, float]
    along: float
    phase: tuple[float, float]

    @classmethod
    def of(cls, placement: Placement, *, heir: bool) -> ScrewWay:
        """Of the z axis at a placement; ``heir``: the parent's x axis stands across both axes, so beta is zero."""
        turn, place = placement.rotation, placement.position
        oblique, small = number(hypot(turn[0, 2], turn[1, 2])), _ROUNDING * (1 + number(highest(np.abs(place))))
        beta = STRAIGHT if heir or oblique <= _ROUNDING else _unit(-turn[1, 2], turn[0, 2])
        back = _about_z(beta).T
        turn, place = back @ turn, back @ place
        c, s = alpha = _unit(turn[2, 2], -turn[1, 2] if oblique > _ROUNDING else 0.0)
        phase = _unit(turn[0, 0], turn[1, 0] * c + turn[2, 0] * s)
        along = 0.0
        if heir:
            along = number(c * place[2] - s * place[1] if oblique > _OBLIQUE else place[2] / c)
        lever = place - along * np.array([0.0, -s, c])
        x, y, z = (0.0 if abs(part) <= small else number(part) for part in lever)
        return cls(beta, (x, y, z), alpha, 0.0 if abs(along) <= small else along, phase)

    def placement(self) -> Placement:
        """The way as one placement."""
        c, s = self.alpha
        tilt = np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
        first = Placement(_about_z(self.beta)) @ Placement(tilt, np.array(self.lever))
        return first @ Placement(_about_z(self.phase), np.array([0.0, 0.0, self.along]))


class Framing:
    """The same chain in other link frames: ``frames`` of each node as seen from its old one, and what stands in them.

    New frames have the rigid links of revolute joints; all others keep theirs. ``placements`` are those of the joint
    frames in their parents' tips; ``screws`` the short ways, None where one is not known beforehand or of another kind.
    """

    def __init__(self, chain: Chain) -> None:
        self.chain = chain
        self.heirs: dict[int, int] = {}
        for index, node in enumerate(chain.nodes):
            if _turns(node) and node.parent >= 0 and _turns(chain.nodes[node.parent]):
                self.heirs.setdefault(node.parent, index)
        self.frames = [self._frame(index, node) for index, node in enumerate(chain.nodes)]
        self._back = [frame.inverse() for frame in self.frames]
        self.placements = [self._placement(index) for index in range(len(chain.nodes))]
        self.screws = [self._screw(index) for index in range(len(chain.nodes))]

    def _frame(self, index: int, node: Node) -> Placement:
        if not _turns(node):
            return Placement()
        heir = self.chain.nodes[self.heirs[index]].joint if index in self.heirs else None
        if heir is None:
            return _standing(node.joint.axis, np.zeros(3), 0.0)
        place = heir.placement
        return _across(node.joint.axis, place.position, place.rotation @ heir.axis)

    def _placement(self, index: int) -> Placement:
        node = self.chain.nodes[index]
        placed = node.joint.placement @ self.frames[index]
        return self._back[node.parent] @ placed if node.parent >= 0 else placed

    def axis(self, index: int) -> Array:
        """Of a node's joint, in its joint frame."""
        node = self.chain.nodes[index]
        return np.array([0.0, 0.0, 1.0]) if _turns(node) else node.joint.axis

    def _screw(self, index: int) -> ScrewWay | None:
        node = self.chain.nodes[index]
        on_section = node.parent >= 0 and self.chain.nodes[node.parent].link.bends
        if not _turns(node) or on_section:
            return None
        return ScrewWay.of(self.placements[index], heir=self.heirs.get(node.parent) == index)

    def bodies(self, index: int, bodies: tuple[Body, ...]) -> tuple[Body, ...]:
        """Bodies in a node's frame."""
        return tuple(moved_body(body, self._back[index]) for body in bodies)

    def offset(self, index: int, offset: Placement) -> Placement:
        """A placement in a node's frame."""
        return self._back[index] @ offset


def moved_body(body: Body, placement: Placement) -> Body:
    """A body, seen from the frame in which its own frame stands as given."""
    turn = placement.rotation
    center = turn @ array(body.center) + placement.position
    return replace(body, center=center, inertia=turn @ body.inertia @ turn.T)


def _turns(node: Node) -> bool:
    return node.joint.kind.turns and not node.link.bends


def _unit(cosine: float, sine: float) -> tuple[float, float]:
    size = number(hypot(cosine, sine))
    return number(cosine) / size, number(sine) / size


def _cross(a: Array, b: Array) -> Array:
    """NumPy's own is made for many vectors, and takes ten times longer for two."""
    (x, y, z), (u, v, w) = a.tolist(), b.tolist()
    return np.array([y * w - z * v, z * u - x * w, x * v - y * u])


def _about_z(angle: tuple[float, float]) -> Array:
    c, s = angle
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _standing(axis: Array, across: Array, shift: float) -> Placement:
    """Axes with z along an axis, x along ``across`` (any where that is zero), moved along the axis."""
    across = across - (across @ axis) * axis
    if norm(across) == 0:
        across = np.eye(3)[(largest(axis) + 1) % 3]
        across = across - (across @ axis) * axis
    across = across / norm(across)
    return Placement(np.stack([across, _cross(axis, across), axis], axis=1), shift * axis)


def _across(axis: Array, place: Array, other: Array) -> Placement:
    """On the axis, x across to the axis ``other`` through ``place``; near the foot of the common normal."""
    normal = _cross(axis, other)
    sine, cosine, height = number(norm(normal)), number(axis @ other), number(place @ axis)
    if sine > _OBLIQUE:
        height += cosine * (cosine * height - number(place @ other)) / sine**2
    offset = place - (place @ axis) * axis
    near = number(norm(offset)) <= _ROUNDING * (1 + number(norm(place)))
    across = normal if sine > _ROUNDING else np.zeros(3) if near else offset
    return _standing(axis, across, height)
