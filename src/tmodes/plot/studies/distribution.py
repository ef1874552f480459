"""How a quantity is distributed over all cases."""

from __future__ import annotations

from typing import Any

from tmodes.plot.studies.contract import STUDY_FIGURES, Data, StudyFigure, axis_name, padded_figure
from tmodes.plot.style import BLUE, INK

__all__ = ["Distribution"]

_MARKED = (5, 50, 95)


@STUDY_FIGURES.register
class Distribution(StudyFigure):
    """A histogram with percentiles."""

    name = "distribution"
    title = "Distribution"

    def missing(self, data: Data, quantity: Data) -> str:
        """Cases that were chosen have no percentiles."""
        if not data["drawn"]:
            return "cases were chosen, not drawn"
        return "" if len(quantity["counts"]) else "no case has a value"

    def draw(self, data: Data, quantity: Data) -> Any:
        """Bars of all cases, dashed lines at 5, 50 and 95 %."""
        figure = padded_figure(2.6)
        axes = figure.subplots()
        edges, counts = quantity["edges"], quantity["counts"]
        axes.bar(edges[:-1], counts, width=edges[1:] - edges[:-1], align="edge", color=BLUE, alpha=0.65, linewidth=0)
        axes.set(xlabel=axis_name(quantity), ylabel=f"cases of {data['cases']:,}", title=self.title)
        top = 1.04
        for share, value in quantity["percentiles"]:
            if share in _MARKED:
                axes.axvline(value, color=INK, linestyle="--", linewidth=0.9)
                words = f"{share} %: {value:.4g}"
                side = {5: "right", 50: "center", 95: "left"}[share]
                axes.annotate(words, (value, top), xycoords=("data", "axes fraction"), ha=side, fontsize=7)
        axes.set_title(self.title, pad=16)
        return figure
