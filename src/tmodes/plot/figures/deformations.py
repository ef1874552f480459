"""The elastic coordinates next to those of the nominal run."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tmodes.plot.facts import coordinate_names, deformation_unit, largest_coordinates, plain
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import Axes, AxesLike, Unit, curves, letter, panels, shared_legend, time_axis
from tmodes.plot.ranges import common_unit
from tmodes.plot.style import REAL, REFERENCE

__all__ = ["Deformations"]

_MOST_GEARS, _MOST_COORDINATES = 4, 6


@register
class Deformations(Figure):
    """Elastic coordinates of links and gears [rad, m], actual and nominal: the largest six and four.

    ``ax``: one axes for each, or None.
    """

    name = "deformations"
    title = "Elastic deformations"
    caption = "Actual and nominal deformation of links and gears; note the scales, and the sag at the start."
    needs: ClassVar = {"deformation_nominal": "there is no nominal run, or nothing of this robot is elastic"}

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each coordinate, two in a row."""
        data = result.data
        names = largest_coordinates(data, coordinate_names(data, gears=False), _MOST_COORDINATES)
        names += largest_coordinates(data, coordinate_names(data, gears=True), _MOST_GEARS)
        rows = [names[k : k + 2] for k in range(0, len(names), 2)]
        axes = panels(ax, [row if len(row) == 2 else row * 2 for row in rows], 0.8 + 1.6 * len(rows))
        units = _units(data, names)
        for panel, name in zip(axes, names, strict=True):
            _coordinate(panel, data, name, units)
        shared_legend(axes[0])
        letter(axes, map(plain, names))
        return axes


def _units(data: Any, names: list[str]) -> dict[str, Unit]:
    """One unit for all angles, and one for all displacements."""
    kinds: dict[str, list[Any]] = {}
    for name in names:
        own = (data[key].sel(deformation_kind=name).values for key in ("deformation", "deformation_nominal"))
        kinds.setdefault(deformation_unit(data, name), []).append(np.stack(list(own)))
    return {si: common_unit(si, *values) for si, values in kinds.items()}


def _coordinate(panel: Axes, data: Any, name: str, units: dict[str, Unit]) -> None:
    actual, planned = (data[key].sel(deformation_kind=name).values for key in ("deformation", "deformation_nominal"))
    shown = {"actual": (actual, REAL), "nominal": (planned, REFERENCE)}
    si = deformation_unit(data, name)
    curves(panel, data["time"].values, shown, si, unit=units[si])
    time_axis(panel, data["time"].values)
