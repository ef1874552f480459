"""The deflection along each elastic link at several instants."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import instant_looks, instants, largest, names_of, plain
from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, curves, letter, pairs, panels, shared_legend, zero_line

__all__ = ["LinkDeflection"]

_MOST = 4


class LinkDeflection(Figure):
    """Deflection [m] along each elastic link from the tangent at its root, along y and z, at several instants.

    Of more than four links, those that bend most. ``ax``: two axes for each link, or None.
    """

    name = "link_deflection"
    title = "Shape of the elastic links"
    caption = "Deflection from the tangent at the root; where curves coincide, the shape hardly changes."
    needs: ClassVar = {"bending_link": "no link of this robot is elastic"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Two panels for each link: along y and along z of its root."""
        data = result.data
        bent = data["deflection"].transpose("bending_link", "time", "s", "plane")
        names = names_of(data, "bending_link")
        names = largest(names, np.abs(bent.values).max(axis=(1, 2, 3)), _MOST)
        chosen = instants(data)
        layout = pairs(len(names))
        axes = panels(ax, layout, 0.8 + 1.75 * len(names), sharex=ax is None)
        shown = [(name, plane) for name in names for plane in ("y", "z")]
        for panel, (name, plane) in zip(axes, shown, strict=True):
            lines, times = bent.sel(bending_link=name, plane=plane).values[chosen], data["time"].values[chosen]
            looks = zip(lines, instant_looks(len(times)), times, strict=True)
            drawn = {f"{time:.3g} s": (line, look) for line, look, time in looks}
            curves(panel, data["s"].values, drawn, "m", "deflection")
            zero_line(panel)
            panel.set_xlim(0.0, 1.0)
        for panel in axes[-2:]:
            panel.set_xlabel("along the link $s$ [–]")
        shared_legend(axes[0])
        letter(axes, (f"{plain(name)}, along {plane}" for name, plane in shown))
        return axes
