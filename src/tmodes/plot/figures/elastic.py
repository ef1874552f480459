"""Elastic coordinates: their course, decomposition, deflection along links and at tips."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import (
    coordinate_names,
    deformation_unit,
    instant_looks,
    instants,
    largest,
    largest_coordinates,
    names_of,
    part_title,
    plain,
    rows_height,
)
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import (
    Axes,
    AxesLike,
    Unit,
    curves,
    last_times,
    letter,
    panels,
    shared_legend,
    time_axis,
    widest_legend,
    zero_line,
)
from tmodes.plot.ranges import all_equal, common_unit, largest_shown, limit_peaks, seen
from tmodes.plot.style import COMPONENTS, INK, QUIET, REAL, REFERENCE

__all__ = ["Deformations", "GearDeflections", "LinkCoordinates", "LinkDeflection", "LinkTips"]

_MOST_GEARS, _MOST_COORDINATES = 4, 6


@register
class Deformations(Figure):
    """Elastic coordinates of links and gears [rad, m], actual and nominal: the largest six and four.

    ``ax``: one axes for each, or None.
    """

    name = "deformations"
    title = "Elastic deformations"
    caption = "Actual and nominal deformation of links and gears; note the scales, and the sag at the start."
    needs: ClassVar = {"deformation_nominal": "there is no nominal run, or nothing of this robot is elastic"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each coordinate, two in a row."""
        data = result.data
        names = largest_coordinates(data, coordinate_names(data, gears=False), _MOST_COORDINATES)
        names += largest_coordinates(data, coordinate_names(data, gears=True), _MOST_GEARS)
        rows = [names[k : k + 2] for k in range(0, len(names), 2)]
        axes = panels(ax, [row if len(row) == 2 else row * 2 for row in rows], 0.8 + 1.6 * len(rows))
        units = _deformation_units(data, names)
        for panel, name in zip(axes, names, strict=True):
            _coordinate(panel, data, name, units)
        shared_legend(axes[0])
        letter(axes, map(plain, names))
        return axes


def _deformation_units(data: Any, names: list[str]) -> dict[str, Unit]:
    """One unit for all angles, and one for all displacements."""
    kinds: dict[str, list[Any]] = {}
    for name in names:
        own = (data[key].sel(deformation_kind=name).values for key in ("deformation", "deformation_nominal"))
        kinds.setdefault(deformation_unit(data, name), []).append(np.stack(list(own)))
    return {si: common_unit(si, *values) for si, values in kinds.items()}


def _coordinate(panel: Axes, data: Any, name: str, units: dict[str, Unit]) -> None:
    actual, planned = (data[key].sel(deformation_kind=name).values for key in ("deformation", "deformation_nominal"))
    shown = {"actual": (actual, REAL), "nominal": (planned, REFERENCE)}
    si = deformation_unit(data, name)
    curves(panel, data["time"].values, shown, si, unit=units[si])
    time_axis(panel, data["time"].values)


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
        units = _part_units(data, shown)
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


def _part_units(data: Any, shown: list[tuple[str, str, Curves]]) -> dict[str, Unit]:
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


@register
class LinkTips(Figure):
    """Deflection of the end of each elastic link from its root's tangent [m], along y and z of its root.

    Of more than eight links, those that bend most. ``ax``: one axes for each link, or None.
    """

    name = "link_tips"
    title = "Deflection of the links"
    caption = "How far the end of each link leaves the tangent at its root, in both planes."
    needs: ClassVar = {"bending_link": "no link of this robot is elastic"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each link."""
        data = result.data
        names = names_of(data, "bending_link")
        ends = data["deflection"].isel(s=-1).transpose("bending_link", "time", "plane")
        names = largest(names, np.abs(ends.values).max(axis=(1, 2)))
        axes = panels(ax, [[str(k)] for k in range(len(names))], 0.8 + 1.25 * len(names), sharex=ax is None)
        unit = common_unit("m", *(ends.sel(bending_link=name).values for name in names))
        for panel, name in zip(axes, names, strict=True):
            curves(panel, data["time"].values, _tip_planes(ends.sel(bending_link=name)), "m", "deflection", unit)
        last_times(axes, data["time"].values, 1)
        widest_legend(axes)
        letter(axes, (f"End of {plain(name)}" for name in names))
        return axes


def _tip_planes(bent: Any) -> dict[str, tuple[Any, dict[str, Any]]]:
    """The deflections in the planes in which the link bends; in both of one that stays straight."""
    both = {f"along {one}": (bent.sel(plane=one), look) for one, look in zip("yz", COMPONENTS, strict=False)}
    size = float(np.abs(bent.values).max())
    return {label: one for label, one in both.items() if seen(one[0], size)} or both
