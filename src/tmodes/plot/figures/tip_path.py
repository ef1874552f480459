"""The path of the tip, seen from one or two sides."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, letter, panels, shared_legend
from tmodes.plot.style import INK, REAL, REFERENCE

__all__ = ["PLANES", "TipPath", "views"]

PLANES = {("x", "y"): "from above", ("x", "z"): "from the side", ("y", "z"): "from the front"}
"""Pairs of axes, and the direction of view in which they are seen."""

FLAT = 0.02
"""A robot that leaves a plane by less than this share of its reach is shown in that plane only."""


def views(points: Any) -> list[tuple[str, str]]:
    """The pairs of axes in which points (..., 3) are to be seen: one where they stay in a plane, else two."""
    extents = dict(zip("xyz", np.ptp(points.reshape(-1, 3), axis=0), strict=True))
    thin = min(extents, key=lambda name: extents[name])
    if extents[thin] <= FLAT * max(extents.values()):
        return [next(pair for pair in PLANES if thin not in pair)]
    widest = sorted(PLANES, key=lambda pair: -extents[pair[0]] * extents[pair[1]])[:2]
    return sorted(widest, key=list(PLANES).index)


class TipPath(Figure):
    """Paths of the tip [m], actual and nominal, to scale, from one or two sides. ``ax``: so many axes, or None."""

    name = "tip_path"
    title = "Path of the tip"
    caption = "The path to scale, from the round mark (start) to the square one (end)."

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each view."""
        data = result.data
        tip = data["tip"].transpose("time", "axis").values
        planned = data["tip_nominal"].transpose("time", "axis").values if "tip_nominal" in data else None
        chosen = views(tip if planned is None else np.concatenate([tip, planned]))
        axes = panels(ax, [["".join(pair) for pair in chosen]], 3.4)
        for panel, pair in zip(axes, chosen, strict=True):
            columns = ["xyz".index(name) for name in pair]
            panel.plot(*tip[:, columns].T, label="actual", **REAL)
            if planned is not None:
                panel.plot(*planned[:, columns].T, label="nominal", **REFERENCE)
            panel.plot(*tip[0, columns], "o", color=INK, markersize=4, label="start")
            panel.plot(*tip[-1, columns], "s", color=INK, markersize=4, label="end")
            panel.set(xlabel=f"${pair[0]}$ [m]", ylabel=f"${pair[1]}$ [m]")
            panel.set_aspect("equal", adjustable="datalim")
            panel.locator_params(nbins=5)
            panel.margins(0.08)
        shared_legend(axes[0])
        letter(axes, (f"Path of the tip, {PLANES[pair]}" for pair in chosen))
        return axes
