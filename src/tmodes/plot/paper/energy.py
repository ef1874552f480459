"""Energy: what is stored, what came in and went out, and how exactly the balance closes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.plot.panels import AxesLike, letter, panels, side_legend, time_axis
from tmodes.plot.style import COMPONENTS, INK, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["energies", "energy_panels"]

DECADES = 6
"""Where the residual changes its sign its logarithm has no floor; what lies further below the largest is cut off."""


@house_style()
def energies(result: PaperResult, ax: AxesLike = None) -> list[Axes]:
    """Energy by kind [J], work since the start by kind [J], and the size of the balance's residual [J], log scale.

    ``ax``: three axes, or None.
    """
    return energy_panels(result.data, ax, COMPONENTS, "motor: brought in; others: taken out", zeros=True)


def energy_panels(data: Any, ax: AxesLike, looks: Sequence[dict[str, Any]], works: str, *, zeros: bool) -> list[Axes]:
    """Three panels: energies, works (``works`` says which come in), residual.

    ``zeros``: kinds that are zero throughout are drawn too.
    """
    axes = panels(ax, [["energy"], ["work"], ["balance"]], 6.0, sharex=ax is None)
    for panel, name in zip(axes[:2], ("energy", "work"), strict=True):
        _kinds(panel, data, name, looks, zeros=zeros)
    _residual(axes[2], data)
    time_axis(axes[2], data["time"].values)
    letter(axes, ("Energy", f"Work since the start ({works})", "Residual, absolute"))
    return axes


def _kinds(panel: Axes, data: Any, name: str, looks: Sequence[dict[str, Any]], *, zeros: bool) -> None:
    kind = f"{name}_kind"
    time, unit = data["time"].values, readable("J", data[name].values)
    for label, look in zip(data[kind].values, looks, strict=False):
        values = data[name].sel({kind: label}).values
        if zeros or np.any(values):
            panel.plot(time, unit.of(values), label=str(label).replace("_", " "), **look)
    panel.set_ylabel(f"{name} [{unit.name}]")
    time_axis(panel, time, label=False)
    if panel.get_legend_handles_labels()[1]:
        side_legend(panel)
    else:
        panel.text(0.5, 0.5, "zero throughout", ha="center", transform=panel.transAxes)


def _residual(panel: Axes, data: Any) -> None:
    """A logarithm has no place for zero: exact zeros are left out, and told when there is nothing else."""
    residual = np.abs(data["energy_balance"].values)
    shown = residual > 0
    panel.set_ylabel("residual [J]")
    if not shown.any():
        panel.text(0.5, 0.5, "exactly zero throughout", ha="center", transform=panel.transAxes)
        return
    panel.plot(data["time"].values[shown], residual[shown], color=INK, linewidth=0.7)
    panel.set_yscale("log")
    panel.set_ylim(max(residual.max() * 10**-DECADES, residual[shown].min() / 2), residual.max() * 3)
