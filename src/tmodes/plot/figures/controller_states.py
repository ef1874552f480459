"""The own states of the controllers: integrals, estimates, and the commands that sampled ones hold."""

from __future__ import annotations

from typing import Any, ClassVar

from tmodes.plot.facts import plain, rows_height
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, curves, last_times, letter, panels, zero_line
from tmodes.plot.style import REAL

__all__ = ["ControllerStates"]

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
