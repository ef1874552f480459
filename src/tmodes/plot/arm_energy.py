"""Energy of an arm: what is stored, what came in and went out, and how exactly the balance closes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.plot.energy import draw_residual
from tmodes.plot.panels import AxesLike, letter, panels, side_legend, time_axis
from tmodes.plot.style import COMPONENTS, INK, QUIET, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.arm_result import ArmResult

__all__ = ["arm_energies"]

LOOKS = (
    *COMPONENTS,
    {"color": INK, "linestyle": (0, (1, 1)), "linewidth": 1.1},
    {"color": QUIET, "linestyle": (0, (3, 1, 1, 1)), "linewidth": 1.1},
)


@house_style()
def arm_energies(result: ArmResult, ax: AxesLike = None) -> list[Axes]:
    """Energy by kind [J], work since the start by kind [J], and the size of the balance's residual [J], log scale.

    Kinds that are zero throughout are left out. ``ax``: three axes, or None.
    """
    axes = panels(ax, [["energy"], ["work"], ["balance"]], 6.0, sharex=ax is None)
    data = result.data
    _kinds(axes[0], data, "energy", "energy_kind")
    _kinds(axes[1], data, "work", "work_kind")
    draw_residual(axes[2], data)
    time_axis(axes[2], data["time"].values)
    titles = (
        "Energy",
        "Work since the start (motor, loads, base: in; others: out)",
        "Residual, absolute",
    )
    letter(axes, titles)
    return axes


def _kinds(panel: Axes, data: Any, name: str, kind: str) -> None:
    time, unit = data["time"].values, readable("J", data[name].values)
    for label, look in zip(data[kind].values, LOOKS, strict=False):
        values = data[name].sel({kind: label}).values
        if np.any(values):
            panel.plot(time, unit.of(values), label=str(label).replace("_", " "), **look)
    panel.set_ylabel(f"{name} [{unit.name}]")
    time_axis(panel, time, label=False)
    if panel.get_legend_handles_labels()[1]:
        side_legend(panel)
    else:
        panel.text(0.5, 0.5, "zero throughout", ha="center", transform=panel.transAxes)
