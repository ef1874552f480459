"""Morris' elementary effects: which parameters matter, and whether they act by themselves."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.studies.contract import STUDY_FIGURES, Data, StudyFigure, of_quantity, padded_figure, titles_of
from tmodes.plot.style import BLUE, INK, QUIET
from tmodes.plot.units import pretty

__all__ = ["ElementaryEffects"]


@STUDY_FIGURES.register
class ElementaryEffects(StudyFigure):
    """Mean size of the effects of each parameter (mu*), and how much they vary (sigma)."""

    name = "morris"
    title = "Elementary effects"

    def missing(self, data: Data, quantity: Data) -> str:
        """Only a sensitivity by Morris has them."""
        return "" if of_quantity(data, "effects", quantity) else "it is none: tmodes sensitivity --method morris"

    def draw(self, data: Data, quantity: Data) -> Any:
        """A point for each parameter, lines 95 % confidence; beyond the dashed line it varies by more than its size."""
        found = of_quantity(data, "effects", quantity)
        assert found is not None  # noqa: S101
        titles, size = titles_of(data), np.array(found["size"])
        value, low, high = size.T
        figure = padded_figure(3.2)
        axes = figure.subplots()
        axes.errorbar(value, found["spread"], xerr=np.maximum([value - low, high - value], 0.0), fmt="o", color=BLUE,
                      ecolor=INK, elinewidth=0.9, markersize=5)  # fmt: skip
        for name, x, y in zip(found["names"], value, found["spread"], strict=True):
            axes.annotate(titles.get(name, name), (x, y), xytext=(5, 5), textcoords="offset points", fontsize=7)
        reach = 1.08 * max(float(np.max(found["spread"])), 1e-300)
        axes.plot([0, reach], [0, reach], "--", color=QUIET, linewidth=0.9, zorder=0)
        axes.annotate("σ = μ*", (reach, reach), ha="left", va="center", xytext=(4, 0), textcoords="offset points",
                      fontsize=7, color=QUIET)  # fmt: skip
        axes.margins(x=0.12, y=0.12)
        axes.set(xlim=(min(0.0, float(low.min())), None), ylim=(0.0, None))
        unit = "" if found["unit"] == "-" else f" [{pretty(found['unit'])}]"
        axes.set(xlabel=f"mean size of the effect, μ*{unit}", ylabel=f"how much it varies, σ{unit}",
                 title=f"{self.title}: {quantity['title'] or quantity['name']}")  # fmt: skip
        return figure
