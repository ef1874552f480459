"""Rigid chains to Pinocchio's models and back, for comparison. Pinocchio is imported where it is used."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np

from tmodes.chain.chain import Chain, Joint, Motor, Node, Point
from tmodes.frame import Placement
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink

__all__ = ["chain_of", "model_of"]

AXES = {"X": 0, "Y": 1, "Z": 2}


def model_of(chain: Chain) -> Any:
    """Pinocchio's model of a chain of rigid links; fixed joints become part of their parents; tip = last frame."""
    pinocchio: Any = import_module("pinocchio")
    model = pinocchio.Model()
    model.gravity.linear = np.asarray(chain.gravity)
    homes: list[tuple[int, Any]] = []
    for node in chain.nodes:
        parent, home = homes[node.parent] if node.parent >= 0 else (0, _se3(chain.base))
        placed = home * _se3(node.joint.placement)
        if node.joint.kind is not joint_kind("fixed"):
            parent = model.addJoint(parent, _joint(node.joint), placed, node.joint.name)
            placed = pinocchio.SE3.Identity()
            if node.joint.motor is not None:
                model.armature[model.joints[parent].idx_v] = node.joint.motor.inertia
        homes.append((parent, placed))
        assert isinstance(node.link, RigidLink)
        for body in node.link.bodies:
            inertia = pinocchio.Inertia(body.mass, np.asarray(body.center), np.asarray(body.inertia))
            model.appendBodyToJoint(parent, inertia, placed)
    for point in chain.points or (chain.tip,):
        parent, placed = homes[point.node]
        kind = pinocchio.FrameType.OP_FRAME
        model.addFrame(pinocchio.Frame(point.name, parent, placed * _se3(point.offset), kind))
    return model


def _se3(placement: Placement) -> Any:
    pinocchio: Any = import_module("pinocchio")
    return pinocchio.SE3(np.asarray(placement.rotation), np.asarray(placement.position))


def _joint(joint: Joint) -> Any:
    pinocchio: Any = import_module("pinocchio")
    revolute = joint.kind is joint_kind("revolute")
    kind = pinocchio.JointModelRevoluteUnaligned if revolute else pinocchio.JointModelPrismaticUnaligned
    return kind(*[float(part) for part in joint.axis])


def chain_of(model: Any, tip: str) -> Chain:
    """The chain of a Pinocchio model whose joints are revolute or prismatic; ``tip``: name of one of its frames."""
    nodes = tuple(_node(model, i) for i in range(1, model.njoints))
    frame = model.frames[model.getFrameId(tip)]
    offset = Placement(np.array(frame.placement.rotation), np.array(frame.placement.translation))
    points = (Point("tip", frame.parentJoint - 1, offset=offset),)
    return Chain(model.name, nodes, np.array(model.gravity.linear), points=points)


def _node(model: Any, i: int) -> Node:
    placed, inertia, name = model.jointPlacements[i], model.inertias[i], model.names[i]
    kind, axis = _axis(model.joints[i])
    rotor = float(model.armature[model.joints[i].idx_v])
    joint = Joint(
        name,
        kind,
        Placement(np.array(placed.rotation), np.array(placed.translation)),
        axis,
        motor=Motor(rotor) if rotor else None,
    )
    body = Body(float(inertia.mass), np.array(inertia.lever), np.array(inertia.inertia))
    return Node(f"link_{name}", int(model.parents[i]) - 1, joint, RigidLink((body,)))


def _axis(joint: Any) -> tuple[Any, Any]:
    """Kind and axis of a joint from what Pinocchio calls it: JointModelRZ, JointModelPX, ...RevoluteUnaligned."""
    name = joint.shortname().removeprefix("JointModel")
    kind = joint_kind("revolute") if name.startswith("R") else joint_kind("prismatic")
    if name.endswith("Unaligned"):
        return kind, np.array(joint.extract().axis)
    return kind, np.eye(3)[AXES[name[-1]]]
