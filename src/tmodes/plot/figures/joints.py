"""The joints: tracking, efforts, states of controllers."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import (
    command_of,
    drive_unit,
    drives_by,
    effort_unit,
    largest,
    motor_of,
    names_of,
    part_title,
    plain,
    rows_height,
)
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, curves, last_times, letter, pairs, panels, widest_legend, zero_line
from tmodes.plot.ranges import common_unit
from tmodes.plot.style import COMPONENTS, REAL, REFERENCE

__all__ = ["ControllerStates", "JointEfforts", "JointTracking"]

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
        units = _position_units(data, names)
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


def _position_units(data: Any, names: list[str]) -> dict[str, Unit]:
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
        units, titles, row = _effort_units(data, names), [], iter(axes)
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


def _effort_units(data: Any, names: list[str]) -> dict[str, Unit]:
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


_MOST = 8


@register
class ControllerStates(Figure):
    """The first eight own states of the controllers, each in its unit. ``ax``: one axes for each."""

    name = "controller_states"
    title = "States of the controllers"
    caption = "What the controllers keep: integrals, estimates, and the commands that sampled controllers hold."
    needs: ClassVar = {"controller_states": "no controller of this robot has states of its own"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One row for each state."""
        data = result.data
        names = [str(name) for name in data["controller_state"].values[:_MOST]]
        axes = panels(ax, [[name] for name in names], rows_height(len(names)), sharex=ax is None)
        for panel, name in zip(axes, names, strict=True):
            one = data["controller_states"].sel(controller_state=name)
            held = {"drawstyle": "steps-post"} if name.endswith(".command") else {}
            si = str(one["controller_state_unit"].item()).replace("*", " ")
            curves(panel, data["time"].values, {"": (one.values, REAL | held)}, si)
            zero_line(panel)
        last_times(axes, data["time"].values, 1)
        letter(axes, [plain(name.replace(".controller.", ": ")) for name in names])
        return axes
