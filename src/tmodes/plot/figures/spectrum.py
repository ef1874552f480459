"""The vibration of a robot: amplitude spectra of its tip and of its elastic coordinates, with its own frequencies."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.facts import deformation_unit, largest, plain, spectral_part
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, letter, panels, readable, side_legend
from tmodes.plot.style import COMPONENTS, QUIET

__all__ = ["SpectrumFigure", "amplitude_spectrum", "keep_apart", "mark_frequencies"]


LEAST_SAMPLES = 32
DECADES = 4
"""What lies further below the highest line is left out of the picture."""

_MOST_COORDINATES = 3
_ROUNDING = 1e-12
"""Amplitudes below this [m, rad] are rounding."""

_NOTHING = 1e-6
"""A coordinate of the tip that oscillates less than this share of the others is not drawn."""

Array = NDArray[Any]
Curves = dict[str, tuple[Array, Array]]


@register
class SpectrumFigure(Figure):
    """Amplitudes of the actual and the nominal tip [m] less the commanded one, and of elastic coordinates [rad].

    Of the time after the move where the run continues long enough; else of the part with constant setpoint rates; else
    of the whole run. Each is marked with its own frequencies about the pose at the end: the actual robot's under
    control (else with locked motors), the nominal one's with locked motors, as they follow their setpoints. ``ax``: an
    axes for each, or None.
    """

    name = "spectrum"
    title = "Vibration spectrum"
    caption = (
        "Dotted: frequencies of the poles about the pose at the end, the actual robot's under control and the nominal "
        "robot's with its motors at their setpoints; within a move the peaks are elsewhere."
    )

    def missing(self, data: Any) -> str:
        """Too few samples, or no oscillation."""
        part = spectral_part(data, LEAST_SAMPLES)
        if len(part["time"]) < LEAST_SAMPLES:
            return f"a spectrum needs {LEAST_SAMPLES} samples, evenly spaced; this run has {len(data['time'])}"
        if not _tip(part, "tip"):
            return "nothing oscillates"
        return ""

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """The tip, and the elastic coordinates."""
        data = result.data
        part = spectral_part(data, LEAST_SAMPLES)
        time = part["time"].values
        step = float(time[1] - time[0])
        groups = list(_groups(result, part))
        found = [
            {name: amplitude_spectrum(values, step) for name, values in signals.items()} for _, signals, *_ in groups
        ]
        scales = _scales(found, [unit for *_, unit, _ in groups], 0.5 / step)
        axes = panels(ax, [[str(k)] for k in range(len(groups))], 1.0 + 2.1 * len(groups))
        pads = []
        for panel, curves, (*_, si, marks) in zip(axes, found, groups, strict=True):
            unit, peak, highest = scales[si]
            _draw(panel, curves, unit, peak, highest)
            panel.set_xlabel("frequency [Hz]")
            pads.append(mark_frequencies(panel, marks, highest))
        span = f"{time[0]:.3g} to {time[-1]:.3g} s"
        letter(axes, [f"{title}, {span}" for title, *_ in groups], pad=max(pads))
        return axes


def _groups(result: Any, part: Any) -> Iterator[tuple[str, dict[str, Array], str, list[dict[str, Any]]]]:
    """Title, signals, their unit and the modes to mark: actual tip, nominal tip, elastic coordinates."""
    modes = result.end_frequencies
    own = _marked(modes.get("actual", []))
    yield "Actual tip", _tip(part, "tip"), "m", own
    if "tip_nominal" in part and (nominal := _tip(part, "tip_nominal")):
        yield "Nominal tip", nominal, "m", _marked(modes.get("nominal", []))
    if inner := _coordinates(part):
        yield "Elastic coordinates", inner, deformation_unit(result.data, next(iter(inner))), own


def _tip(part: Any, path: str) -> dict[str, Array]:
    """The coordinates of a tip that oscillate, less the commanded ones, which do not ring; none where nothing does."""
    compared = "tip_commanded" in part
    tip = part[path] - part["tip_commanded"] if compared else part[path]
    found = {f"{'Δ' if compared else ''}{axis}": tip.sel(axis=axis).values for axis in "xyz"}
    most = max(float(np.ptp(values)) for values in found.values())
    return {name: values for name, values in found.items() if np.ptp(values) >= max(_NOTHING * most, _ROUNDING)}


def _coordinates(part: Any) -> dict[str, Array]:
    """The elastic coordinates of the actual robot that oscillate most."""
    if "deformation_oscillatory" not in part:
        return {}
    names = [str(name) for name in part["deformation_kind"].values]
    turning = [name for name in names if deformation_unit(part, name) == "rad"] or names
    swings = part["deformation"].sel(deformation_kind=turning).transpose("time", "deformation_kind").values
    chosen = largest(turning, np.std(swings, axis=0), _MOST_COORDINATES)
    return {name: part["deformation"].sel(deformation_kind=name).values for name in chosen}


def _marked(modes: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The damped frequencies to mark, with names that may be wrapped at their dots."""
    return [mode | {"element": plain(mode["element"]).replace(".", ".\n")} for mode in modes]


def _highest(curves: Curves, nyquist: float) -> float:
    """The end of the frequency axis [Hz]: what is above stays a thousand times below the highest peak."""
    peak, end = max(float(amplitude.max()) for _, amplitude in curves.values()), 1.0
    for frequency, amplitude in curves.values():
        seen = frequency[amplitude > 1e-3 * peak]
        end = max(end, float(seen[-1]) if len(seen) else 0.0)
    return min(1.25 * end, nyquist)


def _scales(found: list[Curves], units: list[str], nyquist: float) -> dict[str, tuple[Unit, float, float]]:
    """For each SI unit one readable unit, the highest peak, and the end of the frequency axis [Hz]: panels compare."""
    scales: dict[str, tuple[Unit, float, float]] = {}
    for si in dict.fromkeys(units):
        same = [curves for curves, own in zip(found, units, strict=True) if own == si]
        peak = max(float(amplitude.max()) for curves in same for _, amplitude in curves.values())
        scales[si] = readable(si, peak), peak, max(_highest(curves, nyquist) for curves in same)
    return scales


def _draw(panel: Axes, curves: Curves, unit: Unit, peak: float, highest: float) -> None:
    for (name, (frequency, amplitude)), look in zip(curves.items(), COMPONENTS, strict=False):
        shown = (frequency <= highest) & (amplitude > 0)
        panel.plot(frequency[shown], unit.of(amplitude[shown]), label=plain(name), **look)
    panel.set_xlim(0, highest)
    if peak > 0:
        panel.set_yscale("log")
        panel.set_ylim(unit.factor * peak * 10**-DECADES, unit.factor * peak * 3)
    panel.set_ylabel(f"amplitude [{unit.name}]")
    side_legend(panel)


LABEL_WIDTH = 0.1
"""Room that a label takes, as a share of the axis."""

LABEL_LETTERS = 10
"""Letters in a line of a label, so that it takes no more room than that."""

LABEL_SIZE = 6.5
"""Size of a label's letters [points]."""

NO_PEAK = 0.5**0.5
"""Damping ratio from which on the response of an oscillator has no peak."""


def keep_apart(wanted: Sequence[float], least: float, low: float = 0.0, high: float = 1.0) -> NDArray[Any]:
    """Places as near as possible to ``wanted`` (rising), at least ``least`` apart, within [low, high] if they fit.

    Least squares under an order: the moved places, less their offsets, must rise (pool adjacent violators).
    """
    offsets = least * np.arange(len(wanted))
    pools: list[list[float]] = []
    for value in np.asarray(wanted, dtype=float) - offsets:
        pools.append([value, 1.0])
        while len(pools) > 1 and pools[-2][0] > pools[-1][0]:
            (mean, weight), (before, count) = pools.pop(), pools.pop()
            pools.append([(mean * weight + before * count) / (weight + count), weight + count])
    places = np.repeat([mean for mean, _ in pools], [int(count) for _, count in pools])
    room = max(low, high - (offsets[-1] if len(offsets) else 0.0))
    return np.clip(places, low, room) + offsets


_LEADER = {"arrowstyle": "-", "color": QUIET, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 0, "relpos": (0.5, 0.0)}
"""From below a label, so that a long leader passes under its neighbours and through none."""


def mark_frequencies(panel: Axes, modes: Sequence[Mapping[str, Any]], highest: float) -> float:
    """A thin line at each frequency up to ``highest`` [Hz], and above the axes its value and its element.

    A mode that is damped too much to show a peak is not marked. Returns the height of the labels [points].
    """
    rings = ((mode["damped_frequency_Hz"], mode) for mode in modes if mode["damping_ratio"] < NO_PEAK)
    shown = sorted(((f, m["element"]) for f, m in rings if f and f <= highest))[: int(1 / LABEL_WIDTH)]
    frequencies = [float(frequency) for frequency, _ in shown]
    labels = [f"{frequency:.3g} Hz\n{_wrapped(element)}" for frequency, element in shown]
    places = keep_apart([f / highest for f in frequencies], LABEL_WIDTH, LABEL_WIDTH / 2, 1 - LABEL_WIDTH / 2)
    for label, frequency, place in zip(labels, frequencies, places, strict=True):
        panel.axvline(frequency, color=QUIET, linewidth=0.6, linestyle=(0, (2, 2)), zorder=1)
        panel.annotate(
            label,
            xy=(frequency / highest, 1.0),
            xytext=(place, 1.045),
            xycoords="axes fraction",
            textcoords="axes fraction",
            ha="center",
            va="bottom",
            fontsize=LABEL_SIZE,
            color=QUIET,
            arrowprops=_LEADER,
        )
    lines = max((label.count("\n") + 1 for label in labels), default=0)
    return 1.25 * LABEL_SIZE * lines + 10


def _wrapped(element: object) -> str:
    """In short lines; a name that is longer than a line may be parted after an underscore."""
    lines: list[str] = []
    for part in str(element).split("\n"):
        text = part if len(part) <= LABEL_LETTERS else part.replace("_", "_ ")
        lines += textwrap.wrap(text, width=LABEL_LETTERS)
    return "\n".join(line.rstrip(",").replace("_ ", "_") for line in lines)


def amplitude_spectrum(values: Array, step: float, padding: int = 8) -> tuple[Array, Array]:
    """Frequencies [Hz] and amplitudes [unit of ``values``] of evenly sampled ``values``, ``step`` [s] apart.

    A least-squares line is subtracted, then a Hann window applied; a sine of amplitude A between two lines of the grid
    shows a peak of A. ``padding`` makes the grid finer (it does not increase the resolution).
    """
    count = len(values)
    line = np.polynomial.Polynomial.fit(np.arange(count), values, 1)(np.arange(count))
    window = np.hanning(count + 1)[:-1]
    amplitude = 2 * np.abs(np.fft.rfft((values - line) * window, padding * count)) / window.sum()
    return np.fft.rfftfreq(padding * count, step), amplitude
