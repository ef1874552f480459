"""From a sheet of the 2010 robot to a robot of joints and links: which of its paths and coordinates means which there.

One revolute joint about z with motor and elastic gear, one link of the kind ``modes`` with the payload at its tip, the
environment as a contact with a bowl about the base point, whose radius is the length of the undeformed link.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["COORDINATES", "NAME", "own_path", "placed_path", "robot_data", "robot_path", "to_robot", "with_reach"]

NAME = "filipovic2010"
"""What a robot that was read of such a sheet keeps in its field ``imported``."""

_PATHS = {
    "motor.friction": "joints.joint.motor.friction.viscous",
    "motor": "joints.joint.motor",
    "gear": "joints.joint.gear",
    "link.modes": "links.link.beam.modes",
    "payload": "links.link.bodies.payload",
    "environment": "contact",
    "controller": "drives.0.controller",
    "reference.noise": "drives.0.noise",
    "reference": "drives.0.signal",
    "reading": "equations",
}
"""Beginnings of the sheet's paths, and of those of the same numbers in the robot; longer ones first."""


def placed_path(path: str, data: Mapping[str, Any]) -> str:
    """:func:`robot_path`, where a contact that is switched off stands."""
    found = robot_path(path)
    off = found != path and found.startswith("contact") and data.get("contact") is None
    return f"contact_off{found.removeprefix('contact')}" if off else found


def robot_path(path: str) -> str:
    """The path in the robot of a path of the sheet, where a number has one factor; any other path is itself."""
    if path.startswith("real."):
        return f"real.{own_path(path.removeprefix('real.'))}"
    return _replaced(path, _PATHS)


def own_path(path: str) -> str:
    """The path in the sheet of a path in the robot, where it has one; any other path is itself."""
    found = _replaced(path, {there: here for here, there in _PATHS.items()})
    return "gear.stiffness" if found == "gear.stiffness.0" else found


def _replaced(path: str, table: Mapping[str, str]) -> str:
    for start, instead in table.items():
        if path == start or path.startswith(f"{start}."):
            return instead + path[len(start) :]
    return path


def robot_data(data: Mapping[str, Any]) -> dict[str, Any]:
    """Plain data of the robot of a sheet's checked plain data."""
    noise = data["reference"].get("noise", {})
    motion = {key: value for key, value in data["reference"].items() if key != "noise"}
    law = {"law": "dynamic_environment", "point": "tip", "shape": {"type": "ball", "center": [0.0, 0.0, 0.0]}}
    law["shape"] |= {"radius": _reach(data["link"]["modes"]), "inside": True}
    drive = {
        "joint": "joint",
        "command": "position",
        "signal": {"type": "trapezoid", **motion},
        "controller": {"type": "pd", **data["controller"]},
        "noise": {"type": "noise", **noise},
    }
    return {
        "format": 1,
        "kind": "arm",
        "imported": NAME,
        **{key: data[key] for key in ("name", "title", "citation", "task") if data.get(key) is not None},
        "equations": data.get("reading", "consistent"),
        "gravity": data.get("gravity", 9.81),
        "joints": [_joint(data)],
        "links": [_link(data)],
        "tip": {"link": "link"},
        "drives": [drive],
        "contact" if data["contact"] else "contact_off": law | data["environment"],
        "real": dict(data.get("real", {})),
        "integration": dict(data.get("integration", {})),
    }


def _joint(data: Mapping[str, Any]) -> dict[str, Any]:
    motor = {**data["motor"], "side": "joint", "friction": {"viscous": data["motor"]["friction"]}}
    place = {"name": "joint", "type": "revolute", "parent": "base", "child": "link", "axis": [0.0, 0.0, 1.0]}
    return {**place, "motor": motor, "gear": dict(data["gear"])}


def _link(data: Mapping[str, Any]) -> dict[str, Any]:
    payload = {"name": "payload", **data["payload"]}
    return {"name": "link", "bodies": [payload], "beam": {"model": "modes", "modes": list(data["link"]["modes"])}}


def _reach(modes: Sequence[Mapping[str, Any]]) -> float:
    return sum(float(mode["length"]) for mode in modes)


def with_reach(before: Mapping[str, Any], after: dict[str, Any]) -> dict[str, Any]:
    """Changed plain data of a robot: the environment stays at the undeformed tip when a mode changes its length."""
    old, new = (_reach(data["links"][0]["beam"]["modes"]) for data in (before, after))
    shape = (after.get("contact") or after.get("contact_off") or {}).get("shape")
    if shape and old != new and shape.get("radius") == old:
        shape["radius"] = new
    return after


def reach_of(robot: Any, changed: Mapping[tuple[str | int, ...], Any]) -> dict[tuple[str | int, ...], Any]:
    """The radius of the environment, by its steps, that follows from changed lengths of modes (:func:`with_reach`)."""
    lengths = {("links", 0, "beam", "modes", k, "length"): m.length for k, m in enumerate(robot.links[0].beam.modes)}
    contact = "contact" if robot.contact else "contact_off"
    shape, place = getattr(getattr(robot, contact), "shape", None), (contact, "shape", "radius")
    if not changed.keys() & lengths or place in changed or getattr(shape, "radius", None) != sum(lengths.values()):
        return {}
    return {place: sum(changed.get(steps, length) for steps, length in lengths.items())}


COORDINATES = ("q", "delta", "gamma", "vt", "e", "theta")
"""Names of the paper's coordinates, in its order."""

_ROWS = {
    "q": {"joint": 1.0, "link.azimuth1": 1.0},
    "delta": {"link.azimuth1": 0.5, "link.azimuth2": 1.0},
    "gamma": {"joint": 1.0},
    "vt": {"link.elevation1": 1.0},
    "e": {"link.elevation1": 0.5, "link.elevation2": 1.0},
    "theta": {"joint.motor": 1.0},
}
"""Each of the paper's coordinates as a sum of the robot's."""


def to_robot(names: Sequence[str]) -> NDArray[np.float64]:
    """Matrix from the paper's coordinates to the robot's ``names``, shape (n, 6).

    Where an element is rigid, its coordinates are not among the ``names``: the others are those of the nearest state.
    """
    there = np.array([[_ROWS[own].get(name, 0.0) for name in names] for own in COORDINATES])
    return np.linalg.pinv(there)
