"""Percentiles of the tip's motion over time."""

from __future__ import annotations

from typing import Any

from tmodes.plot.studies.contract import STUDY_FIGURES, Data, StudyFigure, padded_figure
from tmodes.plot.style import BLUE, INK

__all__ = ["Bands"]

_SHADES = (0.2, 0.4, 0.6)


@STUDY_FIGURES.register
class Bands(StudyFigure):
    """A panel for each axis in which the tip differs from the sheet's own run."""

    name = "bands"
    title = "Motion of the tip"
    each = False

    def missing(self, data: Data, quantity: Data) -> str:  # noqa: ARG002
        """Some cases must have been run again."""
        return "" if data["bands"] else "no motions"

    def draw(self, data: Data, quantity: Data) -> Any:  # noqa: ARG002
        """Bands between percentiles, the median as a line."""
        figure = padded_figure(0.5 + 1.7 * len(data["bands"]))
        panels = figure.subplots(len(data["bands"]), 1, squeeze=False, sharex=True).ravel()
        for panel, band in zip(panels, data["bands"], strict=True):
            shares, values = band["shares"], band["values"]
            for k in range(len(shares) // 2):
                label = f"{shares[k]} to {shares[-1 - k]} %"
                panel.fill_between(band["times"], values[k], values[-1 - k], color=BLUE, alpha=_SHADES[k], linewidth=0,
                                   label=label)  # fmt: skip
            panel.plot(band["times"], values[len(shares) // 2], color=INK, linewidth=1.0, label="median")
            panel.set(ylabel=f"{band['label']} [{band['unit']}]", title=f"{band['title']}, {band['cases']} cases")
        panels[-1].set_xlabel("time [s]")
        figure.legend(*panels[0].get_legend_handles_labels(), ncols=4, loc="outside lower right")
        return figure
