"""A URDF's tree as the plain data of a robot's sheet. Names stay; only the ground has a name of its own in a sheet."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tmodes.io.urdf_joint import MOVING, Follows, follows
from tmodes.io.urdf_tree import Tree, UrdfJoint
from tmodes.io.urdf_values import fault
from tmodes.io.words import meant, shown
from tmodes.io.xml_file import Element
from tmodes.io.yaml_file import Positions
from tmodes.sheet.topology import BASE

__all__ = ["hold_followers", "name_of", "sheet_of"]


def hold_followers(joints: tuple[UrdfJoint, ...], data: list[dict[str, Any]]) -> str:
    """Lock each joint that mimics, and the one it follows, where the mimic's own equation holds; what was locked.

    The leader stands at zero, or at its limit next to zero. Raises :class:`tmodes.errors.InputError` for a leader
    that does not exist, does not move, or follows another itself.
    """
    info = {joint.name: said for joint in joints if (said := follows(joint))}
    moving = {joint.name: sheet for joint, sheet in zip(joints, data, strict=True) if joint.type in MOVING}
    for joint in joints:
        if joint.name in info:
            _check_leader(joint, info[joint.name].leader, moving, info)
    for name, said in info.items():
        leader = moving[said.leader]
        leader |= {"state": "locked", "locked_at": _next_to_zero(leader)}
        moving[name] |= {"state": "locked", "locked_at": said.factor * leader["locked_at"] + said.offset}
    return _notice(info)


def _check_leader(joint: UrdfJoint, leader: str, moving: dict[str, Any], info: dict[str, Follows]) -> None:
    which = f"joint {joint.name}: mimic"
    if leader not in moving:
        hint = meant(leader, moving, "name a joint that moves, or remove <mimic>")
        raise fault(joint.element, which, f"the unknown joint {shown(leader)}", "a joint that moves", hint)
    if leader in info:
        got, hint = f"{shown(leader)}, which mimics {shown(info[leader].leader)} itself", "name that joint instead"
        raise fault(joint.element, which, got, "a joint that moves by itself", hint)


def _next_to_zero(joint: dict[str, Any]) -> float:
    limits = joint.get("limits", {})
    return min(max(0.0, limits.get("lower", 0.0)), limits.get("upper", float("inf")))


def _notice(info: dict[str, Follows]) -> str:
    if not info:
        return ""
    pairs = ", ".join(f"{name} (follows {said.leader})" for name, said in info.items())
    few = pairs if len(pairs) <= 1500 else pairs[:1500] + " ..."
    return f"Joints coupled by mimic are held with those they follow, which is no part of the file: {few}."


def name_of(link: str, tree: Tree) -> str:
    """A link's name in the sheet: its own, but for one that is called as the ground is and does not stand there."""
    if link != BASE or tree.root == BASE:
        return link
    taken = {tree.root, *(joint.child for joint in tree.joints)}
    return _free(f"{BASE}_frame", taken)


def sheet_of(
    robot: Element,
    tree: Tree,
    joints: list[dict[str, Any]],
    links: Mapping[str, Element],
    bodies: Mapping[str, dict[str, Any]],
) -> tuple[dict[str, Any], Positions]:
    """Data and positions of the sheet: ``joints`` in the order of the tree, ``bodies`` by their names in the sheet.

    The root stands on the ground by a fixed joint of its own, so that it keeps its name.
    """
    notices = [hold_followers(tree.joints, joints)]
    for joint in joints:
        joint |= {"parent": name_of(joint["parent"], tree), "child": name_of(joint["child"], tree)}
    lines = [joint.element.line for joint in tree.joints]
    if tree.root != BASE:
        taken = {joint["name"] for joint in joints}
        joints = [
            {"name": _free(f"{BASE}_to_{tree.root}"[:90], taken), "type": "fixed", "parent": BASE, "child": tree.root},
            *joints,
        ]
        lines = [links[tree.root].line, *lines]
    if BASE in links and tree.root != BASE:
        notices.append(f"The file's link {BASE}, which is not its root, is called {name_of(BASE, tree)} here.")
    weighing = [joint["child"] for joint in joints if joint["child"] in bodies]
    data: dict[str, Any] = {"format": 1, "kind": "arm", "name": _title(robot)}
    if info := " ".join(filter(None, notices)):
        data["assumed"] = info
    data |= {"joints": joints, "links": [{"name": name, "bodies": [bodies[name]]} for name in weighing]}
    positions = dict.fromkeys(("", "name", "joints", "links"), robot.line)
    positions |= {f"joints.{index}": line for index, line in enumerate(lines)}
    by_name = {name_of(name, tree): link.line for name, link in links.items()}
    return data, positions | {f"links.{index}": by_name[name] for index, name in enumerate(weighing)}


def _title(robot: Element) -> str:
    """The robot's name, or that of its file."""
    return (robot.attributes.get("name", "").strip() or Path(robot.source).stem)[:100]


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    return name
