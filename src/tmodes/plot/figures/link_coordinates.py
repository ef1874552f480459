"""The elastic coordinates of the links, decomposed into quasi-static and oscillatory parts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from tmodes.plot.decomposition import coordinate_names, decomposed, largest_coordinates
from tmodes.plot.figure import Figure
from tmodes.plot.panels import AxesLike

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["LinkCoordinates"]

_MOST = 6


class LinkCoordinates(Figure):
    """The six largest elastic coordinates of the links [rad, m], decomposed as the deflections of the gears are.

    ``ax``: two axes for each, or None.
    """

    name = "link_coordinates"
    title = "Elastic coordinates of the links"
    caption = (
        "The largest coordinates of bending, torsion and stretch: left with what the present forces would hold "
        "statically, right the oscillation about it."
    )
    needs: ClassVar = {"deformation_stationary": "no link of this robot is elastic"}

    def missing(self, data: Any) -> str:
        """A robot whose gears alone are elastic has no such figure."""
        return super().missing(data) or (
            "" if coordinate_names(data, gears=False) else self.needs["deformation_stationary"]
        )

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Two panels for each coordinate."""
        names = largest_coordinates(result.data, coordinate_names(result.data, gears=False), _MOST)
        return decomposed(result.data, names, ax)
