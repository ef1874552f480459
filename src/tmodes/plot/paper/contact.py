"""Figure 7 of the paper: the force between the tip and its environment."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.errors import InputError
from tmodes.plot.panels import AxesLike, letter, panels, shared_legend, time_axis
from tmodes.plot.style import COMPONENTS, REAL, REFERENCE, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["contact_force", "no_contact_force"]

NEARLY_CONSTANT = 0.05
"""A force that varies by less than this share of its largest value is told to be nearly constant."""


def no_contact_force(data: Any) -> str:
    """Why there is nothing to draw; empty when there is."""
    return "" if "contact_force" in data else "the tip moved in free space: there is no contact force"


@house_style()
def contact_force(result: PaperResult, ax: AxesLike = None) -> list[Axes]:
    """Radial force [N], real and reference, on an axis from zero and in close-up; and the force's components [N].

    ``ax``: three axes, or None. Raises :class:`tmodes.errors.InputError` for a run in free space.
    """
    data = result.data
    if reason := no_contact_force(data):
        raise InputError("contact_force", reason, "a run in contact", "leave this figure out, or set contact: true")
    axes = panels(ax, [["whole", "close"], ["parts", "parts"]], 4.4)
    real, reference = data["contact_force_radial"].values, data["contact_force_radial_reference"].values
    unit = readable("N", real, reference)
    for panel in axes[:2]:
        panel.plot(data["time"].values, unit.of(real), label="real", **REAL)
        panel.plot(data["time"].values, unit.of(reference), label="reference", **REFERENCE)
        panel.set_ylabel(f"radial force [{unit.name}]")
        time_axis(panel, data["time"].values)
    _from_zero(axes[0])
    axes[0].text(0.03, 0.5, _info_constant(unit.of(real), unit.name), transform=axes[0].transAxes, fontsize=7.5)
    _components(axes[2], data)
    shared_legend(axes[0])
    letter(axes, ("Radial force, from zero", "Radial force, close-up", "Components, by the tip on the environment"))
    return axes


def _from_zero(panel: Axes) -> None:
    low, high = min(0.0, panel.dataLim.y0), max(0.0, panel.dataLim.y1)
    room = 0.1 * (high - low) or 1.0
    panel.set_ylim(low - room if low < 0 else 0.0, high + room)


def _info_constant(force: Any, unit: str) -> str:
    """The true range in words when the force hardly varies, so that no one takes the close-up for a large change."""
    low, high = float(np.min(force)), float(np.max(force))
    largest = max(abs(low), abs(high))
    if high - low >= NEARLY_CONSTANT * largest:
        return ""
    digits = int(np.clip(2 - np.floor(np.log10(max(high - low, 1e-9))), 2, 6))
    share = f"within {100 * (high - low) / largest:.2g} %"
    return f"nearly constant, {share}:\n{low:.{digits}f} to {high:.{digits}f} {unit}"


def _components(panel: Axes, data: Any) -> None:
    unit = readable("N", data["contact_force"].values)
    for axis, look in zip("xyz", COMPONENTS, strict=False):
        panel.plot(data["time"].values, unit.of(data["contact_force"].sel(axis=axis)), label=f"$F_{axis}$", **look)
    panel.set_ylabel(f"force [{unit.name}]")
    time_axis(panel, data["time"].values)
    shared_legend(panel, place="lower left")
