"""Energy of an arm: what is stored, what came in and went out, and how exactly the balance closes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmodes.plot.panels import AxesLike
from tmodes.plot.paper.energy import energy_panels
from tmodes.plot.style import COMPONENTS, INK, QUIET, house_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result import Result

__all__ = ["arm_energies"]

LOOKS = (
    *COMPONENTS,
    {"color": INK, "linestyle": (0, (1, 1)), "linewidth": 1.1},
    {"color": QUIET, "linestyle": (0, (3, 1, 1, 1)), "linewidth": 1.1},
)


@house_style()
def arm_energies(result: Result, ax: AxesLike = None) -> list[Axes]:
    """Energy by kind [J], work since the start by kind [J], and the size of the balance's residual [J], log scale.

    Kinds that are zero throughout are left out. ``ax``: three axes, or None.
    """
    return energy_panels(result.data, ax, LOOKS, "motor, loads, base: in; others: out", zeros=False)
