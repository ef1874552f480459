"""The force between the contact point and its environment."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, curves, letter, panels, shared_legend, side_legend, time_axis, zero_line
from tmodes.plot.style import COMPONENTS, INK, REAL, REFERENCE

__all__ = ["ContactForce"]

NEARLY_CONSTANT = 0.05
"""A force that varies by less than this share of its largest value is noted to be nearly constant."""


class ContactForce(Figure):
    """Normal force [N], actual and nominal, on an axis from zero and in close-up; components [N]; penetration [m].

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
        time, real = data["time"].values, data["contact_force_normal"].values
        shown = {"actual": (real, REAL)}
        if "contact_force_normal_nominal" in data:
            shown["nominal"] = (data["contact_force_normal_nominal"].values, REFERENCE)
        unit, _ = (curves(panel, time, shown, "N", "force") for panel in axes[:2])
        for panel in axes[:2]:
            time_axis(panel, time)
        _from_zero(axes[0])
        note = _constancy(unit.of(real), unit.name)
        axes[0].text(0.03, 0.5, note, transform=axes[0].transAxes, fontsize=7.5)
        forces = data["contact_force"]
        parts = {f"$F_{axis}$": (forces.sel(axis=axis), look) for axis, look in zip("xyz", COMPONENTS, strict=False)}
        curves(axes[2], time, parts, "N", "force")
        side_legend(axes[2])
        curves(axes[3], time, {"": (data["penetration"].values, {"color": INK})}, "m", "depth")
        for panel in axes[2:]:
            zero_line(panel)
            time_axis(panel, time, label=panel is axes[3])
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
