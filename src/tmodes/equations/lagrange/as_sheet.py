"""A system as a robot: a data sheet whose joints are the system's coordinates, so that all that robots have works."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Protocol

from tmodes.errors import InputError
from tmodes.sheet.robot import Robot

__all__ = ["Named", "system_robot"]

_TYPES = {"rad": "revolute", "m": "prismatic"}


class Named(Protocol):
    """What a robot is made of: a system's names."""

    @property
    def name(self) -> str:
        """Its own."""
        ...

    @property
    def title(self) -> str:
        """What it is, in one line."""
        ...

    @property
    def coordinates(self) -> Mapping[str, str]:
        """Coordinates and their units."""
        ...

    @property
    def parameters(self) -> Mapping[str, float]:
        """Parameters and their values."""
        ...

    @property
    def inputs(self) -> tuple[str, ...] | None:
        """Coordinates that a drive may act on; None: all."""
        ...


def system_robot(system: Named, points: Iterable[str], joints: Mapping[str, Mapping[str, Any]], **sheet: Any) -> Robot:
    """The data sheet of a system: coordinates that a drive or ``joints`` names are driven, the others are free.

    ``points``: names of the system's points, the tip first. ``joints``: motor, gear, friction, limits of a coordinate.
    ``sheet``: any other entries of a robot's data sheet. Raises :class:`tmodes.errors.InputErrors` as ``from_data``.
    """
    allowed = system.inputs if system.inputs is not None else tuple(system.coordinates)
    drives = list(sheet.get("drives", ()))
    for index, drive in enumerate(drives):
        if drive["joint"] in system.coordinates and drive["joint"] not in allowed:
            expected = f"one of {', '.join(allowed)}" if allowed else "no drive at all"
            hint = "add it to the system's `inputs`"
            raise InputError(f"drives.{index}.joint", f"`{drive['joint']}`", expected, hint)
    driven = {drive["joint"] for drive in drives} | {name for name, more in joints.items() if "motor" in more}
    rows = [_joint(name, unit, name in driven, joints.get(name, {})) for name, unit in system.coordinates.items()]
    if unknown := [name for name in joints if name not in system.coordinates]:
        known = ", ".join(system.coordinates)
        raise InputError(f"joints.{unknown[0]}", "an unknown coordinate", f"one of {known}", "correct the name")
    last = rows[-1]["child"]
    further = [{"name": name, "link": last} for name in [*points][1:] if name != "tip"]
    data = {
        "format": 1,
        "kind": "arm",
        "name": system.name,
        "title": system.title,
        "equations": system.name,
        "joints": rows,
        "points": further,
    }
    sheet["parameters"] = {**system.parameters, **sheet.get("parameters", {})}
    return Robot.from_data(data | sheet)


def _joint(name: str, unit: str, driven: bool, more: Mapping[str, Any]) -> dict[str, Any]:
    place = {"name": name, "type": _TYPES[unit], "parent": "base", "child": f"{name}_body", "axis": [0.0, 0.0, 1.0]}
    return {**place, "state": "active" if driven else "free", **more}
