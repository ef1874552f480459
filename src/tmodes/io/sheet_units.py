"""Units that depend on where they stand: a joint turns or slides, a signal is an angle, a voltage or a factor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tmodes.kinds.joints.registry import JOINTS

__all__ = ["at", "unit_at"]

COMMANDS = {"voltage": "V", "torque": "N*m|N", "effort": "N*m|N", "position": "rad|m", "prescribed": "rad|m"}


def at(value: Any, *steps: str | int) -> Any:
    """What stands at steps of plain data; None where there is nothing."""
    for step in steps:
        if isinstance(value, Mapping):
            value = value.get(step)
        elif isinstance(value, (list, tuple)) and isinstance(step, int) and 0 <= step < len(value):
            value = value[step]
        else:
            return None
    return value


def unit_at(unit: str | None, steps: Sequence[str | int], data: Any) -> str | None:
    """The unit of a field at a path of plain data: ``rad|m`` becomes one of the two, ``signal`` what it drives."""
    match unit:
        case "signal":
            unit = _signal_unit(steps, data)
        case "gain" | "gain*s":
            unit = _gain_unit(steps, data).replace("/", "*s/" if unit.endswith("*s") else "/")
        case "coordinate" | "coordinate/s":
            unit = "rad/s|m/s" if unit.endswith("/s") else "rad|m"
        case _:
            pass
    if unit is None or "|" not in unit:
        return unit
    turning, sliding = unit.split("|")
    return sliding if _slides(steps, data) else turning


def _signal_unit(steps: Sequence[str | int], data: Any) -> str:
    match list(steps):
        case ["base_motion", ("x" | "y" | "z"), *_]:
            return "m"
        case ["base_motion", *_]:
            return "rad"
        case ["drives", int(index), *_]:
            return COMMANDS.get(str(at(data, "drives", index, "command")), "rad|m")
        case _:
            return "-"


def _gain_unit(steps: Sequence[str | int], data: Any) -> str:
    joint = _joint(steps, data)
    return "V/rad|V/m" if at(joint, "motor", "resistance") is not None else "N*m/rad|N/m"


def _slides(steps: Sequence[str | int], data: Any) -> bool:
    kind = str(at(_joint(steps, data), "type"))
    return kind in JOINTS and any(each.slides for each in JOINTS[kind].coordinates)


def _joint(steps: Sequence[str | int], data: Any) -> Any:
    """The joint that a path belongs to."""
    match list(steps):
        case ["joints", int(index), *_]:
            return at(data, "joints", index)
        case ["drives", int(index), *_]:
            return _named_joint(data, at(data, "drives", index, "joint"))
        case ["initial", _, str(name), *_]:
            return _named_joint(data, name.removesuffix(".motor"))
        case _:
            return None


def _named_joint(data: Any, name: Any) -> Any:
    joints = at(data, "joints")
    found = (joint for joint in joints if at(joint, "name") == name) if isinstance(joints, list) else iter(())
    return next(found, None)
