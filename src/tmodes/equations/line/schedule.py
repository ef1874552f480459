"""The schedule of the elastic lines: inverse dynamics from the base to the tips and back, then the places of each link.

What a link carries at its tip and how its root moves are those of the recursion, whatever joints and bodies there are;
a kind of bending link adds the calls for its own places, see :class:`tmodes.kinds.links.line.LineOfLink`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.recursion.forces import ForceBalance, balance
from tmodes.equations.recursion.link_kernels import body_kernel, times_kernel
from tmodes.equations.recursion.parts import NodePart, Parts
from tmodes.equations.recursion.passes import Blocks, Passes
from tmodes.frame import Placement
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Numbers, Schedule, Slot, kernel
from tmodes.kinds.kernel.spatial import FORCE, Force
from tmodes.kinds.links.line import POSE, LineOfLink, Moved
from tmodes.kinds.noted.functions import array, norm

__all__ = ["MOVING", "RIGID", "ROOTS", "Lines", "line_schedule", "moved_link"]

Array = NDArray[np.float64]

Drawn = Callable[[Blocks], dict[str, Slot]]

ROOTS = " roots"
"""Name of an output that no link has."""

RIGID = {"rotation": slice(0, 9), "position": slice(9, 12), "end": slice(12, 15)}
"""What is computed of a rigid link, in the world: its axes, and where it begins and ends."""

MOVING = {"place": slice(15, 18), "rate": slice(18, 21), "turning": slice(21, 24), "acceleration": slice(24, 27)}
"""And of one whose mass along it is known: a place of it, angular rate and acceleration, and that of the place less
gravity."""


@dataclass(frozen=True, eq=False)
class Lines:
    """``schedule``: (q, v, base, wrenches, a) -> an output for each line by its name, all places one after the other,
    and ``ROOTS`` (6 each: force, moment about the node's root, in the world, by what it carries on what holds it).

    ``numbers``: its parameters, which begin with those of the chain; ``links``: the lines of each node, none of a rigid
    one, whose output is :data:`RIGID`; ``ends``: where rigid links end, in their own frames; ``drawn``: names of more
    straight lines, whose output is :data:`RIGID` too.
    """  # noqa: D205

    schedule: Schedule
    numbers: Array
    links: tuple[tuple[LineOfLink, ...], ...]
    ends: tuple[Array, ...]
    drawn: tuple[str, ...] = ()


def line_schedule(parts: Parts, s: Array, drawn: Drawn, *, loaded: bool = False) -> Lines:
    """The lines at the places ``s`` (S,) along each link; ``loaded``: forces act on the points.

    ``drawn`` adds further lines, see :meth:`tmodes.equations.mechanics.RecursiveMechanics.drawn`.
    """
    way = Passes(parts, posed=True, loaded=loaded)
    way.take_wrenches(loaded=loaded)
    found = balance(way, way.schedule.input("a", parts.size))
    numbers = Numbers(parts.numbers.size)
    links: list[tuple[LineOfLink, ...]] = []
    ends: list[Array] = []
    roots: list[Slot] = []
    for index, part in enumerate(parts.nodes):
        stations = tuple(station for station, _ in part.link.stations) if part.link else ()
        lines = tuple(part.node.link.lines(stations, s)) if part.link else ()
        moved = moved_link(way, found, numbers, index) if part.link else None
        for line in lines:
            assert moved is not None  # noqa: S101
            way.schedule.output(part.node.name + line.suffix, *line.places(moved))
        end = np.zeros(3) if lines else _far_end(parts, index)
        if not lines:
            moving = _moving(way, found, index) if part.node.link.mass_line is not None else ()
            way.schedule.output(part.node.name, *_rigid(way, numbers, index, end), *moving)
        roots.append(_root(way, found, numbers, index))
        links.append(lines)
        ends.append(end)
    further = drawn(Blocks(way.schedule, way.q, way.v, way.base))
    for name, line in further.items():
        way.schedule.output(name, line)
    way.schedule.output(ROOTS, *roots)
    way.schedule.parameters = numbers.size
    return Lines(way.schedule, np.concatenate([parts.numbers.vector, numbers.vector]), tuple(links), tuple(ends),
                 tuple(further))  # fmt: skip


def moved_link(way: Passes, found: ForceBalance, numbers: Numbers, index: int) -> Moved:
    """A bending link as its lines take it."""
    part, here = way.parts.nodes[index], way.ways[index]
    link = part.link
    assert link is not None  # noqa: S101
    assert here.root_pose is not None  # noqa: S101
    assert here.tip is not None  # noqa: S101
    q, rates, a = (way.bend(link, block) for block in (way.q, way.v, found.a))
    return Moved(
        way.schedule.call, numbers, link.tables, link.stiffness, link.damping, q, rates, a, here.root_pose,
        here.root_rate, found.roots[index], here.tip, _outer(way, found, index), found.forces[index],
    )  # fmt: skip


def _outer(way: Passes, found: ForceBalance, index: int) -> list[Slot]:
    """Force that bodies and points need from each station on, then that of the tip alone, about the link's root."""
    part, here, call = way.parts.nodes[index], way.ways[index], way.schedule.call
    assert part.link is not None  # noqa: S101
    assert here.tip is not None  # noqa: S101
    (total,) = call(_outer_kernel(), found.loads[index], here.tip.part(9, 3), way.none[FORCE])
    carried = [total]
    for number in reversed(range(len(here.sections))):
        section = here.sections[number]
        (total,) = call(_outer_kernel(), _single(way, found, index, number), section.part(9, 3), total)
        carried.insert(0, total)
    return carried


def _single(way: Passes, found: ForceBalance, index: int, number: int) -> Slot:
    """Force that the body and the points at a station need, about it, in the link's axes."""
    part, here, call = way.parts.nodes[index], way.ways[index], way.schedule.call
    assert part.link is not None  # noqa: S101
    section, body = here.sections[number], part.link.stations[number][1]
    inertia, bias = way.none[21], way.none[FORCE]
    if body:
        inertia, bias = call(body_kernel(on_section=True), body, way.frame(section), section.part(12, 3))
    for k in way.wrenches:
        point = way.parts.points[k]
        if point.node == index and way.parts.station(point) == number:
            bias = way.pushed(k, here, section, bias)
    (motion,) = call(part.link.kernels.motion(), found.roots[index], section, way.bend(part.link, found.a))
    return call(times_kernel(), inertia, motion, bias)[0]


@kernel("line outer", (FORCE, 3, FORCE), (FORCE,))
def _outer_kernel(force: Any, place: Any, total: Any) -> list[list[Any]]:
    """(force at a section, place of the section, force about the root) -> both about the root."""
    return [(Force.of(total) + Force.of(force).force_at(v.vec(place))).packed()]


def _root(way: Passes, found: ForceBalance, numbers: Numbers, index: int) -> Slot:
    """The load of a node's root."""
    pose, origin = way.ways[index].root_pose, way.parts.framing.offset(index, Placement()).position
    assert pose is not None  # noqa: S101
    return way.schedule.call(_root_kernel(), pose, numbers.block(origin), found.forces[index])[0]


@kernel("line root", (POSE, 3, FORCE), (FORCE,))
def _root_kernel(pose: Any, origin: Any, force: Any) -> list[list[Any]]:
    """(pose, place of the node's root in it, force that it needs) -> the load there, in the world."""
    world, needed = v.tri(pose), Force.of(force)
    about = v.sub(needed.angular, v.cross(v.vec(origin), needed.linear))
    return [v.scale(-1.0, v.matvec(world, needed.linear)) + v.scale(-1.0, v.matvec(world, about))]


def _rigid(way: Passes, numbers: Numbers, index: int, end: Array) -> Sequence[Slot]:
    """A rigid link in the axes of its own frame, which is not always that of the recursion."""
    pose, framing = way.ways[index].root_pose, way.parts.framing
    assert pose is not None  # noqa: S101
    start = framing.offset(index, Placement())
    far = framing.offset(index, Placement(position=end)).position
    block = numbers.block([*start.rotation.ravel(), *start.position])
    return way.schedule.call(_rigid_kernel(), pose, block, numbers.block(far))


def _moving(way: Passes, found: ForceBalance, index: int) -> Sequence[Slot]:
    here = way.ways[index]
    assert here.root_pose is not None  # noqa: S101
    return way.schedule.call(_moving_kernel(), here.root_pose, here.root_rate, found.roots[index])


@kernel("line moving", (POSE, 3, FORCE), (12,))
def _moving_kernel(pose: Any, rate: Any, acceleration: Any) -> list[list[Any]]:
    """(pose, angular rate, acceleration less gravity in its axes) -> place, rate and accelerations in the world."""
    world = v.tri(pose)
    vectors = [v.vec(rate), v.vec(acceleration), v.vec(acceleration, 3)]
    return [v.flat(v.vec(pose, 9), [v.matvec(world, vector) for vector in vectors])]


@kernel("line rigid", (POSE, 12, 3), (15,))
def _rigid_kernel(pose: Any, start: Any, far: Any) -> list[list[Any]]:
    """(pose, placement of the link's frame in it, its far end) -> axes of the link, and both of its ends."""
    world, place = v.tri(pose), v.vec(pose, 9)
    ends = [v.add(place, v.matvec(world, arm)) for arm in (v.vec(start, 9), v.vec(far))]
    return [v.flat(v.matmul(world, v.tri(start)), ends)]


def _far_end(parts: Parts, index: int) -> Array:
    """The farthest thing on a rigid link in its frame: a joint, else a point, else a center of mass."""
    nodes: Sequence[NodePart] = parts.nodes
    link = nodes[index].node.link
    joints = [other.node.joint.placement.position for other in nodes if other.node.parent == index]
    points = [point.offset.position for point in parts.points if point.node == index]
    bodies = [body.center for body in link.bodies_at(1.0)]
    for places in (joints, points, bodies):
        if places:
            return array(max(places, key=norm))
    return np.zeros(3)
