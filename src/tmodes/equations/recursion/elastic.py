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

    Further outputs: ``energies`` (gears, links) and ``losses`` (gear damping, friction, link damping) of each part in
    the order of the nodes; ``energies`` of a node: gear then link.
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
        energy, lost = none, way.none[3].part(0, 2)
        if part.motor in coupled and part.drive and part.drive_numbers:
            blocks = (part.drive_numbers, *coupled[part.motor], *way.angle(part))
            joints[part.angle], energy, lost = schedule.call(part.drive.coupled_elastic(), *blocks)
            torques[part.motor] = schedule.call(part.drive.coupled(), *blocks)[1]
        elif part.drive and part.drive_numbers:
            blocks = (part.drive_numbers, *way.motor(part), *way.angle(part))
            forces, energy, lost = schedule.call(part.drive.elastic(), *blocks)
            joints[part.angle] = forces.part(0, 1)
            motors[part.motor] = forces.part(1, 1)
        bend_energy, bend_lost = (links or {}).get(index, (none, none))
        energies += [energy, bend_energy]
        losses += [lost, bend_lost]
    losses += _coupled_motors(way, torques, motors)
    return motors, joints, energies, losses


def _coupled_motors(way: Coordinates, torques: dict[int, Slot], motors: dict[int, Slot]) -> list[Slot]:
    """Forces on coupled motors, put among ``motors``; the friction they lose, as losses of further parts."""
    loads = way.coupled_loads(torques)
    lost: list[Slot] = []
    for part in way.parts.nodes:
        if part.motor in loads and part.drive and part.drive_numbers:
            blocks = (part.drive_numbers, way.motor(part)[1], way.none[1], loads[part.motor])
            _, motors[part.motor], friction = way.schedule.call(part.drive.coupled_motor(), *blocks)
            lost += [way.none[1], friction, way.none[1]]
    return lost
