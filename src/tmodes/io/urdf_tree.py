"""The tree of a URDF's links and joints: one root, one parent for every other link, no cycle. Linear in the number."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from tmodes.errors import InputError
from tmodes.io.urdf_values import fault
from tmodes.io.words import meant, shown
from tmodes.io.xml_file import Element

__all__ = ["Tree", "UrdfJoint", "tree_of"]

MOST_NAMES = 8


@dataclass(frozen=True, eq=False)
class UrdfJoint:
    """A joint's name, kind, and the links that it connects, with its element."""

    name: str
    type: str
    parent: str
    child: str
    element: Element


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
        raise fault(
            robot,
            "the tree of links",
            f"a cycle: each of {_names(links)} is carried",
            "a tree with one root link",
            hint,
        )
    if len(roots) > 1:
        got = f"links that hang together with no joint: {_names(roots)}"
        hint = f"add the joints that carry them, or remove all of them but {shown(roots[0])}"
        raise fault(links[roots[1]], "the tree of links", got, "one tree with one root link", hint)
    tree = Tree(roots[0], tuple(_depth_first(roots[0], joints)))
    reached = set(tree.joints)
    if missing := [joint for joint in joints if joint not in reached]:
        raise _cycle(missing)
    return tree


def _check_ends(joint: UrdfJoint, links: dict[str, Element]) -> None:
    for end, name in (("parent", joint.parent), ("child", joint.child)):
        if name not in links:
            hint = meant(name, links, f"add <link name={shown(name)}>")
            raise fault(joint.element, f"joint {joint.name}: {end}", f"the unknown link {shown(name)}", "a link", hint)
    if joint.parent == joint.child:
        got, hint = f"{shown(joint.child)} on itself", "name two different links"
        raise fault(joint.element, f"joint {joint.name}", got, "a joint between two links", hint)


def _check_one_parent(joints: list[UrdfJoint]) -> None:
    carrier: dict[str, UrdfJoint] = {}
    for joint in joints:
        if first := carrier.get(joint.child):
            got = f"two parents, {shown(first.parent)} by joint {first.name} and {shown(joint.parent)} by {joint.name}"
            hint = "remove one of the two joints: closed loops are not modelled"
            raise fault(joint.element, f"link {joint.child}", got, "carried by one joint", hint)
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
    return fault(joints[0].element, "the tree of links", got, "links that all hang on the root", hint)


def _names(names: dict[str, Element] | list[str]) -> str:
    few = [shown(name) for name in [*names][:MOST_NAMES]]
    return ", ".join(few) + (f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else "")
