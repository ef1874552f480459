"""Marks of the robot's own frequencies along a frequency axis, with labels that keep apart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.style import QUIET

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["keep_apart", "mark_frequencies"]

LABEL_WIDTH = 0.1
"""Room that a label takes, as a share of the axis."""


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


def mark_frequencies(panel: Axes, modes: Sequence[Mapping[str, Any]], highest: float) -> None:
    """A thin line at each frequency up to ``highest`` [Hz], and above the axes its value and its element."""
    shown = sorted((mode for mode in modes if 0 < mode["frequency_Hz"] <= highest), key=lambda m: m["frequency_Hz"])
    shown = shown[: int(1 / LABEL_WIDTH)]
    frequencies = [float(mode["frequency_Hz"]) for mode in shown]
    half = LABEL_WIDTH / 2
    places = keep_apart([f / highest for f in frequencies], LABEL_WIDTH, half, 1 - half)
    for mode, frequency, place in zip(shown, frequencies, places, strict=True):
        panel.axvline(frequency, color=QUIET, linewidth=0.6, linestyle=(0, (2, 2)), zorder=1)
        panel.annotate(
            f"{frequency:.3g} Hz\n" + str(mode["element"]).replace(" ", "\n"),
            xy=(frequency / highest, 1.0),
            xytext=(place, 1.045),
            xycoords="axes fraction",
            textcoords="axes fraction",
            ha="center",
            va="bottom",
            fontsize=6.5,
            color=QUIET,
            arrowprops={"arrowstyle": "-", "color": QUIET, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 0},
        )
