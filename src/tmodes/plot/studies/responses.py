"""A quantity over each parameter."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.studies.contract import (
    STUDY_FIGURES,
    Data,
    StudyFigure,
    axis_name,
    good_rows,
    padded_figure,
    ticks_of,
    varied,
)  # fmt: skip
from tmodes.plot.style import BLUE, INK

__all__ = ["Responses"]

_MOST_PANELS, _MOST_POINTS, _BINS = 6, 1500, 24


@STUDY_FIGURES.register
class Responses(StudyFigure):
    """Points of all cases, and their median along each parameter."""

    name = "responses"
    title = "Response"

    def missing(self, data: Data, quantity: Data) -> str:
        """Something must vary."""
        return "" if varied(data) and np.isfinite(quantity["values"]).any() else "nothing varies"

    def draw(self, data: Data, quantity: Data) -> Any:
        """A panel for each parameter, at most six."""
        columns = varied(data)[:_MOST_PANELS]
        wide = min(3, len(columns))
        tall = -(-len(columns) // wide)
        figure = padded_figure(0.5 + 2.0 * tall)
        panels = figure.subplots(tall, wide, squeeze=False, sharey=True).ravel()
        rows = good_rows(data) & np.isfinite(quantity["values"])
        for panel, column in zip(panels, columns, strict=False):
            x, y = column["values"][rows], quantity["values"][rows]
            some = np.linspace(0, len(x) - 1, min(len(x), _MOST_POINTS)).astype(int)
            panel.plot(x[some], y[some], ".", color=BLUE, markersize=2.5, alpha=0.5, rasterized=True)
            panel.plot(*_middle(x, y, alone=len(varied(data)) == 1), color=INK, linewidth=1.2)
            panel.set_xlabel(axis_name(column))
            panel.margins(x=0.03)
            if not column["labels"]:
                panel.locator_params(axis="x", nbins=4)
            ticks_of(panel.xaxis, column)
        for panel in panels[::wide]:
            panel.set_ylabel(axis_name(quantity))
        for panel in panels[len(columns) :]:
            panel.remove()
        return figure


def _middle(x: Any, y: Any, *, alone: bool) -> tuple[Any, Any]:
    """Medians at each of few values, else in bins of equally many cases; of one parameter the curve itself."""
    order = np.argsort(x, kind="stable")
    levels = np.unique(x)
    if alone and len(levels) == len(x):
        return x[order], y[order]
    if len(levels) <= _BINS:
        return levels, np.array([np.median(y[x == level]) for level in levels])
    parts = np.array_split(order, min(_BINS, max(2, len(x) // 8)))
    return np.array([np.median(x[part]) for part in parts]), np.array([np.median(y[part]) for part in parts])
