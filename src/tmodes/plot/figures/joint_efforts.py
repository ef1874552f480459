"""What the motion demands of the motors and gears: effort, gear torque, voltage, current."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import drives_by, effort_unit, part_title, plain, rows_height
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, curves, last_times, letter, panels, widest_legend, zero_line
from tmodes.plot.ranges import common_unit
from tmodes.plot.style import COMPONENTS, REAL, REFERENCE

__all__ = ["JointEfforts"]

_ELECTRIC = (("voltage", "V", COMPONENTS[3]), ("current", "A", COMPONENTS[2]))
"""Series of electric motors, their units, and their looks."""


@register
class JointEfforts(Figure):
    """Effort of each motor and torque of its gear [N m, N]; voltage [V] and current [A] of electric motors.

    Of more than eight joints, those with the largest efforts. ``ax``: one axes for each joint, three for one with an
    electric motor, or None.
    """

    name = "joint_efforts"
    title = "Motors and gears"
    caption = "The effort that the motion demands of each motor, and the torque that its gear transmits."
    needs: ClassVar = {"drive": "no joint of this robot can be driven"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One row for each joint."""
        data = result.data
        names = drives_by(data, "effort")
        shown = {name: _electric_of(data, name) for name in names}
        axes = panels(ax, _layout(shown), rows_height(len(names)), sharex=ax is None)
        units, titles, row = _units(data, names), [], iter(axes)
        for name, electric in shown.items():
            _effort(next(row), data, name, units[effort_unit(data, name)])
            for one in electric:
                _electric(next(row), data, name, *one)
            titles += [plain(name), *(part_title(name, series, names, 20) for series, _, _ in electric)]
        last_times(axes, data["time"].values, 1 + len(shown[names[-1]]))
        widest_legend(axes)
        letter(axes, titles)
        return axes


def _electric_of(data: Any, name: str) -> list[tuple[str, str, dict[str, Any]]]:
    """The series of a joint's electric motor; none where it has no such motor."""
    return [one for one in _ELECTRIC if one[0] in data and data[one[0]].sel(drive=name).values.any()]


def _layout(shown: dict[str, list[Any]]) -> list[list[str]]:
    """A row for each joint, of equal width whether it has one, two, or three panels."""
    rows = [[f"{name} {k}" for k in range(1 + len(electric))] for name, electric in shown.items()]
    width = math.lcm(*map(len, rows))
    return [[place for place in row for _ in range(width // len(row))] for row in rows]


def _units(data: Any, names: list[str]) -> dict[str, Unit]:
    """One unit for all torques, and one for all forces."""
    kinds: dict[str, list[Any]] = {}
    for name in names:
        series = (data[key].sel(drive=name).values for key in ("effort", "gear_torque"))
        kinds.setdefault(effort_unit(data, name), []).append(np.stack(list(series)))
    return {si: common_unit(si, *values) for si, values in kinds.items()}


def _effort(panel: Axes, data: Any, name: str, unit: Unit) -> None:
    time, effort = data["time"].values, data["effort"].sel(drive=name).values
    gear = data["gear_torque"].sel(drive=name).values
    shown = {"motor": (effort, REAL)}
    if gear.any():
        shown["gear"] = (gear, COMPONENTS[2])
        if "gear_torque_nominal" in data:
            shown["gear, nominal"] = (data["gear_torque_nominal"].sel(drive=name).values, REFERENCE)
    curves(panel, time, shown, effort_unit(data, name), unit=unit)
    zero_line(panel)


def _electric(panel: Axes, data: Any, name: str, series: str, si: str, look: dict[str, Any]) -> None:
    values = data[series].sel(drive=name).values
    curves(panel, data["time"].values, {"": (values, {"color": look["color"], "linewidth": 1.0})}, si)
    zero_line(panel)
