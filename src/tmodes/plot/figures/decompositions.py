"""Elastic coordinates decomposed: quasi-static part T_st and oscillatory part T_to, y(x, t) = X(x) (T_st + T_to)."""

from __future__ import annotations

from typing import Any, ClassVar

from tmodes.plot.facts import coordinate_names, deformation_unit, largest_coordinates, plain, rows_height
from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, curves, last_times, letter, pairs, panels, shared_legend
from tmodes.plot.style import COMPONENTS, QUIET, REFERENCE

__all__ = ["GearDeflections", "LinkCoordinates"]


class _Decomposition(Figure):
    gears: ClassVar[bool]
    """Elastic coordinates of the gears, or those of the links."""

    most: ClassVar[int]

    def missing(self, data: Any) -> str:
        """A robot that is elastic elsewhere alone has no such figure."""
        known = coordinate_names(data, gears=self.gears)
        return super().missing(data) or ("" if known else self.needs["deformation_stationary"])

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Two axes for each coordinate: the total with its quasi-static part, the oscillatory part."""
        data = result.data
        names = largest_coordinates(data, coordinate_names(data, gears=self.gears), self.most)
        axes = panels(ax, pairs(len(names)), rows_height(len(names)), sharex=ax is None)
        for k, name in enumerate(names):
            time, unit = data["time"].values, deformation_unit(data, name)
            curves(axes[2 * k], time, _stationary(data, name), unit)
            part = data["deformation_oscillatory"].sel(deformation_kind=name).values
            look = {"color": COMPONENTS[2]["color"], "linewidth": 1.0}
            curves(axes[2 * k + 1], time, {"oscillatory $T_{to}$": (part, look)}, unit)
        last_times(axes, data["time"].values, 2)
        shared_legend(axes[0], axes[1])
        letter(axes, (plain(name) for name in names for _ in range(2)))
        return axes


def _stationary(data: Any, name: str) -> dict[str, tuple[Any, dict[str, Any]]]:
    known = {
        "total": ("deformation", {"color": QUIET, "linewidth": 0.8}),
        "quasi-static $T_{st}$": ("deformation_stationary", COMPONENTS[0]),
        "nominal": ("deformation_nominal", REFERENCE | {"linewidth": 0.8}),
    }
    return {
        label: (data[series].sel(deformation_kind=name).values, look)
        for label, (series, look) in known.items()
        if series in data
    }


class GearDeflections(_Decomposition):
    """Gear output − input [rad]: total with its quasi-static part (left), oscillatory part (right).

    Of more than eight gears, those that deflect most. ``ax``: two axes for each, or None.
    """

    name = "gear_deflections"
    title = "Deflection of the gears"
    caption = (
        "Left, with what the present forces would hold statically; right, on its own scale, the oscillation about it."
    )
    needs: ClassVar = {"deformation_stationary": "no gear of this robot is elastic"}
    gears, most = True, 8


class LinkCoordinates(_Decomposition):
    """The six largest elastic coordinates of the links [rad, m], decomposed as the deflections of the gears are.

    ``ax``: two axes for each, or None.
    """

    name = "link_coordinates"
    title = "Elastic coordinates of the links"
    caption = (
        "The largest coordinates of bending, torsion and stretch: left with what the present forces would hold "
        "statically, right the oscillation about it."
    )
    needs: ClassVar = {"deformation_stationary": "no link of this robot is elastic"}
    gears, most = False, 6
