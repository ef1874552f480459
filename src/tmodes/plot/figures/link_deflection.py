"""The deflection along each elastic link at several instants."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import instant_looks, instants, largest, names_of, plain
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, curves, letter, panels, widest_legend, zero_line
from tmodes.plot.ranges import all_equal, common_unit, seen
from tmodes.plot.style import INK

__all__ = ["LinkDeflection"]

_MOST = 4


@register
class LinkDeflection(Figure):
    """Deflection [m] along each elastic link from the tangent at its root, along y and z, at several instants.

    Of more than four links, those that bend most; a plane in which a link stays straight is left out. ``ax``: an axes
    for each link and plane, or None.
    """

    name = "link_deflection"
    title = "Shape of the elastic links"
    caption = "Deflection from the tangent at the root; where curves coincide, the shape hardly changes."
    needs: ClassVar = {"bending_link": "no link of this robot is elastic"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """A panel for each link and plane: along y and along z of its root."""
        data = result.data
        bent = data["deflection"].transpose("bending_link", "time", "s", "plane")
        names = names_of(data, "bending_link")
        names = largest(names, np.abs(bent.values).max(axis=(1, 2, 3)), _MOST)
        chosen = instants(data)
        shown = {name: _planes(bent.sel(bending_link=name), chosen) for name in names}
        layout = [[f"{name} {plane}" for plane in [*planes, *planes][:2]] for name, planes in shown.items()]
        axes = panels(ax, layout, 0.8 + 1.75 * len(names), sharex=ax is None)
        lines = [(f"{plain(name)}, along {plane}", line) for name in names for plane, line in shown[name].items()]
        unit = common_unit("m", *(line for _, line in lines))
        for panel, (_, line) in zip(axes, lines, strict=True):
            _draw(panel, data["s"].values, line, data["time"].values[chosen], unit)
        for panel in axes[-len(shown[names[-1]]) :]:
            panel.set_xlabel("along the link $s$ [–]")
        widest_legend(axes)
        letter(axes, [title for title, _ in lines])
        return axes


def _planes(bent: Any, chosen: Any) -> dict[str, Any]:
    """The lines at the chosen instants in the planes in which the link bends; in both of one that stays straight."""
    both = {plane: bent.sel(plane=plane).values[chosen] for plane in ("y", "z")}
    size = float(np.abs(bent.values).max())
    return {plane: lines for plane, lines in both.items() if seen(lines, size)} or both


def _draw(panel: Axes, s: Any, lines: Any, times: Any, unit: Unit) -> None:
    """One curve for each instant, or for all of them where they are equal."""
    differ = all_equal(lines)
    if differ is None:
        looks = zip(lines, instant_looks(len(times)), times, strict=True)
        curves(panel, s, {f"{t:.3g} s": (line, look) for line, look, t in looks}, "m", "deflection", unit)
    else:
        curves(panel, s, {"all times": (lines.mean(axis=0), {"color": INK, "linewidth": 1.5})}, "m", "deflection", unit)
        note = f"mean of {len(times)} times,\nequal within {max(100 * differ, 0.1):.1g} %"
        panel.text(0.03, 0.05 if lines.mean() < 0 else 0.8, note, fontsize=7, transform=panel.transAxes)
    zero_line(panel)
    panel.set_xlim(0.0, 1.0)
