"""The elastic coordinates of an arm, each split as y(x, t) = X(x) (T_st(t) + T_to(t)): gears, and links."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.plot.facts import deformation_unit, largest, plain, rows_height
from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.style import COMPONENTS, QUIET, REFERENCE, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result import Result

__all__ = ["gear_deflections", "link_coordinates", "link_tips", "no_bending", "no_gears"]

_MOST_COORDINATES = 6
_REFERENCE: dict[str, Any] = REFERENCE | {"linewidth": 0.8}


def no_gears(data: Any) -> str:
    """Why no gear is drawn; empty when one is."""
    return "" if _names(data, gears=True) else "no gear of this arm is elastic"


def no_bending(data: Any) -> str:
    """Why no link is drawn; empty when one is."""
    return "" if "bending_link" in data.dims else "no link of this arm bends"


def _names(data: Any, *, gears: bool) -> list[str]:
    if "deformation_kind" not in data.dims:
        return []
    names = [str(name) for name in data["deformation_kind"].values]
    return [name for name in names if (name not in data["coordinate"].values) == gears]


@house_style()
def gear_deflections(result: Result, ax: AxesLike = None) -> list[Axes]:
    """Gear output less input [rad]: the whole with its stationary part (left), its oscillatory part (right).

    Of more than eight gears, those that give most. ``ax``: two axes for each, or None.
    """
    return _split(result.data, _most(result.data, _names(result.data, gears=True), 8), ax)


@house_style()
def link_coordinates(result: Result, ax: AxesLike = None) -> list[Axes]:
    """The six largest coordinates of the links [rad, m], split as :func:`gear_deflections`. ``ax``: two for each."""
    names = _names(result.data, gears=False)
    return _split(result.data, _most(result.data, names, _MOST_COORDINATES), ax)


def _most(data: Any, names: list[str], most: int) -> list[str]:
    values = data["deformation"].sel(deformation_kind=names).transpose("deformation_kind", "time").values
    return largest(names, np.abs(values).max(axis=1), most)


def _split(data: Any, names: list[str], ax: AxesLike) -> list[Axes]:
    layout = [[f"{k} left", f"{k} right"] for k in range(len(names))]
    axes = panels(ax, layout, rows_height(len(names)), sharex=ax is None)
    for k, name in enumerate(names):
        _stationary(axes[2 * k], data, name)
        _oscillatory(axes[2 * k + 1], data, name)
    for k, panel in enumerate(axes):
        time_axis(panel, data["time"].values, label=k >= len(axes) - 2)
    shared_legend(axes[0], axes[1])
    letter(axes, (plain(name) for name in names for _ in range(2)))
    return axes


def _stationary(panel: Axes, data: Any, name: str) -> None:
    whole, part = (data[key].sel(deformation_kind=name).values for key in ("deformation", "deformation_stationary"))
    unit, time = readable(deformation_unit(data, name), whole, part), data["time"].values
    panel.plot(time, unit.of(whole), color=QUIET, linewidth=0.8, label="whole")
    panel.plot(time, unit.of(part), label="stationary $T_{st}$", **COMPONENTS[0])
    if "deformation_reference" in data:
        planned = data["deformation_reference"].sel(deformation_kind=name).values
        panel.plot(time, unit.of(planned), label="reference", **_REFERENCE)
    panel.set_ylabel(f"[{unit.name}]")


def _oscillatory(panel: Axes, data: Any, name: str) -> None:
    part = data["deformation_oscillatory"].sel(deformation_kind=name).values
    unit = readable(deformation_unit(data, name), part)
    panel.plot(
        data["time"].values, unit.of(part), label="oscillatory $T_{to}$", color=COMPONENTS[2]["color"], linewidth=1.0
    )
    panel.set_ylabel(f"[{unit.name}]")


@house_style()
def link_tips(result: Result, ax: AxesLike = None) -> list[Axes]:
    """Deflection of the end of each link that bends from its root's tangent [m], along y and z of its root.

    Of more than eight links, those that bend most. ``ax``: one axes for each link, or None.
    """
    data = result.data
    names = [str(name) for name in data["bending_link"].values]
    ends = data["deflection"].isel(s=-1).transpose("bending_link", "time", "plane")
    names = largest(names, np.abs(ends.values).max(axis=(1, 2)))
    axes = panels(ax, [[str(k)] for k in range(len(names))], 0.8 + 1.25 * len(names), sharex=ax is None)
    for panel, name in zip(axes, names, strict=True):
        bent = ends.sel(bending_link=name)
        unit = readable("m", bent.values)
        for plane, look in zip(("y", "z"), COMPONENTS, strict=False):
            panel.plot(data["time"].values, unit.of(bent.sel(plane=plane)), label=f"along {plane}", **look)
        panel.set_ylabel(f"[{unit.name}]")
        time_axis(panel, data["time"].values, label=panel is axes[-1])
    shared_legend(axes[0])
    letter(axes, (f"End of {plain(name)}" for name in names))
    return axes
