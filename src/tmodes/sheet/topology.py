"""The tree of a robot: every link hangs on exactly one joint, and every joint leads back to the base."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from tmodes.kinds.joints.joint import JointSheet, JointState
from tmodes.kinds.schema.quantity import Issue

__all__ = ["BASE", "last_link", "loose_links", "parents", "rooted_order", "tree_issues"]

BASE = "base"
"""Name of the link that stands still: the ground."""

MOST_REPORTED = 8
"""Names listed in one message."""


def parents(joints: Sequence[JointSheet]) -> list[str]:
    """Name of the parent link of each joint; one that names none hangs on the child of the joint before it."""
    before = [BASE, *(joint.child for joint in joints)]
    return [joint.parent or previous for joint, previous in zip(joints, before, strict=False)]


def rooted_order(joints: Sequence[JointSheet]) -> list[int]:
    """Indices of the joints that the base leads to, parents before children, otherwise in the order of the sheet."""
    children: dict[str, list[int]] = {}
    for index, parent in enumerate(parents(joints)):
        children.setdefault(parent, []).append(index)
    found: list[int] = []
    waiting = list(reversed(children.pop(BASE, [])))
    while waiting:
        index = waiting.pop()
        found.append(index)
        waiting.extend(reversed(children.pop(joints[index].child, [])))
    return found


def last_link(joints: Sequence[JointSheet]) -> str:
    """The link behind the most joints that move, of several the last of the sheet: where the tip is by default."""
    names, moving = parents(joints), {BASE: 0}
    for index in rooted_order(joints):
        moving[joints[index].child] = moving[names[index]] + joints[index].kind.size
    most = max(moving.values())
    return next(joint.child for joint in reversed(joints) if moving.get(joint.child) == most)


def loose_links(joints: Sequence[JointSheet]) -> set[str]:
    """Links whose root nothing holds: a joint between them and the base is free, and on no spring."""
    names = parents(joints)
    found: set[str] = set()
    for index in rooted_order(joints):
        joint = joints[index]
        free = joint.state is JointState.FREE and joint.kind.moves and joint.spring is None
        if free or names[index] in found:
            found.add(joint.child)
    return found


def tree_issues(joints: Sequence[JointSheet], links: Sequence[str]) -> Iterator[Issue]:
    """All that keeps joints and the names of the described ``links`` from being one tree, by name."""
    if not joints:
        yield Issue("joints", "an empty robot", "at least one joint", "add a joint and the link that it carries")
        return
    yield from _twice("joints", [joint.name for joint in joints])
    yield from _twice("links", list(links))
    yield from _two_parents(joints)
    yield from _strange_parents(joints)
    yield from _cycles(joints)
    yield from _loose_links(joints, links)


def _twice(group: str, names: Sequence[str]) -> Iterator[Issue]:
    for index, name in enumerate(names):
        if name in names[:index]:
            got, expected = f"the name `{name}` a second time", f"a name that none of the other {group} has"
            yield Issue(f"{group}.{index}.name", got, expected, "rename one of them")


def _two_parents(joints: Sequence[JointSheet]) -> Iterator[Issue]:
    carried = Counter(joint.child for joint in joints)
    for index, joint in enumerate(joints):
        if joint.child == BASE:
            yield Issue(f"joints.{index}.child", "`base`, the ground", "a link that moves", "exchange parent and child")
        holders = [other.name for other in joints if other.child == joint.child]
        if carried[joint.child] > 1 and joint.name != holders[0]:
            got = f"`{joint.child}`, which has {len(holders)} parents: the joints {_list(holders)}"
            yield Issue(f"joints.{index}.child", got, "a link that no other joint carries", "remove one of the joints")


def _strange_parents(joints: Sequence[JointSheet]) -> Iterator[Issue]:
    known = [BASE, *(joint.child for joint in joints)]
    for index, parent in enumerate(parents(joints)):
        if parent not in known:
            got = f"`{parent}`, which no joint carries"
            yield Issue(f"joints.{index}.parent", got, f"one of {_list(known)}", "check the spelling of the link")


def _cycles(joints: Sequence[JointSheet]) -> Iterator[Issue]:
    """Joints that the base does not lead to although each has a known parent: they hang on each other."""
    reached = set(rooted_order(joints))
    names = parents(joints)
    holder = {joint.child: index for index, joint in enumerate(joints)}
    info: set[int] = set()
    for start in range(len(joints)):
        path: list[int] = []
        index: int | None = start
        while index is not None and index not in reached and index not in info and index not in path:
            path.append(index)
            index = holder.get(names[index])
        info.update(path)
        if index in path:
            links = [joints[k].child for k in reversed(path[path.index(index) :])]
            got, hint = f"a cycle of the links {_list([*links, links[0]], ' -> ')}", "hang one of them on another link"
            yield Issue(f"joints.{index}.parent", got, "joints that lead back to `base`", hint)


def _loose_links(joints: Sequence[JointSheet], links: Sequence[str]) -> Iterator[Issue]:
    carried = {joint.child for joint in joints}
    loose = [(index, name) for index, name in enumerate(links) if name not in carried]
    for index, name in loose:
        if name == BASE:
            got, hint = "`base`, the ground", "remove it: what stands still has no dynamics"
            yield Issue(f"links.{index}.name", got, "a link that a joint carries", hint)
        else:
            got = f"`{name}`, a disconnected link: no joint carries it"
            hint = "add its joint, or check the spelling"
            yield Issue(f"links.{index}.name", got, f"one of {_list(sorted(carried))}", hint)


def _list(names: Sequence[str], between: str = ", ") -> str:
    more = f"{between}... ({len(names)} in all)" if len(names) > MOST_REPORTED else ""
    return between.join(names[:MOST_REPORTED]) + more
