"""Designs that no other beats in two objectives."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.studies.contract import STUDY_FIGURES, Data, StudyFigure, axis_name, good_rows, padded_figure
from tmodes.plot.style import INK, QUIET, RED

__all__ = ["Pareto"]


@STUDY_FIGURES.register
class Pareto(StudyFigure):
    """All designs, and the front."""

    name = "pareto"
    title = "Best designs"
    each = False

    def missing(self, data: Data, quantity: Data) -> str:  # noqa: ARG002
        """Only an optimization with several objectives has a front."""
        return "" if data["pareto"] else "one objective"

    def draw(self, data: Data, quantity: Data) -> Any:  # noqa: ARG002
        """The first objective across, the second up."""
        named = {column["name"]: column for column in (*data["parameters"], *data["quantities"])}
        one, two = named[data["pareto"]["x"]], named[data["pareto"]["y"]]
        front = np.array(data["pareto"]["front"], dtype=int)
        front = front[np.argsort(one["values"][front])]
        figure = padded_figure(3.0)
        axes = figure.subplots()
        good = good_rows(data)
        if not good.all():
            axes.plot(one["values"][~good], two["values"][~good], "x", color=QUIET, alpha=0.35, markersize=3,
                      markeredgewidth=0.6, label="beyond a limit")  # fmt: skip
        axes.plot(one["values"][good], two["values"][good], ".", color=INK, alpha=0.5, markersize=4, label="designs")
        axes.plot(
            one["values"][front], two["values"][front], "o-", color=RED, markersize=4, linewidth=1.0, label="front"
        )
        axes.set(xlabel=axis_name(one), ylabel=axis_name(two), title=self.title)
        axes.margins(x=0.05)
        axes.legend()
        return figure
