"""The force between the contact point and its environment."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, curves, letter, panels, shared_legend, side_legend, time_axis, zero_line
from tmodes.plot.ranges import fill_from_zero, largest_shown, seen
from tmodes.plot.style import COMPONENTS, INK, REAL, REFERENCE

__all__ = ["ContactForce"]

NEARLY_CONSTANT = 0.05
"""A force that varies by less than this share of its largest value is noted to be nearly constant."""


@register
class ContactForce(Figure):
    """Normal force [N], actual and nominal; its components [N]; penetration [m].

    Of a force that hardly varies, a close-up too. ``ax``: three axes, four with a close-up, or None.
    """

    name = "contact_force"
    title = "Contact force"
    caption = (
        "The normal force on an axis from zero and, where it varies little, in close-up: the first shows how large its "
        "changes are, the second their course. A negative penetration is a gap."
    )
    needs: ClassVar = {"contact_force": "the robot moved in free space: there is no contact force"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Normal force twice, its components, the penetration."""
        data = result.data
        time, real = data["time"].values, data["contact_force_normal"].values
        closer = _range(real) < NEARLY_CONSTANT
        layout = [["whole", "close" if closer else "whole"], ["parts"] * 2, ["deep"] * 2]
        axes = panels(ax, layout, 6.0)
        shown = {"actual": (real, REAL)}
        if "contact_force_normal_nominal" in data:
            shown["nominal"] = (data["contact_force_normal_nominal"].values, REFERENCE)
        for panel in axes[:-2]:
            unit = curves(panel, time, shown, "N", "force")
            time_axis(panel, time)
            if closer and panel is axes[0]:
                note = _constancy(unit.of(real), unit.name)
                panel.text(0.03, 0.5, note, transform=panel.transAxes, fontsize=7.5)
        fill_from_zero(axes[0])
        curves(axes[-2], time, _components(data), "N", "force")
        side_legend(axes[-2])
        curves(axes[-1], time, {"": (data["penetration"].values, {"color": INK})}, "m", "depth")
        for panel in axes[-2:]:
            zero_line(panel)
            time_axis(panel, time, label=panel is axes[-1])
        shared_legend(axes[0])
        titles = ["Normal force, from zero", "Normal force, close-up"] if closer else ["Normal force"]
        letter(axes, [*titles, "Components, by the point on the surface", "Penetration"])
        return axes


def _components(data: Any) -> dict[str, tuple[Any, dict[str, Any]]]:
    """The components that are not zero throughout; all of a force that is."""
    forces = {axis: data["contact_force"].sel(axis=axis).values for axis in "xyz"}
    size = largest_shown(forces.values())
    return {
        f"$F_{axis}$": (forces[axis], look)
        for axis, look in zip("xyz", COMPONENTS, strict=False)
        if size == 0 or seen(forces[axis], size)
    }


def _range(force: Any) -> float:
    """Largest less smallest force, over the largest size."""
    return float(np.ptp(force)) / (float(np.abs(force).max()) or 1.0)


def _constancy(force: Any, unit: str) -> str:
    """The range in words, so that no one takes the close-up for a large change."""
    low, high = float(np.min(force)), float(np.max(force))
    digits = int(np.clip(2 - np.floor(np.log10(max(high - low, 1e-9))), 2, 6))
    share = f"within {100 * _range(force):.2g} %"
    return f"actual: nearly constant,\n{share}:\n{low:.{digits}f} to {high:.{digits}f} {unit}"
