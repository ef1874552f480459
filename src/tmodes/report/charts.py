"""The linked charts of one or several runs, as the page holds them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.charts import Array, Chart, Line, Look, in_units, looks
from tmodes.plot.contents import run_charts
from tmodes.plot.style import PARTS
from tmodes.report.pack import MOST_POINTS, Coarse, thinned
from tmodes.result import Result
from tmodes.result.derived import Derives

__all__ = ["chart_data", "charts_of", "page_charts"]

_TOGETHER = 6
"""Coordinates or joints in one chart, at most."""

_SAME = 2e-3
"""Share of a chart's range within which curves lie on each other."""

_LARGEST_SINGLE = 1e37


def charts_of(results: Sequence[Result], made: Sequence[Derives] = ()) -> list[list[dict[str, Any]]]:
    """The charts of each run as ``Chart`` of ``web/src/contract.ts``; charts of one name have one unit in all runs.

    ``made``: what notes of each run which charts could not be drawn.
    """
    runs = [page_charts(*one) for one in zip(results, made or [Derives() for _ in results], strict=True)]
    shown = {chart.id for run in runs for chart in run if _shows(chart)}
    return [[chart_data(chart) for chart in run if chart.id in shown] for run in in_units(runs)]


def page_charts(result: Result, made: Derives | None = None) -> list[Chart]:
    """The charts of a run with at most six labels each, curves that lie on each other being one."""
    return [part for chart in run_charts(result, made) for part in _parts(chart)]


def _shows(chart: Chart) -> bool:
    """Whether there is more than zeros, or that is what it is to show."""
    return chart.group == "energy" or any(np.any(line.values) for line in chart.lines)


def _parts(chart: Chart) -> Iterator[Chart]:
    if chart.group not in ("motors", "deformations"):
        yield chart
        return
    groups = [[line for line in chart.lines if line.label == label] for label in chart.labels]
    groups = _apart(groups) if chart.group == "motors" else groups
    for first in range(0, len(groups), _TOGETHER):
        part = groups[first : first + _TOGETHER]
        more = f", {first + 1} to {first + len(part)} of {len(groups)}" if len(groups) > _TOGETHER else ""
        lines = tuple(line for group in part for line in group)
        yield replace(chart, id=f"{chart.id}_{first}", title=f"{chart.title}{more}", lines=lines)


def _apart(groups: Sequence[list[Line]]) -> list[list[Line]]:
    """Curves that lie on each other are drawn once, under all their names."""
    largest = max((float(np.ptp(line.values)) for group in groups for line in group), default=0.0)
    found: list[list[Line]] = []
    for group in groups:
        for k, other in enumerate(found):
            if len(other) == len(group) and all(
                np.abs(one.values - two.values).max() <= _SAME * largest for one, two in zip(other, group, strict=True)
            ):
                found[k] = [replace(line, label=f"{line.label} ≈ {group[0].label}") for line in other]
                break
        else:
            found.append(group)
    return found


def chart_data(chart: Chart) -> dict[str, Any]:
    """A chart as the page holds it; too many samples are thinned so that every extreme stays."""
    kept = thinned(chart.values.T, MOST_POINTS)
    coarse = len(kept) < len(chart.at) and chart.log == "no"
    same = ("id", "title", "group", "abscissa", "span", "log", "stacked", "note", "overview", "ordinate")
    drawn = zip(chart.lines, looks(chart), strict=True)
    return {name: getattr(chart, name) for name in same} | {
        "unit": chart.unit.name,
        "at": chart.at[kept] if len(kept) < len(chart.at) else chart.at,
        "samples": len(chart.at),
        "marks": [{"at": place, "label": name} for place, name in chart.marks],
        "curves": [_curve(chart, line, look, kept, coarse=coarse) for line, look in drawn],
    }


def _curve(chart: Chart, line: Line, look: Look, kept: NDArray[np.intp], *, coarse: bool) -> dict[str, Any]:
    values = chart.unit.of(line.values[kept])
    return {
        "label": line.label,
        "role": line.role,
        "part": PARTS[line.role][0],
        "colour": look.colour,
        "dash": look.dash,
        "values": Coarse(values) if coarse and np.isfinite(values).all() else _single(values),
        "source": _source(line, chart.unit.factor),
        "shown": line.shown,
    }


def _source(line: Line, factor: float) -> dict[str, Any] | None:
    if line.place is None:
        return None
    info = {"variable": line.place[0], "index": line.place[1], "factor": factor, "along": line.along}
    return info if line.less is None else info | {"less": {"variable": line.less[0], "index": line.less[1]}}


def _single(values: Array) -> NDArray[Any]:
    """In single precision, which a picture does not leave; in double where that does not hold them."""
    return values.astype(np.float32) if np.abs(values).max(initial=0.0) < _LARGEST_SINGLE else values
