"""Energy: what is stored, what was supplied and dissipated, and how well the balance closes."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.facts import names_of
from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, curves, letter, panels, side_legend, time_axis
from tmodes.plot.style import COMPONENTS, INK, QUIET

__all__ = ["Energies"]

LOOKS = (
    *COMPONENTS,
    {"color": INK, "linestyle": (0, (1, 1)), "linewidth": 1.1},
    {"color": QUIET, "linestyle": (0, (3, 1, 1, 1)), "linewidth": 1.1},
)

DECADES = 6
"""The residual is shown down to so many decades below its largest value: where it changes sign its log has no floor."""


class Energies(Figure):
    """Energy by kind [J], work since the start by kind [J], and the size of the balance's residual [J], log scale.

    Kinds that are zero throughout are left out. ``ax``: three axes, or None.
    """

    name = "energies"
    title = "Energy balance"
    caption = "The residual (c) should stay many orders of magnitude below the energies (a) and works (b)."

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Energies, works, residual."""
        data = result.data
        axes = panels(ax, [["energy"], ["work"], ["balance"]], 6.0, sharex=ax is None)
        for panel, name in zip(axes[:2], ("energy", "work"), strict=True):
            _kinds(panel, data, name)
        _residual(axes[2], data)
        time_axis(axes[2], data["time"].values)
        work = "Work since the start (motors, loads, base: supplied; others: dissipated)"
        letter(axes, ("Energy", work, "Residual of the balance, absolute"))
        return axes


def _kinds(panel: Axes, data: Any, name: str) -> None:
    kind = f"{name}_kind"
    found = {label: data[name].sel({kind: label}).values for label in names_of(data, kind)}
    shown = {
        label.replace("_", " "): (values, look)
        for (label, values), look in zip(found.items(), LOOKS, strict=False)
        if np.any(values)
    }
    time = data["time"].values
    curves(panel, time, shown, "J", name)
    time_axis(panel, time, label=False)
    if shown:
        side_legend(panel)
    else:
        panel.plot(time, np.zeros(len(time)), color=QUIET, linewidth=0.5)
        panel.text(0.5, 0.6, "zero throughout", ha="center", transform=panel.transAxes)


def _residual(panel: Axes, data: Any) -> None:
    """A logarithm has no place for zero: exact zeros are left out, with a note where there is nothing else."""
    residual = np.abs(data["energy_balance"].values)
    shown = residual > 0
    panel.set_ylabel("residual [J]")
    if not shown.any():
        panel.plot(data["time"].values, residual, color=INK, linewidth=0.7)
        panel.text(0.5, 0.6, "exactly zero throughout", ha="center", transform=panel.transAxes)
        return
    panel.plot(data["time"].values[shown], residual[shown], color=INK, linewidth=0.7)
    panel.set_yscale("log")
    panel.set_ylim(max(residual.max() * 10**-DECADES, residual[shown].min() / 2), residual.max() * 3)
