"""Amplitude spectra of a run: of its tip and its elastic coordinates, with the robot's own frequencies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmodes.plot.charts import Array, Chart, Line, line_of, shown_name
from tmodes.plot.facts import deformation_unit, spectral_part
from tmodes.result import Result

__all__ = [
    "LEAST_SAMPLES", "NO_PEAK", "amplitude_spectrum", "own_frequencies", "run_spectra", "still",
]  # fmt: skip


Marks = Sequence[tuple[float, str]]
"""Frequencies [Hz] with the elements that they are of."""

LEAST_SAMPLES = 32
"""Fewest samples of a spectrum."""

NO_PEAK = 0.5**0.5
"""Damping ratio from which on the response of an oscillator has no peak."""

_MOST_LINES = 3
_NOTHING = 1e-6
"""A series that swings less than this share of the others is left out."""

_ROUNDING = 1e-12
"""Swings below this [m, rad] are rounding."""

_FLOOR = 1e-3
"""The axis ends where all amplitudes stay below this share of the highest peak."""


def run_spectra(result: Result) -> Iterator[Chart]:
    """Of the part of a run that :func:`tmodes.plot.facts.spectral_part` gives; those of one unit end together."""
    data, part = result.record, spectral_part(result.record, LEAST_SAMPLES)
    if part.sizes["time"] < LEAST_SAMPLES:
        return
    names = [str(name) for name in part["deformation_kind"].values] if "deformation_kind" in data.dims else []
    units = [deformation_unit(data, name) for name in names]
    unit, marks = "rad" if "rad" in units else "".join(units[:1]), own_frequencies(result)
    end = "" if unit == "rad" else f"_{unit}"
    inner = [line_of(part, ("deformation", k), shown_name(names[k])) for k, one in enumerate(units) if one == unit]
    charts = {
        ("spectrum_tip", "actual tip", "m"): (_tip(part, "tip"), marks["actual"]),
        ("spectrum_tip_nominal", "nominal tip", "m"): (_tip(part, "tip_nominal"), marks["nominal"]),
        (f"spectrum_deformations{end}", "deformations", unit): (inner, marks["actual"]),
    }
    found = [_spectrum(*of, part, lines, own) for of, (swinging, own) in charts.items() if (lines := _most(swinging))]
    for chart in found:
        end = max(_end(other) for other in found if other.si == chart.si)
        last, inside = int(np.searchsorted(chart.at, end)), tuple(mark for mark in chart.marks if mark[0] <= end)
        lines = tuple(replace(line, values=line.values[:last]) for line in chart.lines)
        yield replace(chart, at=chart.at[:last], lines=lines, marks=inside)


def _end(chart: Chart) -> float:
    """Where all amplitudes stay below a share of the highest peak, and a quarter more [Hz]."""
    seen = np.flatnonzero((chart.values > _FLOOR * chart.values.max()).any(axis=0))
    return 1.25 * max(1.0, float(chart.at[seen[-1]]))


def _spectrum(name: str, of: str, unit: str, part: Any, lines: Sequence[Line], marks: Marks) -> Chart:
    """The spectrum of lines of an evenly sampled part of a run."""
    time = part["time"].values
    spectra = [amplitude_spectrum(line.values, (time[-1] - time[0]) / (len(time) - 1)) for line in lines]
    drawn = tuple(replace(line, values=amplitude) for line, (_, amplitude) in zip(lines, spectra, strict=True))
    return Chart(
        name, f"Spectrum of the {of}", "spectrum", unit, spectra[0][0], drawn, "amplitude", "first", "frequency",
        (float(time[0]), float(time[-1])), tuple(marks),
    )  # fmt: skip


def _tip(part: Any, path: str) -> list[Line]:
    """The coordinates of a tip, less the commanded ones where there are some: these do not ring."""
    if path not in part:
        return []
    if "tip_commanded" not in part:
        return [line_of(part, (path, k), axis) for k, axis in enumerate("xyz")]
    return [line_of(part, (path, k), f"Δ{axis}", less=("tip_commanded", k)) for k, axis in enumerate("xyz")]


def still(part: Any) -> bool:
    """Whether the actual tip does not swing within this part of a run."""
    return not _most(_tip(part, "tip"))


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


def amplitude_spectrum(values: Array, step: float, padding: int = 4) -> tuple[Array, Array]:
    """Frequencies [Hz] and amplitudes [unit of ``values``] of evenly sampled ``values``, ``step`` [s] apart.

    A least-squares line is subtracted, then a Hann window applied; a sine of amplitude A between two lines of the grid
    shows a peak of A. ``padding`` makes the grid finer (it does not increase the resolution).
    """
    count = len(values)
    line = np.polynomial.Polynomial.fit(np.arange(count), values, 1)(np.arange(count))
    window = np.hanning(count + 1)[:-1]
    amplitude = 2 * np.abs(np.fft.rfft((values - line) * window, padding * count)) / window.sum()
    return np.fft.rfftfreq(padding * count, step), amplitude
