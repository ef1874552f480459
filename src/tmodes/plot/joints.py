"""The joints of an arm: what was wanted of each, where its motor went, where it went itself; and what that took."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.plot.facts import command_of, drive_unit, drives_by, effort_unit, largest, motor_of, plain, rows_height
from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.style import COMPONENTS, QUIET, REAL, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result import Result

__all__ = ["joint_efforts", "joint_tracking", "no_drives"]

_MOTOR, _WANTED = COMPONENTS[2], COMPONENTS[1]
_PLACES = ("position", "prescribed")


def no_drives(data: Any) -> str:
    """Why there is nothing of joints to draw; empty when there is."""
    return "" if "drive" in data.dims else "no joint of this arm can be driven"


@house_style()
def joint_tracking(result: Result, ax: AxesLike = None) -> list[Axes]:
    """Left, each joint with its motor and what is wanted of it [rad, m]; right, how far they are from that.

    Of a joint that is not told where to be, its rate is on the right. Of more than eight joints, those that move most.
    ``ax``: two axes for each joint, or None.
    """
    data = result.data
    names = _moving(data)
    layout = [[f"{k} left", f"{k} right"] for k in range(len(names))]
    axes = panels(ax, layout, rows_height(len(names)), sharex=ax is None)
    for k, name in enumerate(names):
        _position(axes[2 * k], data, name)
        _error(axes[2 * k + 1], data, name)
    _times(axes, data)
    _one_legend(axes)
    letter(axes, (title for name in names for title in (plain(name), _right_title(data, name))))
    return axes


def _moving(data: Any) -> list[str]:
    names = [str(name) for name in data["drive"].values]
    return largest(names, np.array([np.ptp(data["q"].sel(coordinate=name).values) for name in names]))


def _right_title(data: Any, name: str) -> str:
    return "less wanted" if command_of(data, name) in _PLACES else "rate"


def _position(panel: Axes, data: Any, name: str) -> None:
    time, curves = data["time"].values, _curves(data, name)
    unit = readable(drive_unit(data, name), *(values for values, _ in curves.values()))
    for label, (values, look) in curves.items():
        panel.plot(time, unit.of(values), label=label, **look)
    panel.set_ylabel(f"[{unit.name}]")


def _curves(data: Any, name: str) -> dict[str, tuple[Any, dict[str, Any]]]:
    found = {"joint": (data["q"].sel(coordinate=name).values, REAL)}
    if motor := motor_of(data, name):
        found["motor"] = (data["q"].sel(coordinate=motor).values, _MOTOR)
    if command_of(data, name) in _PLACES:
        found["wanted"] = (data["wanted"].sel(drive=name).values, _WANTED)
    return found


def _error(panel: Axes, data: Any, name: str) -> None:
    time, curves, kind = data["time"].values, _curves(data, name), drive_unit(data, name)
    if "wanted" in curves:
        wanted = curves.pop("wanted")[0]
        shown = {label: (values - wanted, look) for label, (values, look) in curves.items()}
    else:
        kind = f"{kind}/s"
        shown = {"joint": (data["v"].sel(coordinate=name).values, REAL)}
    unit = readable(kind, *(values for values, _ in shown.values()))
    for label, (values, look) in shown.items():
        panel.plot(time, unit.of(values), label=label, **look)
    panel.set_ylabel(f"[{unit.name}]")


@house_style()
def joint_efforts(result: Result, ax: AxesLike = None) -> list[Axes]:
    """Effort of each motor and torque of its gear [N m, N]; beside them the voltage [V], where there is any.

    Of more than eight joints, those with the largest efforts. ``ax``: one axes for each, or two with voltages.
    """
    data = result.data
    names = drives_by(data, "effort")
    electric = "voltage" in data
    layout = [[f"{k} left", f"{k} right"] if electric else [f"{k} left"] for k in range(len(names))]
    axes = panels(ax, layout, rows_height(len(names)), sharex=ax is None)
    columns = 2 if electric else 1
    for k, name in enumerate(names):
        _effort(axes[columns * k], data, name)
        if electric:
            _voltage(axes[columns * k + 1], data, name)
    _times(axes, data, columns)
    _one_legend(axes)
    titles = ((plain(name), "voltage") if electric else (plain(name),) for name in names)
    letter(axes, (title for group in titles for title in group))
    return axes


def _effort(panel: Axes, data: Any, name: str) -> None:
    time, effort = data["time"].values, data["effort"].sel(drive=name).values
    gear = data["gear_torque"].sel(drive=name).values
    unit = readable(effort_unit(data, name), effort, gear)
    panel.plot(time, unit.of(effort), label="motor", **REAL)
    if gear.any():
        panel.plot(time, unit.of(gear), label="gear", **COMPONENTS[1])
    panel.axhline(0.0, color=QUIET, linewidth=0.5)
    panel.set_ylabel(f"[{unit.name}]")


def _voltage(panel: Axes, data: Any, name: str) -> None:
    voltage = data["voltage"].sel(drive=name).values
    unit = readable("V", voltage)
    if not voltage.any():
        panel.text(0.5, 0.5, "none", ha="center", transform=panel.transAxes)
    panel.plot(data["time"].values, unit.of(voltage), color=COMPONENTS[3]["color"], linewidth=1.0)
    panel.axhline(0.0, color=QUIET, linewidth=0.5)
    panel.set_ylabel(f"[{unit.name}]")


def _times(axes: list[Axes], data: Any, last: int = 2) -> None:
    for k, panel in enumerate(axes):
        time_axis(panel, data["time"].values, label=k >= len(axes) - last)


def _one_legend(axes: list[Axes]) -> None:
    """The legend of the panel with most curves, for all."""
    shared_legend(max(axes, key=lambda panel: len(panel.get_legend_handles_labels()[1])))
