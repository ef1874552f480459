"""Tip position and its deviation from the nominal run."""

from __future__ import annotations

from typing import Any

from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, curves, letter, panels, shared_legend, time_axis
from tmodes.plot.style import COMPONENTS, INK, QUIET, REAL, REFERENCE

__all__ = ["TipTracking"]


_COMMANDED = {"color": QUIET, "linestyle": ":", "linewidth": 0.9}


class TipTracking(Figure):
    """Tip x, y, z [m]; commanded and nominal too, and the deviation from the nominal one [m]: distance, components.

    ``ax``: four axes, without a nominal run three, or None.
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
        if planned:
            axes = panels(ax, [["x", "y", "z"], ["deviation"] * 3], 4.4, height_ratios=[1, 1.25])
        else:
            axes = panels(ax, [["x", "y", "z"]], 2.3)
        for panel, axis in zip(axes, "xyz", strict=False):
            _coordinate(panel, data, axis)
        if planned:
            _deviation(axes[3], data)
            shared_legend(axes[3], place="lower left")
        if planned or "tip_commanded" in data:
            shared_legend(axes[0])
        titles = "Tip x", "Tip y", "Tip z", "Deviation, actual − nominal"
        letter(axes, titles[: len(axes)])
        return axes


def _coordinate(panel: Axes, data: Any, axis: str) -> None:
    known = {"actual": ("tip", REAL), "nominal": ("tip_nominal", REFERENCE), "commanded": ("tip_commanded", _COMMANDED)}
    shown = {label: (data[name].sel(axis=axis).values, look) for label, (name, look) in known.items() if name in data}
    curves(panel, data["time"].values, shown, "m", axis)
    time_axis(panel, data["time"].values)


def _deviation(panel: Axes, data: Any) -> None:
    difference = data["tip"] - data["tip_nominal"]  # no component is larger than the distance
    parts = {f"Δ{axis}": (difference.sel(axis=axis), look) for axis, look in zip("xyz", COMPONENTS, strict=False)}
    shown = {"distance": (data["deviation"].values, {"color": INK, "linewidth": 1.5})} | parts
    curves(panel, data["time"].values, shown, "m", "deviation")
    time_axis(panel, data["time"].values)
