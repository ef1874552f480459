"""The deflection of the end of each elastic link over time."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import largest, names_of, plain
from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, curves, last_times, letter, panels, shared_legend
from tmodes.plot.style import COMPONENTS

__all__ = ["LinkTips"]


class LinkTips(Figure):
    """Deflection of the end of each elastic link from its root's tangent [m], along y and z of its root.

    Of more than eight links, those that bend most. ``ax``: one axes for each link, or None.
    """

    name = "link_tips"
    title = "Deflection of the links"
    caption = "How far the end of each link leaves the tangent at its root, in both planes."
    needs: ClassVar = {"bending_link": "no link of this robot is elastic"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each link."""
        data = result.data
        names = names_of(data, "bending_link")
        ends = data["deflection"].isel(s=-1).transpose("bending_link", "time", "plane")
        names = largest(names, np.abs(ends.values).max(axis=(1, 2)))
        axes = panels(ax, [[str(k)] for k in range(len(names))], 0.8 + 1.25 * len(names), sharex=ax is None)
        for panel, name in zip(axes, names, strict=True):
            bent = ends.sel(bending_link=name)
            shown = {f"along {one}": (bent.sel(plane=one), look) for one, look in zip("yz", COMPONENTS, strict=False)}
            curves(panel, data["time"].values, shown, "m", "deflection")
        last_times(axes, data["time"].values, 1)
        shared_legend(axes[0])
        letter(axes, (f"End of {plain(name)}" for name in names))
        return axes
