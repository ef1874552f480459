"""A robot that moves in one plane: its beams bend in that plane alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.joints.joint import JointSheet, MeasuredFrom
from tmodes.kinds.schema.axes import unit
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet.parts import LinkSheet
from tmodes.sheet.topology import parents, rooted_order

__all__ = ["in_plane", "planar_issues"]

Array = NDArray[np.float64]

ASIDE = 1e-4
"""Angle by which an axis may be off [rad]."""


def _frames(joints: Sequence[JointSheet], links: dict[str, LinkSheet]) -> dict[str, tuple[Array, Array]]:
    """Of each joint, by its name, the axes of its frame and of its link's frame in the world, all joints at zero."""
    names, tips, owns = parents(joints), {}, {}
    found = {}
    for index in rooted_order(joints):
        joint = joints[index]
        before = (owns if joint.measured_from is MeasuredFrom.FRAME else tips).get(names[index], np.eye(3))
        placed = joint.dh.before()[0] if joint.dh else joint.origin.rotation() if joint.origin else np.eye(3)
        frame = before @ placed
        own = frame @ joint.dh.after()[0] if joint.dh else frame
        found[joint.name] = frame, own
        owns[joint.child] = tips[joint.child] = own
        link = links.get(joint.child)
        if link and link.beam:
            tips[joint.child] = own @ _mount(link, "root_mount") @ _mount(link, "tip_mount")
    return found


def _mount(link: LinkSheet, name: str) -> Array:
    """Turn of the beam's root in its link, or of the tip frame in its end."""
    mount = link.beam.mounts.get(name) if link.beam else None
    return mount.rotation() if mount else np.eye(3)


def _normal(joints: Sequence[JointSheet], frames: dict[str, tuple[Array, Array]]) -> Array | None:
    """Normal of the plane: the axis of the first joint that turns."""
    for joint in joints:
        if joint.kind.turns and joint.name in frames:
            return frames[joint.name][0] @ _axis(joint)
    return None


def _axis(joint: JointSheet) -> Array:
    return unit(joint.axis) if joint.axis else np.array([0.0, 0.0, 1.0])


def planar_issues(robot: Any) -> Iterator[Issue]:
    """Joints that leave the plane, and beams that do not bend in it."""
    links = {link.name: link for link in robot.links}
    frames = _frames(robot.joints, links)
    normal = _normal(robot.joints, frames)
    if normal is None:
        yield Issue("planar", "true without a joint that turns", "a plane", "remove it, or add a revolute joint")
        return
    for index, joint in enumerate(robot.joints):
        axis = frames[joint.name][0] @ _axis(joint)
        off = np.linalg.norm(np.cross(axis, normal)) if joint.kind.turns else abs(axis @ normal)
        if joint.kind.moves and (off > ASIDE or not joint.kind.is_simple):
            where = "along the normal of the plane" if joint.kind.turns else "in the plane"
            hint = "turn its axis, or remove `planar`"
            yield Issue(f"joints.{index}.axis", "a motion that leaves the plane", f"an axis {where}", hint)
    carriers = {joint.child: joint.name for joint in robot.joints}
    for index, link in enumerate(robot.links):
        if link.beam and not _normal_axis(link, frames[carriers[link.name]][1], normal):
            hint = "turn `root_mount`, or remove `planar`"
            yield Issue(f"links.{index}.beam.root_mount", "a section oblique to the plane", "y or z normal to it", hint)


def _normal_axis(link: LinkSheet, own: Array, normal: Array) -> str:
    """The axis of a beam's section that is normal to the plane; empty where none is."""
    section = own @ _mount(link, "root_mount")
    found = (name for name, k in (("y", 1), ("z", 2)) if np.linalg.norm(np.cross(section[:, k], normal)) < ASIDE)
    return next(found, "")


def in_plane(robot: Any) -> tuple[LinkSheet, ...]:
    """The links of a planar robot, whose beams bend in its plane alone."""
    frames = _frames(robot.joints, {link.name: link for link in robot.links})
    normal = _normal(robot.joints, frames)
    carriers = {joint.child: joint.name for joint in robot.joints}
    changed = []
    for link in robot.links:
        axis = "" if normal is None or not link.beam else _normal_axis(link, frames[carriers[link.name]][1], normal)
        beam = link.beam.bending_about(axis) if link.beam and axis else link.beam
        changed.append(link if beam is link.beam else link.model_copy(update={"beam": beam}))
    return tuple(changed)
