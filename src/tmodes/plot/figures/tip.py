"""Pictures of the robot to scale: the path of its tip, the elastic line of its links."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.facts import instant_looks, instants, names_of
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import (
    Axes,
    AxesLike,
    letter,
    panels,
    readable,
    shared_legend,
)
from tmodes.plot.style import INK, QUIET, REAL, REFERENCE

__all__ = ["PLANES", "ElasticLine", "TipPath", "round_factor", "views"]

PLANES = {("x", "y"): "from above", ("x", "z"): "from the side", ("y", "z"): "from the front"}
"""Pairs of axes, and the direction of view in which they are seen."""

INK_PATH = {"color": INK, "linewidth": 0.9}

FLAT = 0.02
"""A robot that leaves a plane by less than this share of its reach is shown in that plane only."""


def views(points: Any) -> list[tuple[str, str]]:
    """The pairs of axes in which points (..., 3) are to be seen: one where they stay in a plane, else two."""
    extents = dict(zip("xyz", np.ptp(points.reshape(-1, 3), axis=0), strict=True))
    thin = min(extents, key=lambda name: extents[name])
    if extents[thin] <= FLAT * max(extents.values()):
        return [next(pair for pair in PLANES if thin not in pair)]
    widest = sorted(PLANES, key=lambda pair: -extents[pair[0]] * extents[pair[1]])[:2]
    return sorted(widest, key=list(PLANES).index)


@register
class TipPath(Figure):
    """Paths of the tip [m], actual and nominal, to scale, with the robot at the start and at the end (thin).

    From one side where the path stays in a plane, else from two; with a nominal path from one side, the deviation from
    it too. ``ax``: so many axes, or None.
    """

    name = "tip_path"
    title = "Path of the tip"
    caption = "The path from the round mark (start) to the square one (end), with the robot at both (thin)."

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each view."""
        data = result.data
        tip = data["tip"].transpose("time", "axis").values
        planned = data["tip_nominal"].transpose("time", "axis").values if "tip_nominal" in data else None
        chosen = views(tip if planned is None else np.concatenate([tip, planned]))
        alone = len(chosen) == 1 and planned is not None
        axes = panels(ax, [["".join(pair) for pair in chosen] + ["deviation"] * alone], 3.4)
        for panel, pair in zip(axes, chosen, strict=False):
            columns = ["xyz".index(name) for name in pair]
            _path(panel, tip[:, columns], "actual", REAL)
            if planned is not None:
                panel.plot(*planned[:, columns].T, label="nominal", **REFERENCE)
            for pose in _poses(data):
                panel.plot(*pose[:, columns].T, color=QUIET, linewidth=0.6, zorder=1)
            _scale(panel, pair, "")
        if alone:
            _deviation(axes[-1], tip - planned, chosen[0])
        shared_legend(axes[0])
        titles = [f"Path of the tip, {PLANES[pair]}" for pair in chosen]
        letter(axes, [*titles, *(["Error from nominal path"] if alone else [])])
        return axes


def _path(panel: Axes, points: Any, label: str, look: dict[str, Any]) -> None:
    """A path with its start and its end."""
    panel.plot(*points.T, label=label, **look)
    panel.plot(*points[0], "o", color=INK, markersize=4, label="start")
    panel.plot(*points[-1], "s", color=INK, markersize=4, label="end")


def _scale(panel: Axes, pair: tuple[str, str], before: str, unit: str = "m") -> None:
    panel.set(xlabel=f"{before}${pair[0]}$ [{unit}]", ylabel=f"{before}${pair[1]}$ [{unit}]")
    panel.set_aspect("equal", adjustable="datalim")
    panel.locator_params(nbins=5)
    panel.margins(0.08)


def _deviation(panel: Axes, difference: Any, pair: tuple[str, str]) -> None:
    """The deviation [m] from the nominal path, seen from the same side."""
    points = difference[:, ["xyz".index(name) for name in pair]]
    unit = readable("m", points)
    _path(panel, unit.of(points), "", INK_PATH)
    _scale(panel, pair, "Δ", unit.name)


def _poses(data: Any) -> list[Any]:
    """The robot at the first and the last sample: the points of its links, one after the other."""
    if "line" not in data:
        return []
    lines = data["line"].transpose("time", "link", "s", "axis").values
    return [lines[k].reshape(-1, 3) for k in (0, -1)] if len(lines) > 1 else []


VISIBLE = 0.1
"""The largest deflection or deviation is drawn about this large, as a share of the robot's reach."""

WIDE, HEIGHTS = 5.4, (1.2, 3.2)
"""Width that the panels of a row share, and the least and most height of one [in]."""

_INSTANTS = 4
_TOUCHING = 1e-6
"""Distance of two links over the robot's reach below which nothing need join them."""

Array = NDArray[Any]


def round_factor(wanted: float) -> float:
    """The largest of 1, 2, 5, 10, 20, 50, ... that is not above ``wanted``; never below 1."""
    if not 1.0 < wanted < 1e12:
        return 1.0
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(max(step * power for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9)))


@register
class ElasticLine(Figure):
    """The links at several instants [m]: left to scale, right with their deflection ``exaggerate`` times as large.

    The deflection is that from the robot without elasticity at the same motor angles (thin, dashed). None chooses a
    round factor, which the title states; where it is 1, there is no magnified picture. From one side where the robot
    stays in a plane, else from two. ``ax``: one axes for each picture, or None.
    """

    name = "elastic_line"
    title = "The elastic line"
    caption = (
        "The links at several instants, and the robot without elasticity at the same motor angles (thin, dashed); the "
        "titles state how much the deflection is magnified."
    )
    needs: ClassVar = {"line": "no link of this robot has a length"}

    def draw(self, result: Any, ax: AxesLike = None, *, exaggerate: float | None = None) -> list[Axes]:
        """One or two panels for each view."""
        data = result.data
        chosen = instants(data, _INSTANTS)
        dims = ("time", "link", "s", "axis")
        line, rigid = (data[name].transpose(*dims).values[chosen] for name in ("line", "line_rigid"))
        factor = _factor(rigid, line) if exaggerate is None else exaggerate
        shown = _pictures(rigid, line, factor)
        axes = panels(ax, *_layout(rigid + factor * (line - rigid), shown))
        joins = _joins(data, rigid[0])
        for panel, (pair, size) in zip(axes, shown, strict=True):
            columns = ["xyz".index(name) for name in pair]
            magnified = (rigid + size * (line - rigid))[..., columns]
            _draw(panel, magnified, rigid[..., columns], data["time"].values[chosen], joins)
            panel.set(xlabel=f"${pair[0]}$ [m]", ylabel=f"${pair[1]}$ [m]")
            panel.set_aspect("equal", adjustable="datalim")
            panel.locator_params(nbins=5)
        shared_legend(axes[0])
        letter(axes, (f"{PLANES[pair].capitalize()}, {_scale_name(size)}" for pair, size in shown))
        return axes


def _pictures(rigid: Array, line: Array, factor: float) -> list[tuple[tuple[str, str], float]]:
    """Sides and enlargements: to scale those that the motion needs, magnified those that the deflection needs too."""
    plain_sides = views(np.concatenate([rigid, line]))
    if factor == 1:
        return [(pair, 1.0) for pair in plain_sides]
    more = views(np.concatenate([rigid, rigid + factor * (line - rigid)])) if len(plain_sides) == 1 else []
    sides = dict.fromkeys([*plain_sides, *more])
    return [(pair, size) for pair in sides for size in (1.0, factor) if size != 1 or pair in plain_sides]


def _layout(points: Array, shown: list[tuple[tuple[str, str], float]]) -> tuple[list[list[str]], float]:
    """A row for each side, as high as what is seen from there needs, and the height of the figure [in]."""
    rows = {pair: [f"{''.join(pair)} {size:g}" for other, size in shown if other == pair] for pair, _ in shown}
    extents = dict(zip("xyz", np.ptp(points.reshape(-1, 3), axis=0), strict=True))
    height = 0.6
    for (across, up), row in rows.items():
        share = extents[up] / (extents[across] or 1.0)
        height += 0.6 + float(np.clip(share * WIDE / len(row), *HEIGHTS))
    return [row if len(row) == 2 else row * 2 for row in rows.values()], height


def _scale_name(factor: float) -> str:
    return "to scale" if factor == 1 else f"deflection × {factor:g}"


def _factor(rigid: Array, bent: Array) -> float:
    largest = float(np.max(np.linalg.norm(bent - rigid, axis=-1)))
    reach = float(np.linalg.norm(np.ptp(rigid.reshape(-1, 3), axis=0)))
    return round_factor(VISIBLE * reach / largest) if largest > 0 else 1.0


def _joins(data: Any, rigid: Array) -> list[tuple[int, int, int]]:
    """Each link that starts away from its parent: its index, its parent's, and the nearest station of the parent."""
    names = names_of(data, "link")
    reach = float(np.linalg.norm(np.ptp(rigid.reshape(-1, 3), axis=0)))
    found = []
    for k, parent in enumerate(map(str, data["link_parent"].values)):
        if parent in names:
            distance = np.linalg.norm(rigid[names.index(parent)] - rigid[k, 0], axis=-1)
            if distance.min() > _TOUCHING * reach:
                found.append((k, names.index(parent), int(np.argmin(distance))))
    return found


def _draw(panel: Axes, bent: Array, rigid: Array, times: Array, joins: list[tuple[int, int, int]]) -> None:
    """Every link with a gap after it; one that starts away from its parent is joined to it by a thin line."""
    for curve, straight, look, time in zip(bent, rigid, instant_looks(len(times)), times, strict=True):
        panel.plot(*_parted(straight).T, color=QUIET, linewidth=0.5, linestyle=(0, (4, 3)))
        for link, parent, station in joins:
            panel.plot(*np.stack([curve[parent, station], curve[link, 0]]).T, color=look["color"], linewidth=0.7)
        panel.plot(*_parted(curve).T, label=f"{time:.3g} s", **look)
        panel.plot(*curve[:, 0].T, "o", markersize=1.8, color=look["color"])
        panel.plot(*curve[-1, -1], "o", markersize=3.5, color=look["color"])
    panel.margins(0.06)


def _parted(links: Array) -> Array:
    gap = np.full((len(links), 1, links.shape[2]), np.nan)
    return np.concatenate([links, gap], axis=1).reshape(-1, links.shape[2])
