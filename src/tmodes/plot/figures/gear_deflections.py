"""The deflection of the gears, decomposed into quasi-static and oscillatory parts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from tmodes.plot.decomposition import coordinate_names, decomposed, largest_coordinates
from tmodes.plot.figure import Figure
from tmodes.plot.panels import AxesLike

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["GearDeflections"]


class GearDeflections(Figure):
    """Gear output − input [rad]: total with its quasi-static part (left), oscillatory part (right).

    Of more than eight gears, those that deflect most. ``ax``: two axes for each, or None.
    """

    name = "gear_deflections"
    title = "Deflection of the gears"
    caption = (
        "Left, with what the present forces would hold statically; right, on its own scale, the oscillation about it."
    )
    needs: ClassVar = {"deformation_stationary": "no gear of this robot is elastic"}

    def missing(self, data: Any) -> str:
        """A robot whose links alone are elastic has no such figure."""
        return super().missing(data) or (
            "" if coordinate_names(data, gears=True) else self.needs["deformation_stationary"]
        )

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Two panels for each gear."""
        names = largest_coordinates(result.data, coordinate_names(result.data, gears=True), 8)
        return decomposed(result.data, names, ax)
