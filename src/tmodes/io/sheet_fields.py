"""Every place of a data sheet: what belongs there, found by walking the sheet's types along with its data.

Lists of joints and links have any length and a section or a signal may be of several kinds, so the place of a path is
only known next to the data; its unit too, because a joint turns or slides.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import NoneType
from typing import Any, get_args, get_origin

from pydantic.fields import FieldInfo

from tmodes.io.forms import form_of
from tmodes.io.sheet_words import (
    at,
    bounds,
    expected_kind,
    fields,
    first_line,
    is_group,
    is_registered,
    kind_of,
    members_of,
    own_unit,
    unit_at,
)
from tmodes.kinds.schema.kind import form_of_field

__all__ = ["ChainPlace", "Step", "chosen", "inside", "keys", "named", "place_of", "quantities", "root_of"]

Step = str | int


@dataclass(frozen=True)
class ChainPlace:
    """One place of the data sheet: its type, its field (None for the sheet itself), and its unit there."""

    annotation: Any
    info: FieldInfo | None = None
    unit: str | None = None

    @property
    def extra(self) -> dict[str, Any]:
        """Unit, symbol and range of a quantity; empty for other places."""
        extra = self.info.json_schema_extra if self.info else None
        return extra if isinstance(extra, dict) else {}

    @property
    def may_be_infinite(self) -> bool:
        """True for a stiffness that may be infinite, by wish."""
        return bool(self.extra.get("rigid_when_infinite"))

    @property
    def members(self) -> list[Any]:
        """The types it may have, without None and without their notes."""
        return members_of(self.annotation)

    @property
    def tagged(self) -> bool:
        """Whether the validator names the chosen type as a step of its locations."""
        return len(self.members) > 1 and not any(is_registered(member) for member in self.members)

    @property
    def may_be_left_out(self) -> bool:
        """True where nothing may stand."""
        return NoneType in get_args(self.annotation)

    @property
    def whole(self) -> bool:
        """True for a count."""
        return self.members == [int]

    @property
    def meaning(self) -> str:
        """What it is, in words without the unit."""
        description = (self.info.description if self.info else None) or first_line(self.members[0])
        return description.partition(" [")[0].removeprefix("the ").removeprefix("the ")

    @property
    def expected(self) -> str:
        """What belongs here, with its bounds and unit, for a message."""
        if self.unit is None:
            return expected_kind(self.members, self.info)
        infinite = ", or .inf for rigid" if self.may_be_infinite else ""
        return f"{self._numbers}{bounds(self.info, self.annotation)} [{self.unit}]{infinite}"

    @property
    def _numbers(self) -> str:
        member = self.members[0]
        if get_origin(member) is dict:
            return "a group of names and numbers"
        if get_origin(member) is not tuple:
            return "a whole number" if self.whole else "a number"
        items = get_args(member)
        return "a number, or a list of numbers" if Ellipsis in items else f"a list of {len(items)} numbers"


def root_of(data: Any) -> ChainPlace:
    """The place of the whole sheet, in the form that its data have."""
    return ChainPlace(form_of(data).root)


def inside(place: ChainPlace, step: Step, value: Any, steps: Sequence[Step], data: Any) -> ChainPlace | None:
    """The place one step further in.

    ``value`` is what stands at ``place``; ``steps`` lead from the root to the new place in ``data``.
    """
    member = chosen(place.members, value)
    if is_group(member):
        info = fields(member).get(str(step))
        return ChainPlace(form_of_field(info, value), info, unit_at(own_unit(info), steps, data)) if info else None
    if get_origin(member) is tuple and isinstance(step, int):
        items = get_args(member)
        item = items[0] if Ellipsis in items else items[step] if 0 <= step < len(items) else None
        return None if item is None else _item(place, item)
    if get_origin(member) is dict:
        return _item(place, get_args(member)[1])
    return None


def _item(place: ChainPlace, item: Any) -> ChainPlace:
    """An item of a list or of names: a quantity as the whole is one, else a place of its own."""
    return replace(place, annotation=item) if place.unit is not None else ChainPlace(item)


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


def chosen(members: Sequence[Any], value: Any) -> Any:
    """Which of several types a value means: the one whose kind it names; None when it names none of them."""
    if len(members) == 1:
        return members[0]
    if isinstance(value, str):
        return str if str in members else None
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


def quantities(data: Any) -> Iterator[tuple[Any, Step, tuple[Step, ...], ChainPlace]]:
    """Every scalar of plain data that stands where a quantity belongs: its container, key, path and place."""
    yield from _quantities(root_of(data), data, (), data)


def _quantities(
    place: ChainPlace, value: Any, steps: tuple[Step, ...], data: Any
) -> Iterator[tuple[Any, Step, tuple[Step, ...], ChainPlace]]:
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in list(items):
        here = (*steps, key)
        inner = inside(place, key, value, here, data)
        if inner is None or (item is None and inner.may_be_left_out):
            continue
        if inner.unit is not None and not _holds_more(inner, item):
            yield value, key, here, inner
        else:
            yield from _quantities(inner, item, here, data)


def _holds_more(place: ChainPlace, value: Any) -> bool:
    """True for a list or a group at a place where one belongs: its items are the quantities."""
    kind = get_origin(chosen(place.members, value))
    return kind in {tuple, dict} and isinstance(value, (list, dict))


def named(steps: Sequence[Step], data: Any) -> str:
    """The dotted path with the names of joints, links, points and bodies in place of their numbers."""
    info, value = [], data
    for step in steps:
        value = at(value, step)
        name = value.get("name") if isinstance(value, Mapping) and isinstance(step, int) else None
        info.append(name if isinstance(name, str) and name.isprintable() and 0 < len(name) <= 100 else str(step))
    return ".".join(info)
