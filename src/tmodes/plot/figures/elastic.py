"""Elastic links: their shape and their loads along them, the deflection of their ends."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.charts import Chart, Line, in_units, moving, shown_name
from tmodes.plot.facts import instant_looks, instants, largest, names_of
from tmodes.plot.figure import ChartFigure, Rows, register
from tmodes.plot.ranges import all_equal
from tmodes.plot.style import INK
from tmodes.result.result import Result

Array = NDArray[Any]

_NEEDS = {"bending_link": "no link of this robot is elastic"}


def _links(series: str, most: int, row: Callable[[Any, int, str], Iterator[Chart]]) -> Callable[[Result], Rows]:
    """A row for each of so many links, those of which a series is largest, from its number and its name."""

    def rows(result: Result) -> Rows:
        data, names = result.record, names_of(result.record, "bending_link")
        values = data[series].transpose("bending_link", "time", "s", ...).values
        shown = largest(names, np.abs(values).max(axis=(1, 2, 3)), most)
        return in_units([[*row(data, names.index(name), shown_name(name))] for name in shown])

    return rows


def _planes(bent: Array) -> dict[str, Array]:
    """Values (..., 2) in the planes in which a link bends; in both of one that stays straight."""
    both = {f"along {plane}": bent[..., k] for k, plane in enumerate("yz")}
    return {plane: both[plane] for plane in moving(both)}


def _shapes(data: Any, link: int, title: str) -> Iterator[Chart]:
    """Along y and along z of its root."""
    chosen, s = instants(data), data["s"].values
    bent = data["deflection"].transpose("bending_link", "time", "s", "plane").values[link]
    for plane, values in _planes(bent).items():
        lines, note = _at_times(values[chosen], data["time"].values[chosen])
        name = f"{title}, {plane}"
        yield Chart(name, name, "links", "m", s, lines, "deflection", abscissa="along", note=note)


def _at_times(lines: Array, times: Array) -> tuple[tuple[Line, ...], str]:
    """One curve for each instant, or for all of them where they are equal."""
    differ = all_equal(lines)
    if differ is None:
        looks = zip(times, lines, instant_looks(len(times)), strict=True)
        return tuple(Line(f"{time:.3g} s", "real", line, look=look) for time, line, look in looks), ""
    note = f"mean of {len(times)} times,\nequal within {max(100 * differ, 0.1):.1g} %"
    return (Line("all times", "real", lines.mean(axis=0), look={"color": INK, "linewidth": 1.5}),), note


register(ChartFigure(
    "link_deflection", "Shape of the elastic links",
    "Deflection from the tangent at the root; where curves coincide, the shape hardly changes.",
    _links("deflection", 4, _shapes),
    "Deflection [m] along each elastic link from the tangent at its root, along y and z, at several instants.\n\n"
    "Of more than four links, those that bend most; a plane in which a link stays straight is left out. ``ax``: an "
    "axes for each link and plane, or None.",
    _NEEDS,
))  # fmt: skip


def _ends(data: Any, link: int, title: str) -> Iterator[Chart]:
    """One panel."""
    bent = data["deflection"].transpose("bending_link", "time", "s", "plane").values[link, :, -1]
    lines = tuple(Line(plane, "real", values) for plane, values in _planes(bent).items())
    yield Chart(title, f"End of {title}", "links", "m", data["time"].values, lines, "deflection")


register(ChartFigure(
    "link_tips", "Deflection of the links",
    "How far the end of each link leaves the tangent at its root, in both planes.",
    _links("deflection", 8, _ends),
    "Deflection of the end of each elastic link from its root's tangent [m], along y and z of its root.\n\n"
    "Of more than eight links, those that bend most. ``ax``: one axes for each link, or None.",
    _NEEDS,
))  # fmt: skip

_MOMENTS: tuple[str, ...] = ("torsion", "bending about y", "bending about z")


def _loads(data: Any, link: int, title: str) -> Iterator[Chart]:
    """Moments, and stress where it is known, else the size of the shear force."""
    s, times = data["s"].values, data["time"].values
    moments = data["moment"].transpose("bending_link", "time", "s", "moment_kind").values[link]
    worst = _worst(np.linalg.norm(moments[..., 1:], axis=-1))
    kinds = dict(zip(_MOMENTS, moments[worst].T, strict=True))
    lines = tuple(Line(kind, "real", kinds[kind]) for kind in moving(kinds))
    at = f"{title} at {times[worst]:.3g} s"
    yield Chart(f"{title} moments", at, "links", "N m", s, lines, abscissa="along")
    name, stressed = names_of(data, "bending_link")[link], names_of(data, "stressed_link")
    if name in stressed:
        values = data["stress"].transpose("stressed_link", "time", "s").values[stressed.index(name)]
    else:
        shear = data["shear_force"].transpose("bending_link", "time", "s", "plane").values[link]
        values = np.linalg.norm(shear, axis=-1)
    si, what = ("Pa", "stress") if name in stressed else ("N", "shear force")
    worst = _worst(values)
    yield Chart(
        f"{title} {what}", f"{what.capitalize()}, worst at {times[worst]:.3g} s", "links", si, s,
        (Line("when it is largest", "reference", values[worst]),), what, abscissa="along",
        band=(values.min(axis=0), values.max(axis=0)), zero=True,
    )  # fmt: skip


def _worst(values: Array) -> int:
    """The sample at which values (time, station) are largest."""
    return int(np.unravel_index(np.argmax(values), values.shape)[0])


register(ChartFigure(
    "link_loads", "Moments and stress along the links",
    "The section loads of each link when its bending moment is largest, from its root (0) to its tip (1); the band "
    "is the range over the run.",
    _links("moment", 6, _loads),
    "Left, moments [N m] along each link when its bending moment is largest; right, stress [Pa] or shear force [N].\n\n"
    "The band is the range over the run. Of more than six links, those with the largest moments. ``ax``: two axes for "
    "each link, or None.",
    _NEEDS,
))  # fmt: skip
