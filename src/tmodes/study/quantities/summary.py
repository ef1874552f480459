"""A number of the run's summary, by its path."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.errors import InputError
from tmodes.io.words import meant, shown
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet import Robot
from tmodes.study.quantities.contract import QUANTITIES, Asked, Found, Needs, Quantity, in_any
from tmodes.study.quantities.summary_paths import names_in_summary, path_issues

__all__ = ["Summary", "summary_number"]

_UNITS = {"s": "s", "m": "m", "Hz": "Hz", "N": "N", "Nm": "N*m", "Pa": "Pa", "J": "J", "rad": "rad"}
"""Units by the ending of a key."""


_ALONE: dict[str, Callable[[Any], Any]] = {
    "settling": lambda result: result.settling,
    "vibration": lambda result: result.vibration,
}
"""Groups that a result gives by themselves, as its summary has them."""


@QUANTITIES.register
class Summary(Quantity):
    """A number of the summary by its ``path``: ``settling.time_s``, ``first_frequency_Hz.controlled``."""

    named: ClassVar[str] = "path"

    type: Literal["summary"] = Field(description="kind of quantity")
    path: str = Field(min_length=1, max_length=200, description="path in the summary, as `tmodes run --json` prints it")

    def needs(self) -> Needs:
        """The result of the run; with estimated errors where it is one of them."""
        first = self.path.partition(".")[0]
        return Needs(result=True, errors=frozenset({first} & {"error", "model_error"}))

    def name_issues(self, names: Sequence[str]) -> Iterator[Issue]:  # noqa: ARG002
        """A path that no summary has, whatever the names of its robot."""
        yield from path_issues(self.path, {})

    def robot_issues(self, robots: Iterable[Robot]) -> Iterator[Issue]:
        """A path with a name that the robot has not."""
        yield from in_any(robots, lambda robot: path_issues(self.path, names_in_summary(robot)))

    def own_unit(self, asked: Asked) -> str:
        """By the ending of its key."""
        return asked.own_unit

    def values(self, asked: Asked) -> Found:
        """What stands there in the summary of each result."""
        assert asked.own is not None  # noqa: S101
        return asked.own, asked.own_reasons

    def of_result(self, result: Any, function: Any = None) -> tuple[float, str, str]:  # noqa: ARG002
        """The number at the path; not-a-number, and why, where a summary says that there is none.

        What one group of the summary needs is computed for it alone, where that is known: the whole summary may take
        longer than the run. Raises :class:`tmodes.errors.InputError` for a path that it does not have.
        """
        first = self.path.partition(".")[0]
        own = _ALONE[first](result) if first in _ALONE else None
        return summary_number(result.summary() if own is None else {first: own}, self.path)


def summary_number(summary: Mapping[str, Any], path: str) -> tuple[float, str, str]:
    """The number at a path of a summary, its unit, and why there is none; raises as :meth:`Summary.of_result`."""
    value, words, group, unit = summary, path.split("."), {}, "-"
    while words:
        if value is None:
            return math.nan, unit, f"the summary has no {path}"
        key, used = _key(value, words)
        if key is None:
            known = ", ".join(map(str, value)) if isinstance(value, Mapping) else "nothing below it"
            hint = meant(words[0], map(str, value), "see: tmodes run --json") if isinstance(value, Mapping) else ""
            raise InputError(path, f"the unknown key {words[0]!r}", known, hint)
        group, value = value, value[key]
        ending = str(key).rpartition("_")[2]
        unit = _UNITS.get(ending, unit) if "_" in str(key) else unit
        words = words[used:]
    if value is None:
        why = group.get("reason") if isinstance(group, Mapping) else ""
        return math.nan, unit, str(why or f"the summary has no {path}")
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        inner = f": one of {', '.join(map(str, value))}" if isinstance(value, Mapping) else ""
        raise InputError(path, shown(value), f"the path of a number{inner}", "write the whole path")
    return float(value), str(group.get("unit", unit)) if isinstance(group, Mapping) and unit == "-" else unit, ""


def _key(value: Any, words: Sequence[str]) -> tuple[Any, int]:
    """The key of a group, or index of a list, that some words name, and how many: names may hold dots."""
    if isinstance(value, Mapping):
        for count in range(len(words), 0, -1):
            if (name := ".".join(words[:count])) in value:
                return name, count
    if isinstance(value, (list, tuple)) and words[0].isdecimal() and int(words[0]) < len(value):
        return int(words[0]), 1
    return None, 0
