"""Amplitude spectra of the tip and of the deformations that oscillate most, where a run is evenly sampled."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.facts import deformation_unit, spectral_part
from tmodes.plot.frequency_marks import NO_PEAK, amplitude_spectrum
from tmodes.report.drafts import Draft, Line, line_of

if TYPE_CHECKING:
    from tmodes.result import Result

__all__ = ["own_frequencies", "run_spectra", "spectrum_draft"]

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

Array = NDArray[np.float64]


def run_spectra(result: Result) -> Iterator[Draft]:
    """Of the part of a run that :func:`tmodes.plot.facts.spectral_part` gives."""
    data, units = result.data, []
    if "deformation_kind" in data.dims:
        units = [deformation_unit(data, str(name)) for name in data["deformation_kind"].values]
    yield from _spectra(result, spectral_part(data, LEAST_SAMPLES), units)


def _spectra(result: Result, part: Any, units: Sequence[str]) -> Iterator[Draft]:
    if part.sizes["time"] < LEAST_SAMPLES:
        return
    marks = own_frequencies(result)
    named = "minus reference" if "tip_reference" in part else "place"
    yield from spectrum_draft("spectrum_tip", f"Spectrum of the tip, {named}", "m", part, _tip(part), marks)
    turning = [k for k, unit in enumerate(units) if unit == "rad"]
    names = [str(part["deformation_kind"].values[k]) for k in turning]
    lines = [line_of(part, ("deformation", k), name, "real") for k, name in zip(turning, names, strict=True)]
    yield from spectrum_draft("spectrum_deformations", "Spectrum of the deformations", "rad", part, lines, marks)


def _tip(part: Any) -> list[Line]:
    if "tip_reference" not in part:
        return [line_of(part, ("tip", k), axis, "real") for k, axis in enumerate("xyz")]
    return [line_of(part, ("tip", k), f"Δ{axis}", "real", less=("tip_reference", k)) for k, axis in enumerate("xyz")]


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


def own_frequencies(result: Result) -> list[tuple[float, str]]:
    """The damped natural frequencies [Hz], under control where the robot is controlled, with the dominant element."""
    modes = result.frequencies
    info = modes.get("controlled") or modes.get("locked") or []
    ringing = [(mode["damped_frequency_Hz"], mode) for mode in info if mode["damping_ratio"] < NO_PEAK]
    return sorted((float(f), str(mode["element"])) for f, mode in ringing if f)
