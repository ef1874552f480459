"""What every section carries, from the balance of all that is outboard of it: d'Alembert's forces and given wrenches.

Loads are told as the outboard part acts on the inboard one: tension is positive, and positive moments turn the tip
their way.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.strain import Sections
from tmodes.analysis.line.tables import LineTables
from tmodes.analysis.line.vectors import applied, back, cross
from tmodes.analysis.line.walk import Frame, Walked
from tmodes.chain.chain import Beam, Body, Node
from tmodes.model.model import Model

__all__ = ["Load", "NodeLoads", "node_loads"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Load:
    """A force [N] and its moment about a point [N*m], each (n, 3) or (n, S, 3)."""

    force: Array
    moment: Array

    def __add__(self, other: Load) -> Load:
        return Load(self.force + other.force, self.moment + other.moment)

    def moved(self, arm: Array) -> Load:
        """The same load about a point from which this one's is ``arm`` away."""
        return Load(self.force, self.moment + cross(arm, self.force))

    def turned(self, rotation: Array) -> Load:
        """In other axes: ``rotation`` times it."""
        return Load(applied(rotation, self.force), applied(rotation, self.moment))

    def inner(self, rotation: Array) -> Load:
        """In the axes that are the columns of ``rotation``."""
        return Load(back(rotation, self.force), back(rotation, self.moment))


@dataclass(frozen=True, eq=False)
class NodeLoads:
    """Loads of a node: ``root`` about its root, world axes; ``places`` (n, P, 3) about the places, in root axes."""

    root: Load
    places: Load


def node_loads(
    model: Model, tables: list[LineTables | None], walked: list[Walked], wrenches: Array | None
) -> list[NodeLoads]:
    """Loads of all nodes at all their places; ``wrenches`` (n, points, 6): force then moment, world axes."""
    nodes = model.chain.nodes
    nothing = np.zeros_like(walked[0].root.position)
    hung = [Load(nothing, nothing) for _ in nodes]
    found: dict[int, NodeLoads] = {}
    for index in reversed(range(len(nodes))):
        node, way = nodes[index], walked[index]
        tip = hung[index] + _fixed(_tip_bodies(node), way.tip) + _pushed(model, index, None, way.tip, wrenches)
        found[index] = _carried(model, index, tables[index], way, tip, wrenches)
        if node.parent >= 0:
            arm = way.root.position - walked[node.parent].tip.position
            hung[node.parent] = hung[node.parent] + found[index].root.moved(arm)
    return [found[index] for index in range(len(nodes))]


def _tip_bodies(node: Node) -> tuple[Body, ...]:
    return node.link.bodies_at(1.0)


def _fixed(bodies: tuple[Body, ...], frame: Frame) -> Load:
    """Weight and inertia of rigid bodies about the origin of the frame they are fixed to, world axes."""
    total = Load(np.zeros_like(frame.position), np.zeros_like(frame.position))
    for body in bodies:
        center = frame.rotation @ np.asarray(body.center, dtype=float)
        inertia = frame.rotation @ body.inertia @ frame.rotation.transpose(0, 2, 1)
        moved = cross(frame.turning, center) + cross(frame.rate, cross(frame.rate, center))
        force = -body.mass * (frame.acceleration + moved)
        spin = applied(inertia, frame.turning) + cross(frame.rate, applied(inertia, frame.rate))
        total = total + Load(force, cross(center, force) - spin)
    return total


def _pushed(model: Model, index: int, station: int | None, frame: Frame, wrenches: Array | None) -> Load:
    """Wrenches on the points of a node's tip, or of one of its stations, about it, world axes."""
    total = Load(np.zeros_like(frame.position), np.zeros_like(frame.position))
    if wrenches is None:
        return total
    for k, point in enumerate(model.parts.points):
        if point.node == index and model.parts.station(point) == station:
            arm = frame.rotation @ np.asarray(point.offset.position, dtype=float)
            total = total + Load(wrenches[:, k, :3], wrenches[:, k, 3:]).moved(arm)
    return total


def _carried(
    model: Model, index: int, table: LineTables | None, way: Walked, tip: Load, wrenches: Array | None
) -> NodeLoads:
    """From the load on a node's tip (world axes, about it) to all its places, and to its root."""
    if not len(way.s):
        return NodeLoads(tip, Load(way.position, way.position))
    single = [(len(way.s) - 1, tip), *_at_stations(model, index, way, wrenches)]
    total = Load(np.zeros_like(way.position), np.zeros_like(way.position))
    for place, load in single:
        own = load.inner(way.root.rotation)
        arm = way.position[:, place, None] - way.position
        counted = (way.s <= way.s[place])[:, None]
        total = total + Load(
            counted * own.force[:, None], counted * (own.moment[:, None] + cross(arm, own.force[:, None]))
        )
    if table is not None and way.points is not None:
        total = total + _spread(table, way.position, way.points)
    return NodeLoads(Load(total.force[:, 0], total.moment[:, 0]).turned(way.root.rotation), total)


def _at_stations(model: Model, index: int, way: Walked, wrenches: Array | None) -> list[tuple[int, Load]]:
    """Loads of bodies and wrenches at the stations of a beam: (place, load about it in world axes)."""
    link, node = model.parts.nodes[index].link, model.chain.nodes[index].link
    if link is None or way.places is None or not isinstance(node, Beam):
        return []
    first = len(way.s) - 1 - len(link.stations)
    found = []
    for number, (s, _) in enumerate(link.stations):
        frame = way.root.outer(way.places, first + number)
        bodies = tuple(body for at, body in node.bodies if at == s)
        found.append((first + number, _fixed(bodies, frame) + _pushed(model, index, number, frame, wrenches)))
    return found


def _spread(table: LineTables, position: Array, points: Sections) -> Load:
    """Weight and inertia of the beam's own mass outboard of each place, (n, P, 3), in root axes."""
    push = -points.acceleration
    count, g = len(push), push.shape[1]
    force = table.outboard @ push
    pairs = cross(points.position[:, :, None], push[:, None]).reshape(count, g * g, 3)
    moment = table.levers.reshape(-1, g * g) @ pairs - cross(position, force)
    for axis in range(table.turning.shape[1]):
        d = points.rotation[..., axis]
        rate, gain = ((d * x).sum(axis=-1, keepdims=True) for x in (points.rate, points.turning))
        moment = moment - table.turning[:, axis] @ (gain * d + rate * cross(points.rate, d))
    return Load(force, moment)
