"""Error of the tip in its parts: how much of it are controller, gears and links."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.frame import along
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, curves, last_times, letter, panels, widest_legend, zero_line
from tmodes.plot.ranges import seen
from tmodes.plot.style import COMPONENTS, INK, QUIET

__all__ = ["TipErrors"]

_SERIES = {"tip_error": "Actual − commanded", "tip_error_nominal": "Actual − nominal"}

_SMALL = 1e-6
"""Share of the largest error below which the error has no direction to speak of."""


@register
class TipErrors(Figure):
    """Distance of the actual tip from the commanded and from the nominal one [m], and its parts along that error.

    ``ax``: an axes for each path that there is, or None.
    """

    name = "tip_errors"
    title = "Error of the tip, by cause"
    caption = (
        "Distance of the actual tip from the commanded path (the undeformed robot at its setpoints) and from the "
        "nominal one (elastic as known), with the components of its parts along it, which add up to it."
    )
    needs: ClassVar = {"tip_error": "no drive has a setpoint, or an earlier version wrote the result"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each path."""
        data = result.data
        shown = [name for name in _SERIES if name in data]
        axes = panels(ax, [[name] for name in shown], 0.9 + 1.6 * len(shown))
        for panel, name in zip(axes, shown, strict=True):
            parts = data[name].transpose("time", "error_part", "axis").values
            size = np.linalg.norm(parts.sum(axis=1), axis=1)
            values = np.where((size > _SMALL * size.max())[:, None], along(parts), np.nan)
            labels = [str(label) for label in data["error_part"].values]
            looks = [*COMPONENTS[:3], {"color": QUIET, "linestyle": ":"}]
            named = {
                label: (values[:, k], looks[k])
                for k, label in enumerate(labels)
                if seen(np.nan_to_num(values[:, k]), size.max())
            }
            curves(
                panel, data["time"].values, {"error": (size, {"color": INK, "linewidth": 1.5})} | named, "m", "error"
            )
            zero_line(panel)
        last_times(axes, data["time"].values, 1)
        widest_legend(axes)
        letter(axes, [_SERIES[name] for name in shown])
        return axes
