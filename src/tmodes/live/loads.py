"""What a page must know of an arm to tell the loads along its links: how its parts hang together, and their numbers.

The page walks along the nodes and balances what moves outboard of each place, as :mod:`tmodes.analysis.line.line` does,
with the same tables. All numbers are in one vector, so that the map of the sliders finds what each of them changes.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.model_validity import yield_strength
from tmodes.chain.chain import Beam, Chain, Node
from tmodes.equations.loop.plan import LoadPlan, LoopPlan
from tmodes.equations.recursion.parts import NodePart, Parts, packed_bodies
from tmodes.kinds.joints.joint import Limits
from tmodes.live.line_tables import PLANAR_TERMS, TERMS, Interval, info_places, line_tables, pieces_at
from tmodes.sheet import Robot

__all__ = ["PackedLoads", "evenly", "joint_limits", "load_places", "packed_loads", "yield_strengths"]

Array = NDArray[np.float64]

_MOST_PLACES = 101
"""Places along each link at which a page looks for the largest loads; of more a part is taken."""

_ROUNDING = 1e-15

_STIFFNESS = ("bend_y", "bend_z", "axial", "torsion")


def evenly(count: int, most: int) -> NDArray[np.intp]:
    """At most so many of ``count`` places in a row, the first and the last among them."""
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(np.intp))


def load_places(line_points: int) -> Array:
    """Places along each link (0 root, 1 tip) at which loads are told: those of the result, or a part of them."""
    return np.linspace(0.0, 1.0, line_points)[evenly(line_points, _MOST_PLACES)]


@dataclass
class PackedLoads:
    """``layout``: plain data that says what is where in ``numbers``; see ``web/src/live/arm_loads.ts``."""

    layout: dict[str, Any] = field(default_factory=dict)
    _blocks: list[Array] = field(default_factory=list)
    _size: int = 0

    @property
    def numbers(self) -> Array:
        """All of them, in one vector."""
        return np.concatenate([np.zeros(0), *self._blocks])

    def put(self, *values: ArrayLike) -> int:
        """Where numbers begin that are added to the vector."""
        start = self._size
        for one in values:
            self._blocks.append(np.ravel(np.asarray(one, dtype=float)))
            self._size += self._blocks[-1].size
        return start


def packed_loads(plan: LoopPlan, parts: Parts, places: Array) -> PackedLoads:
    """Of a run's chain, with what pushes it, for the ``places`` (S,) along each link, its ends among them."""
    into = PackedLoads()
    touched = [plan.touch.point] if plan.touch else []
    pushed = sorted({load.point for load in plan.loads} | set(touched))
    into.layout = {
        "places": places,
        "nodes": [_node(into, part, places) for part in parts.nodes],
        "points": [_point(into, parts, index) for index in pushed],
        "loads": [_load(into, load, pushed.index(load.point)) for load in plan.loads],
        "touched": pushed.index(touched[0]) if touched else -1,
    }
    return into


def _node(into: PackedLoads, part: NodePart, places: Array) -> dict[str, Any]:
    node = part.node
    joint = node.joint
    return {
        "name": node.name, "parent": node.parent, "kind": str(joint.kind), "angle": part.angle,
        "joint": into.put(joint.placement.rotation, joint.placement.position, joint.axis),
        "tip": _bodies(into, node),
        "beam": _beam(into, part, node.link, places) if isinstance(node.link, Beam) else None,
    }  # fmt: skip


def _bodies(into: PackedLoads, node: Node, s: float | None = None) -> int:
    """Where the bodies at a station of a link, or at its tip, begin: mass, first moment, inertia; -1: none there."""
    bodies = node.link.bodies_at(1.0 if s is None else s)
    return into.put(packed_bodies(bodies)) if bodies else -1


def _point(into: PackedLoads, parts: Parts, index: int) -> dict[str, Any]:
    point = parts.points[index]
    station = parts.station(point)
    info = {"node": point.node, "station": -1 if station is None else station, "point": index}
    return info | {"offset": into.put(point.offset.position)}


def _load(into: PackedLoads, load: LoadPlan, place: int) -> dict[str, Any]:
    return {"place": place, "follower": load.follower, "signal": load.signal, "wrench": into.put(load.wrench)}


def _beam(into: PackedLoads, part: NodePart, beam: Beam, places: Array) -> dict[str, Any]:
    """Structure of a bending link; tables of its steps from section to section, and of the mass outboard of places."""
    assert part.link is not None  # noqa: S101
    stations = tuple(s for s, _ in part.link.stations)
    tables = line_tables(beam, stations, info_places(places, stations))
    shape, info, g = tables.own.shape, slice(1, 1 + len(places)), len(tables.own.points)
    before = np.searchsorted(places, stations, side="right") - 1
    sections = [kind for kind, _ in shape.breaks]
    edges = {name: [k + 1 for k, kind in enumerate(sections) if kind == name] for name in ("point", "station")}
    return {
        "first": part.link.first, "directions": [*shape.directions], "stretches": shape.stretch, "points": g,
        "rotary": shape.rotary, "terms": TERMS if shape.planar is None else PLANAR_TERMS, "edges": len(sections),
        "pointEdges": edges["point"],
        "stations": [
            {"edge": edge, "last": int(last), "body": _bodies(into, part.node, s)}
            for s, edge, last in zip(stations, edges["station"], before, strict=True)
        ],
        "march": _steps(into, tables.march), "reach": _steps(into, tables.reach, info),
        "before": tables.before[info].tolist(), "toPoints": into.put(tables.to_points),
        "toPlaces": into.put(tables.to_places[info]), "toEnds": into.put(tables.to_places[info.stop :]),
        "stretch": into.put(tables.stretch), "outboard": into.put(tables.outboard[info]),
        "levers": into.put(tables.levers[info][:, *np.triu_indices(g)]), "turning": into.put(tables.turning[info]),
        "length": into.put(beam.length), "stress": _stress(into, beam, places),
    }  # fmt: skip


def _steps(into: PackedLoads, steps: Interval, which: slice = slice(None)) -> int:
    """Rows of what each step turns: integrals of the functions, their moments, the unloaded line."""
    return into.put(np.concatenate([steps.alpha[which], steps.beta[which], steps.rest[which]], axis=1))


def _stress(into: PackedLoads, beam: Beam, places: Array) -> int:
    """Where the numbers of :func:`tmodes.analysis.line.stress.stress_of` begin; -1 where it tells nothing.

    Young's and shear modulus, outer fibres along y and z, stiffnesses at the places, 0 where they are infinite.
    """
    if not (beam.young > 0 and min(beam.outer) > 0):
        return -1
    stiffness = np.array([pieces_at(beam, name, places) for name in _STIFFNESS])
    return into.put([beam.young, beam.shear, *beam.outer], np.where(np.isfinite(stiffness), stiffness, 0.0))


def yield_strengths(arm: Robot, chain: Chain) -> dict[str, float]:
    """Yield strength [Pa] of each bending link of which it is known."""
    found = {node.name: yield_strength(arm, node.name) for node in chain.nodes if isinstance(node.link, Beam)}
    return {name: strength for name, strength in found.items() if strength is not None}


def joint_limits(arm: Robot, plan: LoopPlan, parts: Parts) -> list[dict[str, Any]]:
    """Limits of the joints, of which :func:`tmodes.report.facts_motion.arm_facts` tells the largest share.

    Where in coordinates and drives (-1: none) each joint is, with its units; what is not limited is None.
    """
    drives = [drive.joint for drive in plan.drives]
    sliding = plan.chain.sliding
    return [
        {
            "joint": joint.name, "coordinate": parts.names.index(joint.name),
            "drive": drives.index(joint.name) if joint.name in drives else -1,
            "unit": "m" if joint.name in sliding else "rad", "effortUnit": "N" if joint.name in sliding else "N m",
            "speed": joint.limits.speed, "effort": joint.limits.effort, "range": _range(joint.limits),
        }
        for joint in arm.joints
        if joint.limits and joint.name in parts.names
    ]  # fmt: skip


def _range(limits: Limits) -> list[float] | None:
    """Middle and half width of a range; None where there is none."""
    if limits.lower is None or limits.upper is None or limits.upper <= limits.lower + _ROUNDING:
        return None
    return [(limits.upper + limits.lower) / 2, (limits.upper - limits.lower) / 2]
