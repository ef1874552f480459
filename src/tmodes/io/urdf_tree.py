"""The tree of a URDF's links and joints, and the plain data of a robot's sheet that it gives.

One root, one parent for every other link, no cycle; linear in the number. Names stay; only the ground has a name of its
own in a sheet.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tmodes.errors import InputError
from tmodes.io.unread import few
from tmodes.io.urdf_parts import MOVING, Follows, UrdfJoint, follows, hold, zero_limits
from tmodes.io.words import meant, shown
from tmodes.io.xml_file import Element
from tmodes.io.yaml_file import Positions
from tmodes.sheet.robot import MOST_LETTERS, MOST_NOTICES
from tmodes.sheet.topology import BASE

__all__ = ["Tree", "followers", "mimic_notice", "name_of", "sheet_of", "tree_of"]

MOST_NAMES = 8


@dataclass(frozen=True, eq=False)
class Tree:
    """``joints`` in depth-first order, branches in the order of the file; ``root`` is the link that none carries."""

    root: str
    joints: tuple[UrdfJoint, ...]


def tree_of(robot: Element, links: dict[str, Element], joints: list[UrdfJoint]) -> Tree:
    """The tree that the joints make of the links; raises the first InputError of those that make none."""
    for joint in joints:
        _check_ends(joint, links)
    _check_one_parent(joints)
    carried = {joint.child for joint in joints}
    roots = [name for name in links if name not in carried]
    if not roots:
        hint = "remove the joint that closes the cycle"
        got = f"a cycle: each of {_names(links)} is carried"
        raise robot.fault("the tree of links", got, "a tree with one root link", hint)
    if len(roots) > 1:
        got = f"links that hang together with no joint: {_names(roots)}"
        hint = f"add the joints that carry them, or remove all of them but {shown(roots[0])}"
        raise links[roots[1]].fault("the tree of links", got, "one tree with one root link", hint)
    tree = Tree(roots[0], tuple(_depth_first(roots[0], joints)))
    reached = set(tree.joints)
    if missing := [joint for joint in joints if joint not in reached]:
        raise _cycle(missing)
    return tree


def _check_ends(joint: UrdfJoint, links: dict[str, Element]) -> None:
    for end, name in (("parent", joint.parent), ("child", joint.child)):
        if name not in links:
            hint = meant(name, links, f"add <link name={shown(name)}>")
            raise joint.element.fault(f"joint {joint.name}: {end}", f"the unknown link {shown(name)}", "a link", hint)
    if joint.parent == joint.child:
        got, hint = f"{shown(joint.child)} on itself", "name two different links"
        raise joint.element.fault(f"joint {joint.name}", got, "a joint between two links", hint)


def _check_one_parent(joints: list[UrdfJoint]) -> None:
    carrier: dict[str, UrdfJoint] = {}
    for joint in joints:
        if first := carrier.get(joint.child):
            got = f"two parents, {shown(first.parent)} by joint {first.name} and {shown(joint.parent)} by {joint.name}"
            hint = "remove one of the two joints: closed loops are not modelled"
            raise joint.element.fault(f"link {joint.child}", got, "carried by one joint", hint)
        carrier[joint.child] = joint


def _depth_first(root: str, joints: list[UrdfJoint]) -> Iterator[UrdfJoint]:
    sitting: dict[str, list[UrdfJoint]] = {}
    for joint in joints:
        sitting.setdefault(joint.parent, []).append(joint)
    waiting = sitting.get(root, [])[::-1]
    while waiting:
        joint = waiting.pop()
        yield joint
        waiting.extend(sitting.get(joint.child, [])[::-1])


def _cycle(joints: list[UrdfJoint]) -> InputError:
    """Every link has one parent, and these are not reached from the root: at least one cycle is among them."""
    got = f"a cycle apart from the root, among {_names([joint.child for joint in joints])}"
    hint = "remove the joint that closes the cycle, and carry one of the links from the root's side"
    return joints[0].element.fault("the tree of links", got, "links that all hang on the root", hint)


def _names(names: dict[str, Element] | list[str]) -> str:
    few = [shown(name) for name in [*names][:MOST_NAMES]]
    return ", ".join(few) + (f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else "")


def followers(joints: Iterable[UrdfJoint]) -> dict[str, Follows]:
    """The joints that mimic another, by their names."""
    return {joint.name: said for joint in joints if (said := follows(joint))}


def hold_followers(joints: tuple[UrdfJoint, ...], data: list[dict[str, Any]]) -> dict[str, Follows]:
    """Lock each joint that mimics where its equation puts it with its leader's zero; what was locked.

    The leader moves; for that its zero is its limit next to zero. Raises :class:`tmodes.errors.InputError` for a leader
    that does not exist, does not move, or follows another itself.
    """
    info = followers(joints)
    moving = {joint.name: sheet for joint, sheet in zip(joints, data, strict=True) if joint.type in MOVING}
    for joint in joints:
        if joint.name in info:
            _check_leader(joint, info[joint.name].leader, moving, info)
    for name, said in info.items():
        leader = moving[said.leader]
        limits = leader.get("limits", {})
        nearest = min(max(0.0, limits.get("lower", 0.0)), limits.get("upper", float("inf")))
        hold(moving[name], said.factor * nearest + said.offset)
    return info


def _check_leader(joint: UrdfJoint, leader: str, moving: dict[str, Any], info: dict[str, Follows]) -> None:
    which = f"joint {joint.name}: mimic"
    if leader not in moving:
        hint = meant(leader, moving, "name a joint that moves, or remove <mimic>")
        raise joint.element.fault(which, f"the unknown joint {shown(leader)}", "a joint that moves", hint)
    if leader in info:
        got, hint = f"{shown(leader)}, which mimics {shown(info[leader].leader)} itself", "name that joint instead"
        raise joint.element.fault(which, got, "a joint that moves by itself", hint)


def mimic_notice(info: Mapping[str, Follows], joints: Sequence[dict[str, Any]]) -> str:
    """What became of the joints that follow others, by the ``joints`` of the sheet; empty where there are none."""
    held = {joint["name"]: joint.get("locked_at", 0.0) for joint in joints if joint.get("state") == "locked"}
    both = {
        True: [f"{name} at {held[name]:.6g} (follows {said.leader})" for name, said in info.items() if name in held],
        False: [f"{name} (follows {said.leader})" for name, said in info.items() if name not in held],
    }
    words = {
        True: "Couplings by mimic are not modelled; these joints are held while those they follow move",
        False: "Couplings by mimic are not modelled; these joints move by themselves",
    }
    return " ".join(f"{words[still]}: {few(names)}." for still, names in both.items() if names)


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
    changed: Sequence[str] = (),
) -> tuple[dict[str, Any], Positions]:
    """Data and positions of the sheet: ``joints`` in the order of the tree, ``bodies`` by their names in the sheet.

    ``changed``: notices of what the file says and the sheet does not.
    The root stands on the ground by a fixed joint of its own, so that it keeps its name.
    """
    notices = [mimic_notice(hold_followers(tree.joints, joints), joints)]
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
    title = (robot.attributes.get("name", "").strip() or Path(robot.source).stem)[:100]
    data: dict[str, Any] = {"format": 1, "kind": "arm", "name": title}
    if info := " ".join(filter(None, notices)):
        data["assumed"] = info
    if read := [*filter(None, notices), *filter(None, (zero_limits(joints),)), *changed]:
        data["notices"] = [notice[:MOST_LETTERS] for notice in read[:MOST_NOTICES]]
    data |= {"joints": joints, "links": [{"name": name, "bodies": [bodies[name]]} for name in weighing]}
    positions = dict.fromkeys(("", "name", "joints", "links"), robot.line)
    positions |= {f"joints.{index}": line for index, line in enumerate(lines)}
    by_name = {name_of(name, tree): link.line for name, link in links.items()}
    return data, positions | {f"links.{index}": by_name[name] for index, name in enumerate(weighing)}


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    return name
