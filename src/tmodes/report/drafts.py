"""A chart as it is drafted from a result, in SI units, and as the page holds it; amplitude spectra among them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.facts import deformation_unit, spectral_part
from tmodes.plot.figures.spectrum import NO_PEAK, amplitude_spectrum
from tmodes.plot.panels import Unit, readable
from tmodes.report.pack import MOST_POINTS, Coarse, thinned
from tmodes.result import Result

__all__ = [
    "Draft", "Line", "Place", "chart_data", "in_readable_units", "line_of", "own_frequencies", "run_spectra",
    "spectrum_draft", "values_at",
]  # fmt: skip


Array = NDArray[np.float64]
Place = tuple[str, int]
"""A series of a result: its variable, and the column of its flattened trailing dimensions."""

_LARGEST_SINGLE = 1e37

_LONG = 10.0
"""Lengths from here on are in m."""


@dataclass(frozen=True, eq=False)
class Line:
    """A curve: its values [SI of its chart], shape (n,), and what of the result they are.

    ``place`` less ``less``, times ``factor``; None where they are no plain series, which the live model cannot draw.
    Of a spectrum they tell the series that it is of. ``along``: a part of vectors, along their sum; -1: its size.
    """

    label: str
    role: str
    values: Array
    place: Place | None = None
    less: Place | None = None
    factor: float = 1.0
    shown: bool = True
    along: bool = False


@dataclass(frozen=True, eq=False)
class Draft:
    """A chart in SI units; ``at`` (n,) is time [s] or frequency [Hz], ``unit`` that of all lines.

    ``span``: of a spectrum, first and last time [s] of the samples that it is of. ``marks``: places along ``at`` with
    their names. ``stacked``: all lines but the last one add up to it.
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
    stacked: bool = False


def values_at(data: Any, place: Place) -> Array:
    """The series of a result at a place, shape (n,)."""
    values = np.asarray(data[place[0]].transpose("time", ...).values, dtype=float)
    return values.reshape(len(values), -1)[:, place[1]]


def line_of(data: Any, place: Place, label: str, role: str, *, less: Place | None = None, shown: bool = True) -> Line:
    """A curve that is a series of a result, or what one is less another."""
    values = values_at(data, place)
    return Line(label, role, values if less is None else values - values_at(data, less), place, less, 1.0, shown)


def in_readable_units(runs: Sequence[Sequence[Draft]]) -> list[list[dict[str, Any]]]:
    """The charts of several runs as the page holds them: what is compared has one unit in all charts and runs."""
    values: dict[str, list[Array]] = {}
    for draft in (draft for drafts in runs for draft in drafts):
        values.setdefault(_shares(draft), []).extend(line.values for line in draft.lines)
    return [[chart_data(draft, _unit(draft.unit, values[_shares(draft)])) for draft in drafts] for drafts in runs]


def _shares(draft: Draft) -> str:
    """What has the unit of this chart."""
    return f"{draft.group} {draft.unit}" if draft.group in ("error", "deformations") else draft.id


def _unit(unit: str, values: Sequence[Array]) -> Unit:
    """Lengths in mm, as in the numbers of the page."""
    largest = max((float(np.abs(part).max(initial=0.0)) for part in values), default=0.0)
    return Unit("mm", 1e3) if unit == "m" and _ROUNDING < largest < _LONG else readable(unit, *values)


def chart_data(draft: Draft, unit: Unit) -> dict[str, Any]:
    """A chart as the page holds it, in ``unit``; too many samples are thinned so that every extreme stays."""
    kept = thinned(np.stack([line.values for line in draft.lines], axis=1), MOST_POINTS)
    coarse = len(kept) < len(draft.at) and draft.log == "no"
    as_drafted = {name: getattr(draft, name) for name in ("id", "title", "group", "abscissa", "span", "log", "stacked")}
    return as_drafted | {
        "unit": unit.name,
        "at": draft.at[kept] if len(kept) < len(draft.at) else draft.at,
        "samples": len(draft.at),
        "marks": [{"at": place, "label": name} for place, name in draft.marks],
        "curves": [_curve(line, unit, kept, coarse=coarse) for line in draft.lines],
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
    info = {"variable": line.place[0], "index": line.place[1], "factor": unit.factor * line.factor, "along": line.along}
    return info if line.less is None else info | {"less": {"variable": line.less[0], "index": line.less[1]}}


def _single(values: Array) -> NDArray[Any]:
    """In single precision, which a picture does not leave; in double where that does not hold them."""
    return values.astype(np.float32) if np.abs(values).max(initial=0.0) < _LARGEST_SINGLE else values


LEAST_SAMPLES = 32
"""Fewest samples of a spectrum."""

_PADDING = 4
_MOST_LINES = 3
_NOTHING = 1e-6
"""A series that swings less than this share of the others is left out."""

_ROUNDING = 1e-12
"""Swings below this [m, rad] are rounding."""

_FLOOR = 1e-3
"""The axis ends where all amplitudes stay below this share of the highest peak."""


def run_spectra(result: Result) -> Iterator[Draft]:
    """Of the part of a run that :func:`tmodes.plot.facts.spectral_part` gives."""
    data, units = result.record, []
    if "deformation_kind" in data.dims:
        units = [deformation_unit(data, str(name)) for name in data["deformation_kind"].values]
    yield from _spectra(result, spectral_part(data, LEAST_SAMPLES), units)


def _spectra(result: Result, part: Any, units: Sequence[str]) -> Iterator[Draft]:
    if part.sizes["time"] < LEAST_SAMPLES:
        return
    marks = own_frequencies(result)
    for which, path in (("actual", "tip"), ("nominal", "tip_nominal")):
        if path in part:
            name, own = "spectrum_tip" if which == "actual" else "spectrum_tip_nominal", marks[which]
            yield from spectrum_draft(name, f"Spectrum of the {which} tip", "m", part, _tip(part, path), own)
    turning = [k for k, unit in enumerate(units) if unit == "rad"]
    names = [str(part["deformation_kind"].values[k]) for k in turning]
    lines = [line_of(part, ("deformation", k), name, "real") for k, name in zip(turning, names, strict=True)]
    own = marks["actual"]
    yield from spectrum_draft("spectrum_deformations", "Spectrum of the deformations", "rad", part, lines, own)


def _tip(part: Any, path: str) -> list[Line]:
    """The coordinates of a tip, less the commanded ones where there are some: these do not ring."""
    if "tip_commanded" not in part:
        return [line_of(part, (path, k), axis, "real") for k, axis in enumerate("xyz")]
    return [line_of(part, (path, k), f"Δ{axis}", "real", less=("tip_commanded", k)) for k, axis in enumerate("xyz")]


def spectrum_draft(
    name: str, title: str, unit: str, part: Any, lines: Sequence[Line], marks: Sequence[tuple[float, str]]
) -> Iterator[Draft]:
    """The spectrum of the lines that swing most, of an evenly sampled part of a run; none where nothing swings."""
    lines = _most(lines)
    if not lines:
        return
    time = part["time"].values
    spectra = [amplitude_spectrum(line.values, (time[-1] - time[0]) / (len(time) - 1), _PADDING) for line in lines]
    frequency, peak = spectra[0][0], max(float(amplitude.max()) for _, amplitude in spectra)
    seen = [frequency[amplitude > _FLOOR * peak] for _, amplitude in spectra]
    shown = frequency <= 1.25 * max([1.0, *(float(part[-1]) for part in seen if len(part))])
    drawn = tuple(replace(line, values=amplitude[shown]) for line, (_, amplitude) in zip(lines, spectra, strict=True))
    inside = tuple(mark for mark in marks if mark[0] <= frequency[shown][-1])
    span = (float(time[0]), float(time[-1]))
    yield Draft(name, title, "spectrum", unit, frequency[shown], drawn, "first", "frequency", span, inside)


def _most(lines: Sequence[Line]) -> list[Line]:
    swings = [float(np.ptp(line.values)) for line in lines]
    largest = max(swings, default=0.0)
    if largest <= _ROUNDING:
        return []
    ranked = sorted(range(len(lines)), key=lambda k: -swings[k])[:_MOST_LINES]
    return [lines[k] for k in sorted(ranked) if swings[k] > _NOTHING * largest]


def own_frequencies(result: Result) -> dict[str, list[tuple[float, str]]]:
    """Damped frequencies [Hz] about the pose at the end, with the dominant element, of ``actual`` and ``nominal``."""

    def ringing(modes: list[dict[str, Any]]) -> list[tuple[float, str]]:
        seen = [(mode["damped_frequency_Hz"], mode) for mode in modes if mode["damping_ratio"] < NO_PEAK]
        return sorted((float(f), str(mode["element"])) for f, mode in seen if f)

    return {which: ringing(result.end_frequencies.get(which, [])) for which in ("actual", "nominal")}
