"""A chart as it is drafted from a result, in SI units, and as the page holds it, in units that read well."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.units import Unit, readable
from tmodes.report.pack import Coarse
from tmodes.report.thin import MOST_POINTS, thinned

__all__ = ["Draft", "Line", "Place", "chart_data", "in_readable_units", "line_of", "values_at"]

Array = NDArray[np.float64]
Place = tuple[str, int]
"""A series of a result: its variable, and the column of its flattened trailing dimensions."""

_LARGEST_SINGLE = 1e37


@dataclass(frozen=True, eq=False)
class Line:
    """A curve: its values [SI of its chart], shape (n,), and what of the result they are.

    ``place`` less ``less``, times ``factor``; None where they are no plain series, which the live model cannot draw.
    Of a spectrum they tell the series that it is of.
    """

    label: str
    role: str
    values: Array
    place: Place | None = None
    less: Place | None = None
    factor: float = 1.0
    shown: bool = True


@dataclass(frozen=True, eq=False)
class Draft:
    """A chart in SI units; ``at`` (n,) is time [s] or frequency [Hz], ``unit`` that of all lines.

    ``span``: of a spectrum, first and last time [s] of the samples that it is of. ``marks``: places along ``at`` with
    their names.
    """

    id: str
    title: str
    group: str
    unit: str
    at: Array
    lines: tuple[Line, ...]
    log: str = "no"
    abscissa: str = "time"
    span: tuple[float, float] | None = None
    marks: tuple[tuple[float, str], ...] = ()


def values_at(data: Any, place: Place) -> Array:
    """The series of a result at a place, shape (n,)."""
    values = np.asarray(data[place[0]].transpose("time", ...).values, dtype=float)
    return values.reshape(len(values), -1)[:, place[1]]


def line_of(data: Any, place: Place, label: str, role: str, *, less: Place | None = None, shown: bool = True) -> Line:
    """A curve that is a series of a result, or what one is less another."""
    values = values_at(data, place)
    return Line(label, role, values if less is None else values - values_at(data, less), place, less, 1.0, shown)


def in_readable_units(runs: Sequence[Sequence[Draft]]) -> list[list[dict[str, Any]]]:
    """The charts of several runs as the page holds them: what has one name has one unit in all runs."""
    values: dict[str, list[Array]] = {}
    for draft in (draft for drafts in runs for draft in drafts):
        values.setdefault(draft.id, []).extend(line.values for line in draft.lines)
    return [[chart_data(draft, readable(draft.unit, *values[draft.id])) for draft in drafts] for drafts in runs]


def chart_data(draft: Draft, unit: Unit) -> dict[str, Any]:
    """A chart as the page holds it, in ``unit``; too many samples are thinned so that every extreme stays."""
    kept = thinned(np.stack([line.values for line in draft.lines], axis=1), MOST_POINTS)
    coarse = len(kept) < len(draft.at) and draft.log == "no"
    return {
        "id": draft.id,
        "title": draft.title,
        "group": draft.group,
        "unit": unit.name,
        "abscissa": draft.abscissa,
        "at": draft.at[kept] if len(kept) < len(draft.at) else draft.at,
        "samples": len(draft.at),
        "span": draft.span,
        "marks": [{"at": place, "label": name} for place, name in draft.marks],
        "curves": [_curve(line, unit, kept, coarse=coarse) for line in draft.lines],
        "log": draft.log,
    }


def _curve(line: Line, unit: Unit, kept: NDArray[np.intp], *, coarse: bool) -> dict[str, Any]:
    values = unit.of(line.values[kept])
    return {
        "label": line.label,
        "role": line.role,
        "values": Coarse(values) if coarse and np.isfinite(values).all() else _single(values),
        "source": _source(line, unit),
        "shown": line.shown,
    }


def _source(line: Line, unit: Unit) -> dict[str, Any] | None:
    if line.place is None:
        return None
    info = {"variable": line.place[0], "index": line.place[1], "factor": unit.factor * line.factor}
    return info if line.less is None else info | {"less": {"variable": line.less[0], "index": line.less[1]}}


def _single(values: Array) -> NDArray[Any]:
    """In single precision, which a picture does not leave; in double where that does not hold them."""
    return values.astype(np.float32) if np.abs(values).max(initial=0.0) < _LARGEST_SINGLE else values
