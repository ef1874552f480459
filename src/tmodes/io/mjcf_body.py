"""Bodies and joints of a compiled MuJoCo model as links and joints of a robot's sheet.

MuJoCo's joint stands at an anchor in its body's frame; the sheet's link frame stands at its joint. So a link's frame
has the body's axes and lies at the anchor of the body's last joint. A body with several joints is carried by frames
without mass between them. A joint whose position is `ref` in the drawn pose is turned back by it, so that its
positions are MuJoCo's own.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.words import shown
from tmodes.io.yaml_file import Positions
from tmodes.kinds.links.body import entries
from tmodes.kinds.schema.axes import matrix_quaternion, quaternion_matrix, rotation_about
from tmodes.sheet.topology import BASE

__all__ = ["sheet_of_model"]

Array = NDArray[np.float64]
Lines = Mapping[tuple[str, str], int]

HINGE = 3
KINDS = {0: "a free joint (a free-flying base)", 1: "a ball joint"}


def sheet_of_model(model: Any, name: str, lines: Lines, source: str) -> tuple[dict[str, Any], Positions]:
    """Data and positions of the sheet of a compiled model; ``lines`` says where bodies and joints are written.

    Raises :class:`tmodes.errors.InputError` for a joint that the sheet cannot tell of.
    """
    reader = _Reader(model, lines, source)
    for body in range(1, model.nbody):
        reader.body(body)
    if not reader.joints:
        raise InputError("the model", "no body", "bodies and joints", "check that this is a robot", source)
    data: dict[str, Any] = {"format": 1, "kind": "arm", "name": name}
    if BASE in reader.names:
        data["assumed"] = f"The file's body {BASE}, which is not the ground, is called {BASE}_frame here."
    data |= {"gravity": model.opt.gravity.tolist(), "joints": reader.joints, "links": reader.links}
    return data, reader.positions


class _Reader:
    """What has been read of a model so far."""

    def __init__(self, model: Any, lines: Lines, source: str) -> None:
        self.model = model
        self.lines = lines
        self.source = source
        self.names = [model.body(i).name or f"body_{i}" for i in range(model.nbody)]
        self.anchors = np.zeros((model.nbody, 3))
        self.driven = {int(joint) for joint in model.actuator_trnid[:, 0]} if model.nu else set()
        self.joints: list[dict[str, Any]] = []
        self.links: list[dict[str, Any]] = []
        self.positions: Positions = {"": 1, "joints": 1, "links": 1}

    def body(self, body: int) -> None:
        """Read a body: its joints one after the other, then its mass."""
        model, parent = self.model, int(self.model.body_parentid[body])
        place = model.body_pos[body] - self.anchors[parent]
        turn = quaternion_matrix(np.roll(model.body_quat[body], -1))
        first, count = int(model.body_jntadr[body]), int(model.body_jntnum[body])
        holder, link = self._link(parent), self._link(body)
        if count == 0:
            fixed = {"name": f"fix_{self.names[body]}", "type": "fixed", "parent": holder, "child": link}
            self._add(fixed | {"origin": _origin(turn, place)}, ("body", self.names[body]))
        anchor = np.zeros(3)
        for joint in range(first, first + count):
            last = joint == first + count - 1
            child = link if last else f"{link}_{joint - first + 1}"
            at = model.jnt_pos[joint] if model.jnt_type[joint] == HINGE else anchor
            data = self._joint(joint) | {"parent": holder, "child": child}
            data["origin"] = self._joint_origin(joint, turn, place + turn @ (at - anchor))
            self._add(data, ("joint", data["name"]))
            holder, place, turn, anchor = child, np.zeros(3), np.eye(3), at
        self.anchors[body] = anchor
        self._weigh(body, link)

    def _joint_origin(self, joint: int, turn: Array, place: Array) -> dict[str, list[float]]:
        """Where the joint's zero is: the drawn pose, turned or moved back by `ref`."""
        ref, axis = float(self.model.qpos0[self.model.jnt_qposadr[joint]]), self.model.jnt_axis[joint]
        if self.model.jnt_type[joint] == HINGE:
            return _origin(turn @ rotation_about(axis, -ref), place)
        return _origin(turn, place - turn @ axis * ref)

    def _joint(self, joint: int) -> dict[str, Any]:
        """Name, type, axis, limits, friction, and what drives it."""
        model, dof = self.model, int(self.model.jnt_dofadr[joint])
        name = model.joint(joint).name or f"joint_{joint + 1}"
        kind = int(model.jnt_type[joint])
        if kind in KINDS:
            hint = "write it as hinges and slides, or fix the base to the world"
            raise self._fault(name, KINDS[kind], "hinge or slide", hint)
        data: dict[str, Any] = {"name": name, "type": "revolute" if kind == HINGE else "prismatic"}
        data |= {"axis": model.jnt_axis[joint].tolist()}
        limits = _limits(model, joint)
        friction = {"viscous": float(model.dof_damping[dof]), "coulomb": float(model.dof_frictionloss[dof])}
        data |= {"limits": limits} if limits else {}
        data |= {"friction": friction} if any(friction.values()) else {}
        self._refuse_curved(joint, dof, name)
        stiffness, armature = float(model.jnt_stiffness[joint]), float(model.dof_armature[dof])
        if stiffness:
            return data | self._spring(joint, name, stiffness, armature)
        return data | ({"motor": {"inertia": armature, "side": "joint"}} if armature else {})

    def _spring(self, joint: int, name: str, stiffness: float, armature: float) -> dict[str, Any]:
        if joint in self.driven or armature:
            got = "a spring next to an actuator" if joint in self.driven else "a spring next to an armature"
            hint = "remove one of them, or write the arm as a sheet with an elastic gear"
            raise self._fault(name, got, "a passive spring, or none", hint)
        rest = float(self.model.qpos_spring[self.model.jnt_qposadr[joint]])
        return {"state": "locked", "locked_at": rest, "gear": {"stiffness": stiffness, "damping": 0.0}}

    def _refuse_curved(self, joint: int, dof: int, name: str) -> None:
        curved = {"jnt_stiffnesspoly": joint, "dof_dampingpoly": dof}
        for field, index in curved.items():
            if np.any(getattr(self.model, field, np.zeros((index + 1, 1)))[index]):
                raise self._fault(name, "a nonlinear spring or damper", "a linear one", "give one number")

    def _weigh(self, body: int, link: str) -> None:
        model, mass = self.model, float(self.model.body_mass[body])
        if mass <= 0.0:
            return
        axes = quaternion_matrix(np.roll(model.body_iquat[body], -1))
        inertia = entries(axes @ np.diag(model.body_inertia[body]) @ axes.T)
        center = (model.body_ipos[body] - self.anchors[body]).tolist()
        self.positions[f"links.{len(self.links)}"] = self.lines.get(("body", self.names[body]), 1)
        self.links.append(
            {"name": link, "bodies": [{"name": link, "mass": mass, "center": center, "inertia": inertia}]}
        )

    def _link(self, body: int) -> str:
        if body == 0:
            return BASE
        return f"{BASE}_frame" if self.names[body] == BASE else self.names[body]

    def _add(self, joint: dict[str, Any], key: tuple[str, str]) -> None:
        self.positions[f"joints.{len(self.joints)}"] = self.lines.get(key, 1)
        self.joints.append(joint | {"from": "frame"})

    def _fault(self, name: str, got: str, expected: str, hint: str) -> InputError:
        place = f"{self.source}:{self.lines.get(('joint', name), 1)}"
        return InputError(f"joint {shown(name)}", got, expected, hint, place)


def _limits(model: Any, joint: int) -> dict[str, float]:
    limits: dict[str, float] = {}
    if model.jnt_limited[joint]:
        limits |= {"lower": float(model.jnt_range[joint, 0]), "upper": float(model.jnt_range[joint, 1])}
    if model.jnt_actfrclimited[joint] and model.jnt_actfrcrange[joint, 1] > 0:
        limits["effort"] = float(model.jnt_actfrcrange[joint, 1])
    return limits


def _origin(turn: Array, place: Array) -> dict[str, list[float]]:
    return {"position": place.tolist(), "quaternion": matrix_quaternion(turn)}
