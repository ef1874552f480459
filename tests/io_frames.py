"""Frames of an arm without its dynamics, by matrices alone: of a sheet's plain data, and of a chain."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from tmodes.frame import Placement
from tmodes.kinds.joints.registry import joint_kind
from tmodes.sheet import Robot

__all__ = ["chain_frames", "mass_matrix", "matrix", "sheet_frames"]


def matrix(origin: dict[str, Any]) -> np.ndarray:
    """The matrix (4, 4) of an origin of plain data."""
    frame = np.eye(4)
    if "quaternion" in origin:
        frame[:3, :3] = Rotation.from_quat(origin["quaternion"]).as_matrix()
    else:
        frame[:3, :3] = Rotation.from_euler("xyz", origin.get("rpy", [0, 0, 0])).as_matrix()
    frame[:3, 3] = origin.get("position", [0, 0, 0])
    return frame


def sheet_frames(data: dict[str, Any], angles: dict[str, float]) -> dict[str, np.ndarray]:
    """The frame (4, 4) of each link of a sheet of rigid links."""
    frames = {"base": np.eye(4)}
    for joint in data["joints"]:
        moved = np.eye(4)
        if joint["type"] != "fixed":
            axis = np.array(joint["axis"]) / np.linalg.norm(joint["axis"])
            angle = angles[joint["name"]] if joint["name"] in angles else joint.get("locked_at", 0.0)
            if joint["type"] == "revolute":
                moved[:3, :3] = Rotation.from_rotvec(angle * axis).as_matrix()
            else:
                moved[:3, 3] = angle * axis
        frames[joint["child"]] = frames[joint["parent"]] @ matrix(joint.get("origin", {})) @ moved
    return frames


def chain_frames(data: dict[str, Any], angles: dict[str, float]) -> dict[str, np.ndarray]:
    """The frame (4, 4) of each joint's rigid link, straight beams between, of the chain that a sheet becomes."""
    chain = Robot.from_data(data).chain()
    tips: list[np.ndarray] = []
    frames: dict[str, np.ndarray] = {}
    for node in chain.nodes:
        joint, moved = node.joint, np.eye(4)
        angle = angles.get(joint.name, 0.0)
        if joint.kind is joint_kind("revolute"):
            moved[:3, :3] = Rotation.from_rotvec(angle * joint.axis).as_matrix()
        elif joint.kind is joint_kind("prismatic"):
            moved[:3, 3] = angle * joint.axis
        before = tips[node.parent] if node.parent >= 0 else _four(chain.base)
        frames[joint.name] = before @ _four(joint.placement) @ moved
        along = np.eye(4)
        if node.link.bends:
            along[0, 3] = node.link.length
        tips.append(frames[joint.name] @ along)
    return frames


def _four(placement: Placement) -> np.ndarray:
    frame = np.eye(4)
    frame[:3, :3], frame[:3, 3] = placement.rotation, placement.position
    return frame


def mass_matrix(data: dict[str, Any], angles: dict[str, float], names: list[str]) -> np.ndarray:
    """Mass matrix of a sheet of rigid links for the joints ``names``, from the velocities of each body."""
    frames = sheet_frames(data, angles)
    joints = {joint["child"]: joint for joint in data["joints"]}
    total = np.zeros((len(names), len(names)))
    for link in data["links"]:
        for body in link["bodies"]:
            frame = frames[link["name"]]
            center = (frame @ [*body["center"], 1])[:3]
            linear, angular = np.zeros((3, len(names))), np.zeros((3, len(names)))
            holder = joints.get(link["name"])
            while holder is not None:
                if holder["name"] in names:
                    column, at = names.index(holder["name"]), frames[holder["child"]]
                    axis = at[:3, :3] @ (np.array(holder["axis"]) / np.linalg.norm(holder["axis"]))
                    turns = holder["type"] == "revolute"
                    linear[:, column] = np.cross(axis, center - at[:3, 3]) if turns else axis
                    angular[:, column] = axis if turns else 0
                holder = joints.get(holder["parent"])
            turn = frame[:3, :3] @ matrix({"rpy": body.get("rpy", [0, 0, 0])})[:3, :3]
            total += body["mass"] * linear.T @ linear + angular.T @ turn @ _inertia(body) @ turn.T @ angular
    return total


def _inertia(body: dict[str, Any]) -> np.ndarray:
    inertia = body.get("inertia", {})
    return np.array([[inertia.get("".join(sorted(a + b)), 0.0) for b in "xyz"] for a in "xyz"])
