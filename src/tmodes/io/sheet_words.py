"""The types of a robot's data sheet, and what belongs in a place of each type, given in words."""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from enum import Enum
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from tmodes.kinds.joints.registry import JOINTS
from tmodes.kinds.schema.kind import names_allowed
from tmodes.kinds.schema.quantity import LARGEST, span_info

__all__ = [
    "at",
    "bounds",
    "choices",
    "expected_kind",
    "fields",
    "first_line",
    "is_group",
    "is_registered",
    "kind_of",
    "members_of",
    "own_unit",
    "unit_at",
]


def members_of(annotation: Any) -> list[Any]:
    """The types that an annotation allows, without None and without their notes."""
    origin = get_origin(annotation)
    if origin is Annotated:
        return members_of(get_args(annotation)[0])
    if origin in {Union, UnionType}:
        return [member for one in get_args(annotation) if one is not NoneType for member in members_of(one)]
    return list(annotation.members()) if is_group(annotation) else [annotation]


def fields(member: Any) -> dict[str, FieldInfo]:
    """Fields of a group by the keys of the file; none for what is no group."""
    if not is_group(member):
        return {}
    return {info.alias or name: info for name, info in member.model_fields.items()}


def is_group(member: Any) -> bool:
    """True for a type that is a group of keys."""
    return inspect.isclass(member) and issubclass(member, BaseModel)


def is_registered(member: Any) -> bool:
    """True for the sheet of a kind that a field of several words chooses among the registered ones."""
    return is_group(member) and bool(member.chosen_by()[1])


def own_unit(info: FieldInfo) -> str | None:
    """The unit as the field says it, which may depend on where it stands."""
    extra = info.json_schema_extra
    return str(extra["unit"]) if isinstance(extra, dict) and "unit" in extra else None


def kind_of(member: Any) -> tuple[str, tuple[Any, ...], Any]:
    """The key that says which of several groups this is, its values here, and what it is when it is left out."""
    if is_registered(member):
        return (*member.chosen_by(), None)
    for name, info in fields(member).items():
        if get_origin(info.annotation) is Literal:
            return name, get_args(info.annotation)[:1], None if info.is_required() else info.default
    return "", (), None


def expected_kind(members: list[Any], info: FieldInfo | None) -> str:
    """What belongs in a place that is no quantity."""
    if len(members) > 1:
        kinds = [str(kind) for _, words, _ in map(kind_of, members) for kind in words]
        return f"a group of the kind {', '.join(kinds)}" if kinds else "a name, or a group of numbers"
    member = members[0]
    if is_group(member):
        return f"a group with the keys {', '.join(fields(member))}"
    if names := choices(members, info):
        return f"one of {', '.join(names)}"
    items = get_args(member) if get_origin(member) is tuple else ()
    if items and Ellipsis not in items:
        return f"a list of exactly {len(items)} {'groups' if is_group(items[0]) else 'values'}"
    plain = {tuple: f"a list{_length(info, 'items')}", dict: "a group of names"}
    if origin := get_origin(member):
        return repr(get_args(member)[0]) if origin is Literal else plain[origin]
    return "true or false" if member is bool else f"text{_length(info, 'characters')}"


def choices(members: list[Any], info: FieldInfo | None) -> list[str]:
    """The words that a place allows, where it allows only some."""
    enums = [member for member in members if inspect.isclass(member) and issubclass(member, Enum)]
    return names_allowed(info) or [str(choice.value) for member in enums for choice in member]


def bounds(info: FieldInfo | None, annotation: Any) -> str:
    """The bounds of a number, such as `` greater than 0``, but for those of arithmetic."""
    extra = info.json_schema_extra if info else None
    if info and isinstance(extra, dict) and extra.get("span"):
        largest = next((rule.le for rule in info.metadata if hasattr(rule, "le")), None)
        return span_info(extra, largest, whole=annotation is int)
    words = {"gt": "greater than", "ge": "not less than", "le": "not more than"}
    found = [
        f"{word} {getattr(rule, name):.15g}"
        for rule in [*(info.metadata if info else ()), *_notes(annotation)]
        for name, word in words.items()
        if getattr(rule, name, None) is not None and abs(getattr(rule, name)) < LARGEST
    ]
    return " " + " and ".join(dict.fromkeys(found)) if found else ""


def _notes(annotation: Any) -> list[Any]:
    """Rules that a type itself carries."""
    notes = get_args(annotation)[1:] if get_origin(annotation) is Annotated else ()
    return [rule for note in notes for rule in (note.metadata if isinstance(note, FieldInfo) else [note])]


def first_line(member: Any) -> str:
    """What a group is, by the first line of its docstring."""
    return (inspect.getdoc(member) or "").split("\n")[0].rstrip(".") if is_group(member) else "value"


def _length(info: FieldInfo | None, of: str) -> str:
    rules = info.metadata if info else ()
    longest = [rule.max_length for rule in rules if hasattr(rule, "max_length")]
    shortest = [rule.min_length for rule in rules if hasattr(rule, "min_length")]
    return f" of {max([0, *shortest])} to {min(longest)} {of}" if longest else ""


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
