"""Sobol' indices with their confidence intervals."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.studies.contract import STUDY_FIGURES, Data, StudyFigure, of_quantity, padded_figure, titles_of
from tmodes.plot.style import BLUE, INK, OCHRE

__all__ = ["SobolIndices"]


@STUDY_FIGURES.register
class SobolIndices(StudyFigure):
    """Shares of the variance: of each parameter alone, and with all its interactions."""

    name = "sobol"
    title = "Shares of the variance"

    def missing(self, data: Data, quantity: Data) -> str:
        """Only a sensitivity has them."""
        return "" if of_quantity(data, "indices", quantity) else "it is no sensitivity: tmodes sensitivity"

    def draw(self, data: Data, quantity: Data) -> Any:
        """Upper bars first order, lower bars total, lines 95 % confidence."""
        found = of_quantity(data, "indices", quantity)
        assert found is not None  # noqa: S101
        titles = titles_of(data)
        order = sorted(range(len(found["names"])), key=lambda k: found["total"][k][0])
        figure = padded_figure(1.3 + 0.34 * len(order))
        axes = figure.subplots()
        for place, k in enumerate(order):
            for part, shift, colour in (("first", 0.19, BLUE), ("total", -0.19, OCHRE)):
                value, low, high = found[part][k]
                error = np.maximum([[value - low], [high - value]], 0.0)
                label = {"first": "first order", "total": "total"}[part] if not place else None
                axes.barh(place + shift, value, height=0.34, color=colour, linewidth=0, label=label, xerr=error,
                          error_kw={"ecolor": INK, "elinewidth": 0.9})  # fmt: skip
        axes.set_yticks(range(len(order)), [titles.get(found["names"][k], found["names"][k]) for k in order])
        axes.grid(visible=False, axis="y")
        axes.use_sticky_edges = False  # a line of confidence does not end at the edge
        axes.margins(x=0.05)
        axes.set(xlabel="share of the variance", title=f"{self.title}: {quantity['title'] or quantity['name']}")
        axes.legend(loc="lower right")
        return figure
