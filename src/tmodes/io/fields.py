"""Every place of a robot's data sheet by its dotted path: what belongs there, told in words."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from functools import cache
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from tmodes.kinds.schema.quantity import span_info
from tmodes.paper.sheet import FACTOR, PLANT, PaperRobot

__all__ = ["Place", "children", "number_paths", "place_at", "places"]


@dataclass(frozen=True)
class Place:
    """One place of the data sheet; ``info`` is its field, None for an item of a list."""

    path: str
    annotation: Any
    info: FieldInfo | None = None

    @property
    def extra(self) -> dict[str, Any]:
        """Unit, symbol and range of a quantity; empty for other places."""
        extra = self.info.json_schema_extra if self.info else None
        return extra if isinstance(extra, dict) else {}

    @property
    def unit(self) -> str | None:
        """SI unit of a quantity, ``-`` when it has none; None where no quantity belongs."""
        return self.extra.get("unit")

    @property
    def may_be_infinite(self) -> bool:
        """True for a stiffness that may be infinite, by wish."""
        return bool(self.extra.get("rigid_when_infinite"))

    @property
    def meaning(self) -> str:
        """What it is, in words without the unit."""
        description = (self.info.description if self.info else None) or _first_line(self.annotation)
        return description.removesuffix(f" [{self.unit}]")

    @property
    def expected(self) -> str:
        """What belongs here, with its bounds and unit, for a message."""
        if self.unit is not None:
            infinite = ", or .inf for rigid" if self.may_be_infinite else ""
            return f"{self._number}{self._bounds} [{self.unit}]{infinite}"
        return _expected_kind(self.annotation, self.path) + self._length

    @property
    def _number(self) -> str:
        return "a whole number" if self.annotation is int else "a number"

    @property
    def _bounds(self) -> str:
        if self.extra.get("span"):
            largest = next((rule.le for rule in (self.info.metadata if self.info else ()) if hasattr(rule, "le")), None)
            return span_info(self.extra, largest, whole=self.annotation is int)
        words = {"gt": "greater than", "ge": "not less than", "le": "not more than"}
        bounds = [
            f"{word} {getattr(rule, name):.15g}"
            for rule in (self.info.metadata if self.info else ())
            for name, word in words.items()
            if hasattr(rule, name)
        ]
        return " " + " and ".join(bounds) if bounds else ""

    @property
    def _length(self) -> str:
        rules = self.info.metadata if self.info else ()
        longest = [rule.max_length for rule in rules if hasattr(rule, "max_length")]
        shortest = [rule.min_length for rule in rules if hasattr(rule, "min_length")]
        of = "items" if get_origin(self.annotation) is tuple else "characters"
        return f" of {max([0, *shortest])} to {min(longest)} {of}" if longest else ""


@cache
def places() -> dict[str, Place]:
    """All places by path (``gear``, ``gear.stiffness``, ``link.modes.0.length``), in the order of the data sheet."""
    return {place.path: place for place in _inside(PaperRobot, "")}


def place_at(path: str) -> Place | None:
    """The place at a path; each entry of ``real`` is a factor."""
    if path.startswith("real.") and path.removeprefix("real.") in number_paths():
        return Place(path, float, FACTOR)
    return places().get(path)


def children(path: str) -> list[str]:
    """Names of the keys that a group may hold; the group of the whole file is empty."""
    start = f"{path}." if path else ""
    inside = (other.removeprefix(start) for other in places() if other.startswith(start))
    return [name for name in inside if "." not in name]


@cache
def number_paths() -> tuple[str, ...]:
    """Paths of the numbers of the plant, those that ``real`` may name."""
    return tuple(path for path, place in places().items() if place.unit is not None and path.split(".")[0] in PLANT)


def _inside(model: type[BaseModel], path: str) -> Iterator[Place]:
    for name, info in model.model_fields.items():
        yield from _with_inside(Place(f"{path}.{name}" if path else name, info.annotation, info))


def _with_inside(place: Place) -> Iterator[Place]:
    yield place
    if _is_group(place.annotation):
        yield from _inside(place.annotation, place.path)
    elif get_origin(place.annotation) is tuple and Ellipsis not in get_args(place.annotation):
        for index, item in enumerate(get_args(place.annotation)):
            yield from _with_inside(Place(f"{place.path}.{index}", item))


def _is_group(annotation: Any) -> bool:
    return inspect.isclass(annotation) and issubclass(annotation, BaseModel)


def _expected_kind(annotation: Any, path: str) -> str:
    if _is_group(annotation):
        return f"a group with the keys {', '.join(children(path))}"
    if get_origin(annotation) is tuple:
        items = get_args(annotation)
        return "a list of texts" if Ellipsis in items else f"a list of exactly {len(items)} groups"
    if inspect.isclass(annotation) and issubclass(annotation, Enum):
        return f"one of {', '.join(str(choice.value) for choice in annotation)}"
    if get_origin(annotation) is dict:
        return "a group of `path of a number: factor`"
    if get_origin(annotation) is Literal:
        return f"the number {get_args(annotation)[0]}"
    return "true or false" if annotation is bool else "text"


def _first_line(annotation: Any) -> str:
    return (inspect.getdoc(annotation) or "").split("\n")[0].rstrip(".")
