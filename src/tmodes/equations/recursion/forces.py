"""Forces for a given motion: of inertia and gravity (inverse dynamics), of springs, dampers and friction."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from tmodes.equations.recursion.driven import Coordinates
from tmodes.equations.recursion.link_kernels import body_moment_kernel, point_kernel, times_kernel
from tmodes.equations.recursion.parts import LinkPart, Parts
from tmodes.equations.recursion.passes import Passes
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.kinds.kernel.spatial import FORCE

__all__ = [
    "ForceBalance",
    "balance",
    "elastic_forces",
    "elastic_of_drives",
    "inertia_forces",
    "joint_reactions",
    "point_motion",
]


def inertia_forces(way: Passes, a: Slot) -> dict[str, list[Slot]]:
    """Forces of inertia and gravity along the coordinates, less the wrenches, for accelerations ``a``.

    ``forces``; ``base_force`` (6: moment, force, in base axes), ``points`` (pose 15, rate 3, acceleration 6 each),
    ``moment`` (3: sum of mass times position). Rotors are left out: they are a diagonal of numbers.
    """
    found = balance(way, a)
    motions = [
        point_motion(way, k, found.roots, found.tips, lambda link: way.bend(link, found.a))
        for k in range(len(way.parts.points))
    ]
    return {
        "points": [slot for motion in motions for slot in motion],
        "moment": [_moment(way)],
        "forces": way.by_coordinate({}, found.joints, found.links),
        "base_force": [found.at_base],
    }


def joint_reactions(parts: Parts, *, loaded: bool = False) -> Schedule:
    """(q, v, base, wrenches, a) -> what each joint carries: ``reactions`` (6: moment, force) on each node's root.

    By what holds it, in the axes of the root and about it, whose ``poses`` (15) in the world come with them;
    ``base_force`` is that on the base of all branches together.
    """
    way = Passes(parts, posed=True, loaded=loaded)
    way.take_wrenches(loaded=loaded)
    found = balance(way, way.schedule.input("a", parts.size))
    nodes = range(len(parts.nodes))
    way.schedule.output("reactions", *(found.forces[index] for index in nodes))
    way.schedule.output("poses", *(pose for here in way.ways if (pose := here.root_pose)))
    way.schedule.output("base_force", found.at_base)
    return way.schedule


@dataclass
class ForceBalance:
    """Motion and forces that the accelerations ``a`` need, by index of the node, in the axes of its link.

    ``roots`` and ``tips``: accelerations less gravity; ``loads``: force on the tip by what moves with it and
    outboard of it; ``forces``: that on the root. ``joints`` and ``links``: forces along their coordinates, by the index
    of the first of them.
    """

    a: Slot
    at_base: Slot
    roots: list[Slot] = field(default_factory=list)
    tips: list[Slot] = field(default_factory=list)
    loads: list[Slot] = field(default_factory=list)
    forces: dict[int, Slot] = field(default_factory=dict)
    joints: dict[int, Slot] = field(default_factory=dict)
    links: dict[int, Slot] = field(default_factory=dict)


def balance(way: Passes, a: Slot) -> ForceBalance:
    """The calls of inverse dynamics, outwards and back, added to the schedule of ``way``."""
    way.outwards()
    found, schedule, parts = ForceBalance(a, way.none[FORCE]), way.schedule, way.parts
    _accelerations(way, found)
    for index, tip in enumerate(found.tips):
        inertia, bias = way.load_of_tip(index)
        found.loads.append(schedule.call(times_kernel(), inertia, tip, bias)[0])
    for index in reversed(range(len(parts.nodes))):
        part, here = parts.nodes[index], way.ways[index]
        force = found.loads[index]
        if part.link and here.tip:
            terms = way.terms_with_stations(index)
            blocks = (terms, here.tip, found.roots[index], way.bend(part.link, a), force)
            force, found.links[part.link.first] = schedule.call(part.link.kernels.load(), *blocks)
        found.forces[index] = force
        parent = part.node.parent
        total = found.loads[parent] if parent >= 0 else found.at_base
        total, along = schedule.call(part.hinge.load(), force, here.hinge, here.axis, total)
        found.joints |= {axis.angle: along.part(axis.place, 1) for axis in part.axes}
        if parent >= 0:
            found.loads[parent] = total
        else:
            found.at_base = total
    return found


def _accelerations(way: Passes, found: ForceBalance) -> None:
    """Accelerations of the roots and of the tips when all coordinates accelerate as given."""
    a = found.a
    for part, here in zip(way.parts.nodes, way.ways, strict=True):
        before = found.tips[part.node.parent] if part.node.parent >= 0 else way.base.part(0, FORCE)
        given = a.part(part.angle, part.size) if part.axes else way.none[1]
        hinge = part.hinge.as_driven()
        root, _ = way.schedule.call(hinge.onward(), before, here.hinge, here.axis, way.none[hinge.held], given)
        found.roots.append(root)
        if part.link and here.tip:
            (root,) = way.schedule.call(part.link.kernels.motion(), root, here.tip, way.bend(part.link, a))
        found.tips.append(root)


def point_motion(
    way: Passes, k: int, roots: list[Slot], tips: list[Slot], own: Callable[[LinkPart], Slot]
) -> tuple[Slot, ...]:
    """Pose, rate and acceleration of a point, from accelerations of link ends and of their ``own`` coordinates."""
    point = way.parts.points[k]
    here, link, number = way.ways[point.node], way.parts.nodes[point.node].link, way.parts.station(point)
    pose, section, motion = here.tip_pose, here.tip, tips[point.node]
    if number is not None and link:
        pose, section = here.section_poses[number], here.sections[number]
        (motion,) = way.schedule.call(link.kernels.motion(), roots[point.node], section, own(link))
    assert pose is not None  # noqa: S101
    rate = section.part(12, 3) if section else here.tip_rate
    kernel = point_kernel(on_section=section is not None)
    return way.schedule.call(kernel, pose, way.frame(section), rate, motion, way.parts.offsets[k])


def _moment(way: Passes) -> Slot:
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
    return total


def elastic_forces(way: Passes) -> dict[str, list[Slot]]:
    """Forces of springs, dampers and friction along the coordinates, as on the left side of the equations.

    ``forces``; ``energies`` (gear, link) and ``losses`` (gear damping, friction, link damping) of each coordinate
    of a joint and of each link, in the order of the nodes.
    """
    parts = way.parts
    bent = {index: way.elastic(part.link) for index, part in enumerate(parts.nodes) if part.link}
    motors, joints, energies, losses = elastic_of_drives(way, {index: found[1:] for index, found in bent.items()})
    links = {link.first: bent[index][0] for index, part in enumerate(parts.nodes) if (link := part.link)}
    return {"forces": way.by_coordinate(motors, joints, links), "energies": energies, "losses": losses}


def elastic_of_drives(
    way: Coordinates, links: Mapping[int, tuple[Slot, ...]] | None = None
) -> tuple[dict[int, Slot], dict[int, Slot], list[Slot], list[Slot]]:
    """Forces on motors and on joints by coordinate, and energies and losses of the nodes.

    ``links``: energy and loss of the link of each node that bends.
    """
    parts, schedule, none = way.parts, way.schedule, way.none[1]
    motors: dict[int, Slot] = {}
    joints: dict[int, Slot] = {}
    energies: list[Slot] = []
    losses: list[Slot] = []
    coupled = way.coupled_inputs()
    torques: dict[int, Slot] = {}
    for index, part in enumerate(parts.nodes):
        for axis in part.axes:
            energy, lost = none, way.none[3].part(0, 2)
            if axis.motor in coupled and axis.drive and axis.drive_numbers:
                blocks = (axis.drive_numbers, *coupled[axis.motor], *way.angle(axis))
                joints[axis.angle], energy, lost = schedule.call(axis.drive.coupled_elastic(), *blocks)
                torques[axis.motor] = schedule.call(axis.drive.coupled(), *blocks, way.sides(axis))[1]
            elif axis.drive and axis.drive_numbers:
                blocks = (axis.drive_numbers, *way.motor(axis), *way.angle(axis))
                forces, energy, lost = schedule.call(axis.drive.elastic(), *blocks)
                joints[axis.angle] = forces.part(0, 1)
                motors[axis.motor] = forces.part(1, 1)
            energies += [energy, none]
            losses += [lost, none]
        if links and index in links:
            bend_energy, bend_lost = links[index]
            energies += [none, bend_energy]
            losses += [way.none[3].part(0, 2), bend_lost]
    losses += _coupled_motors(way, torques, motors)
    return motors, joints, energies, losses


def _coupled_motors(way: Coordinates, torques: dict[int, Slot], motors: dict[int, Slot]) -> list[Slot]:
    """Forces on coupled motors, put among ``motors``; the friction they lose, as losses of further parts."""
    loads = way.coupled_loads(torques)
    lost: list[Slot] = []
    for axis in way.parts.axes:
        if axis.motor in loads and axis.drive and axis.drive_numbers:
            blocks = (axis.drive_numbers, way.motor(axis)[1], way.none[1], loads[axis.motor], way.sides(axis))
            _, motors[axis.motor], friction = way.schedule.call(axis.drive.coupled_motor(), *blocks)
            lost += [way.none[1], friction, way.none[1]]
    return lost
