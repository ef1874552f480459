"""Every number of a data sheet that may be changed by itself: its path, value, unit and bounds."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import ChainPlace, Step, place_of, quantities
from tmodes.io.sheet_groups import path_of
from tmodes.kinds.links.material import LIBRARY
from tmodes.kinds.schema.quantity import LARGEST
from tmodes.sheet import Robot

__all__ = ["SheetNumber", "sample_lists", "sheet_numbers"]

_SAMPLES = 64
"""Numbers of a list beyond which they are samples, as of a planner's motion, and no numbers of a designer."""


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
    """All finite numbers of a sheet, in its order, but for samples; a material of the library counts as written out."""
    data = sheet_data(sheet)
    for link in data.get("links", ()):
        beam = link.get("beam") or {}
        if isinstance(beam.get("material"), str):
            beam["material"] = LIBRARY[beam["material"]].model_dump(mode="json", exclude_none=True)
    for container, key, steps, place in quantities(data):
        value = container[key]
        if isinstance(container, list) and len(container) > _SAMPLES:
            continue
        if _finite(value) and place.unit is not None and steps[0] != "real":
            yield _number(data, steps, place, float(value))


def sample_lists(sheet: Robot) -> list[str]:
    """Paths of the lists of samples, whose numbers are not of :func:`sheet_numbers`."""
    data = sheet_data(sheet)
    found = {steps[:-1]: None for inner, _, steps, _ in quantities(data)
             if isinstance(inner, list) and len(inner) > _SAMPLES}  # fmt: skip
    return [path_of(steps, data) for steps in found]


def _number(data: Any, steps: tuple[Step, ...], place: ChainPlace, value: float) -> SheetNumber:
    kind = ".".join("*" if isinstance(step, int) else step for step in steps)
    path = path_of(steps, data)
    head = data[steps[0]][steps[1]] if len(steps) > 1 and isinstance(steps[1], int) else {}
    owner = str(head.get("name") or head.get("joint") or "") if isinstance(head, dict) else ""
    bounds = _bounds(place.info.metadata if place.info else ())
    found = place_of(steps, data) or place
    return SheetNumber(
        path, kind, owner, value, found.unit or "-", str(place.extra.get("symbol", "")), place.meaning, *bounds
    )


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
