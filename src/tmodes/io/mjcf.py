"""Bodies and joints of an MJCF file, compiled by MuJoCo, as links and joints of a robot's sheet.

The file is looked through before MuJoCo opens it: no file outside the robot's folders, nothing without bound.

MuJoCo's joint stands at an anchor in its body's frame; the sheet's link frame stands at its joint. So a link's frame
has the body's axes and lies at the anchor of the body's last joint. A body with several joints is carried by frames
without mass between them. A joint whose position is `ref` in the drawn pose is turned back by it, so that its
positions are MuJoCo's own. Actuators become drives (:mod:`.mjcf_drives`); what is not taken is named
(:mod:`.mjcf_read`).
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.files import FilePath, Folders, Roots, folders_of
from tmodes.io.mjcf_parts import (
    FILE_KEYS,
    MJCF,
    MOST_LOADS,
    SHAPES,
    Assets,
    JointActuators,
    compensation,
    servos,
    without_unread,
)
from tmodes.io.units import finite_float
from tmodes.io.unread import Left, few, sentences
from tmodes.io.urdf_parts import hold
from tmodes.io.words import shown, shown_path
from tmodes.io.xml_file import Element, read_xml
from tmodes.io.yaml_file import Positions
from tmodes.kinds.links.body import entries
from tmodes.kinds.schema.axes import matrix_quaternion, quaternion_matrix, rotation_about
from tmodes.sheet.robot import MOST_LETTERS, MOST_NOTICES
from tmodes.sheet.topology import BASE

__all__ = ["check_mjcf", "sheet_of_mjcf"]

Array = NDArray[np.float64]
Lines = Mapping[tuple[str, str], int]
"""Where each body and joint, by its tag and its name, is written."""

HINGE = 3
OTHER_KINDS = {0: "a free joint (a free-flying base)", 1: "a ball joint"}

FOLDER_KEYS = ("meshdir", "texturedir", "assetdir")
_EQUAL_JOINTS = 2
"""Of mjtEq: one joint's position is a polynomial of another's."""

NOT_BODIES = {"replicate", "composite", "flexcomp", "flex", "attach", "plugin", "extension"}
SIZES = ("nrow", "ncol", "width", "height", "size")
MOST = {"size": 1e6} | dict.fromkeys(("hfield", "texture", "numeric"), 8192.0)
MOST_FILES = 100


def check_mjcf(root: Element, folders: Folders) -> tuple[list[Element], Assets]:
    """The root elements of a model and of all that it includes, and the files of its shapes.

    InputError for a path that leaves the folders and for elements that stand for unbounded numbers of others.
    """
    roots, waiting = [], [root]
    while waiting:
        roots.append(element := waiting.pop())
        if len(roots) > MOST_FILES:
            got, most = f"more than {MOST_FILES} files", f"at most {MOST_FILES}"
            raise element.fault("include", got, most, "look for a file that includes itself")
        waiting.extend(_included(element, folders))
    bases = [folders.home, *(base for one in roots for base in _asset_folders(one, folders))]
    assets = Assets()
    for one in roots:
        for element in one.within():
            _check(element, folders, bases)
            if element.tag in SHAPES:
                assets.note(element, folders, bases)
    return roots, assets


def _included(root: Element, folders: Folders) -> Iterator[Element]:
    """Roots of the files that are read as further models."""
    for element in root.within():
        if element.tag in {"include", "model"} and "file" in element.attributes:
            name = element.attributes["file"]
            path = folders.find(name, element.label, element.place)
            if path is None:
                raise element.wrong(f"{shown(name)}, which is not there", "a file", "check the path")
            yield read_xml(path)


def _asset_folders(root: Element, folders: Folders) -> Iterator[Path | InputError]:
    """Folders of meshes and textures; in place of one that may not be opened why."""
    for element, key in product(root.within(), FOLDER_KEYS):
        if element.tag == "compiler" and (name := element.attributes.get(key, "")):
            try:
                yield folders.find(name, f"compiler {key}", element.place) or folders.home
            except InputError as error:
                yield error


def _check(element: Element, folders: Folders, bases: Sequence[Path | InputError]) -> None:
    which = element.label
    if element.tag in NOT_BODIES:
        got, expected = f"the element {which}", "bodies, joints, geoms and assets"
        raise element.wrong(got, expected, "write the bodies and joints out")
    for key in FILE_KEYS if element.tag not in SHAPES else ():
        if name := element.attributes.get(key, ""):
            for base in bases:
                if isinstance(base, InputError):
                    raise base
                folders.find(name, f"{which} {key}", element.place, base)
    most = MOST.get(element.tag)
    for key, text in element.attributes.items() if most else ():
        if (key in SIZES or element.tag == "size") and (finite_float(text.strip()) or 0.0) > (most or 0.0):
            raise element.wrong(f"{key} = {shown(text)}", f"at most {most:g}", "write a sensible size")


def sheet_of_mjcf(
    path: FilePath, root: Element, roots: Roots = (), trust_paths: bool = False
) -> tuple[dict[str, Any], Positions]:
    """Data and positions of the sheet of an MJCF file, whose ``root`` element is read already.

    Raises :class:`tmodes.errors.InputError` for a broken model, one that is more than a robot, a path that leaves the
    folders, and where MuJoCo is not installed.
    """
    folders = folders_of(path, roots, trust_paths)
    (elements, assets), source = check_mjcf(root, folders), shown_path(path)
    model = _compiled(path, source, folders, assets)
    lines = {
        (element.tag, element.attributes["name"]): element.line
        for one in elements
        if one.source == source
        for element in one.within()
        if element.tag in {"body", "joint"} and "name" in element.attributes
    }
    reader = _MjcfReader(model, lines, source)
    for body in range(1, model.nbody):
        reader.body(body)
    if not reader.joints:
        raise InputError("the model", "no body", "bodies and joints", "check that this is a robot", source)
    name = root.attributes.get("model", "").strip()[:100] or "mjcf"
    renamed = f"The file's body {BASE}, which is not the ground, is called {BASE}_frame here."
    if BASE in reader.names:
        reader.said.append(renamed)
    reader.hold_followers()
    if reader.undriven:
        info = "are held where they start (`state: free` lets one move by itself)"
        reader.said.append(f"Joints without an actuator {info}: {few(reader.undriven)}.")
    assumed = " ".join(reader.said)
    gravity = np.zeros(3) if model.opt.disableflags & _GRAVITY_OFF else model.opt.gravity
    data: dict[str, Any] = {"format": 1, "kind": "arm", "name": name}
    data |= {"gravity": gravity.tolist(), "joints": reader.joints, "links": reader.links}
    data |= {key: group for key, group in (("drives", reader.drives), *reader.borne(gravity)) if group}
    left = [one for root in elements for one in MJCF.left(root)]
    notices = [*reader.said, *assets.notices(), *sentences([*left, *reader.left, *_untouched(model)])]
    data |= {"assumed": assumed[:MOST_LETTERS]} if assumed else {}
    data |= {"notices": [notice[:MOST_LETTERS] for notice in notices[:MOST_NOTICES]]} if notices else {}
    return data, reader.positions


_BOUNDS = {
    "upper": ("the stop at the ends of `range`", "a run reports a joint that passes its limits, and nothing stops it"),
    "effort": ("what clips a force", "a run reports an effort beyond its limit, and nothing clips it"),
}
"""What MuJoCo does at limits, by the key of a sheet's."""

_GRAVITY_OFF, _CONTACT_OFF = 1 << 7, 1 << 4
"""Bits of mjtDisableBit."""


def _untouched(model: Any) -> Iterator[Left]:
    """Geoms of a moving body that MuJoCo lets touch other bodies or the ground."""
    solid = [k for k in range(model.ngeom) if model.geom_contype[k] or model.geom_conaffinity[k]]
    moving = {int(model.geom_bodyid[k]) for k in solid if model.body_weldid[model.geom_bodyid[k]]}
    several = len({int(model.body_weldid[model.geom_bodyid[k]]) for k in solid}) > 1
    if moving and several and not model.opt.disableflags & _CONTACT_OFF:
        effect = "bodies pass through each other; what touches is said under `contact`"
        yield from (Left("the contact of <geom>", effect, _body(model, body)) for body in sorted(moving))


def _body(model: Any, body: int) -> str:
    return f"body {model.body(body).name or body}"


def _compiled(path: FilePath, source: str, folders: Folders, assets: Assets) -> Any:
    try:
        mujoco: Any = import_module("mujoco")  # its binary module has no types
    except ImportError:
        hint = "install it with `pip install tmodes[peers]`, or write the arm as URDF"
        raise InputError(source, "no MuJoCo", "read with MuJoCo", hint) from None
    try:
        file = str(folders.home / os.path.basename(path))  # noqa: PTH119 (bytes paths)
        unread = without_unread(mujoco, file, assets.allowed, source) if assets.unread else None
        model = unread or mujoco.MjModel.from_xml_path(file)
    except ValueError as error:
        got = f"a model that MuJoCo refuses ({shown(' '.join(str(error).split()))})"
        raise InputError("the model", got, "a valid MJCF", "correct what MuJoCo reports", source) from None
    loops = int(np.count_nonzero(model.eq_type != _EQUAL_JOINTS)) if model.neq else 0
    more = {"equality constraints of bodies or tendons": loops, "mocap bodies": model.nmocap}
    for what, count in more.items():
        if count:
            got = f"a model with {what}, which no tree of joints with one axis has"
            hint = "remove them, or model the mechanism as an open tree"
            raise InputError("the model", got, "bodies and joints alone", hint, source)
    return model


class _MjcfReader:
    """What has been read of a model so far."""

    def __init__(self, model: Any, lines: Lines, source: str) -> None:
        self.model, self.lines, self.source = model, lines, source
        self.names = [model.body(i).name or f"body_{i}" for i in range(model.nbody)]
        self.frames = [BASE, *(f"{BASE}_frame" if name == BASE else name for name in self.names[1:])]
        self.anchors = np.zeros((model.nbody, 3))
        self.servos, self.left = servos(model)
        self.drives: list[dict[str, Any]] = []
        self.said: list[str] = []
        self.undriven: list[str] = []
        self.weighed: dict[int, tuple[str, Array]] = {}
        self.joints: list[dict[str, Any]] = []
        self.links: list[dict[str, Any]] = []
        self.positions: Positions = {"": 1, "joints": 1, "links": 1}

    def body(self, body: int) -> None:
        """Read a body: its joints one after the other, then its mass."""
        model, parent = self.model, int(self.model.body_parentid[body])
        place = model.body_pos[body] - self.anchors[parent]
        turn = quaternion_matrix(np.roll(model.body_quat[body], -1))
        first, count = int(model.body_jntadr[body]), int(model.body_jntnum[body])
        holder, link = self.frames[parent], self.frames[body]
        if count == 0:
            fixed = {"name": f"fix_{self.names[body]}", "type": "fixed", "parent": holder, "child": link}
            self._add(fixed | {"origin": _origin(turn, place)}, ("body", self.names[body]))
        anchor = np.zeros(3)
        for joint in range(first, first + count):
            last = joint == first + count - 1
            child = link if last else f"{link}_{joint - first + 1}"
            turns = model.jnt_type[joint] == HINGE
            at = model.jnt_pos[joint] if turns else anchor
            data = self._joint(joint) | {"parent": holder, "child": child}
            ref, axis = float(model.qpos0[model.jnt_qposadr[joint]]), model.jnt_axis[joint]
            zero = place + turn @ (
                at - anchor if turns else -ref * axis
            )  # the drawn pose, moved or turned back by `ref`
            data["origin"] = _origin(turn @ rotation_about(axis, -ref) if turns else turn, zero)
            self._add(data, ("joint", data["name"]))
            holder, place, turn, anchor = child, np.zeros(3), np.eye(3), at
        self.anchors[body] = anchor
        self._weigh(body, link)

    def _joint(self, joint: int) -> dict[str, Any]:
        """Name, type, axis, limits, friction, and what drives it."""
        model, dof = self.model, int(self.model.jnt_dofadr[joint])
        name, kind = model.joint(joint).name or f"joint_{joint + 1}", int(model.jnt_type[joint])
        if kind in OTHER_KINDS:
            hint = "write it as hinges and slides, or fix the base to the world"
            raise self._fault(name, OTHER_KINDS[kind], "hinge or slide", hint)
        data: dict[str, Any] = {"name": name, "type": "revolute" if kind == HINGE else "prismatic"}
        data["axis"] = model.jnt_axis[joint].tolist()
        servo = self.servos.get(joint, JointActuators(most=np.inf))
        inertia = float(model.dof_armature[dof]) + servo.inertia
        viscous = float(model.dof_damping[dof]) + servo.viscous
        friction = {"viscous": viscous, "coulomb": float(model.dof_frictionloss[dof])}
        data |= {"limits": limits} if (limits := _limits(model, joint, servo.most)) else {}
        self.left += [Left(*bound, name) for key, bound in _BOUNDS.items() if key in limits]
        data |= {"friction": friction} if any(friction.values()) else {}
        for field, index in (("jnt_stiffnesspoly", joint), ("dof_dampingpoly", dof)):
            if np.any(getattr(model, field, np.zeros((index + 1, 1)))[index]):
                raise self._fault(name, "a nonlinear spring or damper", "a linear one", "give one number")
        return data | self._driven(joint, name, float(model.jnt_stiffness[joint]), inertia)

    def _driven(self, joint: int, name: str, stiffness: float, inertia: float) -> dict[str, Any]:
        """Spring, motor and drive; a joint on a spring alone is free, and with a rotor it has a drive of no effort."""
        rest = float(self.model.qpos_spring[self.model.jnt_qposadr[joint]])
        data: dict[str, Any] = {"spring": {"stiffness": stiffness, "rest": rest}} if stiffness else {}
        servo = self.servos.get(joint)
        if servo is None and stiffness and not inertia:
            return data | {"state": "free"}
        if servo or stiffness:
            self.drives.append((servo or JointActuators()).drive(name))
        elif self.model.nu:
            self.undriven.append(name)
        return data | ({"motor": {"inertia": inertia, "side": "joint"}} if inertia else {})

    def hold_followers(self) -> None:
        """Hold each joint that an equality ties to another, where it stands with the other's drawn pose."""
        model = self.model
        joints = {joint["name"]: joint for joint in self.joints}
        for k in range(model.neq):
            if not model.eq_active0[k]:
                continue
            one, other = int(model.eq_obj1id[k]), int(model.eq_obj2id[k])
            name, leader = (model.joint(j).name or f"joint_{j + 1}" if j >= 0 else "" for j in (one, other))
            at = float(model.qpos0[model.jnt_qposadr[one]] + model.eq_data[k, 0])
            hold(joints[name], at)
            self.undriven = [one for one in self.undriven if one != name]
            self.drives = [drive for drive in self.drives if drive["joint"] != name]
            tied = f"coupled to {leader} by an equality, which is not modelled" if leader else "fixed by an equality"
            self.said.append(f"joint {name} is {tied}: it is held at {at:.6g}.")

    def borne(self, gravity: Array) -> list[tuple[str, list[dict[str, Any]]]]:
        """Points and loads of what is compensated of the weight of bodies."""
        pairs = list(compensation(self.model, self.weighed, gravity))
        if len(pairs) > MOST_LOADS:
            effect = "more bodies than a sheet has loads have it, and gravity acts on them in full"
            self.left += [Left("`gravcomp` of <body>", effect, _body(self.model, body)) for body in self.weighed]
            pairs = []
        if pairs:
            names = few([point["link"] for point, _ in pairs])
            self.said.append(f"gravcomp is taken as loads that bear that share of the weight of a body: {names}.")
        return [("points", [point for point, _ in pairs]), ("loads", [load for _, load in pairs])]

    def _weigh(self, body: int, link: str) -> None:
        model, mass = self.model, float(self.model.body_mass[body])
        if mass <= 0.0:
            return
        axes = quaternion_matrix(np.roll(model.body_iquat[body], -1))
        inertia = entries(axes @ np.diag(model.body_inertia[body]) @ axes.T)
        center = (model.body_ipos[body] - self.anchors[body]).tolist()
        self.weighed[body] = link, center
        self.positions[f"links.{len(self.links)}"] = self.lines.get(("body", self.names[body]), 1)
        bodies = [{"name": link, "mass": mass, "center": center, "inertia": inertia}]
        self.links.append({"name": link, "bodies": bodies})

    def _add(self, joint: dict[str, Any], key: tuple[str, str]) -> None:
        self.positions[f"joints.{len(self.joints)}"] = self.lines.get(key, 1)
        self.joints.append(joint | {"from": "frame"})

    def _fault(self, name: str, got: str, expected: str, hint: str) -> InputError:
        line = self.lines.get(("joint", name), 1)
        return InputError(f"joint {shown(name)}", got, expected, hint, f"{self.source}:{line}")


def _limits(model: Any, joint: int, most: float) -> dict[str, float]:
    """Of position and effort; ``most``: what the actuators can do together."""
    limits: dict[str, float] = {}
    if model.jnt_limited[joint]:
        limits["lower"], limits["upper"] = model.jnt_range[joint].tolist()
    if model.jnt_actfrclimited[joint]:
        most = min(most, float(np.abs(model.jnt_actfrcrange[joint]).max()))
    return limits | ({"effort": most} if np.isfinite(most) else {})


def _origin(turn: Array, place: Array) -> dict[str, list[float]]:
    return {"position": place.tolist(), "quaternion": matrix_quaternion(turn).tolist()}
