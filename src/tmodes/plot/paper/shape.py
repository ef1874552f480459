"""The elastic line: the shape of the arm at several instants, in space and against each mode's chord."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend
from tmodes.plot.paper.facts import mode_lengths, move_duration
from tmodes.plot.style import INSTANTS, QUIET, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["elastic_line", "instants", "mode_deflection", "round_factor"]

VISIBLE = 0.12
"""The largest deflection is drawn about this large, as a share of the arm's length."""

Array = NDArray[Any]


def instants(data: Any, most: int = len(INSTANTS)) -> Array:
    """Indices of at most ``most`` samples, evenly spread from the start to the end of the move (or of the run)."""
    last = max(int(np.searchsorted(data["time"].values, move_duration(data) * (1 + 1e-9), side="right")) - 1, 0)
    return np.unique(np.linspace(0, last, most).round().astype(int))


def round_factor(wanted: float) -> float:
    """The largest of 1, 2, 5, 10, 20, 50, ... that is not above ``wanted``; never below 1."""
    if not 1.0 < wanted < 1e12:
        return 1.0
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(max(step * power for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9)))


@house_style()
def elastic_line(result: PaperResult, ax: AxesLike = None, *, exaggerate: float | None = None) -> list[Axes]:
    """The arm from above (x, y) [m] and from the side (distance from the axis [m], z) at several instants.

    From above, what the line deviates from the rigid arm at the same motor angle is drawn ``exaggerate`` times as
    large, and the title tells it; None chooses a round factor, 1 is to scale. From the side, z has its own scale.
    ``ax``: two axes, or None.
    """
    axes = panels(ax, [["above", "side"]], 3.4)
    data = result.data
    chosen = instants(data)
    line, rigid, times = _line(data, chosen), _rigid(data, chosen), data["time"].values[chosen]
    factor = _factor(rigid[..., :2], line[..., :2]) if exaggerate is None else exaggerate
    _draw(axes[0], rigid[..., :2] + factor * (line - rigid)[..., :2], rigid[..., :2], times)
    axes[0].set_aspect("equal", adjustable="datalim")
    axes[0].set(xlabel="$x$ [m]", ylabel="$y$ [m]")
    unit = readable("m", line[..., 2])
    scale = np.array([1.0, unit.factor])
    _draw(axes[1], _side(line) * scale, _side(rigid) * scale, times)
    axes[1].set(xlabel="distance from the axis [m]", ylabel=f"$z$ [{unit.name}]")
    shared_legend(axes[0], place="lower left")
    info = "to scale" if factor == 1 else f"deviation × {factor:g}"
    letter(axes, (f"From above, {info}", "From the side, $z$ stretched"))
    return axes


@house_style()
def mode_deflection(result: PaperResult, ax: AxesLike = None) -> list[Axes]:
    """Deflection y(x) [m] of each mode against its root's tangent, in both planes, at several instants.

    ``ax``: four axes (mode 1 horizontal, vertical, mode 2 horizontal, vertical), or None.
    """
    shown = list(product(("mode1", "mode2"), ("horizontal", "vertical")))
    names = [f"{mode} {plane}" for mode, plane in shown]
    axes = panels(ax, [names[:2], names[2:]], 4.2)
    data = result.data
    chosen = instants(data)
    for panel, (mode, plane) in zip(axes, shown, strict=True):
        curves = data["deflection"].sel(mode=mode, plane=plane).values[chosen]
        along = data["s"].values * mode_lengths(data)[int(mode[-1]) - 1]
        unit, unit_along = readable("m", curves), readable("m", along)
        for curve, look, time in zip(curves, _looks(len(chosen)), data["time"].values[chosen], strict=True):
            panel.plot(unit_along.of(along), unit.of(curve), label=f"{time:.3g} s", **look)
        panel.set_ylabel(f"deflection $y$ [{unit.name}]")
        panel.set_xlabel(f"along the mode $x$ [{unit_along.name}]")
    shared_legend(axes[0])
    letter(axes, (f"Mode {mode[-1]}, {plane}" for mode, plane in shown))
    return axes


def _line(data: Any, chosen: Array) -> Array:
    line = data["line"].transpose("time", "mode", "s", "axis").values[chosen]
    return line.reshape(len(chosen), -1, 3)


def _rigid(data: Any, chosen: Array) -> Array:
    """The arm as it would lie without any elasticity, at the motor's angle, shape (instants, points, 3)."""
    lengths, s = mode_lengths(data), data["s"].values
    ends = np.concatenate([[0.0], np.cumsum(lengths)])
    along = np.concatenate([start + length * s for start, length in zip(ends, lengths, strict=False)])
    theta = data["q"].sel(coordinate="theta").values[chosen]
    direction = np.stack([np.cos(theta), np.sin(theta), np.zeros_like(theta)], axis=-1)
    return direction[:, None, :] * along[None, :, None]


def _side(points: Array) -> Array:
    return np.stack([np.hypot(points[..., 0], points[..., 1]), points[..., 2]], axis=-1)


def _factor(rigid: Array, bent: Array) -> float:
    largest = float(np.max(np.linalg.norm(bent - rigid, axis=-1)))
    reach = float(np.max(np.linalg.norm(rigid, axis=-1)))
    return round_factor(VISIBLE * reach / largest) if largest > 0 else 1.0


def _looks(count: int) -> list[dict[str, Any]]:
    return [INSTANTS[index] for index in np.linspace(0, len(INSTANTS) - 1, count).round().astype(int)]


def _draw(panel: Axes, bent: Array, rigid: Array, times: Array) -> None:
    for curve, straight, look, time in zip(bent, rigid, _looks(len(times)), times, strict=True):
        panel.plot(*straight.T, color=QUIET, linewidth=0.5, linestyle=(0, (4, 3)))
        panel.plot(*curve.T, label=f"{time:.3g} s", **look)
        panel.plot(*curve[-1], marker="o", markersize=3, color=look["color"])
    panel.margins(0.05)
