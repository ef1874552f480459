"""Rotors, ratios and springs of a URDF's joints, in the dialects that write them.

``<dynamics>`` (``armature``, ``rotor_inertia``, ``gear_ratio``, ``stiffness``, ``spring_reference``), elements of the
joint, ``<transmission>`` (``mechanicalReduction``, ``drake:rotor_inertia``, ``drake:gear_ratio``) and Gazebo's
``springStiffness`` and ``springReference``. An armature is reflected already; a rotor's inertia is on its own shaft.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmodes.io.unread import Left
from tmodes.io.urdf_read import plain_tag
from tmodes.io.xml_file import Element

__all__ = ["OF_DYNAMICS", "DriveWords", "motor_and_spring", "said_of_drives", "without_rotor"]

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
