"""The force between the contact point and its environment."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from tmodes.plot.figure import Figure
from tmodes.plot.panels import AxesLike, letter, panels, readable, shared_legend, time_axis
from tmodes.plot.style import COMPONENTS, INK, QUIET, REAL, REFERENCE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["ContactForce"]

NEARLY_CONSTANT = 0.05
"""A force that varies by less than this share of its largest value is noted to be nearly constant."""


class ContactForce(Figure):
    """Normal force [N], actual and reference, on an axis from zero and in close-up; components [N]; penetration [m].

    ``ax``: four axes, or None.
    """

    name = "contact_force"
    title = "Contact force"
    caption = (
        "The normal force from zero (a) and in close-up (b): (a) shows how large its changes are, (b) their course. "
        "A negative penetration (d) is a gap."
    )
    needs: ClassVar = {"contact_force": "the robot moved in free space: there is no contact force"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Normal force twice, its components, the penetration."""
        data = result.data
        axes = panels(ax, [["whole", "close"], ["parts", "parts"], ["deep", "deep"]], 6.0)
        real, curves = data["contact_force_normal"].values, {"contact_force_normal": ("actual", REAL)}
        if "contact_force_normal_reference" in data:
            curves["contact_force_normal_reference"] = ("reference", REFERENCE)
        unit = readable("N", *(data[name].values for name in curves))
        for panel in axes[:2]:
            for name, (label, look) in curves.items():
                panel.plot(data["time"].values, unit.of(data[name].values), label=label, **look)
            panel.set_ylabel(f"force [{unit.name}]")
            time_axis(panel, data["time"].values)
        _from_zero(axes[0])
        note = _constancy(unit.of(real), unit.name)
        axes[0].text(0.03, 0.5, note, transform=axes[0].transAxes, fontsize=7.5)
        _components(axes[2], data)
        _penetration(axes[3], data)
        shared_legend(axes[0])
        titles = "Normal force, from zero", "Normal force, close-up", "Components, by the point on the surface"
        letter(axes, (*titles, "Penetration"))
        return axes


def _from_zero(panel: Axes) -> None:
    low, high = min(0.0, panel.dataLim.y0), max(0.0, panel.dataLim.y1)
    room = 0.1 * (high - low) or 1.0
    panel.set_ylim(low - room if low < 0 else 0.0, high + room)


def _constancy(force: Any, unit: str) -> str:
    """The range in words when the force hardly varies, so that no one takes the close-up for a large change."""
    low, high = float(np.min(force)), float(np.max(force))
    largest = max(abs(low), abs(high))
    if high - low >= NEARLY_CONSTANT * largest:
        return ""
    digits = int(np.clip(2 - np.floor(np.log10(max(high - low, 1e-9))), 2, 6))
    share = f"within {100 * (high - low) / largest:.2g} %"
    return f"nearly constant, {share}:\n{low:.{digits}f} to {high:.{digits}f} {unit}"


def _components(panel: Axes, data: Any) -> None:
    unit = readable("N", data["contact_force"].values)
    for axis, look in zip("xyz", COMPONENTS, strict=False):
        panel.plot(data["time"].values, unit.of(data["contact_force"].sel(axis=axis)), label=f"$F_{axis}$", **look)
    panel.axhline(0.0, color=QUIET, linewidth=0.5)
    panel.set_ylabel(f"force [{unit.name}]")
    time_axis(panel, data["time"].values, label=False)
    panel.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0))


def _penetration(panel: Axes, data: Any) -> None:
    unit = readable("m", data["penetration"].values)
    panel.plot(data["time"].values, unit.of(data["penetration"].values), color=INK)
    panel.axhline(0.0, color=QUIET, linewidth=0.5)
    panel.set_ylabel(f"depth [{unit.name}]")
    time_axis(panel, data["time"].values)
