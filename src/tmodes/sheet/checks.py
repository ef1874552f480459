"""What must fit together in an arm's data sheet: the tree, the names that point into it, its size, its masses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from typing import TYPE_CHECKING

import numpy as np

from tmodes.kinds.joints.joint import JointSheet, JointState
from tmodes.kinds.links.beam import BeamModel
from tmodes.kinds.schema.frames import Convention
from tmodes.kinds.schema.quantity import SMALLEST, Misfit
from tmodes.sheet.mass import massless_misfits
from tmodes.sheet.parts import Command, DriveSheet, LinkSheet, TipSheet
from tmodes.sheet.topology import BASE, tree_misfits

if TYPE_CHECKING:
    from tmodes.sheet import Arm

__all__ = ["MOST_COORDINATES", "arm_misfits", "coordinate_count"]

MOST_COORDINATES = 2_000
"""Largest number of coordinates of an arm."""

MOST_TOLD = 8

SINGULAR = 1e-9
"""Smallest over largest singular value of couplings at which they are singular but for round-off [-]."""


def arm_misfits(arm: Arm) -> list[Misfit]:
    """All that does not fit; the names only where the tree stands, the masses only where the names do."""
    return (
        list(tree_misfits(arm.joints, [link.name for link in arm.links]))
        or [*_points(arm), *_drives(arm), *_couplings(arm), *_initial(arm), *_links(arm), *_size(arm)]
        or list(massless_misfits(arm))
    )


def _unknown(path: str, name: str, known: Iterable[str], mend: str = "check the spelling") -> Iterator[Misfit]:
    """A misfit when a name is none of those that are known."""
    known = list(known)
    if name not in known:
        close = get_close_matches(name, known, n=1)
        told = ", ".join(known[:MOST_TOLD]) + ("..." if len(known) > MOST_TOLD else "")
        mend = f"did you mean `{close[0]}`?" if close else mend
        yield Misfit(path, f"the unknown name `{name}`", f"one of {told}" if known else "no name", mend)


def _points(arm: Arm) -> Iterator[Misfit]:
    if arm.tip:
        yield from _point(arm, "tip", arm.tip)
    names = ["tip"]
    for index, point in enumerate(arm.points):
        yield from _point(arm, f"points.{index}", point)
        if point.name in names:
            yield Misfit(f"points.{index}.name", f"the name `{point.name}` again", "each name once", "rename the point")
        names.append(point.name)
    for index, load in enumerate(arm.loads):
        yield from _unknown(f"loads.{index}.point", load.point, names, "add it under `points`")
    if arm.contact:
        yield from _unknown("contact.point", arm.contact.point, names, "add it under `points`")


def _point(arm: Arm, path: str, point: TipSheet) -> Iterator[Misfit]:
    yield from _unknown(f"{path}.link", point.link, [joint.child for joint in arm.joints])
    if point.at is not None and arm.link(point.link).beam is None:
        mend = "remove `at`, and give the position in the link's frame"
        yield Misfit(f"{path}.at", f"{point.at:g}", "no station: the link has no beam", mend)


def _drives(arm: Arm) -> Iterator[Misfit]:
    joints = {joint.name: joint for joint in arm.joints}
    active = [name for name, joint in joints.items() if not joint.is_locked and joint.state is JointState.ACTIVE]
    seen: set[str] = set()
    for index, drive in enumerate(arm.drives):
        path = f"drives.{index}"
        if drive.joint in joints and drive.joint not in active:
            yield Misfit(
                f"{path}.joint", f"`{drive.joint}`, which does not move", "an active joint", "remove the drive"
            )
        elif drive.joint not in joints:
            yield from _unknown(f"{path}.joint", drive.joint, active)
        else:
            yield from _drive(path, drive, joints[drive.joint])
        if drive.joint in seen:
            yield Misfit(f"{path}.joint", f"`{drive.joint}` a second time", "one drive for a joint", "keep one of them")
        seen.add(drive.joint)


def _drive(path: str, drive: DriveSheet, joint: JointSheet) -> Iterator[Misfit]:
    motor = joint.motor
    if drive.command is Command.VOLTAGE and (motor is None or motor.resistance is None):
        mend = "give its resistance, back_emf_constant and torque_constant, or take the command `torque`"
        yield Misfit(f"{path}.command", "voltage without an electric motor", "a motor with a resistance", mend)
    if drive.command is Command.TORQUE and motor is None:
        yield Misfit(f"{path}.command", "torque without a motor", "a motor", "take the command `effort`")
    if drive.command is Command.EFFORT and joint.is_elastic:
        got, mend = "effort on a joint behind an elastic gear", "take the command `torque`"
        yield Misfit(f"{path}.command", got, "a joint without an elastic gear", mend)


def _couplings(arm: Arm) -> Iterator[Misfit]:
    elastic = [joint.name for joint in arm.joints if joint.is_elastic and joint.state is JointState.ACTIVE]
    mend = "couplings are between the gears of active joints"
    for joint, factors in arm.couplings.items():
        yield from _unknown(f"couplings.{joint}", joint, elastic, mend)
        for motor in factors:
            yield from _unknown(f"couplings.{joint}.{motor}", motor, elastic, mend)
    if {*arm.couplings, *(motor for factors in arm.couplings.values() for motor in factors)} <= {*elastic}:
        yield from _singular(arm.couplings, elastic)


def _singular(couplings: Mapping[str, Mapping[str, float]], names: list[str]) -> Iterator[Misfit]:
    """Couplings by which some motors move together without moving any gear."""
    if not couplings:
        return
    rows = {name: couplings.get(name, {name: 1.0}) for name in names}
    matrix = np.array([[rows[joint].get(motor, 0.0) for motor in names] for joint in names])
    _, sizes, motions = np.linalg.svd(matrix)
    if sizes[-1] <= SINGULAR * sizes[0]:
        alone = motions[-1] / np.abs(motions[-1]).max()
        told = ", ".join(
            f"{name} {value:.3g}" for name, value in zip(names, alone, strict=True) if abs(value) > SINGULAR
        )
        got = f"a singular matrix, smallest over largest singular value {sizes[-1] / max(sizes[0], SMALLEST):.1e}"
        mend = f"correct the factors: motors that turn by {told} move no gear"
        yield Misfit("couplings", got, "factors by which every motor moves a gear", mend)


def _initial(arm: Arm) -> Iterator[Misfit]:
    names = [*(joint.name for joint in arm.joints), *(joint.child for joint in arm.joints)]
    for group in ("coordinates", "rates"):
        for name in getattr(arm.initial, group):
            if name not in names and name.rpartition(".")[0] not in names:
                yield from _unknown(f"initial.{group}.{name}", name, names)


def _links(arm: Arm) -> Iterator[Misfit]:
    carriers = {joint.child: index for index, joint in enumerate(arm.joints)}
    for index, link in enumerate(arm.links):
        yield from _stations(f"links.{index}", link)
        joint = arm.joints[carriers[link.name]]
        if link.beam and joint.dh and joint.dh.convention is Convention.PAPER and joint.dh.a != link.beam.length:
            expected = f"the length of the beam `{link.name}`, {link.beam.length!r} [m]"
            mend = "in the convention `paper`, a is the length of the mode"
            yield Misfit(f"joints.{carriers[link.name]}.dh.a", repr(joint.dh.a), expected, mend)


def _stations(path: str, link: LinkSheet) -> Iterator[Misfit]:
    """Segments carry bodies at their ends only."""
    if link.beam is None or link.beam.model is not BeamModel.SEGMENTS or link.beam.segments is None:
        return
    count = link.beam.segments
    for index, body in enumerate(link.bodies):
        if abs(body.station * count - round(body.station * count)) > 1e-9:
            expected = f"an end of one of the {count} segments: a multiple of 1/{count}"
            mend = "move the body, change `segments`, or take the model `strain`"
            yield Misfit(f"{path}.bodies.{index}.at", f"{body.station:g}", expected, mend)


def _size(arm: Arm) -> Iterator[Misfit]:
    """Refused before anything is allocated."""
    moving, motors, bends = _counts(arm)
    if (count := moving + motors + bends) > MOST_COORDINATES:
        got = f"{count} coordinates ({moving} joints, {motors} motors, {bends} of the links)"
        yield Misfit("links", got, f"at most {MOST_COORDINATES}", "take fewer functions, segments or joints")


def coordinate_count(arm: Arm) -> int:
    """How many coordinates the arm has: those of its joints, of the motors behind elastic gears, of its links."""
    return sum(_counts(arm))


def _counts(arm: Arm) -> tuple[int, int, int]:
    moving = sum(1 for joint in arm.joints if not joint.is_locked)
    motors = sum(1 for joint in arm.joints if joint.is_elastic)
    return moving, motors, sum(_link_coordinates(link) for link in arm.links if link.name != BASE)


def _link_coordinates(link: LinkSheet) -> int:
    beam = link.beam
    if beam is None or beam.model is BeamModel.RIGID:
        return 0
    if beam.model is BeamModel.SEGMENTS:
        return 2 * (beam.segments or 0)
    functions = beam.functions
    return functions.twist + functions.bend_y + functions.bend_z + functions.stretch if functions else 0
