"""What the motion demands of the motors and gears: effort, gear torque, voltage, current."""

from __future__ import annotations

from typing import Any, ClassVar

from tmodes.plot.facts import drives_by, effort_unit, plain, rows_height
from tmodes.plot.figure import Figure
from tmodes.plot.panels import Axes, AxesLike, curves, last_times, letter, panels, widest_legend, zero_line
from tmodes.plot.style import COMPONENTS, REAL, REFERENCE

__all__ = ["JointEfforts"]

_ELECTRIC = (("voltage", "V", COMPONENTS[3]), ("current", "A", COMPONENTS[2]))
"""Series of electric motors, their units, and their looks."""


class JointEfforts(Figure):
    """Effort of each motor and torque of its gear [N m, N]; voltage [V] and current [A] of electric motors.

    Of more than eight joints, those with the largest efforts. ``ax``: one axes for each joint, or three with voltages.
    """

    name = "joint_efforts"
    title = "Motors and gears"
    caption = "The effort that the motion demands of each motor, and the torque that its gear transmits."
    needs: ClassVar = {"drive": "no joint of this robot can be driven"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One row for each joint."""
        data = result.data
        names = drives_by(data, "effort")
        electric = [one for one in _ELECTRIC if one[0] in data]
        columns = 1 + len(electric)
        layout = [[f"{k} {column}" for column in range(columns)] for k in range(len(names))]
        axes = panels(ax, layout, rows_height(len(names)), sharex=ax is None)
        titles = []
        for k, name in enumerate(names):
            row = axes[columns * k : columns * (k + 1)]
            _effort(row[0], data, name)
            for panel, one in zip(row[1:], electric, strict=True):
                _electric(panel, data, name, *one)
            titles += [plain(name), *(series for series, _, _ in electric)]
        last_times(axes, data["time"].values, columns)
        widest_legend(axes)
        letter(axes, titles)
        return axes


def _effort(panel: Axes, data: Any, name: str) -> None:
    time, effort = data["time"].values, data["effort"].sel(drive=name).values
    gear = data["gear_torque"].sel(drive=name).values
    shown = {"motor": (effort, REAL)}
    if gear.any():
        shown["gear"] = (gear, COMPONENTS[2])
        if "gear_torque_nominal" in data:
            shown["gear, nominal"] = (data["gear_torque_nominal"].sel(drive=name).values, REFERENCE)
    curves(panel, time, shown, effort_unit(data, name))
    zero_line(panel)


def _electric(panel: Axes, data: Any, name: str, series: str, si: str, look: dict[str, Any]) -> None:
    values = data[series].sel(drive=name).values
    if not values.any():
        panel.text(0.5, 0.6, "none", ha="center", transform=panel.transAxes)
    curves(panel, data["time"].values, {"": (values, {"color": look["color"], "linewidth": 1.0})}, si)
    zero_line(panel)
