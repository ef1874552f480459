"""The own states of the controllers: integrals, estimates, and the commands that sampled ones hold."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from tmodes.plot.facts import plain, rows_height
from tmodes.plot.figure import Figure
from tmodes.plot.panels import AxesLike, last_times, letter, panels, readable
from tmodes.plot.style import QUIET, REAL

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["ControllerStates"]

_MOST = 8


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
            unit = readable(str(one["controller_state_unit"].item()).replace("*", " "), one.values)
            held: dict[str, Any] = {"drawstyle": "steps-post"} if name.endswith(".command") else {}
            panel.plot(data["time"].values, unit.of(one.values), **REAL, **held)
            panel.axhline(0.0, color=QUIET, linewidth=0.5)
            panel.set_ylabel(f"[{unit.name}]")
        last_times(axes, data["time"].values, 1)
        letter(axes, [plain(name.replace(".controller.", ": ")) for name in names])
        return axes
