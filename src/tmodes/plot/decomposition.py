"""Elastic coordinates decomposed: quasi-static part T_st and oscillatory part T_to, y(x, t) = X(x) (T_st + T_to)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.plot.facts import deformation_unit, largest, plain, rows_height
from tmodes.plot.panels import AxesLike, last_times, letter, panels, readable, shared_legend
from tmodes.plot.style import COMPONENTS, QUIET, REFERENCE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["coordinate_names", "decomposed", "largest_coordinates"]

_REFERENCE: dict[str, Any] = REFERENCE | {"linewidth": 0.8}


def coordinate_names(data: Any, *, gears: bool) -> list[str]:
    """Elastic coordinates of the gears, or those of the links."""
    if "deformation_kind" not in data.dims:
        return []
    names = [str(name) for name in data["deformation_kind"].values]
    return [name for name in names if (name not in data["coordinate"].values) == gears]


def largest_coordinates(data: Any, names: list[str], most: int) -> list[str]:
    """At most so many of the named elastic coordinates, those that become largest, in their order."""
    values = data["deformation"].sel(deformation_kind=names).transpose("deformation_kind", "time").values
    return largest(names, np.abs(values).max(axis=1), most)


def decomposed(data: Any, names: list[str], ax: AxesLike) -> list[Axes]:
    """Two axes for each name: the whole with its quasi-static part (left), the oscillatory part (right)."""
    layout = [[f"{k} left", f"{k} right"] for k in range(len(names))]
    axes = panels(ax, layout, rows_height(len(names)), sharex=ax is None)
    for k, name in enumerate(names):
        _stationary(axes[2 * k], data, name)
        _oscillatory(axes[2 * k + 1], data, name)
    last_times(axes, data["time"].values, 2)
    shared_legend(axes[0], axes[1])
    letter(axes, (plain(name) for name in names for _ in range(2)))
    return axes


def _stationary(panel: Axes, data: Any, name: str) -> None:
    whole, part = (data[key].sel(deformation_kind=name).values for key in ("deformation", "deformation_stationary"))
    unit, time = readable(deformation_unit(data, name), whole, part), data["time"].values
    panel.plot(time, unit.of(whole), color=QUIET, linewidth=0.8, label="total")
    panel.plot(time, unit.of(part), label="quasi-static $T_{st}$", **COMPONENTS[0])
    if "deformation_reference" in data:
        planned = data["deformation_reference"].sel(deformation_kind=name).values
        panel.plot(time, unit.of(planned), label="reference", **_REFERENCE)
    panel.set_ylabel(f"[{unit.name}]")


def _oscillatory(panel: Axes, data: Any, name: str) -> None:
    part = data["deformation_oscillatory"].sel(deformation_kind=name).values
    unit, look = readable(deformation_unit(data, name), part), COMPONENTS[2]["color"]
    panel.plot(data["time"].values, unit.of(part), label="oscillatory $T_{to}$", color=look, linewidth=1.0)
    panel.set_ylabel(f"[{unit.name}]")
