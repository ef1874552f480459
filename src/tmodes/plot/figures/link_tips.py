"""The deflection of the end of each elastic link over time."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import largest, names_of, plain
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, curves, last_times, letter, panels, widest_legend
from tmodes.plot.ranges import common_unit, seen
from tmodes.plot.style import COMPONENTS

__all__ = ["LinkTips"]


@register
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
        unit = common_unit("m", *(ends.sel(bending_link=name).values for name in names))
        for panel, name in zip(axes, names, strict=True):
            curves(panel, data["time"].values, _planes(ends.sel(bending_link=name)), "m", "deflection", unit)
        last_times(axes, data["time"].values, 1)
        widest_legend(axes)
        letter(axes, (f"End of {plain(name)}" for name in names))
        return axes


def _planes(bent: Any) -> dict[str, tuple[Any, dict[str, Any]]]:
    """The deflections in the planes in which the link bends; in both of one that stays straight."""
    both = {f"along {one}": (bent.sel(plane=one), look) for one, look in zip("yz", COMPONENTS, strict=False)}
    size = float(np.abs(bent.values).max())
    return {label: one for label, one in both.items() if seen(one[0], size)} or both
