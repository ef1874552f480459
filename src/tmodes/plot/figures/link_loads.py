"""Section loads along the links when each is loaded most, and their range over the run."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.facts import largest, names_of, plain
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import (
    Axes,
    AxesLike,
    Unit,
    curves,
    letter,
    pairs,
    panels,
    shared_legend,
    widest_legend,
    zero_line,
)
from tmodes.plot.ranges import common_unit, fill_from_zero, seen
from tmodes.plot.style import BAND, BLUE, COMPONENTS, RED

__all__ = ["LinkLoads"]

_MOST_LINKS = 6
_KINDS = ("torsion", "bending about y", "bending about z")

Array = NDArray[Any]


@register
class LinkLoads(Figure):
    """Left, moments [N m] along each link when its bending moment is largest; right, stress [Pa], or shear force [N].

    The band is the range over the run. Of more than six links, those with the largest moments. ``ax``: two axes for
    each link, or None.
    """

    name = "link_loads"
    title = "Moments and stress along the links"
    caption = (
        "The section loads of each link when its bending moment is largest, from its root (0) to its tip (1); the band "
        "is the range over the run."
    )
    needs: ClassVar = {"bending_link": "no link of this robot is elastic"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Two panels for each link."""
        data = result.data
        names = names_of(data, "bending_link")
        moments = data["moment"].transpose("bending_link", "time", "s", "moment_kind").values
        bending = np.linalg.norm(moments[..., 1:], axis=-1)
        shown = largest(names, bending.max(axis=(1, 2)), _MOST_LINKS)
        layout = pairs(len(shown))
        axes = panels(ax, layout, 0.8 + 1.6 * len(shown), sharex=ax is None)
        units = common_unit("N m", *(moments[names.index(name)] for name in shown)), _shear_unit(data, shown)
        titles = []
        for k, name in enumerate(shown):
            index = names.index(name)
            sample = int(np.unravel_index(np.argmax(bending[index]), bending[index].shape)[0])
            _moments(axes[2 * k], data, moments[index, sample], units[0])
            right = _right(axes[2 * k + 1], data, name, units[1])
            titles += [f"{plain(name)} at {float(data['time'][sample]):.3g} s", right]
        for panel in axes[-2:]:
            panel.set_xlabel("along the link $s$ [–]")
        widest_legend(axes[::2])
        shared_legend(axes[1], place="lower left")
        letter(axes, titles)
        return axes


def _moments(panel: Axes, data: Any, moments: Array, unit: Unit) -> None:
    size = float(np.abs(moments).max())
    shown = {
        kind: (values, look)
        for kind, values, look in zip(_KINDS, moments.T, COMPONENTS, strict=False)
        if size == 0 or seen(values, size)
    }
    curves(panel, data["s"].values, shown, "N m", "moment", unit)
    zero_line(panel, 0.6)
    panel.set_xlim(0.0, 1.0)


def _shear(data: Any, name: str) -> Array:
    """The size of the shear force [N] (time, station)."""
    shear = data["shear_force"].sel(bending_link=name).transpose("time", "s", "plane").values
    return np.linalg.norm(shear, axis=-1)


def _shear_unit(data: Any, names: list[str]) -> Unit:
    return common_unit("N", *(_shear(data, name) for name in names))


def _right(panel: Axes, data: Any, name: str, force: Unit) -> str:
    """Stress where it is known, else the size of the shear force; returns the panel's title."""
    known = "stressed_link" in data.dims and name in data["stressed_link"].values
    if known:
        values = data["stress"].sel(stressed_link=name).transpose("time", "s").values
        words, unit = "stress", Unit("MPa", 1e-6)
    else:
        values, words, unit = _shear(data, name), "shear force", force
    s = data["s"].values
    sample = int(np.unravel_index(np.argmax(values), values.shape)[0])
    low, high, worst = (unit.of(line) for line in (values.min(axis=0), values.max(axis=0), values[sample]))
    panel.fill_between(s, low, high, facecolor=BAND, edgecolor=BLUE, linewidth=0.6, label="range over the run")
    panel.plot(s, worst, color=RED, linewidth=1.2, linestyle=(0, (5, 1.5)), label="when it is largest")
    panel.set_xlim(0.0, 1.0)
    fill_from_zero(panel)
    panel.set_ylabel(f"{words} [{unit.name}]")
    return f"{words.capitalize()}, worst at {float(data['time'][sample]):.3g} s"
