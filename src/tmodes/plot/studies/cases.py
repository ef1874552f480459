"""All cases of a study: parallel coordinates, distributions, responses, surfaces, bands over time."""

from __future__ import annotations

from textwrap import fill
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

__all__ = ["Bands", "Histogram", "ParallelCoordinates", "Responses", "SurfaceFigure"]

_MOST_LINES, _MOST_AXES = 600, 8


@STUDY_FIGURES.register
class ParallelCoordinates(StudyFigure):
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


_MARKED = (5, 50, 95)


@STUDY_FIGURES.register
class Histogram(StudyFigure):
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
            mark = {"linestyle": "", "marker": "_", "markersize": 9} if column["labels"] else {}  # names have no order
            panel.plot(*_middle(x, y, alone=len(varied(data)) == 1), color=INK, linewidth=1.2, **mark)
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


_FEWEST = 3


@STUDY_FIGURES.register
class SurfaceFigure(StudyFigure):
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
