"""A URDF's joints as joints of the sheet: what each element may say, and what it means."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from tmodes.io.units import finite_float
from tmodes.io.unread import Format, Left, few
from tmodes.io.words import meant, shown
from tmodes.io.xml_file import Element

__all__ = [
    "MOVING",
    "OF_DYNAMICS",
    "URDF",
    "DriveWords",
    "Follows",
    "UrdfJoint",
    "follows",
    "hold",
    "joint_ends",
    "joint_of",
    "motor_and_spring",
    "plain_tag",
    "said_of_drives",
    "without_rotor",
    "zero_limits",
]

_SURFACES = "mu mu1 mu2 kp kd fdir1 minDepth maxVel maxContacts selfCollide laserRetro material sensor visual collision"
_SOLVERS = (
    "implicitSpringDamper provideFeedback preserveFixedJoint disableFixedJointLumping stopCfm stopErp cfmDamping "
    "fudgeFactor"
)
_ORIGIN = {"xyz", "rpy"}
_SOFT = "no soft limit acts on the joint"
_BOUND = "it bounds nothing"

URDF = Format(
    read={
        "robot": {"name", "version"},
        "link": {"name", "type"},
        "inertial": set(),
        "inertial/mass": {"value"},
        "inertial/inertia": {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"},
        "origin": _ORIGIN,
        "robot/joint": {"name", "type"},
        "joint/parent": {"link"},
        "joint/child": {"link"},
        "joint/axis": {"xyz"},
        "joint/limit": {"lower", "upper", "effort", "velocity"},
        "joint/dynamics": {
            *("damping", "friction", "armature", "rotor_inertia", "gear_ratio", "stiffness", "spring_stiffness"),
            *("spring_reference",),
        },
        "joint/mimic": {"joint", "multiplier", "offset"},
        "joint/rotor_inertia": {"value"},
        "joint/gear_ratio": {"value"},
        "transmission": {"name", "type"},
        "transmission/type": set(),
        "transmission/joint": {"name"},
        "transmission/actuator": {"name"},
        "transmission/mechanicalReduction": {"value"},
        **{
            f"actuator/{tag}": {"value"}
            for tag in ("mechanicalReduction", "gear_ratio", "rotor_inertia", "drake:gear_ratio", "drake:rotor_inertia")
        },
        "gazebo": {"reference"},
        "gazebo/springStiffness": {"value"},
        "gazebo/springReference": {"value"},
    },
    idle={
        *("visual", "collision", "material", "robot/sensor", "ros2_control", "calibration", "hardwareInterface"),
        *("self_collision_checking", "mujoco", "link@id", "joint@id", "robot@xmlns", "transmission/role"),
        *(f"gazebo/{tag}" for tag in f"{_SURFACES} {_SOLVERS}".split()),
    },
    owners={"link", "joint", "transmission", "gazebo", "plugin"},
    effects={
        "joint/safety_controller": _SOFT,
        "gazebo/stopKp": _SOFT,
        "gazebo/stopKd": _SOFT,
        "limit@acceleration": _BOUND,
        "limit@deceleration": _BOUND,
        "limit@jerk": _BOUND,
        "gazebo/plugin": "what a plugin of Gazebo does to the robot is left out",
        "gazebo/turnGravityOff": "gravity acts on the link",
        "gazebo/gravity": "gravity acts on the link as on all others",
        "gazebo/dampingFactor": "nothing but joints, gears and links damps",
    },
)
"""Namespaces that elements declare are idle by the prefix of the attribute, see :meth:`.unread.Format.left`."""


def plain_tag(tag: str) -> str:
    """A tag without its prefix."""
    return tag.rpartition(":")[2]


DriveWords = dict[str, tuple[float, Element]]
"""What is said of one joint, each number with the element that says it."""

OF_DYNAMICS = {
    "armature": "armature",
    "rotor_inertia": "rotor",
    "gear_ratio": "ratio",
    "stiffness": "stiffness",
    "spring_stiffness": "stiffness",
    "spring_reference": "rest",
}
"""Attributes of ``<dynamics>`` and what each says."""

_ELEMENTS = {
    "rotor_inertia": "rotor",
    "gear_ratio": "ratio",
    "mechanicalReduction": "ratio",
    "springStiffness": "stiffness",
    "springReference": "rest",
}
_LEAST = {"armature": 0.0, "rotor": 0.0, "stiffness": 0.0}
"""The least value of what has one."""


def said_of_drives(robot: Element) -> dict[str, DriveWords]:
    """What a URDF says of rotors, ratios and springs, by the names of the joints.

    Raises :class:`tmodes.errors.InputError` for what is no number, or negative where nothing can be.
    """
    found: dict[str, DriveWords] = {}
    for name, word, value, element in _words(robot):
        if value < _LEAST.get(word, value) or (word == "ratio" and value == 0.0):
            expected = "a ratio that is not zero" if word == "ratio" else "a number not less than 0"
            raise element.fault(f"joint {name}: {word}", f"{value:g}", expected, "correct it")
        found.setdefault(name, {})[word] = (value, element)
    return found


def _words(robot: Element) -> Iterator[tuple[str, str, float, Element]]:
    """Joint, word, number and element."""
    for element in robot.children:
        if element.tag == "joint":
            name = element.attributes.get("name", "")
            for dynamics in element.all("dynamics"):
                for attribute, word in OF_DYNAMICS.items():
                    if attribute in dynamics.attributes:
                        yield name, word, dynamics.number(attribute, f"joint {name}: {attribute}"), dynamics
            yield from _inside(element, name)
        elif element.tag == "transmission":
            joints = [one.attributes.get("name", "") for one in element.all("joint")]
            for part in (element, *element.all("actuator")) if len(joints) == 1 else ():
                yield from _inside(part, joints[0])
        elif element.tag == "gazebo" and "reference" in element.attributes:
            yield from _inside(element, element.attributes["reference"])


def _inside(element: Element, joint: str) -> Iterator[tuple[str, str, float, Element]]:
    for one in element.children:
        if word := _ELEMENTS.get(plain_tag(one.tag)):
            yield joint, word, one.value(f"joint {joint}: {one.tag}"), one


def motor_and_spring(words: DriveWords, *, driven: bool) -> dict[str, Any]:
    """Keys of the sheet's joint; one on its spring that nothing else drives is free.

    ``driven``: a transmission or an actuator names the joint.
    """
    said = {word: value for word, (value, _) in words.items()}
    data: dict[str, Any] = {}
    if said.get("stiffness"):
        data["spring"] = {"stiffness": said["stiffness"], "rest": said.get("rest", 0.0)}
    if said.get("rotor"):
        ratio = {"side": "motor", "ratio": said["ratio"]} if "ratio" in said else {"side": "joint"}
        data["motor"] = {"inertia": said["rotor"], **ratio}
    elif said.get("armature"):
        data["motor"] = {"inertia": said["armature"], "side": "joint"}
    elif "spring" in data and not driven:
        data["state"] = "free"
    return data


def without_rotor(said: dict[str, DriveWords]) -> Iterator[Left]:
    """Ratios of joints whose rotor has no inertia: there is no motor to turn."""
    for name, words in said.items():
        ratio, element = words.get("ratio", (1.0, None))
        if element and abs(ratio) != 1.0 and not words.keys() & {"rotor"}:
            effect = "there is no rotor's inertia that it would multiply; give the joint a `motor` with it"
            yield Left(f"<{element.tag[:60]}>", effect, f"joint {name}")


KINDS = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic", "fixed": "fixed"}
"""What each type of a URDF's joint is in the sheet."""

OTHER_KINDS = {
    "floating": (
        "a floating joint (a free-flying base)",
        "fix the base to the world: make the joint fixed, or remove it with its parent",
    ),
    "planar": ("a planar joint", "write it as two prismatic joints and a revolute one"),
}
"""Types of a URDF's joint that are not modelled: what they are, and what to write."""

MOVING = frozenset(KINDS) - {"fixed"}
CHILDREN = {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic", "calibration", "safety_controller"}
BOUNDLESS = 1e9
"""A limit beyond this [rad or m] says that there is none."""


@dataclass(frozen=True, eq=False)
class UrdfJoint:
    """A joint's name, kind, and the links that it connects, with its element."""

    name: str
    type: str
    parent: str
    child: str
    element: Element


@dataclass(frozen=True)
class Follows:
    """What ``<mimic>`` says: position = ``factor`` * position of ``leader`` + ``offset``."""

    leader: str
    factor: float
    offset: float


def joint_ends(element: Element) -> UrdfJoint:
    """A joint's name, kind and links; raises :class:`tmodes.errors.InputError` for a kind that is not modelled."""
    name = element.text("name", "a joint's name")
    which = f"joint {name}"
    element.check_attributes({"name", "type"}, which)
    element.check_children(CHILDREN, which)
    kind = element.text("type", f"{which}: type")
    if kind not in KINDS:
        got, hint = OTHER_KINDS.get(kind) or (shown(kind), meant(kind, KINDS, "choose one of them"))
        raise element.fault(f"{which}: type", got, f"one of {', '.join(KINDS)}", hint)
    return UrdfJoint(name, kind, _end(element, "parent", which), _end(element, "child", which), element)


def joint_of(joint: UrdfJoint) -> dict[str, Any]:
    """The joint of the sheet; its origin is in the parent link's frame, as a URDF means it."""
    which = f"joint {joint.name}"
    data: dict[str, Any] = {"name": joint.name, "type": KINDS[joint.type], "parent": joint.parent, "child": joint.child}
    data |= {"origin": joint.element.origin(which), "from": "frame"}
    if joint.type == "fixed":
        return data
    data["axis"] = _axis(joint.element, which)
    groups = {"limits": _limits(joint, which), "friction": _friction(joint.element, which)}
    return data | {key: group for key, group in groups.items() if group}


def follows(joint: UrdfJoint) -> Follows | None:
    """The joint that this one mimics, None where it moves by itself."""
    which = f"joint {joint.name}: mimic"
    element = joint.element.only("mimic", which)
    if element is None or joint.type == "fixed":
        return None
    element.check_attributes({"joint", "multiplier", "offset"}, which)
    factor = element.number("multiplier", f"{which} multiplier", 1.0)
    return Follows(element.text("joint", which), factor, element.number("offset", f"{which} offset", 0.0))


def hold(joint: dict[str, Any], at: float) -> None:
    """Lock a joint of the sheet at a position [rad or m]; what only a joint that moves has goes."""
    for key in ("motor", "spring", "gear"):
        joint.pop(key, None)
    joint |= {"state": "locked", "locked_at": at}


def zero_limits(joints: Iterable[dict[str, Any]]) -> str:
    """A sentence on joints that may neither move nor push by their limits; empty where there is none."""
    names = [
        joint["name"] for joint in joints if 0.0 in (joint.get("limits", {}).get(key) for key in ("speed", "effort"))
    ]
    if not names:
        return ""
    info = "is taken as it stands, so that any motion or effort is beyond it"
    hint = "where it says that the limit is not known, leave the attribute out"
    return f"A velocity or effort of 0 in <limit> {info}: {few(names)}; {hint}."


def _end(element: Element, tag: str, which: str) -> str:
    end = element.only(tag, which)
    if end is None:
        raise element.fault(which, f"no <{tag}>", "a joint with a parent and a child link", f'add <{tag} link="..."/>')
    return end.text("link", f"{which}: {tag}")


def _axis(element: Element, which: str) -> list[float]:
    """The axis as written; along x where the file says nothing, which is the format's own rule."""
    axis = element.only("axis", which, {"xyz"})
    if axis is None:
        return [1.0, 0.0, 0.0]
    axis.text("xyz", f"{which}: axis")
    numbers = axis.triple("xyz", f"{which}: axis")
    if max(map(abs, numbers)) < 1e-9:
        raise axis.fault(f"{which}: axis", "a zero axis", "a direction", 'write its direction, such as "0 0 1"')
    return numbers


def _limits(joint: UrdfJoint, which: str) -> dict[str, float]:
    """Those limits that the file states; a zero is one."""
    element = joint.element.only("limit", which, {"lower", "upper", "effort", "velocity"})
    if element is None:
        return {}
    limits: dict[str, float] = {} if joint.type == "continuous" else _range(element, which)
    for key, name in (("speed", "velocity"), ("effort", "effort")):
        if name not in element.attributes:
            continue
        value = _limit(element, name, which)
        if value < 0.0:
            raise element.fault(f"{which}: {name}", f"{value:g}", "a limit not less than 0", "correct the sign")
        if value <= BOUNDLESS:
            limits[key] = value
    return limits


def _range(element: Element, which: str) -> dict[str, float]:
    """Lower and upper limit; one that is missing next to the other is zero, which is the format's own rule."""
    if not element.attributes.keys() & {"lower", "upper"}:
        return {}
    lower, upper = (_limit(element, name, which) for name in ("lower", "upper"))
    if lower > upper:
        got, hint = f"lower {lower:g} above upper {upper:g}", "exchange them, or correct a sign"
        raise element.fault(f"{which}: limit", got, "a range from lower to upper", hint)
    return {name: value for name, value in (("lower", lower), ("upper", upper)) if abs(value) <= BOUNDLESS}


def _limit(element: Element, name: str, which: str) -> float:
    """A limit's number. Infinite and huge ones are written in many ways, and all mean that there is none."""
    text = element.attributes.get(name, "0").strip()
    value = finite_float(text)
    if value is None and text.lower().lstrip("+-") in {"inf", "infinity"}:
        value = float(text)
    return element.number(name, f"{which}: {name}") if value is None else value


def _friction(element: Element, which: str) -> dict[str, float]:
    dynamics = element.only("dynamics", which, {"damping", "friction", *OF_DYNAMICS})
    if dynamics is None:
        return {}
    friction = {"viscous": "damping", "coulomb": "friction"}
    values = {key: dynamics.number(name, f"{which}: {name}", 0.0) for key, name in friction.items()}
    if values["coulomb"] < 0.0:
        hint = "correct the sign: a negative one would drive the joint"
        raise dynamics.fault(f"{which}: friction", f"{values['coulomb']:g}", "a number not less than 0", hint)
    return values if any(values.values()) else {}
