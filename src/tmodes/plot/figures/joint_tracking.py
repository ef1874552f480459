"""The joints: setpoint, motor position and joint position, and the tracking errors."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import command_of, drive_unit, largest, motor_of, names_of, part_title, plain, rows_height
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, curves, last_times, letter, pairs, panels, widest_legend
from tmodes.plot.ranges import common_unit
from tmodes.plot.style import COMPONENTS, REAL

__all__ = ["JointTracking"]

_MOTOR, _SETPOINT = COMPONENTS[2], COMPONENTS[1]
_POSITIONS = ("position", "prescribed")


@register
class JointTracking(Figure):
    """Left, each joint with its motor and its setpoint [rad, m]; right, their tracking errors.

    Of a joint without a position setpoint, its rate is on the right. Of more than eight joints, those that move most.
    ``ax``: two axes for each joint, or None.
    """

    name = "joint_tracking"
    title = "Joints"
    caption = "Left, the position of each joint and of its motor; right, on its own scale, the tracking error."
    needs: ClassVar = {"drive": "no joint of this robot can be driven"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Two panels for each joint."""
        data = result.data
        names = _moving(data)
        layout = pairs(len(names))
        axes = panels(ax, layout, rows_height(len(names)), sharex=ax is None)
        units = _units(data, names)
        for k, name in enumerate(names):
            unit, si = units[drive_unit(data, name)], drive_unit(data, name)
            curves(axes[2 * k], data["time"].values, _positions(data, name), si, unit=unit)
            _right(axes[2 * k + 1], data, name, unit)
        last_times(axes, data["time"].values, 2)
        widest_legend(axes)
        letter(
            axes,
            (title for name in names for title in (plain(name), part_title(name, _right_title(data, name), names))),
        )
        return axes


def _moving(data: Any) -> list[str]:
    names = names_of(data, "drive")
    return largest(names, np.array([np.ptp(data["q"].sel(coordinate=name).values) for name in names]))


def _right_title(data: Any, name: str) -> str:
    return "tracking error" if command_of(data, name) in _POSITIONS else "rate"


def _positions(data: Any, name: str) -> dict[str, tuple[Any, dict[str, Any]]]:
    found = {"joint": (data["q"].sel(coordinate=name).values, REAL)}
    if motor := motor_of(data, name):
        found["motor"] = (data["q"].sel(coordinate=motor).values, _MOTOR)
    if command_of(data, name) in _POSITIONS:
        found["setpoint"] = (data["wanted"].sel(drive=name).values, _SETPOINT)
    return found


def _units(data: Any, names: list[str]) -> dict[str, Unit]:
    """One unit for all angles and their errors, and one for all displacements."""
    kinds: dict[str, list[Any]] = {}
    for name in names:
        for shown in (_positions(data, name), _errors(data, name)):
            values = np.stack([values for values, _ in shown.values()] or [np.zeros(1)])
            kinds.setdefault(drive_unit(data, name), []).append(values)
    return {si: common_unit(si, *values) for si, values in kinds.items()}


def _errors(data: Any, name: str) -> dict[str, tuple[Any, dict[str, Any]]]:
    """The positions less their setpoint; none where there is no setpoint."""
    shown = _positions(data, name)
    setpoint = shown.pop("setpoint", None)
    return {label: (values - setpoint[0], look) for label, (values, look) in shown.items()} if setpoint else {}


def _right(panel: Axes, data: Any, name: str, unit: Unit) -> None:
    time, si = data["time"].values, drive_unit(data, name)
    if errors := _errors(data, name):
        curves(panel, time, errors, si, "error", unit)
    else:
        curves(panel, time, {"joint": (data["v"].sel(coordinate=name).values, REAL)}, f"{si}/s")
