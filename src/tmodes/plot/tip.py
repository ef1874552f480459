"""Where an arm's tip goes: its coordinates over time, and its path seen from two sides."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.style import INK, REAL, REFERENCE, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result import Result

__all__ = ["PLANES", "tip_motion", "tip_path", "views"]

PLANES = {("x", "y"): "from above", ("x", "z"): "from the side", ("y", "z"): "from the front"}
"""Pairs of axes, and how one looks to see them."""

FLAT = 0.02
"""An arm that leaves a plane by less than this share of its reach is shown in that plane only."""


def views(points: Any) -> list[tuple[str, str]]:
    """The pairs of axes in which points (..., 3) are to be seen: one where they stay in a plane, else two."""
    extents = dict(zip("xyz", np.ptp(points.reshape(-1, 3), axis=0), strict=True))
    thin = min(extents, key=lambda name: extents[name])
    if extents[thin] <= FLAT * max(extents.values()):
        return [next(pair for pair in PLANES if thin not in pair)]
    widest = sorted(PLANES, key=lambda pair: -extents[pair[0]] * extents[pair[1]])[:2]
    return sorted(widest, key=list(PLANES).index)


@house_style()
def tip_motion(result: Result, ax: AxesLike = None) -> list[Axes]:
    """Tip x, y, z [m] over time, of a run without a reference. ``ax``: three axes, or None."""
    axes = panels(ax, [["x", "y", "z"]], 2.3)
    time = result.data["time"].values
    for panel, axis in zip(axes, "xyz", strict=True):
        values = result.data["tip"].sel(axis=axis).values
        unit = readable("m", values)
        panel.plot(time, unit.of(values), **REAL)
        panel.set_ylabel(f"{axis} [{unit.name}]")
        time_axis(panel, time)
    letter(axes, ("Tip x", "Tip y", "Tip z"))
    return axes


@house_style()
def tip_path(result: Result, ax: AxesLike = None) -> list[Axes]:
    """The path of the tip [m] and of its reference, to scale, from one or two sides. ``ax``: so many axes, or None."""
    data = result.data
    tip = data["tip"].transpose("time", "axis").values
    planned = data["tip_reference"].transpose("time", "axis").values if "tip_reference" in data else None
    chosen = views(tip if planned is None else np.concatenate([tip, planned]))
    axes = panels(ax, [["".join(pair) for pair in chosen]], 3.4)
    for panel, pair in zip(axes, chosen, strict=True):
        columns = ["xyz".index(name) for name in pair]
        panel.plot(*tip[:, columns].T, label="real", **REAL)
        if planned is not None:
            panel.plot(*planned[:, columns].T, label="reference", **REFERENCE)
        panel.plot(*tip[0, columns], "o", color=INK, markersize=4, label="start")
        panel.plot(*tip[-1, columns], "s", color=INK, markersize=4, label="end")
        panel.set(xlabel=f"${pair[0]}$ [m]", ylabel=f"${pair[1]}$ [m]")
        panel.set_aspect("equal", adjustable="datalim")
        panel.locator_params(nbins=5)
        panel.margins(0.08)
    shared_legend(axes[0])
    letter(axes, (f"Path of the tip, {PLANES[pair]}" for pair in chosen))
    return axes
