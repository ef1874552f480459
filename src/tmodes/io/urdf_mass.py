"""What moves must weigh something: a moving joint that carries no mass makes the equations of motion singular."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

from tmodes.errors import InputError
from tmodes.io.urdf_joint import MOVING
from tmodes.io.urdf_link import says_massless
from tmodes.io.urdf_tree import Tree, UrdfJoint
from tmodes.io.urdf_values import fault
from tmodes.io.words import shown
from tmodes.io.xml_file import Element

__all__ = ["massless"]

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
        stated = says_massless(links[joint.child])
        if whole[joint.child] == 0.0:
            yield _weightless(joint, stated if stated is not None else links[joint.child])
        elif stated is not None and rigid[joint.child] == 0.0:
            hint = "give its mass, or remove its <inertial> if it is only a frame between two joints"
            yield fault(stated, f"link {joint.child}: mass", "0 on a moving link", "a mass greater than 0 [kg]", hint)


def _weightless(joint: UrdfJoint, element: Element) -> InputError:
    got = f"no mass on the moving joint {shown(joint.name)}, neither its own nor of what it carries"
    return fault(element, f"link {joint.child}: mass", got, "a mass greater than 0 [kg]", HINT)


def _carried(tree: Tree, own: Mapping[str, float]) -> tuple[dict[str, float], dict[str, float]]:
    """Mass [kg] of each link with all that hangs on it, and with what hangs on it by fixed joints alone."""
    whole = {name: own.get(name, 0.0) for name in (tree.root, *(joint.child for joint in tree.joints))}
    rigid = dict(whole)
    for joint in reversed(tree.joints):
        whole[joint.parent] += whole[joint.child]
        rigid[joint.parent] += 0.0 if joint.type in MOVING else rigid[joint.child]
    return whole, rigid
