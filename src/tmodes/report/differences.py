"""How runs of one robot differ: the values of their sheets that differ, names made of them, and their numbers."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

from tmodes.io.printed import changed_by
from tmodes.io.sheet_fields import Step, place_of
from tmodes.io.sheet_groups import path_of
from tmodes.io.words import shown
from tmodes.report.markup import Markup, table, tag, written
from tmodes.result import Result

__all__ = ["Difference", "difference_tables", "differences", "names_by_difference", "run_names"]

_ASIDE = {"format", "kind", "name", "title", "imported", "citation", "assumed", "notices"}
"""Entries of a sheet that change no run."""

_MOST_ROWS, _MOST_NAMED = 40, 3
"""Differences that a table lists, and that a name may hold."""


class Difference(NamedTuple):
    """A place of the sheets by its path, and what stands there in each run; a dash for nothing.

    ``values``: with units; ``bare``: numbers in SI units.
    """

    path: str
    values: tuple[str, ...]
    bare: tuple[str, ...]

    def label(self, words: int) -> str:
        """The last words of the path: ``payload.mass``."""
        return ".".join([word for word in self.path.split(".") if not word.isdigit()][-words:])


def differences(results: Sequence[Result]) -> list[Difference]:
    """All values that differ between the sheets of several runs, in the order of the sheets."""
    sheets = [json.loads(result.record.attrs["robot"]) for result in results]
    flat = [{path_of(steps, sheet): (steps, value) for steps, value in _leaves(sheet, ())} for sheet in sheets]
    paths = dict.fromkeys(path for one in flat for path in one)
    found = []
    for path in paths:
        here = [one.get(path) for one in flat]
        if len({json.dumps(one and one[1]) for one in here}) > 1:
            texts = [_texts(*one, sheet) if one else ("–", "–") for one, sheet in zip(here, sheets, strict=True)]
            found.append(Difference(path, *zip(*texts, strict=True)))
    return found


def _leaves(value: Any, steps: tuple[Step, ...]) -> Iterator[tuple[tuple[Step, ...], Any]]:
    """Everything in a sheet that is no group and no list, with what leads to it."""
    items: Any = value.items() if isinstance(value, Mapping) else enumerate(value) if isinstance(value, list) else None
    if items is None:
        yield steps, value
        return
    for step, item in items:
        if steps or step not in _ASIDE:
            yield from _leaves(item, (*steps, step))


def _texts(steps: tuple[Step, ...], value: Any, sheet: Any) -> tuple[str, str]:
    """With its unit, and without."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        text = value if isinstance(value, str) else shown(value)
        return text, text
    place = place_of(steps, sheet)
    return written(float(value), (place and place.unit) or "-", 6), f"{value:.6g}"


def names_by_difference(results: Sequence[Result]) -> list[str] | None:
    """Names of runs of one robot by the fewest values that tell all apart, such as ``gear.stiffness 90``.

    At most 24 letters, so with fewer words of the path, or without the unit, where that is too long. None where there
    are none, or too many.
    """
    if len({result.name for result in results}) != 1 or len(results) < 2:
        return None
    found = differences(results)
    for count in range(1, min(len(found), _MOST_NAMED) + 1):
        for words, field in product((2, 1, 0), ("values", "bare")):
            parts = [[f"{one.label(words)} {value}".strip() if words else value for value in getattr(one, field)]
                     for one in found[:count]]  # fmt: skip
            names = [", ".join(own) for own in zip(*parts, strict=True)]
            if _short_and_apart(names):
                return names
    return None


LONGEST = 24
"""Letters of a run's name."""


def run_names(results: Sequence[Result], files: Sequence[Path] = ()) -> list[str]:
    """Short names of runs that tell them apart: by what differs, else of robots, of folders, else numbers."""
    own = [result.name if len(result.name) <= LONGEST else f"{result.name[: LONGEST - 1]}…" for result in results]
    if len(results) < 2 or _short_and_apart(own):
        return own
    if found := names_by_difference(results):
        return found
    places = [(path.parent if path.name == "result.nc" else path.with_suffix("")).parts for path in files]
    for depth in range(1, 1 + max(map(len, places), default=0)):
        if _short_and_apart(names := ["/".join(parts[-depth:]) for parts in places]):
            return names
    return [f"{name[: LONGEST - 3]} {number}" for number, name in enumerate(own, 1)]


def _short_and_apart(names: Sequence[str]) -> bool:
    return len(set(names)) == len(names) and max(map(len, names)) <= LONGEST


def difference_tables(results: Sequence[Result], runs: Sequence[Mapping[str, Any]]) -> Markup | None:
    """What differs between the sheets of several runs, and the numbers of each with their change from the first.

    ``runs``: as the page has them, with name and facts. None of a single run.
    """
    if len(runs) < 2:
        return None
    names, found = [str(run["name"]) for run in runs], differences(results)
    parts = [tag("h2", "Differences")]
    if found and len({result.name for result in results}) == 1:
        rows = [[one.path, *one.values] for one in found[:_MOST_ROWS]]
        more = f"; {len(found) - _MOST_ROWS} more" if len(found) > _MOST_ROWS else ""
        columns = range(1, len(names) + 1)
        parts.append(table(f"Values of the sheets that differ{more}", ["value", *names], rows, columns))
    rows = [*_numbers(runs)]
    if rows:
        title = f"Numbers of each run, and their change from the first ({names[0]})"
        parts.append(table(title, ["number", *names], rows, range(1, len(names) + 1)))
    return tag("section", *parts, class_="differences", aria_label="Differences") if len(parts) > 1 else None


def _numbers(runs: Sequence[Mapping[str, Any]]) -> Iterator[list[str]]:
    """A row for each number that all runs have."""
    every = [{fact["id"]: fact for fact in run["facts"] if fact["value"] is not None} for run in runs]
    for name, first in every[0].items():
        if name.startswith("energy."):  # rounding, whose change says nothing
            continue
        here = [one.get(name) for one in every]
        if all(one and one["unit"] == first["unit"] for one in here):
            values = [float(one["value"]) for one in here if one]
            yield [first["name"], *(_changed(value, values[0], first["unit"], k) for k, value in enumerate(values))]


def _changed(value: float, first: float, unit: str, index: int) -> str:
    """A value, and its difference from that of the first run."""
    change = value - first
    if not index or not change:
        return written(value, unit)
    words = [f"{'+' if change > 0 else '−'}{written(abs(change), unit, 3)}" if first else "", changed_by(value, first)]
    return f"{written(value, unit)} ({', '.join(filter(None, words))})"
