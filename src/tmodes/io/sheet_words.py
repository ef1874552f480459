"""The types of a robot's data sheet, and a place of each type: what belongs there, given in words."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from tmodes.kinds.schema.kind import names_allowed
from tmodes.kinds.schema.quantity import LARGEST, span_info

__all__ = ["ChainPlace", "Step", "at", "fields", "is_group", "kind_of", "members_of", "own_unit", "types_of"]

Step = str | int


def types_of(annotation: Any) -> list[Any]:
    """The types that an annotation names, without None and without their notes."""
    origin = get_origin(annotation)
    if origin is Annotated:
        return types_of(get_args(annotation)[0])
    if origin in {Union, UnionType}:
        return [member for one in get_args(annotation) if one is not NoneType for member in types_of(one)]
    return [annotation]


def members_of(annotation: Any) -> list[Any]:
    """The types that an annotation allows: those it names, of a family of kinds all its members."""
    return [member for one in types_of(annotation) for member in (one.members() if is_group(one) else [one])]


def fields(member: Any) -> dict[str, FieldInfo]:
    """Fields of a group by the keys of the file; none for what is no group."""
    if not is_group(member):
        return {}
    return {info.alias or name: info for name, info in member.model_fields.items()}


def is_group(member: Any) -> bool:
    """True for a type that is a group of keys."""
    return inspect.isclass(member) and issubclass(member, BaseModel)


def own_unit(info: FieldInfo) -> str | None:
    """The unit as the field says it, which may depend on where it stands."""
    extra = info.json_schema_extra
    return str(extra["unit"]) if isinstance(extra, dict) and "unit" in extra else None


def kind_of(member: Any) -> tuple[str, tuple[Any, ...], Any]:
    """The key that says which of several groups this is, its values here, and what it is when it is left out."""
    if is_group(member) and member.chosen_by()[1]:  # a kind that a field of several words chooses among the registered
        return (*member.chosen_by(), None)
    for name, info in fields(member).items():
        if get_origin(info.annotation) is Literal:
            return name, get_args(info.annotation)[:1], None if info.is_required() else info.default
    return "", (), None


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
        several, groups = types_of(self.annotation), [one for one in self.members if is_group(one)]
        families = [one for one in several if is_group(one) and one.members() != (one,)]
        return len(several) > 1 and not families and not any(one.chosen_by()[1] for one in groups)

    @property
    def may_be_left_out(self) -> bool:
        """True where nothing may stand."""
        return NoneType in get_args(self.annotation)

    @property
    def whole(self) -> bool:
        """True for a count."""
        return self.members == [int]

    @property
    def choices(self) -> list[str]:
        """The words that it allows, where it allows only some."""
        enums = [member for member in self.members if inspect.isclass(member) and issubclass(member, Enum)]
        return names_allowed(self.info) or [str(choice.value) for member in enums for choice in member]

    @property
    def meaning(self) -> str:
        """What it is, in words without the unit."""
        described, member = self.info.description if self.info else None, self.members[0]
        own = (inspect.getdoc(member) or "").split("\n")[0].rstrip(".") if is_group(member) else "value"
        return (described or own).partition(" [")[0].removeprefix("the ").removeprefix("the ")

    @property
    def expected(self) -> str:
        """What belongs here, with its bounds and unit, for a message."""
        if self.unit is None:
            return self._kind
        infinite = ", or .inf for rigid" if self.may_be_infinite else ""
        return f"{self._numbers}{self._bounds} [{self.unit}]{infinite}"

    @property
    def _numbers(self) -> str:
        member = self.members[0]
        if get_origin(member) is dict:
            return "a group of names and numbers"
        if get_origin(member) is not tuple:
            return "a whole number" if self.whole else "a number"
        items = get_args(member)
        return "a number, or a list of numbers" if Ellipsis in items else f"a list of {len(items)} numbers"

    @property
    def _kind(self) -> str:
        """What belongs in a place that is no quantity."""
        if len(self.members) > 1:
            kinds = [str(kind) for _, words, _ in map(kind_of, self.members) for kind in words]
            return f"a group of the kind {', '.join(kinds)}" if kinds else "a name, or a group of numbers"
        member = self.members[0]
        if is_group(member):
            return f"a group with the keys {', '.join(fields(member))}"
        if names := self.choices:
            return f"one of {', '.join(names)}"
        items = get_args(member) if get_origin(member) is tuple else ()
        if items and Ellipsis not in items:
            return f"a list of exactly {len(items)} {'groups' if is_group(items[0]) else 'values'}"
        plain = {tuple: f"a list{self._length('items')}", dict: "a group of names"}
        if origin := get_origin(member):
            return repr(get_args(member)[0]) if origin is Literal else plain[origin]
        number = f"a number{self._bounds}"
        words = {bool: "true or false", int: number, float: number}
        return words.get(member) or f"text{self._length('characters')}"

    @property
    def _bounds(self) -> str:
        """The bounds of a number, such as `` greater than 0``, but for those of arithmetic."""
        rules = self.info.metadata if self.info else []
        if self.extra.get("span"):
            largest = next((rule.le for rule in rules if hasattr(rule, "le")), None)
            least = self.extra["smallest"]
            if self.annotation is int:
                least = next((rule.ge for rule in rules if hasattr(rule, "ge")), max(1.0, least))
            return span_info(least, largest)
        notes = get_args(self.annotation)[1:] if get_origin(self.annotation) is Annotated else ()
        inner = [rule for note in notes for rule in (note.metadata if isinstance(note, FieldInfo) else [note])]
        words = {"gt": "greater than", "ge": "not less than", "le": "not more than"}
        found = [
            f"{word} {getattr(rule, name):.15g}"
            for rule in [*rules, *inner]
            for name, word in words.items()
            if getattr(rule, name, None) is not None and abs(getattr(rule, name)) < LARGEST
        ]
        return " " + " and ".join(dict.fromkeys(found)) if found else ""

    def _length(self, of: str) -> str:
        rules = self.info.metadata if self.info else ()
        longest = [rule.max_length for rule in rules if hasattr(rule, "max_length")]
        shortest = [rule.min_length for rule in rules if hasattr(rule, "min_length")]
        if longest:
            return f" of {max([0, *shortest])} to {min(longest)} {of}"
        return f" of at least {max(shortest)} {of}" if shortest else ""
