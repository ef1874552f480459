"""The rungs of the ladder: one robot with each model of its links; and the same robot with its motors' motion given."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Axis, Chain, Joint, Node
from tmodes.errors import InputError
from tmodes.frame import Placement
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.links.registry import RigidLink
from tmodes.sheet import Robot
from tmodes.sheet.parts import LinkSheet
from tmodes.sheet.robot import RECURSION

__all__ = ["SEGMENTS", "driven", "input_mix", "moved_chain", "rungs", "whole_chain"]

SEGMENTS = (1, 2, 3)
"""Numbers of segments, and of modes, that are tried."""


def rungs(robot: Robot, finest: int) -> Iterator[tuple[str, Robot]]:
    """Name and robot of every rung, from rigid to ``strain(finest)``; directions that do not bend stay so.

    ``modes`` are there where every beam is straight and bends alike in both planes.

    Raises :class:`tmodes.errors.InputError` for a robot without a beam, or with one that has no other model.
    """
    if not any(link.beam for link in robot.links):
        hint = "give a link a `beam`; without one there is only one model"
        raise InputError("links", "no link with a beam", "at least one link that can bend", hint)
    yield "rigid", _with_beams(robot, "rigid", None)
    for count in SEGMENTS:
        yield f"segments({count})", _with_beams(robot, "segments", count)
    for count in SEGMENTS:
        if all(link.beam is None or link.beam.variant("modes", count) for link in robot.links):
            yield f"modes({count})", _with_beams(robot, "modes", count)
    for count in range(1, finest + 1):
        yield f"strain({count})", _with_beams(robot, "strain", count)


def _with_beams(robot: Robot, model: str, count: int | None) -> Robot:
    """The robot with another model of every beam, by the recursion: a system's energies are those of its own links."""

    def changed(link: LinkSheet) -> LinkSheet:
        if link.beam is None:
            return link
        beam = link.beam.variant(model, count)
        if beam is None:
            expected, hint = f"a link that can also be modelled as `{model}`", "describe it as one beam"
            raise InputError(f"links.{link.name}.beam", link.beam.description, expected, hint)
        return link.model_copy(update={"beam": beam})

    return robot.model_copy(update={"links": tuple(map(changed, robot.links)), "equations": RECURSION})


def whole_chain(robot: Robot) -> Chain:
    """The chain of a robot with all its motors, whatever its drives prescribe."""
    return robot.model_copy(update={"drives": ()}).chain()


def moved_chain(chain: Chain) -> Chain:
    """The same robot, its gear inputs given motions: an elastic drive is a given joint, then a spring on the same axis.

    The given joints come in the order of the chain's moving joints that have a drive of their own.
    """
    nodes: list[Node] = []
    last: dict[int, int] = {-1: -1}
    given = drive_kind("prescribed")
    for index, node in enumerate(chain.nodes):
        parent, joint = last[node.parent], node.joint
        if any(axis.drive.has_motor for axis in joint.axes):
            _refuse_several(joint)
            name = f"{joint.name}.input"
            nodes.append(Node(name, parent, replace(joint, name=name, drive=given, gear=None), RigidLink()))
            sprung = replace(joint, placement=Placement(), drive=drive_kind("spring"), motor=None, rest=0.0)
            parent, joint = len(nodes) - 1, sprung
        elif joint.moves and joint.drive.takes_effort:
            joint = replace(joint, drive=given, drives=())
        nodes.append(Node(node.name, parent, joint, node.link))
        last[index] = len(nodes) - 1
    points = tuple(replace(point, node=last[point.node]) for point in chain.points or (chain.tip,))
    return replace(chain, nodes=tuple(nodes), points=points, couplings=None)


def _refuse_several(joint: Joint) -> None:
    if joint.kind.size > 1:
        got, expected = f"an elastic gear on a {joint.kind} joint", "one coordinate behind each elastic gear"
        raise InputError(f"joints.{joint.name}", got, expected, "make its gear rigid for the model hierarchy")


def driven(chain: Chain) -> list[Axis]:
    """Coordinates that a motor or an effort moves, in the order of the chain."""
    return [axis for axis in chain.axes if axis.drive.takes_effort]


def input_mix(chain: Chain) -> NDArray[np.float64]:
    """Given joints over motors, in the order of :func:`driven`: the couplings of the gears' inputs."""
    joints = driven(chain)
    mix = np.eye(len(joints))
    if chain.couplings is not None:
        elastic = [k for k, axis in enumerate(joints) if axis.drive.has_motor]
        mix[np.ix_(elastic, elastic)] = chain.couplings
    return mix
