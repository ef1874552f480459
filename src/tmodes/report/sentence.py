"""The result of a run in one sentence: how far the tip was off, by what, and how soon it came to rest."""

from __future__ import annotations

from typing import Any

from tmodes.report.markup import written
from tmodes.result.summary import TIP

__all__ = ["result_sentence"]


def result_sentence(summary: dict[str, Any]) -> str:
    """From the summary of a run that reached its end; lengths in mm."""
    if error := summary["tip_error"].get("commanded"):
        return f"{_missed(error, summary['point']['name'])}{_settled(summary['settling'])}"
    links = {name: link["deflection"] for name, link in summary["links"].items()}
    if links:
        name = max(links, key=lambda name: links[name]["max_m"])
        return f"The end of {name} is deflected by at most {_largest(links[name]['max_m'], links[name]['time_s'])}."
    if gears := {name: one for name, one in summary["deformations"].items() if one["max"]}:
        name = max(gears, key=lambda name: gears[name]["max"])
        one = gears[name]
        return f"{name} is deflected by at most {_largest(one['max'], one['time_of_max_s'], one['unit'])}."
    return "Nothing elastic moves in this run."


def _missed(error: dict[str, Any], point: str) -> str:
    point = "The tip" if point == TIP else f"T{point.removeprefix('t')}"
    parts = {name: value for name, value in error["parts_m"].items() if abs(value) > _NOTHING * error["max_m"]}
    largest = _largest(error["max_m"], error["time_of_max_s"])
    if not parts:
        return f"{point} misses its commanded path by at most {largest}."
    by = ", ".join(f"{1e3 * value:.3g} {name}" for name, value in sorted(parts.items(), key=lambda one: -abs(one[1])))
    return f"{point} misses its commanded path by at most {largest}: {by}."


_NOTHING = 1e-4
"""Share of the whole error below which a part is left out."""


def _largest(value: float, time: float, unit: str = "m") -> str:
    return f"{written(value, unit, 3)} (t = {time:.3g} s)"


def _settled(known: dict[str, Any]) -> str:
    if known["reason"]:
        return ""
    return f" It comes to rest {known['time_s']:.2g} s after the move, within {written(known['limit_m'], 'm', 2)}."
