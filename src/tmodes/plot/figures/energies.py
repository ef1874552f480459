"""Energy: what is stored, what was supplied and dissipated, and how well the balance closes."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.facts import names_of
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, curves, letter, panels, side_legend, time_axis
from tmodes.plot.ranges import common_unit, largest_shown
from tmodes.plot.style import COMPONENTS, INK, QUIET

__all__ = ["EnergiesFigure"]

LOOKS = (
    *COMPONENTS,
    {"color": INK, "linestyle": (0, (1, 1)), "linewidth": 1.1},
    {"color": QUIET, "linestyle": (0, (3, 1, 1, 1)), "linewidth": 1.1},
)

DECADES = 6
"""The residual is shown down to so many decades below its largest value: where it changes sign its log has no floor."""


ELASTIC = "elastic"
"""The kinds of energy that have their own axis begin with this."""

TINY = 0.005
"""Several kinds below this share of the largest are drawn as their sum."""

WORK = "Work since the start (motors, loads, base: supplied)"

Curves = dict[str, tuple[Any, dict[str, Any]]]


@register
class EnergiesFigure(Figure):
    """Energy by kind [J], that of springs on its own axis, work since the start [J], the residual of the balance [J].

    Kinds that are zero throughout are left out, several very small ones are added up. ``ax``: four axes, without
    elastic energy three, or None.
    """

    name = "energies"
    title = "Energy balance"
    caption = (
        "The residual (last, on a logarithmic axis) should stay many orders of magnitude below the energies and works; "
        "that "
        "of springs has its own axis. Work of motors, loads, and the base is supplied, that of others dissipated."
    )

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Energies, works, residual."""
        data = result.data
        energy, work = _kinds(data, "energy"), _kinds(data, "work")
        springs = {label: one for label, one in energy.items() if label.startswith(ELASTIC)}
        others = {label: one for label, one in energy.items() if label not in springs}
        shown = {"Energy": others, "Elastic energy": springs, WORK: work}
        shown = {title: one for title, one in shown.items() if one or title != "Elastic energy"}
        layout = [[title] for title in shown] + [["balance"]]
        axes = panels(ax, layout, 0.6 + 1.5 * len(layout), sharex=ax is None)
        unit = common_unit("J", *(values for one in shown.values() for values in _sizes(one)))
        for panel, title in zip(axes, shown, strict=False):
            _draw(panel, data["time"].values, shown[title], "work" if title == WORK else "energy", unit)
        _residual(axes[-1], data)
        time_axis(axes[-1], data["time"].values)
        letter(axes, (*shown, "Residual of the balance, absolute"))
        return axes


def _sizes(shown: Curves) -> list[Any]:
    """All values of a panel as one."""
    return [np.stack([values for values, _ in shown.values()])] if shown else []


def _kinds(data: Any, name: str) -> Curves:
    """The kinds of energy or work that are not zero throughout; those that a panel cannot tell from zero as one sum."""
    kind = f"{name}_kind"
    found = {label: data[name].sel({kind: label}).values for label in names_of(data, kind)}
    size = largest_shown(found.values())
    small = [label for label, values in found.items() if np.any(values) and largest_shown([values]) < TINY * size]
    small = [label for label in small if not label.startswith(ELASTIC)]
    looks = dict(zip(found, LOOKS, strict=False))
    shown = {
        _named(label): (values, looks[label])
        for label, values in found.items()
        if np.any(values) and (label not in small or len(small) == 1)
    }
    if len(small) > 1:
        names = ",\n".join(_named(label) for label in small)
        shown[f"{names}\n(sum)"] = (sum(found[label] for label in small), looks[small[0]])
    return shown


def _named(label: str) -> str:
    """A kind in words; the elastic energy of gears holds that of springs at joints."""
    return {"elastic_gear": "elastic joint"}.get(label, label.replace("_", " "))


def _draw(panel: Axes, time: Any, shown: Curves, what: str, unit: Unit) -> None:
    curves(panel, time, shown, "J", what, unit)
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
