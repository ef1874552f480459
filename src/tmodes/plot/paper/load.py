"""Bending moment and shear force along the link: how far they go over the run, and when the moment is largest."""

from __future__ import annotations

from itertools import pairwise, product
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend
from tmodes.plot.paper.facts import mode_lengths
from tmodes.plot.style import BAND, BLUE, QUIET, RED, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["bending_load", "largest_moment"]


class Quantity(NamedTuple):
    """What is drawn: the variable, its SI unit, its name in words, its letter."""

    name: str
    unit: str
    words: str
    symbol: str


QUANTITIES = (
    Quantity("bending_moment", "N m", "Bending moment", "M"),
    Quantity("shear_force", "N", "Shear force", "V"),
)
PLANES = ("horizontal", "vertical")


def largest_moment(data: Any) -> tuple[float, int, float]:
    """The largest bending moment [N m] of either plane, with its sample and its place along the arm [m]."""
    moment = data["bending_moment"].transpose("time", "mode", "plane", "s").values
    time, mode, plane, station = np.unravel_index(np.argmax(np.abs(moment)), moment.shape)
    lengths = mode_lengths(data)
    place = sum(lengths[:mode]) + lengths[mode] * float(data["s"][station])
    return float(moment[time, mode, plane, station]), int(time), place


@house_style()
def bending_load(result: PaperResult, ax: AxesLike = None) -> list[Axes]:
    """Bending moment [N m] and shear force [N] over the length of the arm [m]: the range over the run, and one instant.

    The instant is that of the largest moment. ``ax``: four axes (moment horizontal, vertical, shear horizontal,
    vertical), or None.
    """
    axes = panels(ax, [["mh", "mv"], ["sh", "sv"]], 4.4, sharex=ax is None)
    data = result.data
    _, sample, _ = largest_moment(data)
    for panel, (quantity, plane) in zip(axes, product(QUANTITIES, PLANES), strict=True):
        _along_the_arm(panel, data, quantity, plane, sample)
    for panel in axes[2:]:
        panel.set_xlabel("along the arm [m]")
    shared_legend(axes[0])
    letter(axes, (f"{quantity.words}, {plane}" for quantity, plane in product(QUANTITIES, PLANES)))
    return axes


def _along_the_arm(panel: Axes, data: Any, quantity: Quantity, plane: str, sample: int) -> None:
    values = data[quantity.name].sel(plane=plane).transpose("time", "mode", "s").values
    unit, ends = readable(quantity.unit, values), np.cumsum([0.0, *mode_lengths(data)])
    along = np.concatenate([start + (end - start) * data["s"].values for start, end in pairwise(ends)])
    curves = unit.of(values.reshape(len(values), -1))
    low, high, worst = curves.min(axis=0), curves.max(axis=0), curves[sample]
    instant = f"at {float(data['time'][sample]):.3f} s, when the moment is largest"
    panel.fill_between(along, low, high, facecolor=BAND, edgecolor=BLUE, linewidth=0.6, label="range over the run")
    panel.plot(along, worst, color=RED, linewidth=1.2, linestyle=(0, (5, 1.5)), label=instant)
    panel.axhline(0.0, color=QUIET, linewidth=0.6)
    for join in ends[1:-1]:
        panel.axvline(join, color=QUIET, linewidth=0.6, linestyle=(0, (2, 2)))
    panel.set_xlim(0.0, ends[-1])
    panel.set_ylabel(f"${quantity.symbol}$ [{unit.name}]")
