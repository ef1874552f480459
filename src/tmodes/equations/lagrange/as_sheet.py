"""A system as a robot: a data sheet whose joints are the system's coordinates, so that all that robots have works."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from tmodes.errors import InputError

__all__ = ["system_data"]

_TYPES = {"rad": "revolute", "m": "prismatic"}


def system_data(
    coordinates: Mapping[str, str], inputs: tuple[str, ...] | None, points: Iterable[str],
    joints: Mapping[str, Mapping[str, Any]], sheet: Mapping[str, Any],
) -> dict[str, Any]:  # fmt: skip
    """Plain data of a system's robot: coordinates that a drive or ``joints`` names are driven, the others are free.

    ``coordinates`` with their units; ``inputs``: those that a drive may act on, None: all; ``points``: names of the
    system's points, the tip first; ``joints``: motor, gear, friction, limits of a coordinate; ``sheet``: any other
    entries of a robot's data sheet. Raises :class:`tmodes.errors.InputError` for a wrong joint.
    """
    allowed = inputs if inputs is not None else tuple(coordinates)
    drives = list(sheet.get("drives", ()))
    for index, drive in enumerate(drives):
        if drive["joint"] in coordinates and drive["joint"] not in allowed:
            expected = f"one of {', '.join(allowed)}" if allowed else "no drive at all"
            hint = "add it to the system's `inputs`"
            raise InputError(f"drives.{index}.joint", f"`{drive['joint']}`", expected, hint)
    driven = {drive["joint"] for drive in drives} | {name for name, more in joints.items() if "motor" in more}
    rows = [_joint(name, unit, name in driven, joints.get(name, {})) for name, unit in coordinates.items()]
    if unknown := [name for name in joints if name not in coordinates]:
        known = ", ".join(coordinates)
        raise InputError(f"joints.{unknown[0]}", "an unknown coordinate", f"one of {known}", "correct the name")
    last = rows[-1]["child"]
    further = [{"name": name, "link": last} for name in [*points][1:] if name != "tip"]
    return {"format": 1, "kind": "arm", "joints": rows, "points": further, **sheet}


def _joint(name: str, unit: str, driven: bool, more: Mapping[str, Any]) -> dict[str, Any]:
    place = {"name": name, "type": _TYPES[unit], "parent": "base", "child": f"{name}_body", "axis": [0.0, 0.0, 1.0]}
    return {**place, "state": "active" if driven else "free", **more}
