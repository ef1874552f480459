"""The joints: setpoint, motor position and joint position, and the tracking errors."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from tmodes.plot.facts import command_of, drive_unit, largest, motor_of, plain, rows_height
from tmodes.plot.figure import Figure
from tmodes.plot.panels import AxesLike, last_times, letter, panels, readable, widest_legend
from tmodes.plot.style import COMPONENTS, REAL

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["JointTracking"]

_MOTOR, _SETPOINT = COMPONENTS[2], COMPONENTS[1]
_POSITIONS = ("position", "prescribed")


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
        layout = [[f"{k} left", f"{k} right"] for k in range(len(names))]
        axes = panels(ax, layout, rows_height(len(names)), sharex=ax is None)
        for k, name in enumerate(names):
            _position(axes[2 * k], data, name)
            _error(axes[2 * k + 1], data, name)
        last_times(axes, data["time"].values, 2)
        widest_legend(axes)
        letter(axes, (title for name in names for title in (plain(name), _right_title(data, name))))
        return axes


def _moving(data: Any) -> list[str]:
    names = [str(name) for name in data["drive"].values]
    return largest(names, np.array([np.ptp(data["q"].sel(coordinate=name).values) for name in names]))


def _right_title(data: Any, name: str) -> str:
    return "tracking error" if command_of(data, name) in _POSITIONS else "rate"


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
    if command_of(data, name) in _POSITIONS:
        found["setpoint"] = (data["wanted"].sel(drive=name).values, _SETPOINT)
    return found


def _error(panel: Axes, data: Any, name: str) -> None:
    time, curves, kind = data["time"].values, _curves(data, name), drive_unit(data, name)
    if "setpoint" in curves:
        setpoint = curves.pop("setpoint")[0]
        shown = {label: (values - setpoint, look) for label, (values, look) in curves.items()}
    else:
        kind = f"{kind}/s"
        shown = {"joint": (data["v"].sel(coordinate=name).values, REAL)}
    unit = readable(kind, *(values for values, _ in shown.values()))
    for label, (values, look) in shown.items():
        panel.plot(time, unit.of(values), label=label, **look)
    panel.set_ylabel(f"[{unit.name}]")
