"""Forces: of the contact, and section loads along the links."""

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
    side_legend,
    time_axis,
    widest_legend,
    zero_line,
)
from tmodes.plot.ranges import common_unit, fill_from_zero, largest_shown, seen
from tmodes.plot.style import BAND, BLUE, COMPONENTS, INK, REAL, RED, REFERENCE

__all__ = ["ContactForce", "LinkLoads"]

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
