"""Every number of a data sheet that may be changed by itself: its path, value, unit and bounds."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from tmodes.errors import InputError
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import ChainPlace, Step, named, place_of, quantities
from tmodes.io.sheet_paths import steps_of
from tmodes.io.sheet_words import at
from tmodes.kinds.links.material import LIBRARY
from tmodes.kinds.schema.quantity import LARGEST
from tmodes.sheet import Robot

__all__ = ["SheetNumber", "real_entry", "sheet_numbers"]


@dataclass(frozen=True)
class SheetNumber:
    """A number of a sheet: its path, the same with ``*`` for each item of a list (``pattern``), and what it is of.

    ``least`` and ``most`` are its bounds by the sheet's checks; ``above`` says that the least itself is refused.
    """

    path: str
    pattern: str
    owner: str
    value: float
    unit: str
    symbol: str
    meaning: str
    least: float
    most: float


def sheet_numbers(sheet: Robot) -> Iterator[SheetNumber]:
    """All finite numbers of a sheet, in its order; a material of the library counts as if it were written out."""
    data = sheet_data(sheet)
    for link in data.get("links", ()):
        beam = link.get("beam") or {}
        if isinstance(beam.get("material"), str):
            beam["material"] = LIBRARY[beam["material"]].model_dump(mode="json", exclude_none=True)
    for container, key, steps, place in quantities(data):
        value = container[key]
        if _finite(value) and place.unit is not None and steps[0] != "real":
            yield _number(data, steps, place, float(value))


def real_entry(sheet: Robot, path: str) -> tuple[str | None, float]:
    """Path in ``real`` at which the factor on a number stands, or would stand, and the factor.

    The path is None where several factors act on it, or one that acts on others as well.
    """
    data = sheet_data(sheet)
    steps = steps_of(path, data)
    info = [(other, steps_of(other, data)) for other in sheet.real]
    acting = [(other, own) for other, own in info if steps[: len(own)] == own]
    if not acting:
        return path, 1.0
    (first, own), *others = acting
    shared = bool(others) or (len(own) < len(steps) and len(at(data, *own)) > 1)
    return None if shared else first, math.prod(sheet.real[other] for other, _ in acting)


def _number(data: Any, steps: tuple[Step, ...], place: ChainPlace, value: float) -> SheetNumber:
    kind = ".".join("*" if isinstance(step, int) else step for step in steps)
    own = ".".join(map(str, steps))
    path = named(steps, data)
    if not _leads_to(path, steps, data):
        path = own
    head = data[steps[0]][steps[1]] if len(steps) > 1 and isinstance(steps[1], int) else {}
    owner = str(head.get("name") or head.get("joint") or "") if isinstance(head, dict) else ""
    bounds = _bounds(place.info.metadata if place.info else ())
    found = place_of(steps, data) or place
    return SheetNumber(
        path, kind, owner, value, found.unit or "-", str(place.extra.get("symbol", "")), place.meaning, *bounds
    )


def _leads_to(path: str, steps: Sequence[Step], data: Any) -> bool:
    """Whether a path with names is understood, and means these steps."""
    try:
        return steps_of(path, data) == list(steps)
    except InputError:
        return False


def _finite(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def _bounds(rules: Sequence[Any]) -> tuple[float, float]:
    """Least and most by the rules of a field; an open bound is moved in by rounding."""
    least, most = -LARGEST, LARGEST
    for rule in rules:
        if getattr(rule, "gt", None) is not None:
            least = max(least, math.nextafter(float(rule.gt), math.inf))
        if getattr(rule, "ge", None) is not None:
            least = max(least, float(rule.ge))
        if getattr(rule, "le", None) is not None:
            most = min(most, float(rule.le))
    return least, most
