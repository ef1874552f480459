"""Which parameter matters: a tornado."""

from __future__ import annotations

from typing import Any

from tmodes.plot.studies.contract import (
    STUDY_FIGURES,
    Data,
    StudyFigure,
    axis_name,
    of_quantity,
    padded_figure,
    titles_of,
)
from tmodes.plot.style import BLUE, INK, RED

__all__ = ["Swings"]

_MOST = 15


@STUDY_FIGURES.register
class Swings(StudyFigure):
    """How far a quantity goes with each parameter by itself, the strongest on top."""

    name = "tornado"
    title = "What matters"

    def missing(self, data: Data, quantity: Data) -> str:
        """It needs cases at both ends of the parameters."""
        return "" if of_quantity(data, "tornados", quantity) else "too few cases"

    def draw(self, data: Data, quantity: Data) -> Any:
        """Bars from the base to where a parameter is low (blue) and high (orange)."""
        found = of_quantity(data, "tornados", quantity)
        assert found is not None  # noqa: S101
        titles = titles_of(data)
        bars = sorted(found["bars"], key=lambda bar: abs(bar["high"] - bar["low"]))[-_MOST:]
        figure = padded_figure(1.2 + 0.26 * len(bars))
        axes = figure.subplots()
        for place, bar in enumerate(bars):
            for end, colour in (("low", BLUE), ("high", RED)):
                axes.barh(place, bar[end] - found["base"], left=found["base"], color=colour, height=0.6, linewidth=0)
        axes.axvline(found["base"], color=INK, linewidth=0.8)
        axes.set_yticks(range(len(bars)), [titles[bar["name"]] for bar in bars])
        axes.grid(visible=False, axis="y")
        axes.use_sticky_edges = False
        axes.margins(x=0.05)
        axes.set(xlabel=axis_name(quantity), title=f"{self.title} (blue: low, orange: high)")
        return figure
