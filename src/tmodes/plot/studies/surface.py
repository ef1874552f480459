"""A quantity over two parameters on a grid."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.studies.contract import STUDY_FIGURES, Data, StudyFigure, axis_name, padded_figure, ticks_of, varied

__all__ = ["Surface"]

_FEWEST = 3


@STUDY_FIGURES.register
class Surface(StudyFigure):
    """Colours over all combinations of two parameters."""

    name = "surface"
    title = "Response to two parameters"

    def missing(self, data: Data, quantity: Data) -> str:
        """The cases must be all combinations of the values of two parameters."""
        columns = varied(data)
        if len(columns) != 2:
            return "not two parameters"
        sizes = [len(np.unique(column["values"])) for column in columns]
        whole = np.prod(sizes) == len(quantity["values"]) and min(sizes) >= _FEWEST
        return "" if whole else "its cases are no grid"

    def draw(self, data: Data, quantity: Data) -> Any:
        """The first parameter across, the second up."""
        one, two = varied(data)
        xs, ys = np.unique(one["values"]), np.unique(two["values"])
        values = np.full((len(ys), len(xs)), np.nan)
        values[np.searchsorted(ys, two["values"]), np.searchsorted(xs, one["values"])] = quantity["values"]
        figure = padded_figure(3.2)
        axes = figure.subplots()
        mesh = axes.pcolormesh(xs, ys, values, shading="nearest", cmap="viridis", rasterized=True)
        figure.colorbar(mesh, ax=axes, label=axis_name(quantity))
        axes.set(xlabel=axis_name(one), ylabel=axis_name(two), title=self.title)
        axes.grid(visible=False)
        ticks_of(axes.xaxis, one)
        ticks_of(axes.yaxis, two)
        return figure
