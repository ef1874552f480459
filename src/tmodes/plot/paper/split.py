"""The paper's split of Bernoulli's solution: y(x, t) = X(x) (T_st(t) + T_to(t))."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.paper.angles import NAMES
from tmodes.plot.style import COMPONENTS, QUIET, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["stationary_oscillatory"]


@house_style()
def stationary_oscillatory(result: PaperResult, ax: AxesLike = None) -> list[Axes]:
    """Each elastic angle [rad]: the whole with its stationary part (left), its oscillatory part (right).

    The stationary part is what gravity, the gross motion's inertia and contact would hold statically; at rest it is
    the sag. ``ax``: ten axes, row by row, or None.
    """
    layout = [[f"{name} left", f"{name} right"] for name in NAMES]
    axes = panels(ax, layout, 7.4, sharex=ax is None)
    for row, name in enumerate(NAMES):
        _stationary(axes[2 * row], result.data, name)
        _oscillatory(axes[2 * row + 1], result.data, name)
    for panel in axes[-2:]:
        time_axis(panel, result.data["time"].values)
    shared_legend(axes[0], axes[1])
    letter(axes, (place for _, place in NAMES.values() for _ in range(2)))
    return axes


def _stationary(panel: Axes, data: Any, name: str) -> None:
    whole = data["deformation"].sel(deformation_kind=name).values
    part = data["deformation_stationary"].sel(deformation_kind=name).values
    unit, time = readable("rad", whole, part), data["time"].values
    panel.plot(time, unit.of(whole), color=QUIET, linewidth=0.8, label="whole")
    panel.plot(time, unit.of(part), label="stationary $T_{st}$", **COMPONENTS[0])
    _finish(panel, name, unit.name, time)


def _oscillatory(panel: Axes, data: Any, name: str) -> None:
    part, time = data["deformation_oscillatory"].sel(deformation_kind=name).values, data["time"].values
    unit = readable("rad", part)
    panel.plot(time, unit.of(part), label="oscillatory $T_{to}$", color=COMPONENTS[1]["color"], linewidth=1.0)
    _finish(panel, name, unit.name, time)


def _finish(panel: Axes, name: str, unit: str, time: Any) -> None:
    panel.set_ylabel(f"{NAMES[name][0]} [{unit}]")
    time_axis(panel, time, label=False)
