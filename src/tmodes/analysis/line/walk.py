"""From the base to the tips for many samples: where every link's root and sections are, and how they accelerate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.segment import segment_line, segment_tip
from tmodes.analysis.line.strain import Sections, strain_motion
from tmodes.analysis.line.tables import LineTables
from tmodes.analysis.line.vectors import applied, back, cross
from tmodes.chain.chain import Joint, Link, Segment
from tmodes.model.model import Model

__all__ = ["Frame", "Walked", "info_places", "walk"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Frame:
    """A frame in the world: rotation (n, 3, 3), position, rate, angular acceleration, and acceleration less gravity."""

    rotation: Array
    position: Array
    rate: Array
    turning: Array
    acceleration: Array

    def inner(self) -> tuple[Array, Array, Array]:
        """Rate and accelerations in its own axes."""
        rate, turning, acceleration = (back(self.rotation, x) for x in (self.rate, self.turning, self.acceleration))
        return rate, turning, acceleration

    def outer(self, sections: Sections, k: int) -> Frame:
        """Section ``k`` of a link with its root here, in the world."""
        vectors = (applied(self.rotation, getattr(sections, name)[:, k]) for name in ("position", "rate", "turning",
                                                                                      "acceleration"))  # fmt: skip
        position, rate, turning, acceleration = vectors
        return Frame(self.rotation @ sections.rotation[:, k], self.position + position, rate, turning, acceleration)


@dataclass(frozen=True, eq=False)
class Walked:
    """A node: its root and tip in the world; of a link that bends, its line in the axes of its root.

    ``s`` (P,): the places told: the root, those asked, the model's stations, the tip; ``rotation`` (n, P, 3, 3) and
    ``position`` (n, P, 3) there; of a beam also the motion of these ``places`` and of its Gauss ``points``.
    """

    root: Frame
    tip: Frame
    s: Array
    rotation: Array
    position: Array
    points: Sections | None = None
    places: Sections | None = None


def info_places(asked: Array, stations: tuple[float, ...] = ()) -> Array:
    """All places of a link: root, those asked, stations, tip."""
    return np.concatenate([[0.0], asked, stations, [1.0]])


def walk(
    model: Model, tables: list[LineTables | None], asked: Array, q: Array, v: Array, a: Array, base: Array
) -> list[Walked]:
    """Every node of the arm at n samples; ``base`` (n, 24) as :class:`tmodes.model.model.Model` takes it."""
    found: list[Walked] = []
    start = _base(base)
    for part, table in zip(model.parts.nodes, tables, strict=True):
        before = found[part.node.parent].tip if part.node.parent >= 0 else start
        place = slice(part.angle, part.angle + part.size) if part.axes else slice(0)
        root = _jointed(part.node.joint, before, q[:, place], v[:, place], a[:, place])
        own = part.link.own if part.link else slice(0)
        found.append(_walked(part.node.link, table, asked, root, q[:, own], v[:, own], a[:, own]))
    return found


def _base(base: Array) -> Frame:
    rotation = base[:, 9:18].reshape(-1, 3, 3)
    turning, acceleration, rate = (applied(rotation, base[:, k : k + 3]) for k in (0, 3, 6))
    return Frame(rotation, base[:, 18:21], rate, turning, acceleration)


def _jointed(joint: Joint, before: Frame, q: Array, v: Array, a: Array) -> Frame:
    """The root of the link that a joint on ``before`` carries, at coordinates, rates and accelerations (n, k)."""
    n, numbers, moved = len(before.position), joint.numbers, (list(q.T), list(v.T))
    turned, shifted = joint.kind.place(moved[0], numbers)
    frame = before.rotation @ joint.placement.rotation
    rotation = frame @ _stacked([each for row in turned for each in row], n).reshape(n, 3, 3)
    arm = before.rotation @ joint.placement.position + applied(frame, _stacked(shifted, n))
    columns = [_stacked(each.packed(), n) for each in joint.kind.subspace(moved[0], numbers)]
    bias = _stacked(joint.kind.bias(*moved, numbers).packed(), n) if joint.moves else np.zeros((n, 6))
    speed = sum((v[:, k, None] * each for k, each in enumerate(columns)), np.zeros((n, 6)))
    gain = sum((a[:, k, None] * each for k, each in enumerate(columns)), bias)
    (turn, slide), (spin, push) = ((applied(rotation, x[:, :3]), applied(rotation, x[:, 3:])) for x in (speed, gain))
    turning = before.turning + spin + cross(before.rate, turn)
    extra = 2 * cross(before.rate, slide) + push
    moving = cross(before.turning, arm) + cross(before.rate, cross(before.rate, arm)) + extra
    return Frame(rotation, before.position + arm, before.rate + turn, turning, before.acceleration + moving)


def _stacked(entries: list[Any], count: int) -> Array:
    """(n, entries) of entries that are numbers or arrays (n,)."""
    return np.stack([np.broadcast_to(np.asarray(each, dtype=float), (count,)) for each in entries], axis=1)


def _walked(link: Link, table: LineTables | None, asked: Array, root: Frame, q: Array, v: Array, a: Array) -> Walked:
    if isinstance(link, Segment):
        s = info_places(asked)
        return Walked(root, root.outer(segment_tip(link, root.inner(), q, v, a), 0), s, *segment_line(link, q, s))
    if table is None:
        return Walked(root, root, np.zeros(0), np.zeros((len(q), 0, 3, 3)), np.zeros((len(q), 0, 3)))
    motion = strain_motion(table, root.inner(), q, v, a)
    places = motion.places
    return Walked(root, root.outer(places, -1), table.s, places.rotation, places.position, motion.points, places)
