"""Figure 6 of the paper: the tip's coordinates, and how far it is from the reference."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.style import COMPONENTS, INK, REAL, REFERENCE, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["tip_tracking"]


@house_style()
def tip_tracking(result: PaperResult, ax: AxesLike = None) -> list[Axes]:
    """Tip x, y, z [m], real and reference, and the deviation from the reference [m]: total and components.

    ``ax``: four axes, or None. Returns the four axes.
    """
    axes = panels(ax, [["x", "y", "z"], ["deviation"] * 3], 4.4, height_ratios=[1, 1.25])
    data = result.data
    for panel, axis in zip(axes, "xyz", strict=False):
        _coordinate(panel, data, axis)
    _deviation(axes[3], data)
    shared_legend(axes[0])
    shared_legend(axes[3], place="lower left")
    letter(axes, ("Tip x", "Tip y", "Tip z", "Deviation, real less reference"))
    return axes


def _coordinate(panel: Axes, data: Any, axis: str) -> None:
    time = data["time"].values
    real, reference = data["tip"].sel(axis=axis).values, data["tip_reference"].sel(axis=axis).values
    unit = readable("m", real, reference)
    panel.plot(time, unit.of(real), label="real", **REAL)
    panel.plot(time, unit.of(reference), label="reference", **REFERENCE)
    panel.set_ylabel(f"{axis} [{unit.name}]")
    time_axis(panel, time)


def _deviation(panel: Axes, data: Any) -> None:
    time, total = data["time"].values, data["deviation"].values
    difference = data["tip"] - data["tip_reference"]
    unit = readable("m", total)
    panel.plot(time, unit.of(total), color=INK, linewidth=1.5, label="distance")
    for axis, look in zip("xyz", COMPONENTS, strict=False):
        panel.plot(time, unit.of(difference.sel(axis=axis)), label=f"Δ{axis}", **look)
    panel.set_ylabel(f"deviation [{unit.name}]")
    time_axis(panel, time)
