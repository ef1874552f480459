"""The force between a point of an arm and what it touches."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.style import COMPONENTS, INK, QUIET, REAL, REFERENCE, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result import Result

__all__ = ["arm_contact"]


@house_style()
def arm_contact(result: Result, ax: AxesLike = None) -> list[Axes]:
    """Force into the surface [N], real and reference; its components [N]; how deep the point is in the surface [m].

    ``ax``: three axes, or None.
    """
    data, time = result.data, result.data["time"].values
    axes = panels(ax, [["normal"], ["parts"], ["deep"]], 5.4, sharex=ax is None)
    curves = {"real": (data["contact_force_normal"].values, REAL)}
    if "contact_force_normal_reference" in data:
        curves["reference"] = (data["contact_force_normal_reference"].values, REFERENCE)
    _curves(axes[0], time, curves, "N", "force")
    parts = {f"$F_{axis}$": (data["contact_force"].sel(axis=axis).values, look)
             for axis, look in zip("xyz", COMPONENTS, strict=False)}  # fmt: skip
    _curves(axes[1], time, parts, "N", "force")
    _curves(axes[2], time, {"penetration": (data["penetration"].values, {"color": INK})}, "m", "depth")
    for panel in axes:
        time_axis(panel, time, label=panel is axes[-1])
        panel.axhline(0.0, color=QUIET, linewidth=0.5)
    shared_legend(axes[0])
    shared_legend(axes[1], place="lower left")
    letter(axes, ("Force into the surface", "Components, by the point on the surface", "Penetration"))
    return axes


def _curves(panel: Axes, time: Any, curves: dict[str, tuple[Any, Any]], si: str, words: str) -> None:
    unit = readable(si, *(values for values, _ in curves.values()))
    for label, (values, look) in curves.items():
        panel.plot(time, unit.of(values), label=label, **look)
    panel.set_ylabel(f"{words} [{unit.name}]")
