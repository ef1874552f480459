"""The drive: what the motor is given, what it takes, and what the gear passes on."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.style import REAL, REFERENCE, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["drive"]

ROWS = (("voltage", "Voltage", "$u$"), ("current", "Current", "$i$"), ("gear_torque", "Gear torque", r"$\varsigma$"))


@house_style()
def drive(result: PaperResult, ax: AxesLike = None) -> list[Axes]:
    """Motor voltage [V], current [A] and gear torque [N m], the torque beside its reference. ``ax``: three axes."""
    axes = panels(ax, [[name] for name, _, _ in ROWS], 4.8, sharex=ax is None)
    data = result.data
    time = data["time"].values
    for panel, (name, _, symbol) in zip(axes, ROWS, strict=True):
        curves = [data[part].values for part in (name, f"{name}_reference") if part in data]
        unit = readable(data[name].attrs["units"], *curves)
        for values, label, look in zip(curves, ("real", "reference"), (REAL, REFERENCE), strict=False):
            panel.plot(time, unit.of(values), label=label, **look)
        panel.set_ylabel(f"{symbol} [{unit.name}]")
        time_axis(panel, time, label=panel is axes[-1])
    shared_legend(axes[2])
    letter(axes, (words for _, words, _ in ROWS))
    return axes
