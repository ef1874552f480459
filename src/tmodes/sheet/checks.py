"""What must fit together in a robot's data sheet: the tree, the names that point into it, its size, its masses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from typing import Any

import numpy as np

from tmodes.kinds.joints.joint import JointSheet
from tmodes.kinds.noted.functions import regular
from tmodes.kinds.noted.number import is_noted
from tmodes.kinds.schema.frames import Convention
from tmodes.kinds.schema.quantity import SMALLEST, Issue
from tmodes.sheet.network import control_issues
from tmodes.sheet.parts import Command, DriveSheet, TipSheet
from tmodes.sheet.topology import BASE, tree_issues

__all__ = ["MOST_COORDINATES", "command_issue", "coordinate_count", "sheet_issues", "unknown_name"]

MOST_COORDINATES = 2_000
"""Largest number of coordinates of a robot."""

MOST_REPORTED = 8

SINGULAR = 1e-9
"""Smallest over largest singular value of couplings at which they are singular but for round-off [-]."""


def sheet_issues(robot: Any) -> list[Issue]:
    """All that does not fit; the names only where the tree stands, the masses only where the names do."""
    from tmodes import chain_issues

    return (
        list(tree_issues(robot.joints, [link.name for link in robot.links]))
        or [
            *_points(robot),
            *_drives(robot),
            *control_issues(robot),
            *_rotors(robot),
            *_couplings(robot),
            *_links(robot),
            *_size(robot),
        ]
        or list(chain_issues(robot))
    )


def unknown_name(
    path: str, name: str, known: Iterable[str], hint: str = "check the spelling", of: str = "name"
) -> Iterator[Issue]:
    """An issue when a name, ``of`` a kind, is none of those that are known."""
    known = list(known)
    if name not in known:
        close = get_close_matches(name, known, n=1)
        info = ", ".join(known[:MOST_REPORTED]) + ("..." if len(known) > MOST_REPORTED else "")
        hint = f"did you mean `{close[0]}`?" if close else hint
        yield Issue(path, f"the unknown {of} `{name}`", f"one of {info}" if known else f"no {of}", hint)


def _points(robot: Any) -> Iterator[Issue]:
    if robot.tip:
        yield from _point(robot, "tip", robot.tip)
    names = ["tip"]
    for index, point in enumerate(robot.points):
        yield from _point(robot, f"points.{index}", point)
        if point.name in names:
            got, expected = f"the name `{point.name}` again", "a name that no other point has"
            yield Issue(f"points.{index}.name", got, expected, "rename the point")
        names.append(point.name)
    for index, load in enumerate(robot.loads):
        yield from unknown_name(f"loads.{index}.point", load.point, names, "add it under `points`")
    if robot.contact:
        yield from unknown_name("contact.point", robot.contact.point, names, "add it under `points`")


def _point(robot: Any, path: str, point: TipSheet) -> Iterator[Issue]:
    yield from unknown_name(f"{path}.link", point.link, [joint.child for joint in robot.joints])
    if point.at is not None and robot.link(point.link).beam is None:
        hint = "remove `at`, and give the position in the link's frame"
        yield Issue(f"{path}.at", f"{point.at:g}", "left out: the link has no beam", hint)


def _drives(robot: Any) -> Iterator[Issue]:
    joints = {name: joint for joint in robot.joints for name in (joint.coordinates or [joint.name])}
    active = [name for name, joint in joints.items() if not joint.is_locked and joint.is_active]
    seen: set[str] = set()
    for index, drive in enumerate(robot.drives):
        path = f"drives.{index}"
        if drive.joint in joints and drive.joint not in active:
            yield Issue(f"{path}.joint", f"`{drive.joint}`, which does not move", "an active joint", "remove the drive")
        elif drive.joint not in joints:
            yield from unknown_name(f"{path}.joint", drive.joint, active)
        else:
            yield from _drive(path, drive, joints[drive.joint])
        if drive.joint in seen:
            yield Issue(f"{path}.joint", f"`{drive.joint}` a second time", "one drive for a joint", "keep one of them")
        seen.add(drive.joint)


def _rotors(robot: Any) -> Iterator[Issue]:
    """A rotor behind an elastic gear turns by itself, and has inertia, unless its motion is given."""
    given = {drive.joint for drive in robot.drives if drive.command is Command.PRESCRIBED}
    for index, joint in enumerate(robot.joints):
        turns = joint.is_active and joint.is_elastic and not given.issuperset(joint.coordinates or [joint.name])
        if turns and joint.motor and not joint.motor.inertia:
            expected = "an inertia > 0 kg*m^2 behind an elastic gear, where the rotor turns by itself"
            hint = "give the rotor its inertia, write `state: locked`, or take the command `prescribed`"
            yield Issue(f"joints.{index}.motor.inertia", "0", expected, hint)


def _drive(path: str, drive: DriveSheet, joint: JointSheet) -> Iterator[Issue]:
    motor = joint.motor
    electric = motor is not None and motor.resistance is not None
    if issue := command_issue(drive.command, motor=motor is not None, electric=electric, elastic=joint.is_elastic):
        yield issue._replace(field=f"{path}.command")


def command_issue(command: str, *, motor: bool, electric: bool, elastic: bool) -> Issue | None:
    """Why a joint can not take a command, by what it has; None where it can."""
    match command:
        case Command.VOLTAGE if not electric:
            hint = "give its resistance, back_emf_constant and torque_constant, or take the command `torque`"
            return Issue("", "voltage without an electric motor", "a motor with a resistance", hint)
        case Command.TORQUE if not motor:
            return Issue("", "torque without a motor", "a motor", "take the command `effort`")
        case Command.EFFORT if elastic:
            got, hint = "effort on a joint behind an elastic gear", "take the command `torque`"
            return Issue("", got, "a joint without an elastic gear", hint)
        case _:
            return None


def _couplings(robot: Any) -> Iterator[Issue]:
    elastic = [name for joint in robot.joints if joint.is_elastic and joint.is_active for name in joint.coordinates]
    hint = "couplings are between the gears of active joints"
    for joint, factors in robot.couplings.items():
        yield from unknown_name(f"couplings.{joint}", joint, elastic, hint)
        for motor in factors:
            yield from unknown_name(f"couplings.{joint}.{motor}", motor, elastic, hint)
    if {*robot.couplings, *(motor for factors in robot.couplings.values() for motor in factors)} <= {*elastic}:
        yield from _singular(robot.couplings, elastic)


def _singular(couplings: Mapping[str, Mapping[str, float]], names: list[str]) -> Iterator[Issue]:
    """Couplings by which some motors move together without moving any gear."""
    if not couplings:
        return
    rows = {name: couplings.get(name, {name: 1.0}) for name in names}
    matrix = np.array([[rows[joint].get(motor, 0.0) for motor in names] for joint in names])
    if is_noted(matrix) and regular(matrix, SINGULAR):
        return
    _, sizes, motions = np.linalg.svd(matrix)
    if sizes[-1] <= SINGULAR * sizes[0]:
        alone = motions[-1] / np.abs(motions[-1]).max()
        info = ", ".join(
            f"{name} {value:.3g}" for name, value in zip(names, alone, strict=True) if abs(value) > SINGULAR
        )
        got = f"a singular matrix, smallest over largest singular value {sizes[-1] / max(sizes[0], SMALLEST):.1e}"
        hint = f"correct the factors: motors that turn by {info} move no gear"
        yield Issue("couplings", got, "factors by which every motor moves a gear", hint)


def _links(robot: Any) -> Iterator[Issue]:
    carriers = {joint.child: index for index, joint in enumerate(robot.joints)}
    for index, link in enumerate(robot.links):
        for issue in link.beam.station_issues(link.bodies) if link.beam else ():
            yield issue._replace(field=f"links.{index}.{issue.field}")
        joint = robot.joints[carriers[link.name]]
        if link.beam and joint.dh and joint.dh.convention is Convention.PAPER and joint.dh.a != link.beam.line_length:
            expected = f"the length of the beam `{link.name}`, {link.beam.line_length!r} [m]"
            hint = "in the convention `paper`, a is the length of the mode"
            yield Issue(f"joints.{carriers[link.name]}.dh.a", repr(joint.dh.a), expected, hint)


def _size(robot: Any) -> Iterator[Issue]:
    """Refused before anything is allocated."""
    moving, motors, bends = _counts(robot)
    if (count := moving + motors + bends) > MOST_COORDINATES:
        got = f"{count} coordinates ({moving} joints, {motors} motors, {bends} of the links)"
        yield Issue("links", got, f"at most {MOST_COORDINATES}", "take fewer functions, segments or joints")


def coordinate_count(robot: Any) -> int:
    """How many coordinates the robot has: those of its joints, of the motors behind elastic gears, of its links."""
    return sum(_counts(robot))


def _counts(robot: Any) -> tuple[int, int, int]:
    moving = sum(joint.kind.size for joint in robot.joints if not joint.is_locked)
    motors = sum(joint.kind.size for joint in robot.joints if joint.is_elastic)
    return moving, motors, sum(link.beam.coordinate_count for link in robot.links if link.beam and link.name != BASE)
