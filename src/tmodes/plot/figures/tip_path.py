"""The path of the tip, seen from one or two sides."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, letter, panels, shared_legend
from tmodes.plot.style import INK, QUIET, REAL, REFERENCE

__all__ = ["PLANES", "VISIBLE", "TipPath", "enlargement", "round_factor", "views"]

PLANES = {("x", "y"): "from above", ("x", "z"): "from the side", ("y", "z"): "from the front"}
"""Pairs of axes, and the direction of view in which they are seen."""

FLAT = 0.02
"""A robot that leaves a plane by less than this share of its reach is shown in that plane only."""


VISIBLE = 0.1
"""The largest deflection or deviation is drawn about this large, as a share of the robot's reach."""


def round_factor(wanted: float) -> float:
    """The largest of 1, 2, 5, 10, 20, 50, ... that is not above ``wanted``; never below 1."""
    if not 1.0 < wanted < 1e12:
        return 1.0
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(max(step * power for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9)))


def enlargement(factor: float, what: str) -> str:
    """In words, how much the picture enlarges a deflection or deviation."""
    return "to scale" if factor == 1 else f"{what} × {factor:g}"


def views(points: Any) -> list[tuple[str, str]]:
    """The pairs of axes in which points (..., 3) are to be seen: one where they stay in a plane, else two."""
    extents = dict(zip("xyz", np.ptp(points.reshape(-1, 3), axis=0), strict=True))
    thin = min(extents, key=lambda name: extents[name])
    if extents[thin] <= FLAT * max(extents.values()):
        return [next(pair for pair in PLANES if thin not in pair)]
    widest = sorted(PLANES, key=lambda pair: -extents[pair[0]] * extents[pair[1]])[:2]
    return sorted(widest, key=list(PLANES).index)


class TipPath(Figure):
    """Paths of the tip [m], actual and nominal, to scale, with the robot at the start and at the end (thin).

    From one side where the path stays in a plane, else from two. Seen from one side, a path that differs little from
    the nominal one is shown with its deviation magnified too. ``ax``: so many axes, or None.
    """

    name = "tip_path"
    title = "Path of the tip"
    caption = "The path from the round mark (start) to the square one (end), with the robot at both (thin)."

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each view."""
        data = result.data
        tip = data["tip"].transpose("time", "axis").values
        planned = data["tip_nominal"].transpose("time", "axis").values if "tip_nominal" in data else None
        chosen = [(pair, 1.0) for pair in views(tip if planned is None else np.concatenate([tip, planned]))]
        factor = 1.0 if planned is None else _factor(tip, planned)
        if len(chosen) == 1 and planned is not None and factor > 1:
            chosen.append((chosen[0][0], factor))
        axes = panels(ax, [[f"{''.join(pair)} {size:g}" for pair, size in chosen]], 3.4)
        for panel, (pair, size) in zip(axes, chosen, strict=True):
            columns = ["xyz".index(name) for name in pair]
            for pose in _poses(data):
                panel.plot(*pose[:, columns].T, color=QUIET, linewidth=0.6, zorder=1)
            actual = tip if planned is None else planned + size * (tip - planned)
            panel.plot(*actual[:, columns].T, label="actual", **REAL)
            if planned is not None:
                panel.plot(*planned[:, columns].T, label="nominal", **REFERENCE)
            panel.plot(*actual[0, columns], "o", color=INK, markersize=4, label="start")
            panel.plot(*actual[-1, columns], "s", color=INK, markersize=4, label="end")
            panel.set(xlabel=f"${pair[0]}$ [m]", ylabel=f"${pair[1]}$ [m]")
            panel.set_aspect("equal", adjustable="datalim")
            panel.locator_params(nbins=5)
            panel.margins(0.08)
        shared_legend(axes[0])
        letter(axes, (f"{PLANES[pair].capitalize()}, {enlargement(size, 'deviation')}" for pair, size in chosen))
        return axes


def _factor(tip: Any, planned: Any) -> float:
    """How much the deviation is magnified."""
    largest = float(np.linalg.norm(tip - planned, axis=1).max())
    return round_factor(VISIBLE * float(np.linalg.norm(np.ptp(planned, axis=0))) / largest) if largest > 0 else 1.0


def _poses(data: Any) -> list[Any]:
    """The robot at the first and the last sample: the points of its links, one after the other."""
    if "line" not in data:
        return []
    lines = data["line"].transpose("time", "link", "s", "axis").values
    return [lines[k].reshape(-1, 3) for k in (0, -1)] if len(lines) > 1 else []
