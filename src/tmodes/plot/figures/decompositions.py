"""Elastic coordinates decomposed: quasi-static part T_st and oscillatory part T_to, y(x, t) = X(x) (T_st + T_to)."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import coordinate_names, deformation_unit, largest_coordinates, part_title, plain, rows_height
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, curves, last_times, letter, panels, shared_legend
from tmodes.plot.ranges import common_unit, largest_shown, limit_peaks
from tmodes.plot.style import COMPONENTS, QUIET, REFERENCE

__all__ = ["GearDeflections", "LinkCoordinates"]

SMALL = 1e-3
"""An oscillation below this share of the coordinate has no panel; the title says how large it is."""

Curves = dict[str, tuple[Any, dict[str, Any]]]


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
        shown = [(name, title, part) for name in names for title, part in _parts(data, name, names)]
        layout = [_row(name, [title for other, title, _ in shown if other == name]) for name in names]
        axes = panels(ax, layout, rows_height(len(names)), sharex=ax is None)
        units = _units(data, shown)
        for panel, (name, _, part) in zip(axes, shown, strict=True):
            unit = units[si := deformation_unit(data, name)]
            curves(panel, data["time"].values, part, si, unit=unit)
            limit_peaks(panel, data["time"].values, _values(part), unit)
        last_times(axes, data["time"].values, len(set(layout[-1])))
        shared_legend(*_first_of_each(axes, [list(part) for _, _, part in shown]))
        letter(axes, [title for _, title, _ in shown])
        return axes


def _row(name: str, titles: list[str]) -> list[str]:
    """Two panels, or one across."""
    places = [f"{name} {k}" for k in range(len(titles))]
    return places if len(places) == 2 else places * 2


def _first_of_each(axes: list[Axes], labels: list[list[str]]) -> list[Axes]:
    """The first panel of the totals, and the first of the oscillatory parts."""
    firsts: dict[tuple[str, ...], Axes] = {}
    for panel, names in zip(axes, labels, strict=True):
        firsts.setdefault(tuple(names), panel)
    return list(firsts.values())


def _parts(data: Any, name: str, among: list[str]) -> list[tuple[str, Curves]]:
    """The titles and curves of a coordinate's panels; one panel where it hardly oscillates."""
    total, text = _stationary(data, name), plain(name)
    part = data["deformation_oscillatory"].sel(deformation_kind=name).values
    share = largest_shown([part]) / (largest_shown([_values(total)]) or 1.0)
    if 0 < share < SMALL:
        return [(f"{text} (oscillatory part at most {100 * share:.1g} %)", total)]
    look = {"color": COMPONENTS[2]["color"], "linewidth": 1.0}
    return [(text, total), (part_title(name, "oscillatory part", among), {"oscillatory $T_{to}$": (part, look)})]


def _values(part: Curves) -> Any:
    return np.stack([values for values, _ in part.values()])


def _units(data: Any, shown: list[tuple[str, str, Curves]]) -> dict[str, Unit]:
    """One unit for all angles, and one for all displacements."""
    kinds: dict[str, list[Any]] = {}
    for name, _, part in shown:
        kinds.setdefault(deformation_unit(data, name), []).append(_values(part))
    return {si: common_unit(si, *values) for si, values in kinds.items()}


def _stationary(data: Any, name: str) -> Curves:
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


@register
class GearDeflections(_Decomposition):
    """Gear output − input [rad]: total with its quasi-static part (left), oscillatory part (right).

    Of more than eight gears, those that deflect most. ``ax``: two axes for each that oscillates, else one, or
    None.
    """

    name = "gear_deflections"
    title = "Deflection of the gears"
    caption = (
        "Left, with what the present forces would hold statically; right, on its own scale, the oscillation about it."
    )
    needs: ClassVar = {"deformation_stationary": "no gear of this robot is elastic"}
    gears, most = True, 8


@register
class LinkCoordinates(_Decomposition):
    """The six largest elastic coordinates of the links [rad, m], decomposed as the deflections of the gears are.

    ``ax``: two axes for each that oscillates, else one, or None.
    """

    name = "link_coordinates"
    title = "Elastic coordinates of the links"
    caption = (
        "The largest coordinates of bending, torsion and stretch: left with what the present forces would hold "
        "statically, right the oscillation about it."
    )
    needs: ClassVar = {"deformation_stationary": "no link of this robot is elastic"}
    gears, most = False, 6
