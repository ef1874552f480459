"""Forces of inertia and gravity for given accelerations: inverse dynamics, and motion of the named points."""

from __future__ import annotations

from tmodes.equations.recursion.body_kernels import body_moment_kernel, point_kernel, times_kernel
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import Passes
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["inertia_forces"]


def inertia_forces(parts: Parts, *, loaded: bool = False) -> Schedule:
    """(q, v, base, wrenches, a) -> forces of inertia and gravity along the coordinates, less the wrenches.

    Further outputs: ``base_force`` (6: moment, force, in base axes), ``points`` (pose 15, rate 3, acceleration 6 each),
    ``moment`` (3: sum of mass times position). Rotors are left out: they are a diagonal of numbers.
    """
    way = Passes(parts, posed=True, loaded=loaded)
    way.take_wrenches()
    schedule = way.schedule
    a = schedule.input("a", parts.size)
    way.outwards()
    roots, tips = _accelerations(way, a)
    _points(way, a, roots, tips)
    _moment(way)
    loads: list[Slot] = []
    for index, tip in enumerate(tips):
        inertia, bias = way.load_of_tip(index)
        loads.append(schedule.call(times_kernel(), inertia, tip, bias)[0])
    joints: dict[int, Slot] = {}
    links: dict[int, Slot] = {}
    at_base = way.none[FORCE]
    for index in reversed(range(len(parts.nodes))):
        part, found = parts.nodes[index], way.ways[index]
        force = loads[index]
        if part.link and found.tip:
            terms = way.terms_with_stations(index)
            blocks = (terms, found.tip, roots[index], way.bend(part.link, a), force)
            force, links[part.link.first] = schedule.call(part.link.kernels.load(), *blocks)
        parent = part.node.parent
        total = loads[parent] if parent >= 0 else at_base
        total, along = schedule.call(part.hinge.load(), force, found.hinge, found.axis, total)
        joints |= {axis.angle: along.part(axis.place, 1) for axis in part.axes}
        if parent >= 0:
            loads[parent] = total
        else:
            at_base = total
    schedule.output("forces", *way.by_coordinate({}, joints, links))
    schedule.output("base_force", at_base)
    return schedule


def _accelerations(way: Passes, a: Slot) -> tuple[list[Slot], list[Slot]]:
    """Accelerations of the roots and of the tips when all coordinates accelerate as given."""
    roots: list[Slot] = []
    tips: list[Slot] = []
    for part, found in zip(way.parts.nodes, way.ways, strict=True):
        before = tips[part.node.parent] if part.node.parent >= 0 else way.base.part(0, FORCE)
        given = a.part(part.angle, part.size) if part.axes else way.none[1]
        hinge = part.hinge.as_driven()
        root, _ = way.schedule.call(hinge.onward(), before, found.hinge, found.axis, way.none[hinge.held], given)
        roots.append(root)
        if part.link and found.tip:
            (root,) = way.schedule.call(part.link.kernels.motion(), root, found.tip, way.bend(part.link, a))
        tips.append(root)
    return roots, tips


def _points(way: Passes, a: Slot, roots: list[Slot], tips: list[Slot]) -> None:
    """Pose, rate and acceleration of each named point."""
    info: list[Slot] = []
    for point, offset in zip(way.parts.points, way.parts.offsets, strict=True):
        found, link = way.ways[point.node], way.parts.nodes[point.node].link
        number = way.parts.station(point)
        pose, section, motion = found.tip_pose, found.tip, tips[point.node]
        if number is not None and link:
            pose, section = found.section_poses[number], found.sections[number]
            (motion,) = way.schedule.call(link.kernels.motion(), roots[point.node], section, way.bend(link, a))
        assert pose is not None  # noqa: S101
        rate = section.part(12, 3) if section else found.tip_rate
        kernel = point_kernel(on_section=section is not None)
        info += way.schedule.call(kernel, pose, way.frame(section), rate, motion, offset)
    way.schedule.output("points", *info)


def _moment(way: Passes) -> None:
    """Sum of mass times position, for the potential of gravity."""
    total = way.none[3]
    for part, found in zip(way.parts.nodes, way.ways, strict=True):
        if part.link and part.link.kernels.kind.own_terms and found.root_pose:
            terms = found.terms
            assert terms is not None  # noqa: S101
            for section, (_, body) in zip(found.sections, part.link.stations, strict=True):
                if body:
                    blocks = (terms, section, body, way.none[FORCE])
                    (terms,) = way.schedule.call(part.link.kernels.station_load(), *blocks)
            (total,) = way.schedule.call(part.link.kernels.moment(), terms, found.root_pose, total)
        if part.tip_body and found.tip_pose:
            (total,) = way.schedule.call(body_moment_kernel(), part.tip_body, found.tip_pose, total)
    way.schedule.output("moment", total)
