"""The path of the tip, seen from one or two sides."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, letter, panels, readable, shared_legend
from tmodes.plot.style import INK, QUIET, REAL, REFERENCE

__all__ = ["PLANES", "TipPath", "views"]

PLANES = {("x", "y"): "from above", ("x", "z"): "from the side", ("y", "z"): "from the front"}
"""Pairs of axes, and the direction of view in which they are seen."""

INK_PATH = {"color": INK, "linewidth": 0.9}

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


@register
class TipPath(Figure):
    """Paths of the tip [m], actual and nominal, to scale, with the robot at the start and at the end (thin).

    From one side where the path stays in a plane, else from two; with a nominal path from one side, the deviation from
    it too. ``ax``: so many axes, or None.
    """

    name = "tip_path"
    title = "Path of the tip"
    caption = "The path from the round mark (start) to the square one (end), with the robot at both (thin)."

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each view."""
        data = result.data
        tip = data["tip"].transpose("time", "axis").values
        planned = data["tip_nominal"].transpose("time", "axis").values if "tip_nominal" in data else None
        chosen = views(tip if planned is None else np.concatenate([tip, planned]))
        alone = len(chosen) == 1 and planned is not None
        axes = panels(ax, [["".join(pair) for pair in chosen] + ["deviation"] * alone], 3.4)
        for panel, pair in zip(axes, chosen, strict=False):
            columns = ["xyz".index(name) for name in pair]
            _path(panel, tip[:, columns], "actual", REAL)
            if planned is not None:
                panel.plot(*planned[:, columns].T, label="nominal", **REFERENCE)
            for pose in _poses(data):
                panel.plot(*pose[:, columns].T, color=QUIET, linewidth=0.6, zorder=1)
            _scale(panel, pair, "")
        if alone:
            _deviation(axes[-1], tip - planned, chosen[0])
        shared_legend(axes[0])
        titles = [f"Path of the tip, {PLANES[pair]}" for pair in chosen]
        letter(axes, [*titles, *(["Deviation, actual − nominal"] if alone else [])])
        return axes


def _path(panel: Axes, points: Any, label: str, look: dict[str, Any]) -> None:
    """A path with its start and its end."""
    panel.plot(*points.T, label=label, **look)
    panel.plot(*points[0], "o", color=INK, markersize=4, label="start")
    panel.plot(*points[-1], "s", color=INK, markersize=4, label="end")


def _scale(panel: Axes, pair: tuple[str, str], before: str, unit: str = "m") -> None:
    panel.set(xlabel=f"{before}${pair[0]}$ [{unit}]", ylabel=f"{before}${pair[1]}$ [{unit}]")
    panel.set_aspect("equal", adjustable="datalim")
    panel.locator_params(nbins=5)
    panel.margins(0.08)


def _deviation(panel: Axes, difference: Any, pair: tuple[str, str]) -> None:
    """The deviation [m] from the nominal path, seen from the same side."""
    points = difference[:, ["xyz".index(name) for name in pair]]
    unit = readable("m", points)
    _path(panel, unit.of(points), "", INK_PATH)
    _scale(panel, pair, "Δ", unit.name)


def _poses(data: Any) -> list[Any]:
    """The robot at the first and the last sample: the points of its links, one after the other."""
    if "line" not in data:
        return []
    lines = data["line"].transpose("time", "link", "s", "axis").values
    return [lines[k].reshape(-1, 3) for k in (0, -1)] if len(lines) > 1 else []
