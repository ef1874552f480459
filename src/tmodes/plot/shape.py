"""The shape of an arm at several instants: to scale, and with its deflection enlarged so that it can be seen."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend
from tmodes.plot.paper.shape import round_factor
from tmodes.plot.style import INSTANTS, QUIET, house_style
from tmodes.plot.tip import PLANES, views

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result import Result

__all__ = ["arm_shape"]

VISIBLE = 0.1
"""The largest deflection is drawn about this large, as a share of the arm's reach."""

_INSTANTS = 4
_SETTLED = 0.05
"""Share of the largest distance from the last place within which the arm is there."""

_TOUCHING = 1e-6
"""Distance of two links over the arm's reach below which nothing need join them."""

Array = NDArray[Any]


@house_style()
def arm_shape(result: Result, ax: AxesLike = None, *, exaggerate: float | None = None) -> list[Axes]:
    """The links at several instants [m]: left to scale, right with their deflection ``exaggerate`` times as large.

    The deflection is that from the arm without elasticity and with the same motor angles (thin, dashed). None chooses a
    round factor, which the title tells; where it is 1, there is no enlarged picture. From one side where the arm stays
    in a plane, else from two. ``ax``: one axes for each picture, or None.
    """
    data = result.data
    chosen = _instants(data)
    line, rigid = (data[name].transpose("time", "link", "s", "axis").values[chosen] for name in ("line", "line_rigid"))
    times = data["time"].values[chosen]
    factor = _factor(rigid, line) if exaggerate is None else exaggerate
    sides, factors = views(np.concatenate([rigid, line])), [1.0] if factor == 1 else [1.0, factor]
    layout = [["".join(pair) + str(k) for k in range(len(factors))] for pair in sides]
    axes = panels(ax, layout, 0.5 + 3.0 * len(sides))
    shown = [(pair, size) for pair in sides for size in factors]
    joins = _joins(data, rigid[0])
    for panel, (pair, size) in zip(axes, shown, strict=True):
        columns = ["xyz".index(name) for name in pair]
        _draw(panel, (rigid + size * (line - rigid))[..., columns], rigid[..., columns], times, joins)
        panel.set(xlabel=f"${pair[0]}$ [m]", ylabel=f"${pair[1]}$ [m]")
        panel.set_aspect("equal", adjustable="datalim")
        panel.locator_params(nbins=5)
    shared_legend(axes[0])
    letter(axes, (f"{PLANES[pair].capitalize()}, {_info(size)}" for pair, size in shown))
    return axes


def _info(factor: float) -> str:
    return "to scale" if factor == 1 else f"deflection × {factor:g}"


def _instants(data: Any) -> Array:
    """Samples evenly spread from the start until the links are, for good, near where they are at the end."""
    ends = data["line"].isel(s=-1).transpose("time", "link", "axis").values
    away = np.linalg.norm(ends - ends[-1], axis=-1).max(axis=1)
    moving = np.flatnonzero(away > _SETTLED * away.max()) if away.max() > 0 else np.zeros(1, dtype=int)
    last = min(int(moving[-1]) + 1, len(ends) - 1)
    return np.unique(np.linspace(0, last, _INSTANTS).round().astype(int))


def _factor(rigid: Array, bent: Array) -> float:
    largest = float(np.max(np.linalg.norm(bent - rigid, axis=-1)))
    reach = float(np.linalg.norm(np.ptp(rigid.reshape(-1, 3), axis=0)))
    return round_factor(VISIBLE * reach / largest) if largest > 0 else 1.0


def _joins(data: Any, rigid: Array) -> list[tuple[int, int, int]]:
    """Each link that stands off its parent: its index, its parent's, and the parent's station that is nearest to it."""
    names = [str(name) for name in data["link"].values]
    reach = float(np.linalg.norm(np.ptp(rigid.reshape(-1, 3), axis=0)))
    found = []
    for k, parent in enumerate(map(str, data["link_parent"].values)):
        if parent in names:
            distance = np.linalg.norm(rigid[names.index(parent)] - rigid[k, 0], axis=-1)
            if distance.min() > _TOUCHING * reach:
                found.append((k, names.index(parent), int(np.argmin(distance))))
    return found


def _draw(panel: Axes, bent: Array, rigid: Array, times: Array, joins: list[tuple[int, int, int]]) -> None:
    """Every link with a gap after it; what stands off its parent is joined to it by a thin line."""
    looks = [INSTANTS[k] for k in np.linspace(0, len(INSTANTS) - 1, len(times)).round().astype(int)]
    for curve, straight, look, time in zip(bent, rigid, looks, times, strict=True):
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
