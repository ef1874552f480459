"""The two forms of data sheet that a person writes: a robot of joints and links, and that of the 2010 robot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from tmodes.io.filipovic2010 import importer
from tmodes.io.filipovic2010.format import FORMAT, PLANT, Format2010
from tmodes.sheet import ARM_FORMAT, Robot

__all__ = ["F2010", "ROBOT", "Form", "form_of", "own_path", "robot_path", "with_reach"]


@dataclass(frozen=True)
class Form:
    """One form: the type that checks it, the version of its format, and the groups that ``real`` may name."""

    name: str
    root: type[Any]
    version: int
    factored: tuple[str, ...]


ROBOT = Form(
    "arm",
    Robot,
    ARM_FORMAT,
    (
        "gravity",
        "base",
        "joints",
        "links",
        "tip",
        "points",
        "couplings",
        "loads",
        "drives",
        "contact",
        "contact_off",
        "parameters",
    ),
)
F2010 = Form(importer.NAME, Format2010, FORMAT, PLANT)

_ROBOT_KEYS = ("kind", "joints", "links", "urdf")
"""Keys by one of which a sheet is that of joints and links."""


def form_of(data: Any) -> Form:
    """The form of a sheet's plain data."""
    if not isinstance(data, Mapping) or any(key in data for key in _ROBOT_KEYS):
        return ROBOT
    return F2010


def robot_path(path: str, data: Any) -> str:
    """A path in a robot's plain data, where one of the format that it was imported from may stand."""
    return importer.placed_path(path, data) if _is_imported(data) else path


def own_path(path: str, data: Any) -> str:
    """The path of a number in the format that the robot was imported from."""
    return importer.own_path(path) if _is_imported(data) else path


def with_reach(before: Mapping[str, Any], after: dict[str, Any]) -> dict[str, Any]:
    """Changed plain data of a robot, with what follows from the changes in the format that it was imported from."""
    return importer.with_reach(before, after) if _is_imported(after) else after


def _is_imported(data: Any) -> bool:
    return isinstance(data, Mapping) and data.get("imported") == importer.NAME
