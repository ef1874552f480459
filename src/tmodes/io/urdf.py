"""Read a URDF into the plain data of a robot's sheet.

Links, joints, inertias, limits, friction, rotors and springs are read; names stay. Geometry is not loaded: only the
checked paths of its files are kept. What changes the motion and is not read is named (:mod:`.urdf_read`); what is
misspelt is refused. Format: http://wiki.ros.org/urdf/XML.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.errors import InputError, InputErrors
from tmodes.io.files import FilePath, Folders, Roots, folders_of
from tmodes.io.unread import few, sentences
from tmodes.io.urdf_body import POSES, ImpossibleBodyError, Mover, body_of, inertia_of, says_massless
from tmodes.io.urdf_parts import (
    MOVING,
    URDF,
    Follows,
    UrdfJoint,
    joint_ends,
    joint_of,
    motor_and_spring,
    said_of_drives,
    without_rotor,
)
from tmodes.io.urdf_tree import Tree, followers, name_of, sheet_of, tree_of
from tmodes.io.words import shown
from tmodes.io.xml_file import Element, read_xml
from tmodes.io.yaml_file import Positions

__all__ = ["UrdfRobot", "massless", "read_urdf", "urdf_robot"]

MOST_ERRORS = 100
ROUNDING = 1e-6
"""Tenths of a per cent by which a frequency may fall unsaid."""

TOP = {"link", "joint", "material", "gazebo", "transmission", "sensor", "ros2_control"}


@dataclass(frozen=True, eq=False)
class UrdfRobot:
    """What a URDF says: ``data`` and ``positions`` of a robot's sheet, bodies and files of geometry by link.

    ``links``: their elements by names in the sheet; ``root``: that of the file; ``folders``: where its files may lie;
    ``followers``: joints that mimic another.
    """

    data: dict[str, Any]
    positions: Positions
    bodies: dict[str, dict[str, Any]]
    meshes: dict[str, list[Path]]
    links: dict[str, Element]
    root: Element
    folders: Folders
    followers: Mapping[str, Follows] = field(default_factory=dict)


@dataclass
class _UrdfReading:
    """What has been read so far, and all that was found wrong."""

    links: dict[str, Element] = field(default_factory=dict)
    joints: dict[str, UrdfJoint] = field(default_factory=dict)
    bodies: dict[str, dict[str, Any]] = field(default_factory=dict)
    errors: list[InputError] = field(default_factory=list)
    impossible: dict[str, ImpossibleBodyError] = field(default_factory=dict)
    unread: dict[str, dict[str, None]] = field(default_factory=dict)

    def refuse(self, further: Iterable[InputError] = ()) -> None:
        """Raise what is wrong, and where anything is, what else may be, from the first line on."""
        if self.errors:
            raise InputErrors(sorted([*self.errors, *further], key=_line)[:MOST_ERRORS])


def read_urdf(
    path: FilePath,
    roots: Roots = (),
    trust_paths: bool = False,
    weighed: Collection[str] = (),
    *,
    fix_inertia: bool = False,
) -> UrdfRobot:
    """The robot of a URDF file.

    ``roots`` are further folders in which the files it names may lie; ``trust_paths`` allows any. Links that are
    ``weighed`` get a mass elsewhere and need none here. Raises :class:`tmodes.errors.InputError` or, with all that is
    wrong, :class:`tmodes.errors.InputErrors`.
    """
    return urdf_robot(read_xml(path), folders_of(path, roots, trust_paths), weighed, fix_inertia=fix_inertia)


def urdf_robot(
    robot: Element, folders: Folders, weighed: Collection[str] = (), *, fix_inertia: bool = False
) -> UrdfRobot:
    """The robot of a URDF's root element; see :func:`read_urdf`.

    ``fix_inertia``: impossible inertias of moving links too are raised to possible ones, each with a notice.
    """
    _check_root(robot)
    reading = _UrdfReading()
    for element in robot.children:
        _tried(reading, _read, element, reading)
    if not reading.links and not reading.errors:
        reading.errors.append(robot.fault("the robot", "no link", "made of links and joints", "add <link> and <joint>"))
    reading.refuse(reading.impossible.values())  # which of these links stand still is not known yet
    tree = tree_of(robot, reading.links, list(reading.joints.values()))
    said = _tried(reading, said_of_drives, robot) or {}
    unweighed = {*weighed, *reading.impossible}  # a mass that was refused is reported once
    reading.errors.extend(massless(tree, reading.links, reading.bodies, unweighed))
    meshes = {name: _meshes(name, link, folders, reading) for name, link in reading.links.items()}
    joints = [_tried(reading, joint_of, joint) or {} for joint in tree.joints]
    if not all(joints):
        reading.refuse(reading.impossible.values())
    notices = [*_made_possible(reading, tree, joints, fix_inertia=fix_inertia), *_unread_meshes(reading)]
    driven = _driven(robot)
    for data in joints:
        if data.get("type") != "fixed" and (words := said.get(data.get("name", ""))):
            data.update(motor_and_spring(words, driven=data["name"] in driven))
    notices += sentences([*URDF.left(robot), *without_rotor(said)])
    reading.refuse()
    if not joints:
        raise robot.fault("the robot", "no joint", "at least one joint", "add <joint>: what does not move is no robot")
    names = {link: name_of(link, tree) for link in reading.links}
    bodies = {names[link]: body for link, body in reading.bodies.items()}
    files = {names[link]: paths for link, paths in meshes.items() if paths}
    data, positions = sheet_of(robot, tree, joints, reading.links, bodies, notices)
    elements = {names[link]: element for link, element in reading.links.items()}
    return UrdfRobot(data, positions, bodies, files, elements, robot, folders, followers(tree.joints))


def _driven(robot: Element) -> set[str]:
    """Joints that a transmission or ros2_control names: something moves them."""
    named = (one for tag in ("transmission", "ros2_control") for group in robot.all(tag) for one in group.within())
    return {one.attributes.get("name", "") for one in named if one.tag == "joint"}


_OTHERS = {
    "sdf": (
        "<sdf>, a robot of Gazebo",
        "give the URDF or xacro that it was made from, or write its joints and links as a sheet with `kind: arm`",
    ),
    "mujoco": (
        "<mujoco>, an MJCF",
        "read it by itself, with the ending .xml; an elasticity file lays over a URDF or xacro alone, so write what "
        "bends as a sheet with `kind: arm`",
    ),
}
"""Other formats by their root element: what they are, and what to do."""


def _check_root(robot: Element) -> None:
    if robot.tag != "robot":
        got, hint = _OTHERS.get(robot.tag, (robot.label, "check that this is a URDF"))
        raise robot.fault("the root element", got, "<robot> of a URDF or xacro", hint)
    robot.check_attributes({"name", "version"}, "robot")
    robot.check_children(TOP, "robot")
    if prefixed := next((child for child in robot.children if child.tag.startswith("xacro:")), None):
        hint = "save the file with the ending .xacro"
        raise prefixed.fault("robot", f"{prefixed.label} in a plain URDF", "<link> and <joint>", hint)


def _read(element: Element, reading: _UrdfReading) -> None:
    """Read one link or joint."""
    if element.tag == "link":
        name = element.text("name", "a link's name")
        _refuse_second(name, "link", element, reading.links.get(name))
        reading.links[name] = element
        try:
            body = body_of(element, name)
        except ImpossibleBodyError as error:
            reading.impossible[name], body = error, error.stands
        if body:
            reading.bodies[name] = body
    elif element.tag == "joint":
        joint = joint_ends(element)
        first = reading.joints.get(joint.name)
        _refuse_second(joint.name, "joint", element, first.element if first else None)
        reading.joints[joint.name] = joint


def _line(error: InputError) -> int:
    """The line of the file in which it is; 0 where it has none."""
    line = error.where.rpartition(":")[2]
    return int(line) if line.isdecimal() else 0


def _standing(tree: Tree) -> set[str]:
    """The links that stand still with the base: they hang on it by fixed joints alone."""
    found = {tree.root}
    for joint in tree.joints:  # parents first
        if joint.type not in MOVING and joint.parent in found:
            found.add(joint.child)
    return found


def _made_possible(
    reading: _UrdfReading, tree: Tree, joints: Sequence[dict[str, Any]], *, fix_inertia: bool
) -> Iterator[str]:
    """Notices of what was taken in place of an impossible mass or inertia; the others are errors."""
    standing, mover, added = _standing(tree), Mover(joints), {}
    for name, error in reading.impossible.items():
        body = error.stands
        if not (name in standing or fix_inertia) or (name not in standing and body is None):
            error.hint += "" if body is None else "; or let its unused moments be raised: --fix-inertia"
            reading.errors.append(error)
        elif body and "inertia" in body:
            reading.bodies[name] = mover.repaired(name, body)
            added[name] = inertia_of(reading.bodies[name]) - inertia_of(body)
    for name, error in reading.impossible.items():
        if error in reading.errors:
            continue
        taken = _moments(inertia_of(reading.bodies[name])) if name in added else "no mass"
        effect = "it stands still with the base, so that no motion depends on it"
        if name not in standing:
            effect = _fall(mover.largest_fall(reading.bodies, name, added[name]))
        yield f"{error.which} is not possible ({error.got}): {taken} is taken; {effect}"


def _fall(share: float | None) -> str:
    """How much a natural frequency falls at most, in words."""
    if share is None:
        return "how much that lowers a natural frequency is not known"
    most = math.ceil(1000 * share - ROUNDING) / 10
    return f"that lowers a natural frequency by at most {most:g} % (rigid links, {POSES} poses)"


def _moments(matrix: Any) -> str:
    """The moments that are taken, in words."""
    moments = np.linalg.eigvalsh(matrix)
    return f"one with raised moments, {', '.join(f'{max(moment, 0.0):.6g}' for moment in moments)} kg*m^2,"


def _refuse_second(name: str, kind: str, element: Element, first: Element | None) -> None:
    if first is not None:
        got, hint = f"a second {kind} of this name (first in line {first.line})", "give each its own name"
        raise element.fault(f"{kind} {name}", got, f"one {kind} of each name", hint)


def _tried(reading: _UrdfReading, read: Any, *what: Any) -> Any:
    """What is read; what is wrong is kept next to the other errors."""
    try:
        return read(*what)
    except InputError as error:
        reading.errors.append(error)
        return None


def _meshes(name: str, link: Element, folders: Folders, reading: _UrdfReading) -> list[Path]:
    """The checked paths of a link's files of geometry; those that are not there, or may not be read, are left out."""
    found = []
    for one in link.within():
        if one.tag in {"mesh", "texture"} and "filename" in one.attributes:
            try:
                path = folders.find(one.attributes["filename"].strip(), f"link {name}: {one.tag}", one.place)
            except InputError as error:
                reading.unread.setdefault(error.hint, {})[f"{name} ({error.got})"] = None
            else:
                found += [path] if path else []
    return found


def _unread_meshes(reading: _UrdfReading) -> Iterator[str]:
    """A sentence for each reason for which files of geometry are not read; no motion depends on them."""
    for hint, names in reading.unread.items():
        yield f"shapes of links are not drawn, as their files may not be read: {few([*names])}; {hint}."


HINT = "give it a mass and an inertia, make the joint fixed, or remove both"


def massless(
    tree: Tree, links: Mapping[str, Element], bodies: Mapping[str, dict[str, Any]], weighed: Collection[str] = ()
) -> Iterator[InputError]:
    """Moving links that weigh nothing with all that they carry, and those whose mass is said to be zero.

    A link without ``<inertial>`` between two joints is only a frame (two axes that meet), and is right as long as
    something with a mass hangs on it. A massless link on a fixed joint is right too. Links that are ``weighed`` get
    their mass elsewhere.
    """
    own = {name: body["mass"] for name, body in bodies.items()} | dict.fromkeys(weighed, 1.0)
    whole, rigid = _carried(tree, own)
    for joint in tree.joints:
        if joint.type not in MOVING:
            continue
        stated, which = says_massless(links[joint.child]), f"link {joint.child}: mass"
        if whole[joint.child] == 0.0:
            got = f"no mass on the moving joint {shown(joint.name)}, neither its own nor of what it carries"
            yield (stated or links[joint.child]).fault(which, got, "a mass greater than 0 [kg]", HINT)
        elif stated is not None and rigid[joint.child] == 0.0:
            hint = "give its mass, or remove its <inertial> if it is only a frame between two joints"
            yield stated.fault(which, "0 on a moving link", "a mass greater than 0 [kg]", hint)


def _carried(tree: Tree, own: Mapping[str, float]) -> tuple[dict[str, float], dict[str, float]]:
    """Mass [kg] of each link with all that hangs on it, and with what hangs on it by fixed joints alone."""
    whole = {name: own.get(name, 0.0) for name in (tree.root, *(joint.child for joint in tree.joints))}
    rigid = dict(whole)
    for joint in reversed(tree.joints):
        whole[joint.parent] += whole[joint.child]
        rigid[joint.parent] += 0.0 if joint.type in MOVING else rigid[joint.child]
    return whole, rigid
