"""Marks of the robot's own frequencies along a frequency axis, with labels that keep apart."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.panels import Axes
from tmodes.plot.style import QUIET

__all__ = ["amplitude_spectrum", "keep_apart", "mark_frequencies"]

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
    """In short lines; names may be parted after an underscore."""
    lines = textwrap.wrap(str(element).replace("_", "_ "), width=LABEL_LETTERS)
    return "\n".join(line.rstrip(",").replace("_ ", "_") for line in lines)


Array = NDArray[Any]


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
