"""Figure 8 of the paper: the five elastic deformations, real and reference."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.style import REAL, REFERENCE, house_style
from tmodes.plot.units import Unit, readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["NAMES", "deformations"]

NAMES = {
    "th11q": (r"$\vartheta_{1,1q}$", "Mode 1, horizontal"),
    "th11m": (r"$\vartheta_{1,1m}$", "Mode 1, vertical"),
    "th12d": (r"$\vartheta_{1,2\delta}$", "Mode 2, horizontal"),
    "th12e": (r"$\vartheta_{1,2e}$", "Mode 2, vertical"),
    "xi": (r"$\xi$", "Gear"),
}
"""Symbol and place of each elastic angle, in the order of reading."""


@house_style()
def deformations(result: PaperResult, ax: AxesLike = None) -> list[Axes]:
    """The bending angles of both modes in both planes and the gear's deflection [rad], real and reference.

    ``ax``: five axes, or None.
    """
    axes = panels(ax, [["1q", "1m"], ["2d", "2e"], ["xi", "xi"]], 5.6)
    data = result.data
    unit = readable("rad", data["deformation"].values, data["deformation_reference"].values)
    for panel, name in zip(axes, NAMES, strict=True):
        _angle(panel, data, name, unit)
    shared_legend(axes[0])
    letter(axes, (place for _, place in NAMES.values()))
    return axes


def _angle(panel: Axes, data: Any, name: str, unit: Unit) -> None:
    time = data["time"].values
    panel.plot(time, unit.of(data["deformation"].sel(deformation_kind=name)), label="real", **REAL)
    panel.plot(time, unit.of(data["deformation_reference"].sel(deformation_kind=name)), label="reference", **REFERENCE)
    panel.set_ylabel(f"{NAMES[name][0]} [{unit.name}]")
    time_axis(panel, time)
