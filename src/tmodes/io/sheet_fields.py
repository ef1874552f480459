"""Every place of a data sheet: what belongs there, found by walking the sheet's types along with its data.

Lists of joints and links have any length and a section or a signal may be of several kinds, so the place of a path is
only known next to the data; its unit too, because a joint turns or slides.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, get_args, get_origin

from tmodes.io.forms import SHORTHANDS, form_of
from tmodes.io.sheet_words import ChainPlace, Step, at, fields, is_group, kind_of, members_of, own_unit, types_of
from tmodes.kinds.joints.registry import JOINTS
from tmodes.kinds.schema.kind import form_of_field
from tmodes.kinds.sensors.registry import SENSORS

__all__ = ["ChainPlace", "Step", "chosen", "inside", "keys", "named", "place_of", "quantities", "root_of"]


def root_of(data: Any) -> ChainPlace:
    """The place of the whole sheet, in the form that its data have."""
    return ChainPlace(form_of(data).root)


def inside(place: ChainPlace, step: Step, value: Any, steps: Sequence[Step], data: Any) -> ChainPlace | None:
    """The place one step further in.

    ``value`` is what stands at ``place``; ``steps`` lead from the root to the new place in ``data``.
    """
    member = chosen(place, value) or _with(place.members, step, value)
    if is_group(member):
        info = fields(member).get(str(step))
        plain = "-" if info and float in (info.annotation, *get_args(info.annotation)) else None  # of a user's kind
        unit = _unit_at(own_unit(info) or plain, steps, data) if info else None
        return ChainPlace(form_of_field(info, value), info, unit) if info else None
    if get_origin(member) is tuple and isinstance(step, int):
        items = get_args(member)
        item = items[0] if Ellipsis in items else items[step] if 0 <= step < len(items) else None
        return None if item is None else _item(place, item, steps, data)
    if get_origin(member) is dict:
        return _item(place, get_args(member)[1], steps, data)
    return None


def _with(members: Sequence[Any], step: Step, value: Any) -> Any:
    """The first group with such a key, where the data do not say of which kind they are."""
    groups = [member for member in members if is_group(member)] if isinstance(value, Mapping) else []
    return next((group for group in groups if str(step) in fields(group)), None)


def _item(place: ChainPlace, item: Any, steps: Sequence[Step], data: Any) -> ChainPlace:
    """An item of a list or of names: a quantity as the whole is one, else a place of its own."""
    if place.unit is None or place.info is None:
        return ChainPlace(item)
    named = own_unit(place.info) == "parameter"  # the name of the item says of which
    return replace(place, annotation=item, unit=_unit_at("parameter", steps, data) if named else place.unit)


def place_of(steps: Sequence[Step], data: Any) -> ChainPlace | None:
    """The place that steps lead to in plain data; None when the sheet has no such place."""
    place: ChainPlace | None = root_of(data)
    value = data
    for count, step in enumerate(steps, 1):
        place = inside(place, step, value, steps[:count], data)
        if place is None:
            return None
        value = at(value, step)
    return place


def chosen(place: ChainPlace, value: Any) -> Any:
    """Which of the types of a place a value means: the one whose kind it names; None when it names none of them."""
    types = types_of(place.annotation)
    if len(types) == 1 and is_group(types[0]) and (named_type := types[0].kind_named(value)):
        return named_type  # no other kind of its family is looked at, which would import it
    members = place.members
    if len(members) == 1:
        return members[0]
    if isinstance(value, str | list):
        kind = str if isinstance(value, str) else tuple
        return next((one for one in members if kind in (one, get_origin(one))), None)
    groups = [member for member in members if is_group(member)]
    if len(groups) == 1:
        return groups[0]
    for group in groups:
        key, kinds, default = kind_of(group)
        if isinstance(value, Mapping) and value.get(key, default) in kinds:
            return group
    return None


def keys(member: Any) -> list[str]:
    """Names of the keys that a group may hold; empty for what is no group."""
    return list(fields(member))


def quantities(data: Any, places: Collection[str] = ("",)) -> Iterator[tuple[Any, Step, tuple[Step, ...], ChainPlace]]:
    """Every scalar of plain data that stands where a quantity belongs: its container, key, path and place.

    ``places``: dotted keys and numbers of the parts of the data to look at; by default all.
    """
    above = [place.split(".")[:count] for place in places for count in range(1, place.count(".") + 1)]
    parts = dict.fromkeys(map(".".join, above), False) | dict.fromkeys(places, True)
    yield from _quantities(root_of(data), data, (), data, None if "" in places else parts)


def _quantities(
    place: ChainPlace, value: Any, steps: tuple[Step, ...], data: Any, parts: Mapping[str, bool] | None
) -> Iterator[tuple[Any, Step, tuple[Step, ...], ChainPlace]]:
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    before = "".join(f"{step}." for step in steps)
    for key, item in list(items):
        here, own = (*steps, key), f"{before}{key}"
        if parts is not None and own not in parts:
            continue
        inner = inside(place, key, value, here, data)
        if inner is None or (item is None and inner.may_be_left_out):
            continue
        inner = _as_one(inner, key) if isinstance(item, str) else inner
        # the items of a list or a group, where one belongs, are quantities themselves
        holds_more = isinstance(item, (list, dict)) and get_origin(chosen(inner, item)) in {tuple, dict}
        if inner.unit is not None and not holds_more:
            yield value, key, here, inner
        else:
            yield from _quantities(inner, item, here, data, None if parts is None or parts[own] else parts)


def _as_one(place: ChainPlace, key: Step) -> ChainPlace:
    """A group in whose place one number may stand, as that number, with the unit of what it is of."""
    first = next(iter(fields(place.members[0]).values()), None) if key in SHORTHANDS and place.unit is None else None
    return replace(place, unit=own_unit(first)) if first and members_of(first.annotation) == [float] else place


def named(steps: Sequence[Step], data: Any) -> str:
    """The dotted path with the names of joints, links, points and bodies in place of their numbers."""
    info, value = [], data
    for step in steps:
        value = at(value, step)
        name = value.get("name") if isinstance(value, Mapping) and isinstance(step, int) else None
        info.append(name if isinstance(name, str) and name.isprintable() and 0 < len(name) <= 100 else str(step))
    return ".".join(info)


COMMANDS = {"voltage": "V", "torque": "N*m|N", "effort": "N*m|N", "position": "rad|m", "prescribed": "rad|m"}


def _unit_at(unit: str | None, steps: Sequence[Step], data: Any) -> str | None:
    """The unit of a field at a path of plain data: ``rad|m`` becomes one of the two, ``signal`` what it drives."""
    match unit:
        case "signal":
            unit = _signal_unit(steps, data)
        case "gain" | "gain*s":
            electric = at(_joint(steps, data), "motor", "resistance") is not None
            of_time = "*s" if unit.endswith("*s") else ""
            unit = f"V{of_time}/rad|V{of_time}/m" if electric else f"N*m{of_time}/rad|N{of_time}/m"
        case "parameter":
            unit = _parameter_unit(steps, data)
        case "output":
            unit = _sensor_unit(steps, data)
        case "command":
            electric = at(_joint(steps, data), "motor", "resistance") is not None
            unit = "V" if electric else "N*m|N"
        case "coordinate" | "coordinate/s":
            unit = "rad/s|m/s" if unit.endswith("/s") else "rad|m"
        case _:
            pass
    if unit is None or "|" not in unit:
        return unit
    kind = JOINTS.get(str(at(_joint(steps, data), "type")))
    slides = kind is not None and any(each.slides for each in kind.coordinates)
    return unit.split("|")[slides]


def _signal_unit(steps: Sequence[Step], data: Any) -> str:
    match list(steps):
        case ["base_motion", ("x" | "y" | "z"), *_]:
            return "m"
        case ["base_motion", *_]:
            return "rad"
        case ["drives", int(index), *_]:
            return COMMANDS.get(str(at(data, "drives", index, "command")), "rad|m")
        case _:
            return "-"


def _sensor_unit(steps: Sequence[Step], data: Any) -> str:
    """Of what a sensor gives first; of any output SI, by no name."""
    kind = str(at(data, "sensors", steps[1], "type")) if len(steps) > 1 and steps[0] == "sensors" else ""
    unit = SENSORS[kind].ports[0].unit if kind in SENSORS.names else "-"
    return "-" if unit == "1" else unit


def _parameter_unit(steps: Sequence[Step], data: Any) -> str:
    """Of a parameter of a study: in its own group, or by its name in the plan."""
    match list(steps):
        case ["parameters", str(name), *_] | ["plan", _, int(), str(name), *_] | ["plan", _, str(name), *_]:
            unit = at(data, "parameters", name, "unit")
            return unit if isinstance(unit, str) else "-"
        case _:
            return "-"


def _joint(steps: Sequence[Step], data: Any) -> Any:
    """The joint that a path belongs to."""
    match list(steps):
        case ["joints", int(index), *_]:
            return at(data, "joints", index)
        case ["drives", int(index), *_]:
            name = at(data, "drives", index, "joint")
        case ["sensors", int(index), *_]:
            name = at(data, "sensors", index, "joint")
        case ["control", int(index), *_]:
            name = at(data, "control", index, "of") or at(data, "control", index, "drives", 0)
        case ["initial", _, str(coordinate), *_]:
            name = coordinate.removesuffix(".motor")
        case _:
            return None
    joints = at(data, "joints")
    among = joints if isinstance(joints, list) else []
    found = (joint for joint in among if isinstance(joint, dict) and joint.get("name") == name)
    return next(found, None)
