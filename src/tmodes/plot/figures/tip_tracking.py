"""Tip position and its deviation from the nominal run."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, curves, letter, panels, shared_legend, time_axis
from tmodes.plot.ranges import common_unit, largest_shown, seen
from tmodes.plot.style import COMPONENTS, INK, QUIET, REAL, REFERENCE

__all__ = ["TipTracking"]


_COMMANDED = {"color": QUIET, "linestyle": ":", "linewidth": 0.9}


@register
class TipTracking(Figure):
    """Tip x, y, z [m]; commanded and nominal too, and the deviation from the nominal one [m]: distance, components.

    A coordinate that is zero throughout is left out. ``ax``: an axes for each other one and, with a nominal run, one
    for the deviation, or None.
    """

    name = "tip_tracking"
    title = "Tip position"
    caption = (
        "Position of the tip: actual, nominal (the elasticity as known), and commanded (no elasticity, the setpoints); "
        "with a nominal run, (d) shows by how much and in which direction the actual tip leaves it."
    )

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each axis, and one of the deviation."""
        data = result.data
        planned = "tip_nominal" in data
        shown = _moving(data)
        if planned:
            axes = panels(ax, [list(shown), ["deviation"] * len(shown)], 4.4, height_ratios=[1, 1.25])
        else:
            axes = panels(ax, [list(shown)], 2.3)
        unit = common_unit("m", *shown.values())
        for panel, axis in zip(axes, shown, strict=False):
            _coordinate(panel, data, axis, unit)
        if planned:
            _deviation(axes[-1], data, list(shown))
            shared_legend(axes[-1], place="lower left")
        if planned or "tip_commanded" in data:
            shared_legend(axes[0])
        letter(axes, [*(f"Tip {axis}" for axis in shown), *(["Deviation, actual − nominal"] if planned else [])])
        return axes


_SERIES = {"actual": ("tip", REAL), "nominal": ("tip_nominal", REFERENCE), "commanded": ("tip_commanded", _COMMANDED)}


def _moving(data: Any) -> dict[str, Any]:
    """The values of each coordinate of the tip that is not zero throughout; of a tip at the origin, of all."""
    known = [name for name, _ in _SERIES.values() if name in data]
    values = {axis: np.stack([data[name].sel(axis=axis).values for name in known]) for axis in "xyz"}
    size = largest_shown(values.values())
    return {axis: value for axis, value in values.items() if seen(value, size)} or values


def _coordinate(panel: Axes, data: Any, axis: str, unit: Unit) -> None:
    known = {label: (name, look) for label, (name, look) in _SERIES.items() if name in data}
    shown = {label: (data[name].sel(axis=axis).values, look) for label, (name, look) in known.items()}
    curves(panel, data["time"].values, shown, "m", axis, unit)
    time_axis(panel, data["time"].values)


def _deviation(panel: Axes, data: Any, axes: list[str]) -> None:
    difference = data["tip"] - data["tip_nominal"]  # no component is larger than the distance
    parts = {
        f"Δ{axis}": (difference.sel(axis=axis), look)
        for axis, look in zip("xyz", COMPONENTS, strict=False)
        if axis in axes
    }
    shown = {"distance": (data["deviation"].values, {"color": INK, "linewidth": 1.5})} | parts
    curves(panel, data["time"].values, shown, "m", "deviation")
    time_axis(panel, data["time"].values)
