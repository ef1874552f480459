"""Forces of springs, dampers and friction, their energies and losses."""

from __future__ import annotations

from collections.abc import Mapping

from tmodes.equations.recursion.coordinates import Coordinates
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import Passes
from tmodes.kinds.kernel.schedule import Schedule, Slot

__all__ = ["elastic_forces", "elastic_of_drives"]


def elastic_forces(parts: Parts) -> Schedule:
    """(q, v) -> forces of springs, dampers and friction along the coordinates, as on the left side of the equations.

    Further outputs: ``energies`` (gear, link) and ``losses`` (gear damping, friction, link damping) of each coordinate
    of a joint and of each link, in the order of the nodes.
    """
    way = Passes(parts, posed=False, loaded=False)
    schedule = way.schedule
    bent = {}
    for index, part in enumerate(parts.nodes):
        if part.link:
            link = part.link
            blocks = (link.stiffness, link.damping, way.bend(link, way.q), way.bend(link, way.v))
            bent[index] = schedule.call(link.kernels.elastic(), *blocks)
    motors, joints, energies, losses = elastic_of_drives(way, {index: found[1:] for index, found in bent.items()})
    links = {link.first: bent[index][0] for index, part in enumerate(parts.nodes) if (link := part.link)}
    schedule.output("forces", *way.by_coordinate(motors, joints, links))
    schedule.output("energies", *energies)
    schedule.output("losses", *losses)
    return schedule


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
                torques[axis.motor] = schedule.call(axis.drive.coupled(), *blocks)[1]
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
            blocks = (axis.drive_numbers, way.motor(axis)[1], way.none[1], loads[axis.motor])
            _, motors[axis.motor], friction = way.schedule.call(axis.drive.coupled_motor(), *blocks)
            lost += [way.none[1], friction, way.none[1]]
    return lost
