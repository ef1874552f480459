"""Parallel coordinates of all cases."""

from __future__ import annotations

from textwrap import fill
from typing import Any

import numpy as np

from tmodes.plot.studies.contract import STUDY_FIGURES, Data, StudyFigure, axis_name, good_rows, padded_figure, varied
from tmodes.plot.style import INK

__all__ = ["Cases"]

_MOST_LINES, _MOST_AXES = 600, 8


@STUDY_FIGURES.register
class Cases(StudyFigure):
    """Each case as a line across the axes of parameters and quantities, coloured by one quantity."""

    name = "cases"
    title = "All cases"

    def missing(self, data: Data, quantity: Data) -> str:
        """It needs two axes and a case."""
        enough = len(_columns(data)) > 1 and np.isfinite(quantity["values"]).any()
        return "" if enough else "fewer than two columns vary"

    def draw(self, data: Data, quantity: Data) -> Any:
        """At most 600 of the cases, evenly taken; from dark for small to light for large values."""
        from matplotlib import colormaps
        from matplotlib.collections import LineCollection

        columns = _columns(data)[:_MOST_AXES]
        rows = np.flatnonzero(good_rows(data) & np.isfinite(quantity["values"]))
        rows = rows[np.linspace(0, len(rows) - 1, min(len(rows), _MOST_LINES)).astype(int)]
        shown = [column["values"][rows] for column in columns]
        spans = [(np.nanmin(values), np.nanmax(values) - np.nanmin(values) or 1.0) for values in shown]
        heights = np.column_stack([(values - low) / span for values, (low, span) in zip(shown, spans, strict=True)])
        own = quantity["values"][rows]
        shades = colormaps["viridis"]((own - own.min()) / (np.ptp(own) or 1.0))
        figure = padded_figure(3.0)
        axes = figure.subplots()
        lines = [np.column_stack([range(len(columns)), height]) for height in heights]
        axes.add_collection(LineCollection(lines, colors=shades, linewidths=0.6, alpha=0.5, rasterized=True))
        axes.set(xlim=(-0.15, len(columns) - 0.85), ylim=(-0.12, 1.12), title=self.title, yticks=[])
        names = [axis_name(column) for column in columns]
        axes.set_xticks(range(len(columns)), [fill(name, 14) for name in names])
        for place, (column, (low, span)) in enumerate(zip(columns, spans, strict=True)):
            axes.plot([place, place], [0.0, 1.0], color=INK, linewidth=0.8)
            for end, height, side in ((low, -0.03, "top"), (low + span, 1.03, "bottom")):
                words = column["labels"][int(end)] if column["labels"] else f"{end:.4g}"
                axes.text(place, height, words, ha="center", va=side, fontsize=7)
        axes.spines[["left", "bottom"]].set_visible(False)
        axes.tick_params(length=0, pad=10)
        axes.grid(visible=False)
        return figure


def _columns(data: Data) -> list[Data]:
    quantities = [column for column in data["quantities"] if np.isfinite(column["values"]).any()]
    return [*varied(data), *quantities]
