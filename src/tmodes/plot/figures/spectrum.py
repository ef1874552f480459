"""The vibration of a robot: amplitude spectra of its tip and of its elastic coordinates, with its own frequencies."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.charts import Chart, shown_name
from tmodes.plot.contents import figure_charts
from tmodes.plot.facts import spectral_part
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, draw_charts, letter, plain
from tmodes.plot.spectra import LEAST_SAMPLES, still
from tmodes.plot.style import QUIET

__all__ = ["SpectrumFigure", "keep_apart", "mark_frequencies"]

Array = NDArray[Any]


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
        return "nothing oscillates" if still(part) else ""

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """The tip, and the elastic coordinates; what has one unit has one scale."""
        charts = [*figure_charts(result, "spectra").values()]
        axes = draw_charts(ax, [[chart] for chart in charts], 1.0 + 2.1 * len(charts))
        for panel, chart in zip(axes, charts, strict=True):
            same = [one for one, other in zip(axes, charts, strict=True) if other.si == chart.si]
            panel.set_xlim(0, max(one.get_xlim()[1] for one in same))
            panel.set_ylim(min(one.get_ylim()[0] for one in same), max(one.get_ylim()[1] for one in same))
        pads = [mark_frequencies(panel, chart.marks) for panel, chart in zip(axes, charts, strict=True)]
        letter(axes, map(_title, charts), pad=max(pads))
        return axes


def _title(chart: Chart) -> str:
    start, end = chart.span or (0.0, 0.0)
    return f"{chart.title}, {start:.3g} to {end:.3g} s"


LABEL_WIDTH = 0.1
"""Room that a label takes, as a share of the axis."""

LABEL_LETTERS = 10
"""Letters in a line of a label, so that it takes no more room than that."""

LABEL_SIZE = 6.5
"""Size of a label's letters [points]."""


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


def mark_frequencies(panel: Axes, marks: Sequence[tuple[float, str]]) -> float:
    """A thin line at each frequency [Hz] of the panel, and above the axes its value and its element.

    Returns the height of the labels [points].
    """
    highest = panel.get_xlim()[1]
    shown = [mark for mark in marks if mark[0] <= highest][: int(1 / LABEL_WIDTH)]
    frequencies = [frequency for frequency, _ in shown]
    labels = [f"{frequency:.3g} Hz\n{_wrapped(plain(shown_name(element)))}" for frequency, element in shown]
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
