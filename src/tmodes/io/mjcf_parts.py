"""Actuators and meshes of an MJCF file, and what of the file is read; all else is named."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.errors import InputError
from tmodes.io.files import Folders
from tmodes.io.unread import Format, Left, few
from tmodes.io.words import shown
from tmodes.io.xml_file import Element

__all__ = ["FILE_KEYS", "MJCF", "SHAPES", "Assets", "JointActuators", "compensation", "servos", "without_unread"]

_PLACED = {"pos", "quat", "axisangle", "euler", "xyaxes", "zaxis"}
_ACTUATOR = {
    *("name", "class", "joint", "jointinparent", "gear", "ctrlrange", "ctrllimited", "forcerange", "forcelimited"),
    *("kp", "kv", "dampratio", "gainprm", "biasprm", "gaintype", "biastype", "dyntype", "armature", "damping"),
    *("inheritrange", "group", "user", "tendon", "site", "body", "cranksite", "slidersite", "refsite", "cranklength"),
}
"""Of an actuator; one that is not taken is named by itself."""

_ACTUATORS = (
    *("general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion"),
    *("dcmotor", "plugin"),
)
_FLAGS = (
    *("contact", "warmstart", "filterparent", "clampctrl", "refsafe", "sensor", "midphase", "nativeccd", "eulerdamp"),
    *("autoreset", "island", "energy", "fwdinv", "invdiscrete", "multiccd", "sleep", "override"),
)
"""Flags that change how MuJoCo computes, not what."""

_SOFT = "its limits are sharp bounds that a run reports, not springs"
_STICKS = "its dry friction sticks exactly"
_FLUID = "no fluid acts on the robot"

MJCF = Format(
    read={
        "mujoco": {"model"},
        "compiler": {
            *("angle", "autolimits", "coordinate", "eulerseq", "meshdir", "texturedir", "assetdir", "strippath"),
            *("fusestatic", "balanceinertia", "boundmass", "boundinertia", "inertiafromgeom", "inertiagrouprange"),
            *("settotalmass", "alignfree", "fitaabb", "discardvisual", "usethread", "saveinertial", "conflict"),
            *("exactmeshinertia", "convexhull", "local"),
        },
        "compiler/lengthrange": set(),
        "option": {"gravity"},
        "option/flag": {"gravity"},
        "default": {"class"},
        "worldbody": set(),
        "body": {"name", "childclass", "gravcomp", "mocap", *_PLACED},
        "frame": {"name", "childclass", *_PLACED},
        "inertial": {"mass", "diaginertia", "fullinertia", *_PLACED},
        "joint": {
            *("name", "class", "type", "pos", "axis", "range", "limited", "stiffness", "springref", "springdamper"),
            *("damping", "frictionloss", "armature", "ref", "actuatorfrcrange", "actuatorfrclimited"),
        },
        "freejoint": {"name"},
        "include": {"file"},
        "contact": set(),
        "equality": set(),
        "equality/joint": {"name", "class", "active", "joint1", "joint2", "polycoef"},
        "actuator": set(),
        **{f"{parent}/{tag}": _ACTUATOR for tag in _ACTUATORS for parent in ("actuator", "default")},
    },
    idle={
        *("visual", "statistic", "size", "custom", "asset", "sensor", "keyframe", "geom", "site", "camera", "light"),
        *("contact/exclude", "lengthrange", "default/mesh", "default/material", "default/pair", "default/equality"),
        *("default/tendon", "option@timestep", "option@integrator", "option@solver", "option@iterations"),
        *("option@tolerance", "option@ls_iterations", "option@ls_tolerance", "option@noslip_iterations"),
        *("option@noslip_tolerance", "option@ccd_iterations", "option@ccd_tolerance", "option@jacobian"),
        *("option@cone", "option@impratio", "option@sdf_iterations", "option@sdf_initpoints", "option@magnetic"),
        *(
            "option@mpr_iterations",
            "option@mpr_tolerance",
            "option@apirate",
            "option@collision",
            "option@sleep_tolerance",
        ),
        *(f"flag@{name}" for name in _FLAGS),
        *(
            "joint@solref",
            "joint@solimp",
            "joint@group",
            "joint@user",
            "body@user",
            "body@sleep",
            "default/joint@group",
        ),
    },
    owners={"joint", "body", "default", "fixed", "spatial", *_ACTUATORS},
    effects={
        "joint@solreflimit": _SOFT,
        "joint@solimplimit": _SOFT,
        "joint@margin": _SOFT,
        "joint@solreffriction": _STICKS,
        "joint@solimpfriction": _STICKS,
        "joint@actuatorgravcomp": "the compensation of its weight is a load, whatever the joint's actuator could bear",
        "option@density": _FLUID,
        "option@viscosity": _FLUID,
        "option@wind": _FLUID,
        "tendon": "what its tendons pull, and what actuators pull by them, is left out",
        "contact/pair": "nothing touches but what a sheet says under `contact`",
        "flag@actuation": "its actuators are taken",
        "flag@limit": "its limits are taken",
    },
)
"""Geoms are read by MuJoCo for masses and inertias; that they touch nothing is a notice of its own."""


ON_JOINT = (0, 1)
"""Transmissions (mjtTrn) by which an actuator acts on a joint; the two are one on a hinge or slide."""

NONE, FIXED, AFFINE = 0, 0, 1
"""Of mjtDyn: no state; of mjtGain: a number; of mjtBias: none, and affine in length and velocity."""

MOST_LOADS = 100


@dataclass
class JointActuators:
    """What all actuators of a joint do together: push - position * q - velocity * q' [N*m or N].

    ``inertia`` and ``damping``: what they add to the joint's; ``most``: the largest effort that they have together,
    infinite where one of them has no bound.
    """

    push: float = 0.0
    position: float = 0.0
    velocity: float = 0.0
    inertia: float = 0.0
    damping: float = 0.0
    most: float = 0.0

    def drive(self, joint: str) -> dict[str, Any]:
        """The drive of a sheet."""
        if self.position:
            signal = {"type": "constant", "value": self.push / self.position}
            gains = {"type": "pd", "position_gain": self.position, "velocity_gain": self.velocity}
            return {"joint": joint, "command": "position", "signal": signal, "controller": gains}
        return {"joint": joint, "command": "effort", "signal": {"type": "constant", "value": self.push}}

    @property
    def viscous(self) -> float:
        """What it damps next to a servo's own gain."""
        return self.damping + (0.0 if self.position else self.velocity)


def servos(model: Any) -> tuple[dict[int, JointActuators], list[Left]]:
    """What drives each joint, by its number; and the actuators that are not taken."""
    found: dict[int, JointActuators] = {}
    left = []
    for k in range(model.nu):
        name, joint = model.actuator(k).name or f"actuator {k + 1}", int(model.actuator_trnid[k, 0])
        if why := _strange(model, k):
            left.append(Left("the force of an actuator", why, name))
        else:
            _add(found.setdefault(joint, JointActuators()), model, k)
    for joint, servo in [*found.items()]:
        if servo.position < 0 or servo.velocity < 0:
            del found[joint]
            why = "it pushes the joint on along its motion, which no controller here does"
            left.append(Left("the force of an actuator", why, f"of joint {model.joint(joint).name or joint + 1}"))
    return found, left


def _strange(model: Any, k: int) -> str:
    """Why an actuator is not taken; empty for one that is."""
    if int(model.actuator_trntype[k]) not in ON_JOINT:
        return "it acts by a tendon, a site or a body, which is left out"
    if int(model.actuator_dyntype[k]) != NONE:
        return "it has a state of its own, which is left out"
    plugin = int(getattr(model, "actuator_plugin", [-1] * model.nu)[k]) >= 0
    bias = int(model.actuator_biastype[k])
    if plugin or int(model.actuator_gaintype[k]) != FIXED or bias not in (NONE, AFFINE):
        return "its force is no gain times its control with springs and dampers, which is left out"
    return ""


def _add(servo: JointActuators, model: Any, k: int) -> None:
    gear, gain = float(model.actuator_gear[k, 0]), float(model.actuator_gainprm[k, 0])
    affine = int(model.actuator_biastype[k]) == AFFINE
    constant, by_length, by_rate = map(float, model.actuator_biasprm[k, :3]) if affine else (0.0, 0.0, 0.0)
    low, high = map(float, model.actuator_ctrlrange[k]) if model.actuator_ctrllimited[k] else (-np.inf, np.inf)
    servo.push += gear * (gain * min(max(0.0, low), high) + constant)
    servo.position -= gear**2 * by_length
    servo.velocity -= gear**2 * by_rate
    none = np.zeros(model.nu)  # older versions have neither of the two
    servo.inertia += gear**2 * float(getattr(model, "actuator_armature", none)[k])
    servo.damping += gear**2 * float(getattr(model, "actuator_damping", none)[k])
    if model.actuator_forcelimited[k]:
        most = float(np.abs(model.actuator_forcerange[k]).max())
    elif affine or not model.actuator_ctrllimited[k]:
        most = np.inf
    else:
        most = abs(gain) * max(abs(low), abs(high))
    servo.most += abs(gear) * most


def compensation(
    model: Any, links: Mapping[int, tuple[str, Any]], gravity: Any
) -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
    """Points and loads that bear each body's compensated share of its weight at its center of mass.

    ``links``: link and center of mass (3,) in its frame of each body with a mass.
    """
    shares = np.asarray(model.body_gravcomp, dtype=float)
    for body, (link, center) in links.items():
        if shares[body] and np.any(gravity):
            force = -shares[body] * float(model.body_mass[body]) * np.asarray(gravity, dtype=float)
            name = f"{link[:90]}_gravcomp"
            point = {"name": name, "link": link, "position": [*map(float, center)]}
            yield point, {"point": name, "frame": "world", "force": force.tolist()}


SHAPES = ("mesh", "texture", "skin")
"""Elements whose files are of shapes or looks."""

FILE_KEYS = ("file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")

TRUE = 1
"""Of the compiler's inertiafromgeom: geoms count also where a body says its inertia."""


@dataclass
class Assets:
    """Names of files that may be opened, and those that may not or are not there, each with its reason."""

    allowed: set[str] = field(default_factory=set)
    unread: dict[str, str] = field(default_factory=dict)

    def note(self, element: Element, folders: Folders, bases: Sequence[Path | InputError]) -> None:
        """Look for the files of an element; ``bases``: folders they may start at, or why one of these may not be."""
        for key in FILE_KEYS:
            if name := element.attributes.get(key, ""):
                try:
                    if closed := next((base for base in bases if isinstance(base, InputError)), None):
                        raise closed
                    starts = [base for base in bases if isinstance(base, Path)]
                    found = [folders.find(name, f"{element.label} {key}", element.place, base) for base in starts]
                except InputError as error:
                    self.unread[name] = error.got
                else:
                    if any(found):
                        self.allowed.add(name)
                    else:
                        self.unread[name] = f"{shown(name)}, which is not there"

    def notices(self) -> list[str]:
        """A sentence on what is not read; empty where all is."""
        names = few([why if name in why else f"{shown(name)} ({why})" for name, why in self.unread.items()])
        return (
            [f"Shapes whose files may not be read are left out: {names}; give their folder with --root."]
            if names
            else []
        )


def without_unread(mujoco: Any, path: str, allowed: Iterable[str], source: str) -> Any:
    """The compiled model without all meshes, textures and skins whose files are none of the ``allowed``.

    Raises :class:`tmodes.errors.InputError` for a body whose mass is that of such a mesh, and what MuJoCo raises.
    """
    spec, allowed = mujoco.MjSpec.from_file(path), {*allowed, ""}
    meshes = {mesh.name for mesh in spec.meshes if mesh.file not in allowed}
    for geom in [geom for geom in spec.geoms if geom.meshname and geom.meshname in meshes]:
        body, weightless = geom.parent, geom.mass == 0 or (np.isnan(geom.mass) and geom.density == 0)
        if (
            not weightless
            and (spec.compiler.inertiafromgeom == TRUE or not body.explicitinertial)
            and body.name != "world"
        ):
            got = f"the mass of a mesh that may not be read ({shown(geom.meshname)})"
            raise InputError(f"body {shown(body.name)}", got, "an inertia of its own", "add <inertial>", source)
        spec.delete(geom)
    textures = {texture.name for texture in spec.textures if not {texture.file, *texture.cubefiles} <= allowed}
    for material in [one for one in spec.materials if textures & {*one.textures}]:
        material.textures = ["" if name in textures else name for name in material.textures]
    for group, bad in ((spec.meshes, meshes), (spec.textures, textures)):
        for one in [one for one in group if one.name in bad]:
            spec.delete(one)
    for skin in [skin for skin in spec.skins if skin.file not in allowed]:
        spec.delete(skin)
    return spec.compile()
