"""Sheets to start from, and the pose of a chain's parts by plain composition of what stands in it."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from tmodes.chain.chain import Chain
from tmodes.errors import InputErrors
from tmodes.frame import Placement
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.strain import Beam
from tmodes.sheet import Robot

SECTION = {"bending_stiffness": [120.0, 80.0], "torsional_stiffness": 60.0, "mass_per_length": 0.7}
SECTION = {**SECTION, "polar_inertia_per_length": 2e-4}


def joint(name: str, child: str, **more: Any) -> dict[str, Any]:
    """A revolute joint about z."""
    return {"name": name, "type": "revolute", "child": child, "axis": [0, 0, 1], **more}


def body(mass: float = 1.0, **more: Any) -> dict[str, Any]:
    """A body with inertia about every axis."""
    return {"mass": mass, "inertia": {"xx": 0.02, "yy": 0.03, "zz": 0.025}, **more}


def beam(**more: Any) -> dict[str, Any]:
    """A strain beam of given stiffnesses."""
    return {"model": "strain", "functions": 3, "length": 0.6, "damping_time": 2e-4, "section": SECTION, **more}


def sheet(**more: Any) -> dict[str, Any]:
    """A right sheet of two links, the first of which bends."""
    motor = {"inertia": 0.175, "side": "joint", "friction": {"viscous": 0.5}}
    data = {
        "format": 1,
        "kind": "arm",
        "name": "two",
        "joints": [
            joint("shoulder", "upper", motor=motor, gear={"stiffness": 4700.0, "damping": 2.0}),
            joint("elbow", "fore", axis=[0, 1, 0]),
        ],
        "links": [{"name": "upper", "beam": beam()}, {"name": "fore", "bodies": [body()]}],
    }
    return copy.deepcopy({**data, **more})


def one_link(link: dict[str, Any], **more: Any) -> dict[str, Any]:
    """A sheet of one joint and this link."""
    return sheet(joints=[joint("pivot", "rod", **more)], links=[{"name": "rod", **link}])


def problem(data: Any) -> str:
    """What is said of plain data; empty for a right sheet."""
    try:
        Robot.from_data(data)
    except InputErrors as error:
        return str(error)
    return ""


def changed(change: Callable[[dict[str, Any]], Any]) -> dict[str, Any]:
    """The sheet of two links with something done to it."""
    data = sheet()
    change(data)
    return data


def matrix(placement: Placement) -> np.ndarray:
    """A placement as a matrix (4, 4)."""
    out = np.eye(4)
    out[:3, :3], out[:3, 3] = placement.rotation, placement.position
    return out


def at(position=(0, 0, 0), rpy=(0, 0, 0)) -> np.ndarray:
    """A matrix (4, 4) of a position and fixed-axis angles, by SciPy."""
    out = np.eye(4)
    out[:3, :3], out[:3, 3] = Rotation.from_euler("xyz", rpy).as_matrix(), position
    return out


def turned(axis, angle: float) -> np.ndarray:
    """A rotation (4, 4) about a direction, by SciPy."""
    out = np.eye(4)
    out[:3, :3] = Rotation.from_rotvec(angle * np.asarray(axis) / np.linalg.norm(axis)).as_matrix()
    return out


def points(chain: Chain, values: dict[str, float]) -> dict[str, np.ndarray]:
    """Matrix (4, 4) of each point of an unbent chain whose joints have these positions; straight at rest."""
    tips, frames = [], []
    for node in chain.nodes:
        before = tips[node.parent] if node.parent >= 0 else matrix(chain.base)
        value = values.get(node.joint.name, 0.0)
        motion = np.eye(4)
        if node.joint.kind is joint_kind("revolute"):
            motion = turned(node.joint.axis, value)
        elif node.joint.kind is joint_kind("prismatic"):
            motion = at(node.joint.axis * value)
        frames.append(before @ matrix(node.joint.placement) @ motion)
        length = 0.0 if isinstance(node.link, RigidLink) else node.link.length
        if isinstance(node.link, Beam):
            assert not node.link.rest_curvature.any()
        tips.append(frames[-1] @ at((length, 0, 0)))
    out = {}
    for point in chain.points:
        link = chain.nodes[point.node].link
        along = 0.0 if isinstance(link, RigidLink) else point.s * link.length
        out[point.name] = frames[point.node] @ at((along, 0, 0)) @ matrix(point.offset)
    return out


def arm_of(data: Any) -> Any:
    """The arm of plain data, whose parts a test knows to be there."""
    return Robot.from_data(data)
